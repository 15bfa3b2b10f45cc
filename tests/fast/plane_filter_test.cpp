// SPDX-License-Identifier: MIT
// The error bounds of PlaneFilter at the worst inputs that a search finds: never broken, by
// determinants of rationals, and not so wide that they would be of no use.
#include <doctest/doctest.h>

#include "fast/signs.hpp"
#include "hill_climb.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

// Numbers as a test sees them: doubles, or sums of two of them.
Rational exactly(double x) { return to_rational(x); }
Rational exactly(const DoubleDouble& x) { return to_rational(x.hi()) + to_rational(x.lo()); }

// A dual point of doubles x, y, z as the arithmetic takes it; the second half of a long coordinate
// is drawn from the first one's bits, so that the same doubles make the same point.
template <class Scalar>
Scalar coordinate(double x) {
  if constexpr (std::is_same_v<Scalar, double>) {
    return x;
  } else {
    const double rest = std::ldexp(std::remainder(0x1.234567p40 * x, 1.0), -53) * std::abs(x);
    return {x, rest};
  }
}

template <class Scalar>
std::vector<Scalar> coordinates(const std::vector<double>& x) {
  std::vector<Scalar> all;
  for (const double c : x) all.push_back(coordinate<Scalar>(c));
  return all;
}

template <class Number>
Triple<Number> point(const std::vector<Number>& x, std::size_t p) {
  return {x[3 * p], x[3 * p + 1], x[3 * p + 2]};
}

// ((b - a) x (c - a)).(p - a) and ((b - a) x (c - a)).a, in any numbers.
template <class Number>
Number height(const std::vector<Number>& x) {
  const auto a = point(x, 0), f = point(x, 1) - a, g = point(x, 2) - a, h = point(x, 3) - a;
  return dot(cross(f, g), h);
}
template <class Number>
Number determinant(const std::vector<Number>& x) {
  const auto a = point(x, 0), f = point(x, 1) - a, g = point(x, 2) - a;
  return dot(cross(f, g), a);
}

template <class Scalar>
PlaneFilter filter_of(const std::vector<Scalar>& x) {
  Extent extent;
  for (std::size_t p = 1; 3 * p < x.size(); ++p) extent.include(point(x, p) - point(x, 0));
  return PlaneFilter::within(extent.size, Roundoff<Scalar>::kUnit);
}

template <class Scalar>
std::vector<Rational> rationals(const std::vector<Scalar>& x) {
  std::vector<Rational> all;
  for (const Scalar& c : x) all.push_back(exactly(c));
  return all;
}

// (computed - true) / bound for the true points that fit the coordinates worst.
template <class Scalar>
double height_ratio(const std::vector<double>& doubles) {
  const auto x = coordinates<Scalar>(doubles);
  const Rational error = to_rational(2 * Roundoff<Scalar>::kUnit);
  const Rational distance =
      hill_climb::worst_distance(exactly(height(x)), rationals(x), error, height<Rational>);
  return Rational(distance / to_rational(filter_of(x).height)).template convert_to<double>();
}
template <class Scalar>
double determinant_ratio(const std::vector<double>& doubles) {
  const auto x = coordinates<Scalar>(doubles);
  const Rational error = to_rational(2 * Roundoff<Scalar>::kUnit);
  const Rational distance = hill_climb::worst_distance(exactly(determinant(x)), rationals(x), error,
                                                       determinant<Rational>);
  return Rational(distance / to_rational(filter_of(x).determinant)).template convert_to<double>();
}

// Never broken; and within a factor of ten of what it must be.
void check_ratio(const char* bound, double ratio) {
  MESSAGE(std::string(bound) << ": " << ratio << " of the bound is reached");
  CHECK(ratio <= 1);
  CHECK(ratio > 0.1);
}

}  // namespace

TEST_CASE("PlaneFilter: the bounds hold for the worst doubles found, and are not vacuous" * sweep) {
  check_ratio("H in double", hill_climb::highest(12, 20, 400, 1, height_ratio<double>));
  check_ratio("D in double", hill_climb::highest(9, 20, 400, 2, determinant_ratio<double>));
}

TEST_CASE("PlaneFilter: the bounds hold for the worst long doubles found, and are not vacuous") {
  check_ratio("H in DoubleDouble", hill_climb::highest(12, 20, 200, 3, height_ratio<DoubleDouble>));
  check_ratio("D in DoubleDouble",
              hill_climb::highest(9, 20, 200, 4, determinant_ratio<DoubleDouble>));
}
