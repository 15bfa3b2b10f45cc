// SPDX-License-Identifier: MIT
// Property of orient3d: for all finite doubles the sign is that of the determinant in rationals,
// and the value of each stage is within the bound that the stage states. Property of plane_side:
// the side of each point, and how many points lie outside, are those of n.x + d in rationals.
#include "convexact/geometry.hpp"
#include "convexact/stored.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "geometry/orient3d_stages.hpp"
#include "hard_numbers.hpp"
#include "orient3d_bounds.hpp"

using namespace convexact;

namespace {

Rational determinant(const RationalVector3& x, const RationalVector3& y, const RationalVector3& z) {
  return x.dot(y.cross(z));
}

bool is_within(double value, const Rational& truth, double bound) {
  return abs(Rational(to_rational(value) - truth)) <= to_rational(bound);
}

void hold_orient3d(FuzzInput& in) {
  HardNumbers numbers(in);
  const Point a = numbers.point(), b = numbers.point(), c = numbers.point();
  Point d = numbers.point();
  // Often in the plane of the others, up to rounding.
  if (in.below(2) == 0) d = a + (b - a) * 0.25 + (c - a) * 0.5;
  if (!d.allFinite()) return;
  const RationalVector3 origin = to_rational(d);
  const RationalVector3 x = to_rational(a) - origin, y = to_rational(b) - origin,
                        z = to_rational(c) - origin;
  const Rational truth = determinant(x, y, z);
  const StagedSign found = orient3d_staged(a, b, c, d);
  FUZZ_CHECK(found.sign == sign_of(truth));
  FUZZ_CHECK(orient3d(a, b, c, d) == found.sign);
  if (found.stage == Orient3dStage::Rationals) return;
  const Orient3dBounds bounds = orient3d_bounds(a, b, c, d);
  FUZZ_CHECK(is_within(bounds.value_a, truth, bounds.bound_a));
  FUZZ_CHECK(is_within(bounds.value_c, truth, bounds.bound_c));
  const Rational rounded =
      determinant(to_rational(Point(a - d)), to_rational(Point(b - d)), to_rational(Point(c - d)));
  FUZZ_CHECK(abs(Rational(rounded - truth)) <= to_rational(bounds.bound_b));
}

// Small, or so close to another number that doubles cannot distinguish them.
Integer coefficient(FuzzInput& in, bool is_close) {
  const Integer small = static_cast<int>(in.below(9)) - 4;
  if (!is_close) return small;
  return (small << 60) + (static_cast<int>(in.below(5)) - 2);
}

void hold_plane_side(FuzzInput& in) {
  const bool is_close = in.below(2) == 1;
  std::vector<Halfspace> halfspaces;
  for (std::size_t count = 1 + in.below(3); count > 0; --count) {
    IntegerVector3 normal;
    for (Integer& n : normal) n = coefficient(in, is_close);
    if (normal == IntegerVector3::Zero()) normal[0] = 1;
    halfspaces.emplace_back(normal, coefficient(in, is_close));
  }
  HardNumbers numbers(in);
  std::vector<Point> points;
  for (std::size_t count = 1 + in.below(4); count > 0; --count) points.push_back(numbers.point());
  std::size_t outside = 0;
  for (const Point& x : points) {
    bool is_outside = false;
    for (const Halfspace& h : halfspaces) {
      const Rational value = h.normal().cast<Rational>().dot(to_rational(x)) + Rational(h.offset());
      FUZZ_CHECK(side_of(h, x) == sign_of(value));
      is_outside = is_outside || value > 0;
    }
    outside += is_outside ? 1 : 0;
  }
  FUZZ_CHECK(count_outside(halfspaces, PointSet(points)) == outside);
}

const FuzzTarget kOrient3d("orient3d", hold_orient3d);
const FuzzTarget kPlaneSide("plane_side", hold_plane_side);

}  // namespace
