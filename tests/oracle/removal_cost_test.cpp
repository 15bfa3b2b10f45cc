// SPDX-License-Identifier: MIT
// Costs by definition against closed forms; the rounding that is allowed for against planes that
// are really off by one rounding.
#include "oracle/removal_cost.hpp"

#include <doctest/doctest.h>

#include "cut_box.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"

using namespace convexact;

TEST_CASE("removal cost: a corner cut at depth t costs t^3 / 6") {
  const std::vector<Rational> depths = {Rational(1), Rational(1, 3), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  const RemovalOracle oracle(solid.halfspaces, kCutBoxCenter);
  for (std::size_t c = 0; c < depths.size(); ++c) {
    const Rational& t = depths[c];
    const RemovalCost cost = oracle.without(corner_cut(c, t));
    CHECK(cost.cost == Rational(t * t * t / 6));
    // The cone is t^2 (6 - t) / 6; the box is [-2, 2]^3; |P|.|x| is 1 for the sides, 6 / (6 - t)
    // for the cut.
    const Rational reach = t * t * (6 - t) / 3 + t * t * t / 6;
    CHECK(cost.rounding == Rational(to_rational(kPlaneRounding) * 3 * 6 / (6 - t) * reach));
  }
}

TEST_CASE("removal cost: a side is to be had only where the cut bounds what it leaves open") {
  const DualHull solid = cut_box({Rational(1)});
  const RemovalOracle oracle(solid.halfspaces, kCutBoxCenter);
  const std::vector<Halfspace> sides = cube_sides();
  for (std::size_t k = 0; k < 3; ++k) {
    CAPTURE(k);
    CHECK_FALSE(oracle.without(sides[2 * k]).cost.has_value());
    // Down to x = 1 - y - z: the integral of y + z - 1 over [0, 4]^2 where that is positive.
    CHECK(oracle.without(sides[2 * k + 1]).cost == Rational(48) + Rational(1, 6));
  }
}

TEST_CASE("removal cost: planes that bound no facet and unbounded solids are refused") {
  const DualHull solid = cut_box({Rational(1)});
  const RemovalOracle oracle(solid.halfspaces, kCutBoxCenter);
  CHECK_THROWS(oracle.without(corner_cut(1, Rational(1))));
  std::vector<Halfspace> open = cube_sides();
  open.pop_back();
  CHECK_THROWS(RemovalOracle(open, kCutBoxCenter));
  CHECK_FALSE(intersect(open, kCutBoxCenter).has_value());
}

namespace {

// Every dual point off by the share +-2^-52 in each coordinate, as doubles may be.
std::vector<Halfspace> rounded_planes(const DualHull& solid, const RationalPoint& center,
                                      Random& random) {
  std::vector<Halfspace> rounded;
  for (const Halfspace& plane : solid.halfspaces) {
    const Rational slack = -plane(center);
    RationalVector3 dual;
    for (int k = 0; k < 3; ++k) {
      const Rational share = to_rational(uniform_below(random, 2) == 0 ? 0x1p-52 : -0x1p-52);
      dual[k] = Rational(plane.normal()[k]) / slack * (1 + share);
    }
    rounded.emplace_back(dual, Rational(-1) - dual.dot(center));
  }
  return rounded;
}

}  // namespace

TEST_CASE("removal cost: planes off by one rounding move a cost by a 64th of what is allowed") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const DualHull solid = dual_of_doubles(shapes::in_ball(20, seed));
    const RationalPoint center = center_of(solid);
    Random random(seed);
    const std::vector<Halfspace> rounded = rounded_planes(solid, center, random);
    const RemovalOracle exact(solid.halfspaces, center), off(rounded, center);
    for (std::size_t i = 0; i < rounded.size(); ++i) {
      const RemovalCost before = exact.without(solid.halfspaces[i]);
      const RemovalCost after = off.without(rounded[i]);
      REQUIRE(before.cost.has_value() == after.cost.has_value());
      if (!before.cost) continue;
      const Rational moved = abs(Rational(*after.cost - *before.cost));
      // To first order in 2^-52: the rest is far below a millionth of it.
      CHECK(moved * 64 <= *before.rounding * Rational(1000001, 1000000));
    }
  }
}
