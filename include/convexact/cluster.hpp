// SPDX-License-Identifier: MIT
// cluster.hpp - triangles merged into clusters of small concavity, or split at notches.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/number.hpp"
#include "convexact/overlay.hpp"
#include "convexact/run.hpp"
#include "convexact/surface.hpp"

namespace convexact {

// ---- The triangles of a surface as few connected clusters of small concavity, by merging pairs of
// neighbours; every decision is exact, or is reported as not exact.  docs/design/clustering.md has
// the method, its source [MamouGhorbel2009], and what is ours.

// ---- Concavity

/// The points of a cluster at which its concavity is taken.
enum class ConcavityMeasure {
  Surface,   ///< At all points of its triangles, along their normals.
  Vertices,  ///< At the corners of its triangles, along the normals of these: the sum of the area
             ///< vectors of all triangles of the surface at that point.
};

/// How far a cluster lies below its convex hull: the largest distance that a ray from one of its
/// points along the outward normal there runs inside the hull.
struct Concavity {
  Rational squared = 0;   ///< In squared length units; 0 where the ray leaves at once.
  TriangleId triangle;    ///< The triangle of the point; among equal distances the lowest one.
  RationalPoint at;       ///< The point M, on that triangle.
  RationalPoint leaves;   ///< Where the ray from M leaves the hull: |leaves - at|^2 = squared.
  IntegerVector3 normal;  ///< The direction of the ray; 0 if the point has none.
};

/// Concavities by the definition, one linear program for each triangle: the reference that the
/// filtered engine is compared with.
class ExactConcavity {
 public:
  /// Keeps a reference.
  ExactConcavity(const Surface& surface, ConcavityMeasure measure);

  /// The concavity of a cluster of at least one triangle. It never falls when a cluster grows.
  /// @param hull  convex_part() of the cluster's points.
  /// @par Cost    For each triangle a ray, and a linear program of three variables unless one plane
  ///              shows that another triangle's rays are longer; by Vertices a ray for each corner.
  [[nodiscard]] Concavity operator()(std::span<const TriangleId> cluster, const ConvexPart& hull,
                                     const Watch& watch = {}) const;

  /// The concavity of one triangle, at all of its points; by Vertices, at its corners.
  [[nodiscard]] Concavity operator()(TriangleId triangle, const ConvexPart& hull) const;

  /// The direction in which concavity is taken at corner k of a triangle: an integer multiple of
  /// its normal, or of the normal of the corner. 0 if it has none.
  [[nodiscard]] IntegerVector3 direction(TriangleId triangle, int k) const;

  /// By Surface: whether one plane shows that no ray of the triangle is longer than the root of
  /// `squared`.
  [[nodiscard]] bool is_no_longer(TriangleId triangle, const ConvexPart& hull,
                                  const Rational& squared) const;

 private:
  const Surface* surface_;
  ConcavityMeasure measure_;
  std::vector<IntegerVector3> normals_;  // by point; none by Surface
};

/// The points of a cluster, ascending, each once.
[[nodiscard]] std::vector<PointId> points_of(const Surface& surface,
                                             std::span<const TriangleId> cluster);

// ---- Neighbours

/// Which triangles are neighbours, besides those with a common edge.
enum class Connect {
  Edge,      ///< None.
  Overlap,   ///< Those that have edges with a common segment of positive length.
  Touching,  ///< Those of Overlap, and those of different components that have a common point.
};

/// All pairs of neighbours, the lower triangle first, ascending, each once.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] std::vector<std::pair<TriangleId, TriangleId>> neighbours(const Surface& surface,
                                                                        Connect connect,
                                                                        const Watch& watch = {});

// ---- Clusters

/// The largest concavity allowed.
struct ConcavityLimit {
  Rational value{3, 100};  ///< At least 0; a share is at most 1.
  bool is_share =
      true;  ///< A share of the diameter, the diagonal of the surface's box; else a length.

  /// The square of the limit as a length. @param squared_diameter  Of the surface's points.
  [[nodiscard]] Rational squared(const Rational& squared_diameter) const;
};

/// Whether a cluster of these triangles may be made at all, besides the limit of concavity. What
/// holds a cluster that was refused must be refused, too; then it need not be asked about.
using ClusterGuard = std::function<bool(std::span<const TriangleId> triangles)>;

