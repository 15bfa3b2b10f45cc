// SPDX-License-Identifier: MIT
// hull.hpp - the exact convex hull, and the check of its certificate.
//
// convex_hull() decides every sign exactly, so no input is too degenerate: points that span no
// volume give the point, line or plane that holds them. check_hull() proves a hull in linear time.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// Facets as cycles of corners in one flat array; facet f is corners [start[f], start[f+1]).
class FacetList {
 public:
  std::size_t size() const { return starts_.size() - 1; }
  std::span<const PointId> operator[](std::size_t facet) const {
    return {corners_.data() + starts_[facet], corners_.data() + starts_[facet + 1]};
  }
  std::size_t corner_count() const { return corners_.size(); }
  void push_back(std::span<const PointId> corners) {
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    starts_.push_back(static_cast<std::uint32_t>(corners_.size()));
  }

 private:
  std::vector<std::uint32_t> starts_{0};
  std::vector<PointId> corners_;
};

/// Proof that `point` adds nothing: it lies in the tetrahedron of the interior point and the three
/// input points `triangle` (or on its boundary).
struct InsideProof {
  PointId point;
  std::array<PointId, 3> triangle;
};

/// The data that check_hull() needs besides the surface; see docs/design/hull.md.
struct HullCertificate {
  /// Four input points that span a volume; their centroid, or a double near it, is the interior
  /// point.
  std::array<PointId, 4> simplex;
  /// One entry for each input point that is not extreme, in the order in which the construction
  /// discarded the points: a triangle's corners are extreme or discarded later. A repeat of an
  /// extreme point names it in all three corners.
  std::vector<InsideProof> inside;
};

/// The convex hull of n points that span a volume.
struct Hull {
  std::vector<PointId> vertices;  ///< The extreme points, ascending; of equal points the lowest id.
  /// Maximal facets: counter-clockwise from outside, corners extreme, starting at the lowest id.
  FacetList facets;
  HullCertificate certificate;
};

/// Proof that n points span no volume. `dimension` is -1 (no points), 0, 1 or 2.
struct FlatInput {
  int dimension;
  std::vector<PointId> basis;        ///< dimension + 1 affinely independent points.
  std::vector<Halfspace> equations;  ///< 3 - dimension independent planes that hold every point.
};

using HullOutcome = std::variant<Hull, FlatInput>;

class HullObserver;

struct HullOptions {
  /// Seed of the insertion order; the hull does not depend on it.
  std::uint64_t seed = 1;
  /// Points are inserted furthest first until e n log2(n) steps are spent, the rest in random
  /// order. At least 0; 0 is random order from the start.
  double furthest_first_effort = 8;
  std::size_t jobs = 1;              ///< Threads, 1 to 256; the hull does not depend on them.
  Watch watch = {};                  ///< Ends it: Error Stopped.
  HullObserver* observer = nullptr;  ///< Of our lessons; null for none.
};

/// Exact hull by randomised incremental insertion with a conflict graph.
/// @par Cost    Expected O(n log n) time, O(n) memory.
/// @par Source  [ClarksonShor1989], [deBerg2008, sec. 11.2]
[[nodiscard]] HullOutcome convex_hull(const PointSet& points, const HullOptions& options = {});

/// Checks a hull against its points in linear time. It shares the points, their exact predicates
/// and the filters of these with convex_hull(), and no code of the construction.
/// @par Source  [Mehlhorn1999]
[[nodiscard]] bool check_hull(const Hull& hull, const PointSet& points);
[[nodiscard]] bool check_flat(const FlatInput& flat, const PointSet& points);

/// The halfspaces of a hull, one per facet, in the order of the facets (not canonical).
[[nodiscard]] std::vector<Halfspace> facet_halfspaces(const Hull& hull, const PointSet& points);

/// The corners of each facet, as the polygons of a Mesh of the same points.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> polygons_of(const FacetList& facets);

/// The hull as a polytope: vertices in the order of hull.vertices, facets in canonical order.
[[nodiscard]] Polytope to_polytope(const Hull& hull, const PointSet& points);

/// The hull of rational points n / w in homogeneous integers; ids are indices. Mainly for dual
/// points, whose extreme ones are the halfspaces that are not redundant.
/// @throws Error InvalidArgument if some w <= 0.
[[nodiscard]] HullOutcome convex_hull(std::span<const HomogeneousPoint> points,
                                      const HullOptions& options = {});

/// check_hull() for homogeneous points.
[[nodiscard]] bool check_hull(const Hull& hull, std::span<const HomogeneousPoint> points);

}  // namespace convexact
