// SPDX-License-Identifier: MIT
// overlay.hpp - a surface laid over convex parts: what the union of the parts leaves uncovered,
// and the volumes of both. Every decision is exact. `jobs` are threads, 1 to 256, on which no
// answer depends.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/surface.hpp"

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
                                             const Watch& watch = {}, std::size_t jobs = 1);

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
[[nodiscard]] std::optional<UncoveredSolid> find_uncovered_solid(
    const Surface& surface, const Winding& winding, std::span<const ConvexPart> parts,
    const SurfaceCoverage& coverage, const Watch& watch = {}, std::size_t jobs = 1);

/// The volume of the solid of a closed surface, in cubed length units, as union_volume() gives it:
/// of {winding number != 0}, each point counted once, however often the surface winds about it or
/// crosses itself.
/// @throws Error InvalidArgument unless the surface is closed; Stopped when the watch ends the
/// call.
/// @par Cost  O(n log n) if no two triangles cross; else each triangle is cut where others meet it.
[[nodiscard]] Measured solid_volume(const Surface& surface, long precision, bool exact,
                                    const Watch& watch = {}, std::size_t jobs = 1);

/// The volume of the solid outside of the union, as union_volume() gives it. 0 iff
/// find_uncovered_solid() finds nothing.
/// @throws Error Stopped when the watch ends the call.
/// @par Cost  A sum over the boundary: pieces of triangles outside of the union, and of facets
///            inside the solid; each is cut where triangles cross it.
[[nodiscard]] Measured uncovered_volume(const Surface& surface, const Winding& winding,
                                        std::span<const ConvexPart> parts, long precision,
                                        bool exact, const Watch& watch = {}, std::size_t jobs = 1);

// ---- The parts

/// The volume of the union, as an enclosure of relative width about 2^-precision, and as a fraction
/// on request (which may have tens of thousands of digits).
/// @throws Error Stopped when the watch ends the call.
/// @par Cost  Each facet is cut, in its plane, by the parts that meet it; nothing is cut in space.
[[nodiscard]] Measured union_volume(std::span<const ConvexPart> parts, long precision, bool exact,
                                    const Watch& watch = {}, std::size_t jobs = 1);

/// A point in the interior of both parts, if there is one; touching or flat parts have none.
/// @par Cost  Signs of vertices with respect to facets, mostly in doubles, then clipping of a few
///            facets.
[[nodiscard]] std::optional<RationalPoint> common_interior(const ConvexPart& a,
                                                           const ConvexPart& b);

/// A plane between two parts, half way between the points of both that are farthest beyond it.
struct PlaneBetween {
  IntegerVector3 direction;  ///< From the first part to the second, across the plane. Not zero.
  /// The squared distance that each of them reaches beyond it, in squared length units; 0 if they
  /// lie on different sides.
  Rational squared;
};

/// How far two parts reach beyond the plane across a direction.
[[nodiscard]] PlaneBetween plane_between(const ConvexPart& a, const ConvexPart& b,
                                         IntegerVector3 direction);

/// The plane beyond which two parts reach least. That of a facet of one of them is enough if they
/// do not reach farther than `squared_enough` beyond it; else the hull of all differences of their
/// vertices has the direction among its facets' normals, since the overlap along a direction is the
/// distance of its supporting plane from the origin.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] PlaneBetween plane_between(const ConvexPart& a, const ConvexPart& b,
                                         const Rational& squared_enough, const Watch& watch = {});

/// The numbers to measure beside what is proven of a decomposition.
enum class PartMeasures {
  None,
  Uncovered,  ///< What the parts leave out of the surface and of its solid.
  All,        ///< Also union, excess and overlap, and how far the parts lie from the input.
};

/// The volumes of parts and of the solid that a surface encloses.
struct DecompositionMeasures {
  /// Of the surface; none if it encloses none, or if parts of Cut are asked for Uncovered only.
  std::optional<Measured> solid_volume;
  std::optional<Measured> uncovered_volume;  ///< Of the solid outside of the union.
  // Of PartMeasures::All only:
  std::optional<Measured> excess_volume;  ///< Of the union outside of the solid.
  std::optional<Measured> union_volume;
  std::optional<Measured> overlap_volume;  ///< What the parts' volumes add up to, less the union's.
};

// ---- How far a surface and a union of convex parts are from each other: exactly for points,
// against a tolerance by subdivision, and as an enclosure of the Hausdorff distance.

// ---- Points

/// The part that is nearest to a point, and the nearest point of that part.
struct NearestPart {
  std::size_t part;       ///< The lowest one on a tie.
  RationalPoint nearest;  ///< The unique point of that part nearest to x; x itself if in the part.
  Rational squared;       ///< Exact squared distance of x to the union, in squared length units.
};

/// Distances of points to the union of convex parts of any dimension: solids, polygons, segments
/// and points. Any threads may ask at the same time.
class UnionDistance {
 public:
  /// Keeps a reference to the parts. @throws Error InvalidArgument if there is none.
  explicit UnionDistance(std::span<const ConvexPart> parts);
  ~UnionDistance();

