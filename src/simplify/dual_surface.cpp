// SPDX-License-Identifier: MIT
#include "simplify/dual_surface.hpp"

#include <algorithm>
#include <array>

#include "convexact/error.hpp"
#include "simplify/cap.hpp"

namespace convexact {

DualSurface::DualSurface(std::span<const Halfspace> halfspaces,
                         std::span<const DualTriangle> triangles, const RationalPoint& center,
                         std::uint64_t seed, CostMeasure measure)
    : adjacency_(halfspaces.size()),
      is_present_(halfspaces.size(), false),
      measure_(measure),
      random_(seed) {
  points_.reserve(halfspaces.size());
  for (const Halfspace& halfspace : halfspaces) points_.push_back(polar(halfspace, center));
  if (measure != CostMeasure::Volume) directions_ = primitive_directions(points_);
  for (const DualTriangle& triangle : triangles) {
    adjacency_.add(triangle);
    for (const HalfspaceId i : triangle) is_present_[i.index()] = true;
  }
  left_ = static_cast<std::size_t>(std::count(is_present_.begin(), is_present_.end(), true));
}

DualPlane DualSurface::plane_of(const DualTriangle& t) const {
  return plane_through(points_[t[0].index()], points_[t[1].index()], points_[t[2].index()]);
}

// Steps as in docs/construction.md.
Removal DualSurface::removal_of(HalfspaceId i, RingObserver* observer) {
  CONVEXACT_ASSERT(has(i));
  // (1) The neighbours of the dual point, in order.
  Removal removal{i, adjacency_.one_ring(i), {}, {}};
  // (2) The dual hull without the point differs only inside the ring.
  removal.roof = triangulate_ring(points_, removal.ring, random_, observer);
  // (3) A new dual face without a vertex: the solid would reach to infinity.
  if (!removal.roof.is_bounded()) return removal;
  // (4) The cap lies between the old vertices on plane i and the new ones.
  const Cap cap = make_cap(points_, i, removal.ring, removal.roof);
  // (5) The cost is the amount that it adds to the measure.
  removal.cost = cost_of(cap, directions_, i, removal.ring, measure_);
  return removal;
}

Cost DualSurface::added_by(const Removal& removal, CostMeasure measure) {
  if (measure == measure_) return removal.cost.value();
  if (measure != CostMeasure::Volume && directions_.empty()) {
    directions_ = primitive_directions(points_);
  }
  const Cap cap = make_cap(points_, removal.removed, removal.ring, removal.roof);
  return cost_of(cap, directions_, removal.removed, removal.ring, measure);
}

void DualSurface::apply(const Removal& removal) {
  CONVEXACT_ASSERT(removal.cost);
  const std::vector<HalfspaceId>& ring = removal.ring;
  for (std::size_t t = 0; t < ring.size(); ++t) {
    adjacency_.remove({removal.removed, ring[t], ring[(t + 1) % ring.size()]});
  }
  for (const DualTriangle& triangle : removal.roof.triangles) adjacency_.add(triangle);
  is_present_[removal.removed.index()] = false;
  --left_;
}

void DualSurface::undo(const Removal& removal) {
  for (const DualTriangle& triangle : removal.roof.triangles) adjacency_.remove(triangle);
  const std::vector<HalfspaceId>& ring = removal.ring;
  for (std::size_t t = 0; t < ring.size(); ++t) {
    adjacency_.add({removal.removed, ring[t], ring[(t + 1) % ring.size()]});
  }
  is_present_[removal.removed.index()] = true;
  ++left_;
}

bool DualSurface::insert(HalfspaceId i) {
  CONVEXACT_ASSERT(!has(i));
  // (1) The triangles that the new dual point is beyond or level with. Degenerate: a level triangle
  //     counts as visible, as if the point were a little farther out. So all triangles around a
  //     dual point go if it is no corner of the new hull: there each supporting plane has the new
  //     point beyond it or on it.
  std::vector<DualTriangle> visible;
  bool is_outside = false;
  for (const DualTriangle& t : adjacency_.triangles()) {
    const Integer height_above = height(plane_of(t), points_[i.index()]);
    if (height_above < 0) continue;
    is_outside = is_outside || height_above > 0;
    visible.push_back(t);
  }
  if (!is_outside) return false;
  // (2) They form a disk. Its rim consists of their edges that keep a triangle on the other side.
  for (const DualTriangle& t : visible) adjacency_.remove(t);
  std::vector<std::array<HalfspaceId, 2>> rim;
  for (const DualTriangle& t : visible) {
    for (int e = 0; e < 3; ++e) {
      const HalfspaceId from = t[e], to = t[(e + 1) % 3];
      if (adjacency_.at(to, from)) rim.push_back({from, to});
    }
  }
  // (3) Join the point to the rim. Degenerate: were it collinear with an edge of the rim, it would
  //     be level with the triangle on the other side, which would then be visible.
  for (const auto& [from, to] : rim) adjacency_.add({i, from, to});
  is_present_[i.index()] = true;
  ++left_;
  // (4) Dual points that have lost all their triangles stand for redundant halfspaces now.
  for (const DualTriangle& t : visible) {
    for (const HalfspaceId j : t) {
      if (!has(j) || !adjacency_.one_ring(j).empty()) continue;
      is_present_[j.index()] = false;
      --left_;
    }
  }
  return true;
}

}  // namespace convexact
