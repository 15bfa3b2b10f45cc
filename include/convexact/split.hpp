// SPDX-License-Identifier: MIT
// split.hpp - the triangles of a surface as a tree of connected leaves of small concavity, by
// splitting the most concave one at its deepest notch; every decision is exact.
//
// docs/design/splitting.md has the method, its source [Backenhof2011], and what is ours.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "convexact/cluster.hpp"
#include "convexact/halfspace.hpp"
#include "convexact/surface.hpp"
#include "convexact/watch.hpp"

namespace convexact {

/// The bridge to which the distance of a point of a part is measured.
enum class BridgeChoice {
  Farther,  ///< The farthest of the bridges of the nearest point on a path.
  Region,   ///< The bridge that most points around its region have; on a path, the nearest.
  Nearer,   ///< The nearest of the bridges of the nearest point on a path.
};

struct SplitOptions {
  ConcavityLimit limit = {};
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
  MaxParts,      ///< More concave, but there were as many leaves as allowed.
  Unsplittable,  ///< More concave, but no plane through the notch leaves something on both sides.
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
