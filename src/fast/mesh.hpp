// SPDX-License-Identifier: MIT
// mesh.hpp - the triangulated dual hull in flat arrays; removals reuse the slots that they free.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact {

inline constexpr std::uint32_t kNone = 0xffffffff;

/// A triangle of the polygon 0, 1, ..., k - 1 (positions in a one-ring): low < middle < high,
/// counter-clockwise. It hangs below its edge (low, high) on the triangle `parent`, an earlier
/// position in the list, of which that edge is (low, middle) or (middle, high); for the first
/// triangle that edge is (0, k - 1) and `parent` is kNone.
struct RingTriangle {
  std::uint32_t low, middle, high;
  std::uint32_t parent;
};

/// For each half-edge the one in the opposite direction.
/// @param tail, head  Of each half-edge, below vertex_count; each directed edge occurs once.
/// @throws Error      InvalidArgument if some half-edge has no opposite.
/// @par Cost          Sum over the edges of the smaller degree of their ends: linear on a sphere.
[[nodiscard]] std::vector<std::uint32_t> match_twins(std::span<const std::uint32_t> tail,
                                                     std::span<const std::uint32_t> head,
                                                     std::size_t vertex_count);

/// The surroundings of a vertex: its neighbours, counter-clockwise from outside, and for each edge
/// of the cycle (vertices[m] -> vertices[m + 1]) the half-edge across it.
struct OneRing {
  std::vector<HalfspaceId> vertices;
  std::vector<std::uint32_t> outer;
};

/// A closed triangulated sphere. Half-edges 3t, 3t + 1, 3t + 2 bound triangle t counter-clockwise.
/// Removing a vertex of degree k frees k triangles and takes k - 2 of them again, so nothing is
/// ever allocated; inserting one takes freed triangles first.
class HalfEdgeMesh {
 public:
  /// @param twins  Of half-edge 3 t + c, which leaves corner c of triangle t, the opposite one.
  HalfEdgeMesh(std::size_t vertex_count, std::span<const DualTriangle> triangles,
               std::span<const std::uint32_t> twins);
  HalfEdgeMesh(std::size_t vertex_count, std::span<const DualTriangle> triangles);

  /// Reads the ring of v into `ring`. @par Cost  Its length.
  void one_ring(HalfspaceId v, OneRing& ring) const;
  /// Whether v is on the mesh.
  bool has(HalfspaceId v) const { return out_[v.index()] != kNone; }
  std::uint32_t twin(std::uint32_t half_edge) const { return edges_[half_edge].twin; }
  /// The third corner of the triangle of a half-edge.
  HalfspaceId apex(std::uint32_t half_edge) const {
    return HalfspaceId(edges_[previous(half_edge)].tail);
  }
  /// Removes v and closes the hole. `ring` is v's, `triangles` a triangulation of it.
  void remove(HalfspaceId v, const OneRing& ring, std::span<const RingTriangle> triangles);
  /// Takes remove() back. `ring` is the same; nothing has changed since.
  void put_back(HalfspaceId v, const OneRing& ring);
  /// Adds v, which is not on the mesh, and joins it to the rim of the triangles that it sees.
  /// @param sees  Asked of triangles. Those seen form a disk, and each of its vertices is on the
  ///              rim.
  /// @param near  Half-edges: the triangles on both sides of them are asked first.
  /// @par Cost    One question for each triangle that is seen, each one across its rim, and each
  ///              one until the first is seen.
  template <class Sees>
  void insert(HalfspaceId v, Sees sees, std::span<const std::uint32_t> near = {}) {
    look(sees, near);
    fill_seen(v);
  }
  /// The ring that insert() would give a vertex. Nothing changes.
  template <class Sees>
  void rim(Sees sees, std::span<const std::uint32_t> near, OneRing& ring) {
    look(sees, near);
    walk_rim(ring);
  }
  /// Every triangle once; the ones freed are left out.
  std::vector<DualTriangle> triangles() const;
  /// Every vertex that was not removed, ascending.
  std::vector<HalfspaceId> vertices() const;

 private:
  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  void link(std::uint32_t a, std::uint32_t b) {
    edges_[a].twin = b;
    edges_[b].twin = a;
  }

  DualTriangle triangle(std::uint32_t slot) const {
    return {HalfspaceId(edges_[3 * slot].tail), HalfspaceId(edges_[3 * slot + 1].tail),
            HalfspaceId(edges_[3 * slot + 2].tail)};
  }
  template <class Sees>
  void look(Sees& sees, std::span<const std::uint32_t> near);
  void walk_rim(OneRing& ring) const;
  void fill_seen(HalfspaceId v);
  void fill_fan(HalfspaceId v, const OneRing& ring, std::span<const std::uint32_t> slots);

  struct HalfEdge {
    std::uint32_t tail;  // kNone in a freed triangle
    std::uint32_t twin;  // of the first one of a freed triangle: the next freed triangle, or kNone
  };

  std::vector<HalfEdge> edges_;
  std::vector<std::uint32_t> out_;    // of each vertex some half-edge that starts there
  std::uint32_t freed_ = kNone;       // the last triangle that was freed
  std::vector<std::uint32_t> hole_;   // of the last remove(): the triangles around the vertex
  std::vector<std::uint32_t> slots_;  // scratch of insert(): the triangles seen
  enum class Sight : char { NotAsked, Seen, Hidden };
  std::vector<Sight> sight_;  // scratch of insert(), as the next
  OneRing rim_;
};

// Those seen are connected: from the first one the others are reached across edges.
template <class Sees>
void HalfEdgeMesh::look(Sees& sees, std::span<const std::uint32_t> near) {
  sight_.assign(edges_.size() / 3, Sight::NotAsked);
  slots_.clear();
  const auto ask = [&](std::uint32_t slot) {
    if (sight_[slot] != Sight::NotAsked) return;
    sight_[slot] = sees(triangle(slot)) ? Sight::Seen : Sight::Hidden;
    if (sight_[slot] == Sight::Seen) slots_.push_back(slot);
  };
  for (std::size_t m = 0; m < near.size() && slots_.empty(); ++m) {
    ask(near[m] / 3);
    ask(twin(near[m]) / 3);
  }
  for (std::uint32_t slot = 0; slot < sight_.size() && slots_.empty(); ++slot) {
    if (edges_[3 * slot].tail != kNone) ask(slot);
  }
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    for (std::uint32_t h = 3 * slots_[s], end = h + 3; h < end; ++h) ask(twin(h) / 3);
  }
}

}  // namespace convexact
