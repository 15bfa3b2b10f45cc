// SPDX-License-Identifier: MIT
// union_distance.hpp - how far a surface and a union of convex parts are from each other: exactly
// for points, against a tolerance by subdivision, and as an enclosure of the Hausdorff distance.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "convexact/number.hpp"
#include "convexact/overlay.hpp"
#include "convexact/point_set.hpp"
#include "convexact/surface.hpp"
#include "convexact/watch.hpp"

namespace convexact {

// ---- Points

/// The part that is nearest to a point, and the nearest point of that part.
struct NearestPart {
  std::size_t part;       ///< The lowest one on a tie.
  RationalPoint nearest;  ///< The unique point of that part nearest to x; x itself if in the part.
  Rational squared;       ///< Exact squared distance of x to the union, in squared length units.
};

/// Distances of points to the union of convex parts of any dimension: solids, polygons, segments
/// and points. Not for several threads at once.
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
                                                const Watch& watch = {});

}  // namespace convexact