struct ClusterOptions {
  ConcavityLimit limit = {};
  /// Asked about each merge when its turn has come. Merges for `max_parts` alone are made anyway.
  ClusterGuard guard = {};
  /// When no merge is within the limit any more, go on merging by least concavity until only this
  /// many clusters are left; >= 1. Clusters of different groups of neighbours are never merged.
  std::optional<std::size_t> max_parts = {};
  ConcavityMeasure measure = ConcavityMeasure::Surface;
  Connect connect = Connect::Edge;
  Engine engine = Engine::Filtered;
  /// Make each merge. Otherwise, with the filtered engine, a group of neighbours that is certain to
  /// be within the limit as a whole is one cluster at once: the merges would end there, as
  /// concavity never falls when a cluster grows.
  bool every_merge = true;
  /// Fill in the concavity and the cost of each merge.
  bool costs = false;
  /// Fill in Clustering::further_merges, for a tree.
  bool further = false;
  /// Reports merges as progress. It can end a long run with Error Stopped.
  Watch watch = {};
};

/// Two neighbouring clusters become one. A cluster is named by its lowest triangle.
struct Merge {
  TriangleId kept, gone;  ///< kept < gone.
  /// Other pairs of neighbours whose cost was the same; of equal ones the lowest (kept, gone) is
  /// merged.
  std::size_t ties = 0;
  /// Why they count as equal: EqualRationals of two concavities beyond the limit, SquareClasses of
  /// two costs, or Undecided.
  TieEvidence tie_evidence = {};
  bool beyond_limit = false;  ///< Made for `max_parts`, by least concavity.
  /// If asked for: the squared concavity of the union, and E D, which the method keeps small
  /// (docs/design/clustering.md).
  std::optional<Rational> squared_concavity = {};
  std::optional<Enclosure> cost = {};

  /// The same decision; how it was reached is not compared.
  friend bool operator==(const Merge& a, const Merge& b) {
    return a.kept == b.kept && a.gone == b.gone && a.ties == b.ties &&
           a.beyond_limit == b.beyond_limit;
  }
};

/// A partition of the triangles of a surface, and how it came about.
struct Clustering {
  /// Each list is ascending; the clusters are in the order of their lowest triangles.
  std::vector<std::vector<TriangleId>> clusters;
  /// Triangles without area, each with the triangle over its longest edge to whose cluster it was
  /// added before the first merge.
  std::vector<std::pair<TriangleId, TriangleId>> united;
  std::vector<Merge> merges;
  /// If asked for: the further merges by least concavity that would follow, until each group of
  /// neighbours is one cluster.
  std::vector<Merge> further_merges;
  bool stopped_by_count = false;  ///< Whether `max_parts` ended the run, not the limit.
  std::size_t whole_groups = 0;   ///< Within the limit as a whole, without their merges.
  std::size_t refused = 0;        ///< Merges that the guard refused when their turn had come.
  Rational squared_limit, squared_diameter;
  /// How often the concavity of a pair was bounded or computed, and how often in exact numbers.
  std::size_t evaluations = 0, exact_evaluations = 0;
};

/// The number of groups of triangles that chains of neighbours connect: no clustering has fewer
/// clusters.
[[nodiscard]] std::size_t count_groups(const Surface& surface,
                                       std::span<const std::pair<TriangleId, TriangleId>> pairs);

/// Starts with a cluster for each triangle and merges, one after another, the two neighbours of
/// least cost whose union is not more concave than the limit, until there are none; then, for
/// `max_parts`, those whose union is least concave.
/// @throws Error InvalidArgument for a limit out of its range, and if there are more groups than
///               `max_parts`, naming their number; Stopped when the watch ends the call.
/// @par Cost     A hull and a bound for each triangle of two clusters, once or twice per triangle
///               of the surface; the exact engine: at each merge, for each pair at the merged
///               cluster.
/// @par Source   [MamouGhorbel2009]
[[nodiscard]] Clustering cluster(const Surface& surface, const ClusterOptions& options = {});

// ---- The triangles of a surface as a tree of connected leaves of small concavity, by splitting
// the most concave one at its deepest notch; every decision is exact.  docs/design/splitting.md has
// the method, its source [Backenhof2011], and what is ours.

/// The bridge to which the distance of a point of a part is measured.
enum class BridgeChoice {
  Farther,  ///< The farthest of the bridges of the nearest point on a path.
  Region,   ///< The bridge that most points around its region have; on a path, the nearest.
  Nearer,   ///< The nearest of the bridges of the nearest point on a path.
};

struct SplitOptions {
  ConcavityLimit limit = {};
  /// A leaf that it refuses is split as if it were too concave; if its notch does not divide it, at
  /// the edge where it is most concave.
  ClusterGuard guard = {};
  std::optional<std::size_t> max_parts = {};  ///< Stop splitting at this many leaves; >= 1.
  BridgeChoice bridge = BridgeChoice::Farther;
  /// Facets are joined to one bridge over an edge if the cosine of the angle between their normals
  /// is larger; above 0, at most 1.
  Rational coplanar{99, 100};
  Connect connect = Connect::Edge;
  bool associations = false;  ///< Fill in SplitNode::association, for a trace.
  /// Reports the triangles of finished leaves as progress. It can end a long run with Error
  /// Stopped.
  Watch watch = {};
};

