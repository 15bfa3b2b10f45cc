// SPDX-License-Identifier: MIT
#include "lab/compare/refit.hpp"

#include <algorithm>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "convexact/stored.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"

namespace convexact {
namespace {

// The halfspace of this direction that touches the hull from outside.
Halfspace touching(const Polytope& hull, const RationalVector3& direction) {
  const IntegerVector3 n = primitive_direction(clear_denominators(direction).n);
  const RationalVector3 normal = n.cast<Rational>();
  Rational support = normal.dot(hull.vertices.front());
  for (const RationalPoint& vertex : hull.vertices) {
    support = std::max<Rational>(support, normal.dot(vertex));
  }
  return {normal, -support};
}

Polytope solid_of(const std::vector<Halfspace>& halfspaces, std::uint64_t seed) {
  StageLog log;
  auto made = make_polytope(halfspaces, seed, log);
  if (std::holds_alternative<NotSolid>(made)) {
    throw Error(ErrorCode::Internal, "bounded halfspaces around a hull bound no solid");
  }
  return std::get<Polytope>(std::move(made));
}

// `distance` is the one between the solid and the hull.
Refit refit_of(Polytope solid, const HausdorffDistance& distance, const HullMeasures& measures,
               const Watch& watch) {
  const HullMeasures after = measures_of(solid, watch);
  return Refit{.solid = std::move(solid),
               .volume_ratio = after.volume / measures.volume,
               .area_ratio = after.area / measures.area,
               .mean_width_ratio = after.mean_width / measures.mean_width,
               .squared_distance_ratio = distance.squared / measures.squared_diameter};
}

}  // namespace

HullMeasures measures_of(const Polytope& hull, const Watch& watch) {
  return {volume(hull), surface_area(hull, kMeasureBits, watch),
          mean_width(hull, kMeasureBits, watch), bounding_box(hull.vertices).squared_diameter()};
}

Ratios ratios_of(const Refit& refit) {
  const auto middle = [](const Enclosure& x) {
    return to_double(Rational((x.low() + x.high()) / 2), Rounding::Nearest);
  };
  return {to_double(refit.volume_ratio, Rounding::Nearest), middle(refit.area_ratio),
          middle(refit.mean_width_ratio),
          middle(sqrt(Enclosure(refit.squared_distance_ratio, kMeasureBits)))};
}

RefitOutcome refit(const HullToFit& hull, const HullMeasures& measures, const Normals& directions,
                   std::uint64_t seed) {
  // (1) Touching halfspaces, each once.
  std::vector<Halfspace> halfspaces;
  for (const RationalVector3& direction : directions) {
    hull.watch.ask();
    if (direction.isZero()) throw Error(ErrorCode::InvalidArgument, "a direction is zero");
    halfspaces.push_back(touching(hull.polytope(), direction));
  }
  std::sort(halfspaces.begin(), halfspaces.end());
  halfspaces.erase(std::unique(halfspaces.begin(), halfspaces.end()), halfspaces.end());
  // (2) Bounded or not.
  const BoundedOutcome bounded = find_recession(halfspaces);
  if (const auto* ray = std::get_if<RecessionRay>(&bounded)) return *ray;
  // (3) The solid without redundant halfspaces; it holds every point.
  Polytope solid = solid_of(halfspaces, seed);
  if (count_outside(solid.planes, hull.solid.points) != 0) {
    throw Error(ErrorCode::Internal, "a refitted solid misses a point of the input");
  }
  // (4) Its measures.
  const HausdorffDistance distance = hausdorff_distance(solid, hull.polytope(), hull.watch);
  return refit_of(std::move(solid), distance, measures, hull.watch);
}

RefitOutcome hull_of_corners(const HullToFit& hull, const HullMeasures& measures,
                             HullCorners corners, std::uint64_t seed) {
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<RationalPoint> selected;
  for (const std::uint32_t corner : corners) {
    if (corner >= hull.polytope().vertices.size()) {
      throw Error(ErrorCode::InvalidArgument, "the hull has no such vertex");
    }
    selected.push_back(hull.polytope().vertices[corner]);
  }
  if (selected.size() < 4) return FlatSelection{};
  const PointSet points(std::move(selected));
  const HullOutcome outcome = convex_hull(points, {.seed = seed, .watch = hull.watch});
  const auto* found = std::get_if<Hull>(&outcome);
  if (found == nullptr) return FlatSelection{};
  if (count_outside(hull.polytope().planes, points) != 0) {
    throw Error(ErrorCode::Internal, "a selected vertex is outside of the hull");
  }
  Polytope solid = to_polytope(*found, points);
  const HausdorffDistance distance = hausdorff_distance(hull.polytope(), solid, hull.watch);
  return refit_of(std::move(solid), distance, measures, hull.watch);
}

}  // namespace convexact
