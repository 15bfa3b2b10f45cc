// SPDX-License-Identifier: MIT
// simplify_points.hpp - an exact simplification of points, with the dual hull from the definition.
#pragma once
#include "definitional_dual.hpp"
#include "simplify/exact_engine.hpp"

/// The mean of the solid's vertices: strictly inside.
inline convexact::RationalPoint center_of(const convexact::DualHull& solid) {
  convexact::RationalPoint sum = convexact::RationalPoint::Zero();
  for (const convexact::RationalPoint& v : solid.vertices) sum += v;
  return sum / convexact::Rational(solid.vertices.size());
}

inline convexact::DualHull dual_of_doubles(const std::vector<convexact::Point>& points) {
  std::vector<convexact::RationalPoint> exact;
  for (const convexact::Point& p : points) exact.push_back(convexact::to_rational(p));
  return definition::dual_of_points(exact);
}

inline convexact::Run simplify_points(const std::vector<convexact::Point>& points,
                                      const convexact::SimplifyOptions& options = {}) {
  const convexact::DualHull solid = dual_of_doubles(points);
  return convexact::simplify_exact(solid, center_of(solid), options);
}