/// An edge of the hull of a part between two bridges, projected onto the mesh.
struct BridgePath {
  std::array<std::uint32_t, 2> bridges;  ///< Ascending.
  /// Along edges of the mesh, from the lower end of the hull's edge to the other one. Only these
  /// two ends if the edge spans a hole of the mesh, or if no path leads from one to the other.
  std::vector<PointId> points;
  bool spans_hole = false;
  bool is_joined = true;  ///< Whether there is a path, and it was looked for.
};

/// How the points of a part belong to the bridges over it.
struct Association {
  using Facet = std::vector<PointId>;  ///< Counter-clockwise from outside, from the lowest id.
  /// Each ascending; by their first facets. None if the hull is flat.
  std::vector<std::vector<Facet>> bridges;
  std::vector<BridgePath> paths;  ///< By the ends of the hull's edges.
  std::vector<PointId> points;    ///< Of the part, ascending.
  /// By point: its bridges, ascending. A point without any is measured to the nearest facet.
  std::vector<std::vector<std::uint32_t>> bridges_of;
};

/// A part, or a branch, of the tree.
struct SplitNode {
  std::optional<std::uint32_t> parent;    ///< None of a root.
  std::array<std::uint32_t, 2> children;  ///< If it was split: nodes, both above this one.
  TriangleId lowest;                      ///< Of its triangles.
  std::size_t triangle_count = 0;
  /// The distance of its deepest point, the *notch*, to its bridge: of equal ones the lowest. `at`
  /// is that point, `leaves` the nearest point of the bridge, `triangle` the lowest one at it.
  /// A point has none if all triangles of the part at it lie on the hull.
  Concavity concavity;
  PointId notch;  ///< If the concavity is not 0.
  std::optional<Association> association;
  bool is_split = false;
};

enum class LeafStatus {
  WithinLimit,
  MaxParts,      ///< Too concave, or refused, but there were as many leaves as allowed.
  Unsplittable,  ///< Too concave, or refused, but no plane through a notch leaves something on both
                 ///< sides.
};

struct SplitLeaf {
  std::uint32_t node;
  LeafStatus status;
  std::vector<TriangleId> triangles;  ///< Ascending.
  /// The largest distance of a point to the nearest facet of the hull, squared: no association of
  /// points to facets gives a smaller concavity.
  Rational least_squared_concavity;
};

/// How a node was divided: by a plane through an edge at its notch.
struct Split {
  std::uint32_t node;
  std::array<PointId, 2> edge;    ///< The notch, and the other end.
  Halfspace plane;                ///< The moved triangles are beyond it.
  std::size_t refused = 0;        ///< Planes that were tried before, and left nothing on a side.
  std::vector<TriangleId> moved;  ///< Ascending. They and the islands are the second child.
  /// The triangles that were cut off from those that stay at the notch, ascending.
  std::vector<TriangleId> islands;
};

struct SplitTree {
  /// First a root for each group of neighbours, by their lowest triangles; then the children of
  /// each split, first those at the notch that stay, then those that go.
  std::vector<SplitNode> nodes;
  std::size_t roots = 0;
  std::vector<Split> splits;
  std::vector<SplitLeaf> leaves;  ///< By their lowest triangles.
  /// Triangles without area, each with the triangle over its longest edge with which it goes.
  std::vector<std::pair<TriangleId, TriangleId>> united;
  bool stopped_by_count = false;  ///< Whether `max_parts` ended the run.
  std::size_t refused = 0;        ///< Nodes within the limit that the guard refused.
  Rational squared_limit, squared_diameter;
};

/// Starts with a leaf for each group of neighbours and splits, one after another, the most concave
/// one that is beyond the limit and can be split. Ends when there is none, or at `max_parts`
/// leaves.
/// @throws Error InvalidArgument for options out of their range, if there are more groups than
///               `max_parts`, naming their number, and for more than 2^22 points; Stopped when the
///               watch ends the call.
/// @par Cost     For each node a hull, and a path to find for each edge between bridges.
/// @par Source   [Backenhof2011], [LienAmato2007]
[[nodiscard]] SplitTree split(const Surface& surface, const SplitOptions& options = {});

struct BridgeMeasure {
  Concavity concavity;  ///< As SplitNode::concavity.
  PointId notch;        ///< If that is not 0.
  Rational least_squared_concavity;
  Association association;
};

/// How concave one part is by the bridges over it.
/// @param triangles  At least one, ascending.
/// @param options    Only `bridge`, `coplanar` and `watch` count.
/// @throws Error     as split().
[[nodiscard]] BridgeMeasure measure_by_bridges(const Surface& surface,
                                               std::span<const TriangleId> triangles,
                                               const SplitOptions& options = {});

}  // namespace convexact
