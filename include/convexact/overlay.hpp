// SPDX-License-Identifier: MIT
// overlay.hpp - a surface laid over convex parts: what the union of the parts leaves uncovered,
// and the volumes of both. Every decision is exact.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "convexact/halfspace.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/surface.hpp"
#include "convexact/watch.hpp"

namespace convexact {

/// The convex hull of some points, of any dimension: a closed set.
struct ConvexPart {
  int dimension = -1;                   ///< 3; or 2, 1, 0 of a flat part.
  std::vector<RationalPoint> vertices;  ///< Its extreme points.
  /// The part is their intersection. For a flat part, both sides of each plane that holds it are
  /// among them.
  std::vector<Halfspace> halfspaces;
  /// The solid of a part of dimension 3; `vertices` and `halfspaces` are those of this solid.
  std::optional<Polytope> solid;
  BoundingBox box;
};

/// @throws Error InvalidArgument if there is no point; Stopped when the watch ends the call.
[[nodiscard]] ConvexPart convex_part(const PointSet& points, const Watch& watch = {});

/// Whether x lies in the part, its boundary included.
[[nodiscard]] bool holds(const ConvexPart& part, const RationalPoint& x);

/// Whether all points of a part lie in another one, exactly.
[[nodiscard]] bool lies_in(const ConvexPart& inner, const ConvexPart& outer);

// ---- The surface

/// A piece of a triangle that no part covers, except for its boundary: a convex polygon with an
/// area. For a triangle without area: the two ends of a segment, or one point.
struct UncoveredPiece {
  TriangleId triangle;
  std::vector<RationalPoint> corners;  ///< Counter-clockwise like the triangle.
  /// The piece's share of the triangle's area, or of its length; 1 for a point.
  Rational share;
};

struct SurfaceCoverage {
  std::vector<UncoveredPiece> uncovered;  ///< Empty: the union holds every triangle.
  std::size_t in_one_part = 0;            ///< Triangles whose corners lie in one and the same part.
};

/// The pieces of the triangles that lie in no part. Triangle and union are closed, so the rest of
/// the triangle is relatively open: it is empty iff it has no area.
/// @throws Error Stopped when the watch ends the call.
/// @par Cost  Each triangle is cut only by facets of parts that it crosses; corners are pairs of
///            lines, so numbers do not grow with the cuts.
[[nodiscard]] SurfaceCoverage find_uncovered(const Surface& surface,
                                             std::span<const ConvexPart> parts,
                                             const Watch& watch = {});

// ---- The solid

/// A point of the solid that no part holds.
struct UncoveredSolid {
  RationalPoint point;
  long winding;  ///< Of the surface about it: not 0.
};

/// A point of the solid of a closed surface that the union does not hold; nothing if it holds the
/// solid. Looks first at the uncovered pieces of the surface, from find_uncovered(), then at the
/// boundary of the rest of the solid outside the parts, which is empty iff that rest has no volume.
/// Flat parts hold no volume.
/// @param coverage  Only shortens the search: `{}` gives the same verdict.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] std::optional<UncoveredSolid> find_uncovered_solid(const Surface& surface,
                                                                 const Winding& winding,
                                                                 std::span<const ConvexPart> parts,
                                                                 const SurfaceCoverage& coverage,
                                                                 const Watch& watch = {});

/// The volume of the solid of a closed surface, in cubed length units, as union_volume() gives it:
/// of {winding number != 0}, each point counted once, however often the surface winds about it or
/// crosses itself.
/// @throws Error InvalidArgument unless the surface is closed; Stopped when the watch ends the
/// call.
/// @par Cost  O(n log n) if no two triangles cross; else each triangle is cut where others meet it.
[[nodiscard]] Measured solid_volume(const Surface& surface, long precision, bool exact,
                                    const Watch& watch = {});

/// The volume of the solid outside of the union, as union_volume() gives it. 0 iff
/// find_uncovered_solid() finds nothing.
/// @throws Error Stopped when the watch ends the call.
/// @par Cost  A sum over the boundary: pieces of triangles outside of the union, and of facets
///            inside the solid; each is cut where triangles cross it.
[[nodiscard]] Measured uncovered_volume(const Surface& surface, const Winding& winding,
                                        std::span<const ConvexPart> parts, long precision,
                                        bool exact, const Watch& watch = {});

// ---- The parts

/// The volume of the union, as an enclosure of relative width about 2^-precision, and as a fraction
/// on request (which may have tens of thousands of digits).
/// @throws Error Stopped when the watch ends the call.
/// @par Cost  Each facet is cut, in its plane, by the parts that meet it; nothing is cut in space.
[[nodiscard]] Measured union_volume(std::span<const ConvexPart> parts, long precision, bool exact,
                                    const Watch& watch = {});

/// A point in the interior of both parts, if there is one; touching or flat parts have none.
/// @par Cost  Signs of vertices with respect to facets, mostly in doubles, then clipping of a few
///            facets.
[[nodiscard]] std::optional<RationalPoint> common_interior(const ConvexPart& a,
                                                           const ConvexPart& b);

/// The numbers to measure beside what is proven of a decomposition.
enum class PartMeasures {
  None,
  Uncovered,  ///< What the parts leave out of the surface and of its solid.
  All,        ///< Also union, excess and overlap, and how far the parts lie from the input.
};

/// The volumes of parts and of the solid that a surface encloses.
struct DecompositionMeasures {
  std::optional<Measured> solid_volume;      ///< Of the surface; none if it encloses none.
  std::optional<Measured> uncovered_volume;  ///< Of the solid outside of the union.
  // Of PartMeasures::All only:
  std::optional<Measured> excess_volume;  ///< Of the union outside of the solid.
  std::optional<Measured> union_volume;
  std::optional<Measured> overlap_volume;  ///< What the parts' volumes add up to, less the union's.
};

}  // namespace convexact
