// SPDX-License-Identifier: MIT
// inner_run.hpp - the record of an inner run: which vertices of a hull were removed, in which order
// and at what loss of volume.
//
// An inner run works in the opposite direction to simplify(): it removes vertices, so the solid
// shrinks and lies inside the hull of the input. docs/design/inner.md has the reasons.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "convexact/hull.hpp"
#include "convexact/number.hpp"
#include "convexact/point_set.hpp"
#include "convexact/run.hpp"

namespace convexact {

/// Position in VertexHull::points. Polarity makes a halfspace of each vertex, and the hull without
/// a vertex is the polar of the solid without that halfspace; so both kinds of run share their ids
/// and the data structures that hold them.
using VertexId = HalfspaceId;
/// Three vertices, counter-clockwise seen from outside.
using VertexTriangle = DualTriangle;

/// The hull of points as an inner run starts with it.
struct VertexHull {
  /// The extreme points in canonical order: by x, then y, then z, compared exactly. Ties are broken
  /// by this order, so no result depends on the order of the input.
  PointSet points;
  std::vector<PointId> ids;               ///< Of `points` in the input; of equal ones the lowest.
  std::vector<VertexTriangle> triangles;  ///< The facets, cut into 2 points.size() - 4 triangles.
};

/// The facets are cut in a zigzag, so that no vertex gets more than two diagonals of a facet.
/// @param hull  Of `points`. @par Cost  O(n log n) comparisons.
[[nodiscard]] VertexHull vertex_hull(const Hull& hull, const PointSet& points);

/// One removal.
struct InnerStep {
  VertexId removed;
  /// The volume that the solid loses, exactly, in cubed length units; none until add_costs().
  std::optional<Rational> cost = {};
  std::vector<VertexId> tie = {};   ///< All that cost as little, ascending: `removed` is the first.
  std::vector<VertexId> ring = {};  ///< Neighbours of `removed` before the step, counter-clockwise.
  std::vector<VertexTriangle> triangles = {};  ///< They close the ring; `removed` is beyond them.
  std::size_t left = 0;                        ///< Vertices after the step.
};

enum class InnerStop {
  Reached,    ///< The wanted number of vertices, or it was already met.
  LossLimit,  ///< The next step would exceed the loss allowed.
};

/// Any prefix of `steps` is a valid result.
struct InnerRun {
  std::vector<InnerStep> steps;
  InnerStop stop = InnerStop::Reached;
  std::vector<VertexTriangle> triangles;  ///< The hull of what is left.
};

struct InnerOptions {
  std::size_t vertices = 4;  ///< To keep, at least 4.
  /// Stop before the volume falls below (1 - max_loss) times that of the hull; >= 0.
  std::optional<Rational> max_loss = {};
  std::uint64_t seed = 1;  ///< Of random orders; removals, costs and ties do not depend on it.
  /// Called after every step with the number of vertices left.
  std::function<void(std::size_t left)> progress = {};
  /// When it becomes true, the run ends with Error(Stopped).
  const std::atomic<bool>* stop = nullptr;
};

/// Vertices that are left after all steps, ascending. @param count  Vertices at the start.
[[nodiscard]] std::vector<VertexId> vertices_left(const InnerRun& run, std::size_t count);

/// Fills in the cost of each step that has none, from its triangles, in integers.
void add_costs(const VertexHull& hull, InnerRun& run);

/// Proves each step again, from the lists in the run alone; docs/design/inner.md has the claims.
/// @param level  Full: in addition the whole surface after each step, and the volume before, less
///               the cost, is the volume after, as rationals. It needs the costs.
/// @throws Error Internal, naming the step and the claim, if one fails.
void verify_inner_run(const VertexHull& hull, const InnerRun& run, VerifyLevel level,
                      const std::atomic<bool>* stop = nullptr);

}  // namespace convexact
