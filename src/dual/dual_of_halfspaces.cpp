// SPDX-License-Identifier: MIT
// The dual of halfspaces as given: parallel ones go first, the hull of the dual points finds the
// rest.
#include <algorithm>
#include <numeric>
#include <optional>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/hull.hpp"

namespace convexact {
namespace {

// Keeps the tightest halfspace of each direction, of equal ones the first row; rows in canonical
// order. In that order the tightest of a direction stands last: n.x <= -d.
std::vector<std::size_t> tightest_rows(std::span<const Halfspace> halfspaces,
                                       std::vector<std::size_t>& redundant) {
  std::vector<std::size_t> order(halfspaces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return halfspaces[a] < halfspaces[b]; });
  std::vector<std::size_t> kept;
  for (const std::size_t row : order) {
    if (!kept.empty() && halfspaces[row] == halfspaces[kept.back()]) {
      redundant.push_back(row);
      continue;
    }
    if (!kept.empty() && same_direction(halfspaces[row], halfspaces[kept.back()])) {
      redundant.push_back(kept.back());
      kept.pop_back();
    }
    kept.push_back(row);
  }
  return kept;
}

[[noreturn]] void reject_unbounded() {
  throw Error(ErrorCode::InvalidArgument, "the intersection of the halfspaces is unbounded");
}

}  // namespace

HalfspaceDual dual_of(std::span<const Halfspace> halfspaces, const RationalPoint& center,
                      std::uint64_t seed, HullObserver* observer) {
  HalfspaceDual result;
  // (1) Dual points, one per direction.
  result.hull_rows = tightest_rows(halfspaces, result.redundant);
  const std::vector<std::size_t>& rows = result.hull_rows;
  std::vector<DualPoint> points;
  for (const std::size_t row : rows) points.push_back(polar(halfspaces[row], center));
  // (2) Their hull. Flat means that some line lies in the intersection.
  HullOptions options;
  options.seed = seed;
  options.observer = observer;
  const HullOutcome outcome = convex_hull(points, options);
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) reject_unbounded();
  // (3) A dual point that is not extreme is a halfspace that the others imply.
  std::vector<std::optional<HalfspaceId>> id_of(points.size());
  DualHull& dual = result.dual;
  for (const PointId p : hull->vertices) {
    id_of[p.index()] = HalfspaceId(dual.halfspaces.size());
    dual.halfspaces.push_back(halfspaces[rows[p.index()]]);
    result.rows.push_back(rows[p.index()]);
  }
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (!id_of[p]) result.redundant.push_back(rows[p]);
  }
  // (4) Dual facets are the vertices; with the center inside all of them lie beyond the origin.
  dual.witness.resize(dual.halfspaces.size());
  for (std::size_t f = 0; f < hull->facets.size(); ++f) {
    const std::span<const PointId> facet = hull->facets[f];
    const DualPlane plane =
        plane_through(points[facet[0].index()], points[facet[1].index()], points[facet[2].index()]);
    if (plane.d <= 0) reject_unbounded();
    for (std::size_t c = 0; c < facet.size(); ++c) {
      dual.witness[id_of[facet[c].index()]->index()] =
          static_cast<std::uint32_t>(dual.vertices.size());
      if (c >= 2) {
        dual.triangles.push_back(
            {*id_of[facet[0].index()], *id_of[facet[c - 1].index()], *id_of[facet[c].index()]});
      }
    }
    dual.vertices.push_back(polar(plane, center));
  }
  std::sort(result.redundant.begin(), result.redundant.end());
  return result;
}

}  // namespace convexact
