// SPDX-License-Identifier: MIT
// Walks around the vertices of a hull and cuts the polygons found there into triangles.
#include "convexact/error.hpp"
#include "fast/dual.hpp"
#include "fast/mesh.hpp"

namespace convexact {
namespace {

// Half-edges of the hull's facets; those of facet f are [start[f], start[f + 1]), in its order.
struct FacetEdges {
  std::vector<std::uint32_t> start, tail, twin, facet;

  FacetEdges(const FacetList& facets, std::size_t point_count);
  std::uint32_t previous(std::uint32_t h) const {
    return h == start[facet[h]] ? start[facet[h] + 1] - 1 : h - 1;
  }
};

FacetEdges::FacetEdges(const FacetList& facets, std::size_t point_count) : start(1, 0) {
  std::vector<std::uint32_t> head;
  for (std::vector<std::uint32_t>* list : {&tail, &head, &facet}) {
    list->reserve(facets.corner_count());
  }
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto corners = facets[f];
    for (const PointId corner : corners) {
      tail.push_back(corner.value);
      facet.push_back(static_cast<std::uint32_t>(f));
    }
    for (const PointId corner : corners.subspan(1)) head.push_back(corner.value);
    head.push_back(corners[0].value);
    start.push_back(static_cast<std::uint32_t>(tail.size()));
  }
  twin = match_twins(tail, head, point_count);
}

// Cuts polygons and links the pieces. Edge e of a polygon runs from its corner e to the next; it is
// known by the half-edge `rim` of the hull that it crosses, and its opposite by that one's twin.
class Zigzag {
 public:
  Zigzag(DualFaces& faces, std::size_t rim_count) : faces_(faces), at_rim_(rim_count, kNone) {}

  void cut(const std::vector<HalfspaceId>& polygon, const std::vector<std::uint32_t>& rim) {
    std::size_t low = 0, high = polygon.size() - 1;
    std::uint32_t diagonal = kNone;  // the half-edge that the next triangle hangs on
    for (bool left = true; high - low >= 2; left = !left) {
      const auto h = static_cast<std::uint32_t>(3 * faces_.triangles.size());
      const std::size_t middle = left ? low + 1 : high - 1;
      faces_.triangles.push_back({polygon[low], polygon[middle], polygon[high]});
      faces_.twins.insert(faces_.twins.end(), 3, kNone);
      if (diagonal == kNone) {
        at_rim_[rim[high]] = h + 2;
      } else {
        link(h + 2, diagonal);
      }
      const bool last = high - low == 2;
      if (left || last) at_rim_[rim[low]] = h;
      if (!left || last) at_rim_[rim[middle]] = h + 1;
      diagonal = left ? h + 1 : h;
      (left ? low : high) = middle;
    }
  }
  void link_rims(const FacetEdges& edges) {
    for (std::uint32_t h = 0; h < at_rim_.size(); ++h) {
      faces_.twins[at_rim_[h]] = at_rim_[edges.twin[h]];
    }
  }

 private:
  void link(std::uint32_t a, std::uint32_t b) {
    faces_.twins[a] = b;
    faces_.twins[b] = a;
  }

  DualFaces& faces_;
  std::vector<std::uint32_t> at_rim_;  // the dual half-edge that crosses each half-edge of the hull
};

}  // namespace

DualFaces triangulate_dual_faces(const FacetList& facets, std::size_t point_count) {
  const FacetEdges edges(facets, point_count);
  std::vector<std::uint32_t> out(point_count, kNone);
  for (std::uint32_t h = 0; h < edges.tail.size(); ++h) out[edges.tail[h]] = h;

  DualFaces faces;
  faces.triangles.reserve(2 * facets.size() - 4);
  faces.twins.reserve(3 * (2 * facets.size() - 4));
  Zigzag zigzag(faces, edges.tail.size());
  std::vector<HalfspaceId> polygon;
  std::vector<std::uint32_t> rim;
  for (const std::uint32_t first : out) {
    if (first == kNone) continue;
    // The facet to the left of v -> w, then the one across its edge into v: counter-clockwise.
    polygon.clear();
    rim.clear();
    std::uint32_t h = first;
    do {
      polygon.push_back(HalfspaceId(edges.facet[h]));
      rim.push_back(edges.previous(h));
      h = edges.twin[rim.back()];
    } while (h != first);
    zigzag.cut(polygon, rim);
  }
  CONVEXACT_ASSERT(faces.triangles.size() == 2 * facets.size() - 4);
  zigzag.link_rims(edges);
  return faces;
}

}  // namespace convexact
