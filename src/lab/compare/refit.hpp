// SPDX-License-Identifier: MIT
// refit.hpp - turns directions into a solid that holds the hull, or vertices of the hull into one
// inside, exactly, and measures it.
#pragma once
#include <variant>

#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"
#include "lab/compare/method.hpp"

namespace convexact {

/// The measures of the hull with which solids around it, and those inside, are compared.
struct HullMeasures {
  Rational volume;
  Enclosure area, mean_width;
  Rational squared_diameter;  ///< Of its box.
};

[[nodiscard]] HullMeasures measures_of(const Polytope& hull, const Watch& watch = {});

/// The least solid with facets of the given directions that holds a hull, or the hull of some of
/// its vertices.
struct Refit {
  Polytope solid;
  Rational volume_ratio;  ///< Over the hull's, exact, as the next two are enclosures.
  Enclosure area_ratio, mean_width_ratio;
  /// Hausdorff distance to the hull, over the diameter of its box; squared and exact.
  Rational squared_distance_ratio;
};

/// The measures as doubles, within some units of the last place; the distance is not squared.
struct Ratios {
  double volume, area, mean_width, distance;
};
[[nodiscard]] Ratios ratios_of(const Refit& refit);

/// Selected vertices lie in one plane.
struct FlatSelection {};

/// A solid, or a direction in which the proposed halfspaces leave it open, or why there is none.
using RefitOutcome = std::variant<Refit, RecessionRay, FlatSelection>;

/// Moves the plane of each direction until it touches the hull, drops redundant halfspaces, and
/// proves that the rest is bounded and holds every point of the input.
/// @throws Error InvalidArgument for a direction that is zero; Internal if a proof fails; Stopped.
/// @par Cost  An exact product for each direction and vertex, a solid of that many halfspaces, a
///            sign for each plane and point, and the Hausdorff distance.
[[nodiscard]] RefitOutcome refit(const HullToFit& hull, const HullMeasures& measures,
                                 const Normals& directions, std::uint64_t seed);

/// The hull of the selected vertices. Each is proven to lie in every halfspace of the hull.
/// @throws Error InvalidArgument for a vertex that the hull does not have; Internal if a proof
///         fails; Stopped.
/// @par Cost  A hull of the vertices, a sign for each of them and plane, and the Hausdorff
/// distance.
[[nodiscard]] RefitOutcome hull_of_corners(const HullToFit& hull, const HullMeasures& measures,
                                           HullCorners corners, std::uint64_t seed);

}  // namespace convexact