  std::span<const ConvexPart> parts() const;

  /// @par Cost  Bounds in doubles for each part whose box may be the nearest; exact numbers only
  ///            for the parts that their bounds do not exclude.
  NearestPart operator()(const RationalPoint& x) const;

  /// The point of one part nearest to x, exactly; x itself if in the part.
  RationalPoint nearest_in(std::size_t part, const RationalPoint& x) const;

 private:
  class Search;
  std::unique_ptr<const Search> search_;
};

// ---- The surface, seen from the union

/// A point of the surface that is not in the union.
struct FarPoint {
  TriangleId triangle;  ///< The triangle that it lies on.
  RationalPoint point;
  NearestPart nearest;
};

/// The one of the corners and centroids of the pieces that is farthest from the union, as far as
/// bounds in doubles tell (they differ by about 2^-46 of the diameter); its own distance is exact
/// and not zero. The first one on a tie. Nothing if there is no piece.
/// @param uncovered  From find_uncovered().
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] std::optional<FarPoint> farthest_found(std::span<const UncoveredPiece> uncovered,
                                                     const UnionDistance& distance,
                                                     const Watch& watch = {});

enum class Reach {
  Within,     ///< No point of the surface is farther from the union than the tolerance.
  Beyond,     ///< The witness is farther.
  Undecided,  ///< The largest distance is so near the tolerance that subdivision did not decide.
};

/// low <= x <= high, of the square of a distance.
struct SquaredBracket {
  Rational low, high;
};

struct WithinDistance {
  Reach reach = Reach::Within;
  /// Beyond: a point farther than the tolerance. Undecided: the farthest one that was found.
  std::optional<FarPoint> witness;
  /// Undecided: bounds of the largest squared distance of the surface to the union;
  /// low <= squared tolerance < high.
  std::optional<SquaredBracket> bracket;
};

/// Whether no point of the pieces is farther than T from the union. A piece is within T if all its
/// corners are within T of one and the same part, because a dilated convex set is convex; a corner
/// farther than T from all parts is a witness; other pieces are bisected. Every comparison is
/// exact, and at a distance of exactly T a point is within. Undecided if a piece with sides shorter
/// than T 2^-20 is neither, or if kReachPieces pieces did not suffice.
/// @param uncovered          From find_uncovered(); what it leaves out has distance 0.
/// @param squared_tolerance  T^2 >= 0, in squared length units.
/// @throws Error InvalidArgument if squared_tolerance < 0; Stopped when the watch ends the call.
[[nodiscard]] WithinDistance is_within(std::span<const UncoveredPiece> uncovered,
                                       const UnionDistance& distance,
                                       const Rational& squared_tolerance, const Watch& watch = {});

/// The largest number of bisections of is_within(), and of each directed distance.
inline constexpr std::size_t kReachPieces = std::size_t{1} << 17;

// ---- Directed Hausdorff distances

/// Branch and bound ends when the bounds of a directed distance differ by the diameter divided by
/// this, or when kReachPieces bisections are spent; then they differ by more.
inline constexpr long kDistanceSteps = 1024;

/// The largest distance of a point of one set to the other set.
struct DirectedDistance {
  Enclosure bounds;                 ///< In length units, not squared.
  std::optional<RationalPoint> at;  ///< A point of the one set whose distance is about the lower
                                    ///< bound; nothing if that is 0.
};

/// Largest distance of a point of the surface to the union; 0 if nothing is uncovered.
/// @param uncovered         From find_uncovered().
/// @param squared_diameter  > 0, of the set that the caller compares distances with.
/// @throws Error InvalidArgument if squared_diameter <= 0; Stopped when the watch ends the call.
[[nodiscard]] DirectedDistance surface_to_union(std::span<const UncoveredPiece> uncovered,
                                                const UnionDistance& distance,
                                                const Rational& squared_diameter,
                                                const Watch& watch = {});

/// Largest distance of a point of the union to the surface and, if it is closed, the solid that it
/// bounds. Such a point may lie inside of a part, in a void of the solid.
/// @param parts             At least one.
/// @param surface           With a triangle.
/// @param winding           Of the surface; null if it is open, and distances inside count as well.
/// @param squared_diameter  > 0, of the set that the caller compares distances with.
/// @throws Error InvalidArgument if there is no part, no triangle, or squared_diameter <= 0;
///               Stopped when the watch ends the call.
/// @par Cost  Bounds in doubles of the distances of points to triangles, found by a tree of boxes;
///            winding numbers of those points that are farther from the surface than any before.
[[nodiscard]] DirectedDistance union_to_surface(std::span<const ConvexPart> parts,
                                                const Surface& surface, const Winding* winding,
                                                const Rational& squared_diameter,
                                                const Watch& watch = {}, std::size_t jobs = 1);

}  // namespace convexact
