// SPDX-License-Identifier: MIT
// Costs by definition against closed forms; the rounding that is allowed for against planes that
// are really off by one rounding.
#include "oracle/order/removal_cost.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "cut_box.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"
#include "sweep.hpp"

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

// The edges beyond the cut have the length t, between sides at the distance 2 from the center;
// those of the base t sqrt 2, between a side and the cut, at the angle of which the cosine is 1 /
// sqrt 3. The farthest point is the corner, at 2 sqrt 3.
TEST_CASE("removal cost: the rounding of area and mean width in closed form") {
  const double root = std::sqrt(3.0);
  for (const double t : {1.0, 0.25, 1.5}) {
    const DualHull solid = cut_box({to_rational(t)});
    const auto rounding = [&](CostMeasure measure) {
      const RemovalOracle oracle(solid.halfspaces, kCutBoxCenter, measure);
      return oracle.without(corner_cut(0, to_rational(t))).rounding.value().convert_to<double>();
    };
    const double share = kPlaneRounding * 6 / (6 - t);
    CHECK(rounding(CostMeasure::Area) ==
          doctest::Approx(share * (12 * t + 3 * t * (root - 1) * (2 + (6 - t) / root)))
              .epsilon(1e-12));
    CHECK(rounding(CostMeasure::MeanWidth) ==
          doctest::Approx(share * 2 * (2 * root) * (1 - 1 / root)).epsilon(1e-12));
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

TEST_CASE("removal cost: planes off by one rounding move a cost by a 64th of what is allowed" *
          sweep) {
  for (const CostMeasure measure :
       {CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth}) {
    CAPTURE(static_cast<int>(measure));
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      CAPTURE(seed);
      const DualHull solid = dual_of_doubles(shapes::in_ball(20, seed));
      const RationalPoint center = center_of(solid);
      Random random(seed);
      const std::vector<Halfspace> rounded = rounded_planes(solid, center, random);
      const RemovalOracle exact(solid.halfspaces, center, measure), off(rounded, center, measure);
      for (std::size_t i = 0; i < rounded.size(); ++i) {
        const RemovalCost before = exact.without(solid.halfspaces[i]);
        const RemovalCost after = off.without(rounded[i]);
        REQUIRE(before.cost.has_value() == after.cost.has_value());
        if (!before.cost) continue;
        REQUIRE(before.rounding.has_value());
        const Enclosure moved = after.cost->enclose(256) - before.cost->enclose(256);
        const Rational most = std::max(abs(moved.low()), abs(moved.high()));
        // To first order in 2^-52: the rest is far below a millionth of it.
        CHECK(most * 64 <= *before.rounding * Rational(1000001, 1000000));
      }
    }
  }
}

// A cut of a corner at the depths x, y, z along its edges: (xy + yz + zx - |(yz, zx, xy)|) / 2 of
// area, and of 4 pi times the mean width (x + y + z) pi / 2 less the lengths times angles of the
// base: an edge of length |(x, y)|, say, at the angle of the cut and the side z = 0.
TEST_CASE("removal cost: a corner of a box in closed form, by area and by mean width") {
  const Rational depths[][3] = {{1, 1, 1}, {1, 2, 3}, {Rational(1, 3), 2, Rational(5, 4)}};
  for (const auto& [x, y, z] : depths) {
    std::vector<Halfspace> planes = cube_sides();
    const Halfspace cut(RationalVector3(-1 / x, -1 / y, -1 / z), 1);
    planes.push_back(cut);
    const auto by = [&](CostMeasure measure) {
      return RemovalOracle(planes, kCutBoxCenter, measure).without(cut).cost.value();
    };
    RootSum area(Rational((x * y + y * z + z * x) / 2));
    area.add(Rational(-1, 2), x * x * y * y + y * y * z * z + z * z * x * x);
    CHECK(by(CostMeasure::Area) == Cost(area));
    // The outward normals are those of the cut, -(1/x, 1/y, 1/z) times the product, and of a side.
    AngleSum width = AngleSum::pi((x + y + z) / 2);
    const RationalVector3 n(y * z, z * x, x * y);
    const Rational legs[] = {x, y, z};
    const Integer scale = 144;  // of the denominators of n
    for (int side = 0; side < 3; ++side) {
      const Rational &u = legs[(side + 1) % 3], &v = legs[(side + 2) % 3];
      const Rational across = n.squaredNorm() - n[side] * n[side];
      width -= AngleSum(
          std::vector<AngleTerm>{{1, u * u + v * v, numerator(Rational(across * scale * scale)),
                                  numerator(Rational(n[side] * scale))}});
    }
    CHECK(compare(by(CostMeasure::MeanWidth), Cost(width)).order == Order::Equal);
  }
}
