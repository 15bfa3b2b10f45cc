// SPDX-License-Identifier: MIT
// checked_hull.hpp - a hull whose certificate holds and that does not depend on the order of
// insertion.
#pragma once
#include <doctest/doctest.h>

#include <set>

#include "convexact/hull.hpp"

inline bool operator==(const convexact::FacetList& a, const convexact::FacetList& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t f = 0; f < a.size(); ++f)
    if (!std::ranges::equal(a[f], b[f])) return false;
  return true;
}

/// The hull of points that span a volume: furthest first, in random order, and with a budget that
/// runs out on the way, all with valid certificates and all the same.
inline convexact::Hull checked_hull(const convexact::PointSet& points) {
  using namespace convexact;
  const HullOutcome outcome = convex_hull(points);
  REQUIRE(std::holds_alternative<Hull>(outcome));
  const Hull& hull = std::get<Hull>(outcome);
  CHECK(check_hull(hull, points));
  for (const HullOptions& options : {HullOptions{1, 0}, HullOptions{2, 0}, HullOptions{3, 0.05}}) {
    CAPTURE(options.seed);
    const Hull other = std::get<Hull>(convex_hull(points, options));
    CHECK(check_hull(other, points));
    CHECK(other.vertices == hull.vertices);
    CHECK(other.facets == hull.facets);
  }
  return hull;
}

inline std::set<convexact::Halfspace> facet_set(const convexact::Hull& hull,
                                                const convexact::PointSet& points) {
  const auto list = facet_halfspaces(hull, points);
  return {list.begin(), list.end()};
}
