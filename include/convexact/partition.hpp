// SPDX-License-Identifier: MIT
// partition.hpp - a solid cut by planes into convex leaves that hold it, none of which reaches far
// from it.  docs/design/cutting.md has the method and why the leaves hold the solid.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/overlay.hpp"
#include "convexact/reach.hpp"
#include "convexact/surface.hpp"

namespace convexact {

/// A region of space: the box around everything, cut by the planes on the way from the root.
struct PartitionNode {
  std::optional<std::uint32_t> parent;  ///< None: the root.
  /// Of a node that was cut: the plane, and the nodes of what lies within its halfspace and of what
  /// lies beyond.
  std::optional<Halfspace> plane = {};
  std::array<std::uint32_t, 2> children = {};
  /// The triangles with a piece in the plane that went beyond: the solid is only there.
  std::vector<TriangleId> raised = {};
};

/// A region that is not cut any more, and what the solid has in it.
struct PartitionLeaf {
  std::uint32_t node;
  /// The triangles of which it holds a piece, ascending. Each piece with an area is in one leaf.
  std::vector<TriangleId> triangles;
  /// The extreme points of the hull of these pieces and of the region's corners inside of the
  /// solid, exactly. The hull holds all that the interiors of the solid and of the region have in
  /// common.
  PointSet corners;
  bool is_flat = false;   ///< Whether that hull has no volume.
  bool is_within = true;  ///< Proven to be within the limit.
};

struct Partition {
  std::vector<PartitionNode> nodes;   ///< Parents first.
  std::vector<PartitionLeaf> leaves;  ///< Those that hold something, in the order of their nodes.
  bool stopped_by_count = false;      ///< Whether `max_leaves` ended the run.
  Rational squared_limit, squared_diameter;  ///< Of the distance, and of the surface's box.
  std::size_t planes_tried = 0;
};

/// Which planes may cut.
enum class CutPlanes {
  /// Those of facets at notches, those between these, and some through the farthest point.
  All,
  /// Those of facets, which the input says exactly, those at notches first.
  Facets,
  /// Those between facets at notches, and some through the farthest point where none of these cuts.
  /// Rings are cut across, not along chords.
  Bisectors,
};

struct PartitionOptions {
  std::optional<std::size_t> max_leaves = {};
  /// Decide each sign in exact numbers, without bounds in doubles.
  bool is_exact = false;
  CutPlanes planes = CutPlanes::All;
  /// Threads, at least 1. The cuts are the same for any number of them.
  std::size_t jobs = 1;
  Watch watch = {};
};

/// Cuts the leaf that reaches farthest from the solid, again and again, until all are within the
/// limit, or none that is not can be cut.
/// @param winding  Of the surface; null if it is open.
/// @param limit    Of the surface.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] Partition cut(const Surface& surface, const Winding* winding, ReachLimit& limit,
                            const PartitionOptions& options = {});

}  // namespace convexact
