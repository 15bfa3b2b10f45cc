// SPDX-License-Identifier: MIT
// compared_hulls.hpp - hulls as the methods of comparison see them, and methods by name.
#pragma once
#include <doctest/doctest.h>

#include <string_view>
#include <utility>
#include <vector>

#include "convexact/geometry.hpp"
#include "lab/compare/refit.hpp"

namespace support {

/// A hull with all that a refit needs. It stays where it is.
struct ComparedHull {
  explicit ComparedHull(convexact::PointSet points)
      : solid(solid_of(std::move(points))),
        hull(convexact::hull_to_fit(solid)),
        measures(convexact::measures_of(solid.polytope)) {}
  explicit ComparedHull(std::vector<convexact::Point> points)
      : ComparedHull(convexact::PointSet(std::move(points))) {}
  ComparedHull(const ComparedHull&) = delete;
  ComparedHull& operator=(const ComparedHull&) = delete;

  convexact::RefitOutcome fit(const convexact::Normals& normals) const {
    return convexact::refit(hull, measures, normals, 1);
  }

  convexact::RefitOutcome inside(const convexact::HullCorners& corners) const {
    return convexact::hull_of_corners(hull, measures, corners, 1);
  }

  convexact::Solid solid;
  convexact::HullToFit hull;
  convexact::HullMeasures measures;

 private:
  static convexact::Solid solid_of(convexact::PointSet points) {
    convexact::StageLog log;
    return std::get<convexact::Solid>(convexact::make_solid(points, {}, log));
  }
};

inline const convexact::Method& method(std::string_view name) {
  for (const convexact::Method& each : convexact::methods()) {
    if (each.name == name) return each;
  }
  FAIL("no method of that name");
  return convexact::methods().front();
}

/// The solid of a method that must find one.
inline convexact::Refit refit_of(const ComparedHull& compared, std::string_view name,
                                 std::size_t faces = 18, std::uint64_t seed = 1) {
  auto outcome = compared.fit(method(name).propose(compared.hull, faces, seed));
  REQUIRE(std::holds_alternative<convexact::Refit>(outcome));
  return std::get<convexact::Refit>(std::move(outcome));
}

}  // namespace support
