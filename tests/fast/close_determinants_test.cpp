// SPDX-License-Identifier: MIT
// The error bounds of close_height() and close_determinant() on dual points in two close pairs, by
// determinants of rationals: never broken, and small enough for the sign of H.
#include "fast/close_determinants.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hill_climb.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

Rational sum_of_halves(const DoubleDouble& x) { return to_rational(x.hi()) + to_rational(x.lo()); }

// Four points in the order a, b, a', b', of which a' and b' are next to a and b.
std::vector<DoubleDouble> in_close_pairs(const std::vector<double>& x) {
  std::vector<DoubleDouble> all;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const DoubleDouble far(x[k % 6], 0x1p-54 * x[(k + 1) % 6] * x[k % 6]);
    all.push_back(k < 6 ? far : far + DoubleDouble(0x1p-50 * x[k]));
  }
  return all;
}

template <class Number>
Triple<Number> triple_at(const std::vector<Number>& x, std::size_t p) {
  return {x[3 * p], x[3 * p + 1], x[3 * p + 2]};
}

Rational true_height(const std::vector<Rational>& x) {
  const auto a = triple_at(x, 0), f = triple_at(x, 1) - a, g = triple_at(x, 2) - a,
             h = triple_at(x, 3) - a;
  return dot(cross(f, g), h);
}
Rational true_determinant(const std::vector<Rational>& x) {
  const auto a = triple_at(x, 0), f = triple_at(x, 1) - a, g = triple_at(x, 2) - a;
  return dot(cross(f, g), a);
}

Approximate long_height(const std::vector<DoubleDouble>& x) {
  return close_height(triple_at(x, 0), triple_at(x, 1), triple_at(x, 2), triple_at(x, 3));
}
Approximate long_determinant(const std::vector<DoubleDouble>& x) {
  return close_determinant(triple_at(x, 0), triple_at(x, 1), triple_at(x, 2));
}

// (computed - true) / bound for the true points that fit the coordinates worst.
template <Approximate (*computed)(const std::vector<DoubleDouble>&),
          Rational (*truth)(const std::vector<Rational>&)>
double close_ratio(const std::vector<double>& doubles) {
  const std::vector<DoubleDouble> x = in_close_pairs(doubles);
  std::vector<Rational> rationals;
  for (const DoubleDouble& c : x) rationals.push_back(sum_of_halves(c));
  const auto [value, error] = computed(x);
  const Rational distance = hill_climb::worst_distance(
      sum_of_halves(value), rationals, to_rational(2 * Roundoff<DoubleDouble>::kUnit), truth);
  return Rational(distance / to_rational(error)).convert_to<double>();
}

}  // namespace

TEST_CASE("close_determinants: the bounds hold for the worst close pairs found" * sweep) {
  const double of_heights =
                   hill_climb::highest(12, 20, 200, 1, close_ratio<long_height, true_height>),
               of_determinants = hill_climb::highest(
                   12, 20, 200, 2, close_ratio<long_determinant, true_determinant>);
  MESSAGE(of_heights << " and " << of_determinants << " of the bounds are reached");
  CHECK(of_heights <= 1);
  CHECK(of_heights > 0.05);
  CHECK(of_determinants <= 1);
  CHECK(of_determinants > 0.05);
}

TEST_CASE("close_height: a height of two close pairs has a sign, in any order of the points") {
  // Both distances within pairs enter H, so it is some 2^-103: less than PlaneFilter's bound.
  const std::vector<double> x{0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.75, 0, 0.25, 0.125};
  const std::vector<DoubleDouble> all = in_close_pairs(x);
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  do {
    std::vector<Rational> rationals;
    for (const std::size_t p : order) {
      for (std::size_t k = 0; k < 3; ++k) rationals.push_back(sum_of_halves(all[3 * p + k]));
    }
    const auto [value, error] = close_height(triple_at(all, order[0]), triple_at(all, order[1]),
                                             triple_at(all, order[2]), triple_at(all, order[3]));
    const Rational truth = true_height(rationals);
    CHECK(truth.sign() == (value.hi() > 0 ? 1 : -1));
    CHECK(error < 0x1p-20 * std::abs(value.hi()));
    CHECK(abs(Rational(sum_of_halves(value) - truth)) <= to_rational(error));
  } while (std::next_permutation(order.begin(), order.end()));
}
