// SPDX-License-Identifier: MIT
// plane_between(): how far two convex parts reach into one another.
#include <algorithm>

#include "convexact/overlay.hpp"

namespace convexact {
namespace {

Rational along(const IntegerVector3& direction, const RationalPoint& x) {
  Rational sum = 0;
  for (int k = 0; k < 3; ++k) sum += Rational(direction[k]) * x[k];
  return sum;
}

// Half of what they have in common along a direction, squared.
Rational squared_push(const Rational& overlap, const IntegerVector3& direction) {
  if (overlap <= 0) return 0;
  return overlap * overlap / Rational(4 * direction.squaredNorm());
}

// An axis along which the boxes do not overlap.
std::optional<IntegerVector3> axis_between(const BoundingBox& a, const BoundingBox& b) {
  for (int k = 0; k < 3; ++k) {
    IntegerVector3 axis = IntegerVector3::Zero();
    axis[k] = 1;
    if (a.high[k] <= b.low[k]) return axis;
    if (b.high[k] <= a.low[k]) return IntegerVector3(-axis);
  }
  return {};
}

}  // namespace

PlaneBetween plane_between(const ConvexPart& a, const ConvexPart& b, IntegerVector3 direction) {
  Rational high = along(direction, a.vertices.front()), low = along(direction, b.vertices.front());
  for (const RationalPoint& x : a.vertices) high = std::max(high, along(direction, x));
  for (const RationalPoint& x : b.vertices) low = std::min(low, along(direction, x));
  Rational squared = squared_push(Rational(high - low), direction);
  return {std::move(direction), std::move(squared)};
}

PlaneBetween plane_between(const ConvexPart& a, const ConvexPart& b, const Rational& squared_enough,
                           const Watch& watch) {
  if (auto axis = axis_between(a.box, b.box)) return {std::move(*axis), 0};
  for (const bool is_first : {true, false}) {
    for (const Halfspace& facet : (is_first ? a : b).halfspaces) {
      watch.ask();
      const IntegerVector3& normal = facet.normal();
      PlaneBetween plane = plane_between(a, b, is_first ? normal : IntegerVector3(-normal));
      if (plane.squared <= squared_enough) return plane;
    }
  }
  std::vector<RationalPoint> differences;
  for (const RationalPoint& x : a.vertices) {
    for (const RationalPoint& y : b.vertices) differences.emplace_back(x - y);
  }
  const ConvexPart hull = convex_part(PointSet(std::move(differences)), watch);
  std::optional<PlaneBetween> least;
  for (const Halfspace& facet : hull.halfspaces) {
    // n.(x - y) <= -d
    const IntegerVector3& normal = facet.normal();
    Rational squared = squared_push(Rational(-facet.offset()), normal);
    if (!least || squared < least->squared) least = {normal, std::move(squared)};
  }
  return std::move(*least);
}

}  // namespace convexact
