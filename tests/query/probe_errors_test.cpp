// SPDX-License-Identifier: MIT
// The error bounds of lines against planes at the worst inputs that a search finds: never broken,
// by rationals, and not so wide that they would be of no use.
#include "query/probe_errors.hpp"

#include <doctest/doctest.h>

#include "hill_climb.hpp"

using namespace convexact;

namespace {

// Two planes, |n_k| <= 1 and |d| <= 2, and a line through two points, |y_k| <= 1; and t / kMostT.
struct TwoPlanes {
  DoubleHalfspace i, j;
  Point first, second;
  double t;

  explicit TwoPlanes(const std::vector<double>& x)
      : i(plane_of(x, 0)),
        j(plane_of(x, 4)),
        first(x[8], x[9], x[10]),
        second(x[11], x[12], x[13]),
        t(kMostT * x[14]) {}

  static DoubleHalfspace plane_of(const std::vector<double>& x, std::size_t k) {
    const RationalVector3 normal = to_rational(Point(x[k], x[k + 1], x[k + 2]));
    return DoubleHalfspace(Halfspace(normal, 2 * to_rational(x[k + 3])));
  }
  bool is_in_range() const { return std::abs(i.d) <= 2 && std::abs(j.d) <= 2; }

  std::vector<Rational> numbers() const {
    std::vector<Rational> all;
    for (const DoubleHalfspace* plane : {&i, &j}) {
      for (const double n : plane->n) all.push_back(to_rational(n));
      all.push_back(to_rational(plane->d));
    }
    return all;
  }
};

Rational value(const std::vector<Rational>& planes, std::size_t k, const Point& at) {
  Rational sum = planes[k + 3];
  for (int axis = 0; axis < 3; ++axis) sum += planes[k + axis] * to_rational(at[axis]);
  return sum;
}

// The planes themselves are off by a rounding in each of their numbers: at most u of it.
double ratio(const TwoPlanes& planes, double computed, const auto& truth) {
  const Rational distance = hill_climb::worst_distance(to_rational(computed), planes.numbers(),
                                                       to_rational(kUnitRoundoff), truth);
  return Rational(distance / to_rational(kLineError)).convert_to<double>();
}

double value_ratio(const std::vector<double>& x) {
  if (x[0] == 0 || x[4] == 0) return 0;
  const TwoPlanes planes(x);
  if (!planes.is_in_range()) return 0;
  const LineValues values(planes.i, planes.first, planes.second);
  return ratio(planes, values.at(planes.t), [&](const std::vector<Rational>& at) -> Rational {
    const Rational v = value(at, 0, planes.first);
    return v + to_rational(planes.t) * (value(at, 0, planes.second) - v);
  });
}

double gap_ratio(const std::vector<double>& x) {
  if (x[0] == 0 || x[4] == 0) return 0;
  const TwoPlanes planes(x);
  if (!planes.is_in_range()) return 0;
  const LineValues i(planes.i, planes.first, planes.second),
      j(planes.j, planes.first, planes.second);
  return ratio(planes, i.gap_before(j), [&](const std::vector<Rational>& at) -> Rational {
    const Rational v = value(at, 0, planes.first), w = value(at, 4, planes.first);
    return v * (value(at, 4, planes.second) - w) - w * (value(at, 0, planes.second) - v);
  });
}

}  // namespace

TEST_CASE("kLineError: it holds for the worst lines found, and is not vacuous") {
  const double of_values = hill_climb::highest(15, 20, 600, 1, value_ratio);
  const double of_gaps = hill_climb::highest(15, 20, 600, 2, gap_ratio);
  MESSAGE("values: " << of_values << ", gaps: " << of_gaps << " of the bound");
  CHECK(of_values <= 1);
  CHECK(of_gaps <= 1);
  CHECK(std::max(of_values, of_gaps) > 1.0 / 16);
}
