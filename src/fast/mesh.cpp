// SPDX-License-Identifier: MIT
#include "fast/mesh.hpp"

#include <utility>

#include "convexact/error.hpp"

namespace convexact {

std::vector<std::uint32_t> match_twins(std::span<const std::uint32_t> tail,
                                       std::span<const std::uint32_t> head,
                                       std::size_t vertex_count) {
  // Half-edges grouped by tail: those of v are sorted[start[v], start[v + 1]).
  std::vector<std::uint32_t> start(vertex_count + 1, 0), sorted(tail.size());
  for (const std::uint32_t v : tail) ++start[v + 1];
  for (std::size_t v = 0; v < vertex_count; ++v) start[v + 1] += start[v];
  std::vector<std::uint32_t> place(start.begin(), start.end() - 1);
  for (std::uint32_t h = 0; h < tail.size(); ++h) sorted[place[tail[h]]++] = h;

  std::vector<std::uint32_t> twin(tail.size(), kNone);
  const auto degree = [&](std::uint32_t v) { return start[v + 1] - start[v]; };
  for (std::uint32_t h = 0; h < tail.size(); ++h) {
    const std::uint32_t a = tail[h], b = head[h];
    // The opposite b -> a is looked for at b, if b has fewer edges than a; else b -> a finds h.
    if (degree(b) > degree(a) || twin[h] != kNone) continue;
    for (std::uint32_t s = start[b]; s < start[b + 1]; ++s) {
      if (head[sorted[s]] != a) continue;
      twin[h] = sorted[s];
      twin[sorted[s]] = h;
      break;
    }
  }
  for (const std::uint32_t h : twin) {
    if (h == kNone) throw Error(ErrorCode::InvalidArgument, "a surface is not closed");
  }
  return twin;
}

namespace {

std::vector<std::uint32_t> match_twins_of(std::span<const DualTriangle> triangles,
                                          std::size_t vertex_count) {
  std::vector<std::uint32_t> tail, head;
  for (const DualTriangle& t : triangles) {
    for (int c = 0; c < 3; ++c) {
      tail.push_back(t[c].value);
      head.push_back(t[(c + 1) % 3].value);
    }
  }
  return match_twins(tail, head, vertex_count);
}

}  // namespace

HalfEdgeMesh::HalfEdgeMesh(std::size_t vertex_count, std::span<const DualTriangle> triangles)
    : HalfEdgeMesh(vertex_count, triangles, match_twins_of(triangles, vertex_count)) {}

HalfEdgeMesh::HalfEdgeMesh(std::size_t vertex_count, std::span<const DualTriangle> triangles,
                           std::span<const std::uint32_t> twins)
    : out_(vertex_count, kNone) {
  edges_.reserve(3 * triangles.size());
  for (const DualTriangle& t : triangles) {
    for (const HalfspaceId corner : t) {
      const auto h = static_cast<std::uint32_t>(edges_.size());
      edges_.push_back({corner.value, twins[h]});
      out_[corner.index()] = h;
    }
  }
}

void HalfEdgeMesh::one_ring(HalfspaceId v, OneRing& ring) const {
  ring.vertices.clear();
  ring.outer.clear();
  const std::uint32_t first = out_[v.index()];
  std::uint32_t spoke = first;
  do {
    const std::uint32_t rim = next(spoke);
    ring.vertices.push_back(HalfspaceId(edges_[rim].tail));
    ring.outer.push_back(edges_[rim].twin);
    spoke = edges_[previous(spoke)].twin;
  } while (spoke != first);
}

void HalfEdgeMesh::remove(HalfspaceId v, const OneRing& ring,
                          std::span<const RingTriangle> triangles) {
  const std::size_t k = ring.vertices.size();
  CONVEXACT_ASSERT(triangles.size() == k - 2);
  hole_.clear();
  for (const std::uint32_t outer : ring.outer) hole_.push_back(edges_[outer].twin / 3);
  for (const std::uint32_t slot : {hole_[k - 2], hole_[k - 1]}) {
    for (std::uint32_t h = 3 * slot; h < 3 * slot + 3; ++h) edges_[h].tail = kNone;
    edges_[3 * slot].twin = std::exchange(freed_, slot);
  }
  out_[v.index()] = kNone;

  const auto link_rim = [&](std::uint32_t h, std::uint32_t m) {
    link(h, ring.outer[m]);
    out_[ring.vertices[m].index()] = h;
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const RingTriangle& triangle = triangles[t];
    const std::uint32_t h = 3 * hole_[t];
    edges_[h].tail = ring.vertices[triangle.low].value;
    edges_[h + 1].tail = ring.vertices[triangle.middle].value;
    edges_[h + 2].tail = ring.vertices[triangle.high].value;
    if (triangle.middle == triangle.low + 1) link_rim(h, triangle.low);
    if (triangle.high == triangle.middle + 1) link_rim(h + 1, triangle.middle);
    if (triangle.parent == kNone) {
      link_rim(h + 2, triangle.high);
    } else {
      const bool below_first = triangles[triangle.parent].low == triangle.low;
      link(h + 2, 3 * hole_[triangle.parent] + (below_first ? 0 : 1));
    }
  }
}

void HalfEdgeMesh::put_back(HalfspaceId v, const OneRing& ring) {
  const std::size_t k = ring.vertices.size();
  CONVEXACT_ASSERT(hole_.size() == k && freed_ == hole_[k - 1]);
  freed_ = edges_[3 * hole_[k - 2]].twin;  // remove() freed these two
  fill_fan(v, ring, hole_);
}

// Along the edges of the seen triangles with an unseen one across, which is on the right.
void HalfEdgeMesh::walk_rim(OneRing& ring) const {
  ring.vertices.clear();
  ring.outer.clear();
  const auto is_inner = [&](std::uint32_t h) { return sight_[edges_[h].twin / 3] == Sight::Seen; };
  std::uint32_t first = kNone;
  for (std::size_t s = 0; first == kNone; ++s) {
    for (std::uint32_t h = 3 * slots_[s]; h < 3 * slots_[s] + 3; ++h) {
      if (!is_inner(h)) first = h;
    }
  }
  std::uint32_t h = first;
  do {
    ring.vertices.emplace_back(edges_[h].tail);
    ring.outer.push_back(edges_[h].twin);
    for (h = next(h); is_inner(h);) h = next(edges_[h].twin);
  } while (h != first);
}

// The triangles seen, those of slots_, make room for a fan around v: one triangle for each edge of
// their rim, which is two more than they are.
void HalfEdgeMesh::fill_seen(HalfspaceId v) {
  walk_rim(rim_);
  const std::size_t k = rim_.vertices.size();
  CONVEXACT_ASSERT(k == slots_.size() + 2);
  // (1) Two more slots, freed ones if there are any.
  while (slots_.size() < k) {
    if (freed_ == kNone) {
      slots_.push_back(static_cast<std::uint32_t>(edges_.size() / 3));
      edges_.resize(edges_.size() + 3);
    } else {
      slots_.push_back(freed_);
      freed_ = edges_[3 * freed_].twin;
    }
  }
  // (2) One for each edge.
  fill_fan(v, rim_, slots_);
}

// The triangle (v, a, b) for each edge a -> b of the ring, and the next one across b -> v.
void HalfEdgeMesh::fill_fan(HalfspaceId v, const OneRing& ring,
                            std::span<const std::uint32_t> slots) {
  for (std::size_t m = 0, k = slots.size(); m < k; ++m) {
    const std::size_t after = m + 1 < k ? m + 1 : 0;
    const std::uint32_t h = 3 * slots[m];
    edges_[h].tail = v.value;
    edges_[h + 1].tail = ring.vertices[m].value;
    edges_[h + 2].tail = ring.vertices[after].value;
    link(h + 1, ring.outer[m]);
    link(h + 2, 3 * slots[after]);
    out_[edges_[h + 1].tail] = h + 1;
  }
  out_[v.index()] = 3 * slots.front();
}

std::vector<DualTriangle> HalfEdgeMesh::triangles() const {
  std::vector<DualTriangle> list;
  for (std::size_t h = 0; h < edges_.size(); h += 3) {
    if (edges_[h].tail != kNone) list.push_back(triangle(static_cast<std::uint32_t>(h / 3)));
  }
  return list;
}

std::vector<HalfspaceId> HalfEdgeMesh::vertices() const {
  std::vector<HalfspaceId> list;
  for (std::size_t v = 0; v < out_.size(); ++v) {
    if (out_[v] != kNone) list.push_back(HalfspaceId(v));
  }
  return list;
}

}  // namespace convexact
