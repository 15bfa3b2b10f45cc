// SPDX-License-Identifier: MIT
#include <algorithm>
#include <tuple>
#include <vector>

#include "hull/hull_steps.hpp"

namespace convexact {
namespace {

// Merges coplanar triangles and leaves out the vertices that are not extreme.
template <ExactPoints Points>
class FacetMerging {
 public:
  FacetMerging(const Points& points, TriangulatedHull surface)
      : points_(points), surface_(std::move(surface)) {}

  Hull merge(const std::array<PointId, 4>& simplex) && {
    find_sharp_edges();
    choose_among_equal_points();
    collect_facets();
    prove_flat_vertices();
    return finish(simplex);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  const SurfaceTriangle& triangle(std::size_t t) const { return surface_.triangles[t]; }
  std::size_t triangle_count() const { return surface_.triangles.size(); }
  bool is_sharp(std::size_t t, std::size_t k) const { return sharp_[t] >> k & 1; }
  bool is_extreme(PointId p) const { return sharp_degree_[p.index()] >= 3; }

  // An edge is sharp if its two triangles are not coplanar. The sharp edges are the edges of the
  // hull, so a vertex is extreme iff three or more of them meet in it: two are one straight edge
  // with the vertex inside, none a vertex inside a facet, and one is impossible.
  void find_sharp_edges() {
    sharp_.assign(triangle_count(), 0);
    sharp_degree_.assign(points_.near().size(), 0);
    for (std::uint32_t t = 0; t < triangle_count(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = triangle(t).neighbors[k];
        if (other < t) continue;
        const std::size_t edge = edge_towards(triangle(other), t);
        const PointId opposite = triangle(other).corners[kNextCorner[kNextCorner[edge]]];
        if (side_of(points_, triangle(t).plane, triangle(t).corners, opposite) == Sign::Zero)
          continue;
        sharp_[t] |= static_cast<std::uint8_t>(1u << k);
        sharp_[other] |= static_cast<std::uint8_t>(1u << edge);
        ++sharp_degree_[triangle(t).corners[k].index()];
        ++sharp_degree_[triangle(other).corners[edge].index()];
      }
    }
  }

  // Of equal points the lowest id is the vertex, even if another one was inserted.
  void choose_among_equal_points() {
    if (surface_.repeats.empty()) return;
    chosen_.resize(points_.near().size());
    for (std::size_t i = 0; i < chosen_.size(); ++i) chosen_[i] = PointId(i);
    for (const auto& [p, vertex] : surface_.repeats) {
      if (!is_extreme(vertex)) continue;
      chosen_[vertex.index()] = std::min(chosen_[vertex.index()], p);
    }
    for (auto& [point, corners] : surface_.inside) {
      // The point chosen instead of a vertex was discarded as its repeat; now they swap roles.
      if (corners[0] == corners[1] && chosen(corners[0]) == point) point = corners[0];
      for (PointId& corner : corners) corner = chosen(corner);
    }
  }
  PointId chosen(PointId p) const { return chosen_.empty() ? p : chosen_[p.index()]; }

  // Floods over the edges that are not sharp, then walks along the sharp ones.
  void collect_facets() {
    facet_of_.assign(triangle_count(), kNone);
    for (std::uint32_t t = 0; t < triangle_count(); ++t) {
      if (facet_of_[t] == kNone) walk_boundary(flood(t));
    }
  }

  // Labels the facet of t; returns one of its triangles with a sharp edge.
  std::uint32_t flood(std::uint32_t t) {
    const auto facet = static_cast<std::uint32_t>(facets_.size());
    std::uint32_t on_boundary = t;
    region_.assign(1, t);
    facet_of_[t] = facet;
    for (std::size_t i = 0; i < region_.size(); ++i) {
      if (sharp_[region_[i]] != 0) on_boundary = region_[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = triangle(region_[i]).neighbors[k];
        if (is_sharp(region_[i], k) || facet_of_[other] == facet) continue;
        facet_of_[other] = facet;
        region_.push_back(other);
      }
    }
    return on_boundary;
  }

  void walk_boundary(std::uint32_t t) {
    std::size_t k = 0;
    while (!is_sharp(t, k)) ++k;
    const std::uint32_t first_triangle = t;
    const std::size_t first_edge = k;
    cycle_.clear();
    do {
      const PointId corner = triangle(t).corners[k];
      if (is_extreme(corner)) cycle_.push_back(chosen(corner));
      k = kNextCorner[k];
      while (!is_sharp(t, k)) {  // turn about the end of the edge, inside the facet
        const std::uint32_t other = triangle(t).neighbors[k];
        k = kNextCorner[edge_towards(triangle(other), t)];
        t = other;
      }
    } while (t != first_triangle || k != first_edge);
    std::rotate(cycle_.begin(), std::min_element(cycle_.begin(), cycle_.end()), cycle_.end());
    facets_.push_back(cycle_);
  }

  // A vertex that is not extreme lies in a facet, so in a triangle of its fan from its first
  // corner.
  void prove_flat_vertices() {
    std::vector<bool> proven(points_.near().size(), false);
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      for (const PointId p : triangle(t).corners) {
        if (is_extreme(p) || proven[p.index()]) continue;
        proven[p.index()] = true;
        const auto corners = facets_[facet_of_[t]];
        std::size_t low = 1, end = corners.size() - 1;
        while (end - low > 1) {
          const std::size_t middle = (low + end) / 2;
          const Sign side = center_side_of(points_, corners[0], corners[middle], p);
          (side != Sign::Negative ? low : end) = middle;
        }
        surface_.inside.push_back({p, {corners[0], corners[low], corners[low + 1]}});
      }
    }
  }

  // Facets in the order of their corners, so that the hull does not depend on the seed. The first
  // two decide, as an edge has one facet on its left.
  Hull finish(const std::array<PointId, 4>& simplex) {
    Hull hull;
    for (std::size_t i = 0; i < sharp_degree_.size(); ++i) {
      if (is_extreme(PointId(i))) hull.vertices.push_back(chosen(PointId(i)));
    }
    std::sort(hull.vertices.begin(), hull.vertices.end());
    std::vector<std::tuple<PointId, PointId, std::uint32_t>> order;
    order.reserve(facets_.size());
    for (std::uint32_t f = 0; f < facets_.size(); ++f) {
      order.emplace_back(facets_[f][0], facets_[f][1], f);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [first, second, f] : order) hull.facets.push_back(facets_[f]);
    hull.certificate = {simplex, std::move(surface_.inside)};
    return hull;
  }

  const Points& points_;
  TriangulatedHull surface_;
  std::vector<std::uint8_t> sharp_;          // by triangle: bit k says that edge k is sharp
  std::vector<std::uint32_t> sharp_degree_;  // by point: sharp edges that end there
  std::vector<PointId> chosen_;              // by point; empty if no vertex is repeated
  std::vector<std::uint32_t> facet_of_;      // by triangle
  FacetList facets_;
  std::vector<std::uint32_t> region_;
  std::vector<PointId> cycle_;
};

}  // namespace

template <ExactPoints Points>
Hull merge_facets(const Points& points, TriangulatedHull surface,
                  const std::array<PointId, 4>& simplex) {
  return FacetMerging(points, std::move(surface)).merge(simplex);
}

template Hull merge_facets(const DoublePoints&, TriangulatedHull, const std::array<PointId, 4>&);
template Hull merge_facets(const HomogeneousPoints&, TriangulatedHull,
                           const std::array<PointId, 4>&);

}  // namespace convexact
