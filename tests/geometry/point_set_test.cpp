// SPDX-License-Identifier: MIT
// Which points make a set: all that doubles reach, exactly; the rest is refused with its number.
#include <doctest/doctest.h>

#include <limits>

#include "convexact/geometry.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

template <class Point>
std::string refusal(std::vector<Point> points) {
  const Error error = error_of([&] { return PointSet(std::move(points)).size(); });
  CHECK(error.code() == ErrorCode::NotFinite);
  return error.what();
}

}  // namespace

TEST_CASE("PointSet: rationals that are doubles make a binary set, others are kept") {
  const Rational third(1, 3), half(1, 2);
  const PointSet binary(std::vector{RationalPoint(half, half, half)});
  CHECK(binary.is_binary());
  CHECK(binary[PointId(0)] == RationalPoint(half, half, half));
  const PointSet rational(
      std::vector{RationalPoint(half, half, half), RationalPoint(half, half, third)});
  CHECK_FALSE(rational.is_binary());
  CHECK(rational[PointId(1)].z() == third);
}

TEST_CASE("PointSet: NaN, infinite and beyond the largest double are refused, with the number") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    CAPTURE(bad);
    CHECK(refusal(std::vector<Point>{{0, 0, 0}, {0, bad, 0}}).find("point 1") != std::string::npos);
  }
  // The largest double is (2 - 2^-52) 2^1023; from half a unit above it on, the nearest is
  // infinite.
  const Rational largest = to_rational(std::numeric_limits<double>::max());
  const Rational half_a_unit = scale_by_power_of_two(Rational(1), 970);
  const PointSet set(std::vector{RationalPoint(0, 0, largest + half_a_unit / 2)});
  CHECK_FALSE(set.is_binary());
  for (const Rational& z : {Rational(largest + half_a_unit), Rational(-largest - half_a_unit)}) {
    CHECK(refusal(std::vector{RationalPoint(0, 0, 1), RationalPoint(0, 0, z)}).find("point 1") !=
          std::string::npos);
  }
}

TEST_CASE("PointSet: remainders are what rounding left, and subsets are sets of their own") {
  const Rational third(1, 3), tiny = scale_by_power_of_two(Rational(1, 3), -1200);
  const PointSet set(std::vector{RationalPoint(1, 2, 3), RationalPoint(third, 1, -third),
                                 RationalPoint(1, 1, 1 + tiny)});
  for (std::size_t i = 0; i < set.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Rational left = set[PointId(i)][k] - to_rational(set.doubles()[i][k]);
      CHECK(set.remainders()[i][k] == to_double(left, Rounding::Nearest));
    }
  }
  const auto of = [&](std::vector<PointId> ids) { return subset(set, ids); };
  CHECK(of({PointId(0), PointId(0)}).is_binary());
  CHECK(of({PointId(0), PointId(0)}).remainders().empty());
  CHECK(of({}).is_binary());
  const PointSet both = of({PointId(1), PointId(0)});
  CHECK(both[PointId(0)] == set[PointId(1)]);
  CHECK(both[PointId(1)] == set[PointId(0)]);
  CHECK(both.remainders()[0] == set.remainders()[1]);
  // Its remainder is too small for a double, and yet it is none.
  CHECK(set.remainders()[2].isZero(0));
  CHECK_FALSE(of({PointId(2)}).is_binary());
  CHECK(of({PointId(2)})[PointId(0)] == set[PointId(2)]);
}
