// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"
#include "number/roundoff.hpp"
#include "task/lazy.hpp"

namespace convexact {

class NearestPoint::Search {
 public:
  explicit Search(const Polytope& polytope);
  RationalPoint operator()(const RationalPoint& x) const;

 private:
  // A facet's side from vertex `tail` to vertex `head`.
  struct HalfEdge {
    std::uint32_t tail, head, twin, facet;
  };
  // Two planes through its tail.
  struct EdgePlanes {
    Lazy<Halfspace> side;  // holds what projects to the facet's side of the edge
    Lazy<Halfspace> end;   // perpendicular to it; holds what does not lie towards `head`
  };

  // A plane in doubles with a normal of length 1, for coordinates relative to the first vertex.
  struct UnitPlane {
    Vector3<double> n;
    double d;
  };

  std::optional<std::uint32_t> visible_facet(const RationalPoint& x,
                                             const HomogeneousPoint& homogeneous) const;
  RationalPoint nearest_around(std::uint32_t visible, const RationalPoint& x,
                               const HomogeneousPoint& homogeneous) const;
  const Halfspace& side(std::uint32_t half_edge) const;
  const Halfspace& end(std::uint32_t half_edge) const;
  bool in_facet_region(std::uint32_t facet, const HomogeneousPoint& x) const;
  bool in_edge_region(std::uint32_t half_edge, const HomogeneousPoint& x) const;
  bool in_vertex_region(std::uint32_t vertex, const HomogeneousPoint& x) const;

  const Polytope& polytope_;
  std::vector<UnitPlane> near_planes_;
  std::vector<HalfEdge> half_edges_;
  std::vector<EdgePlanes> edge_planes_;                // as half_edges_
  std::vector<std::vector<std::uint32_t>> of_facet_;   // half-edges around each facet
  std::vector<std::vector<std::uint32_t>> of_vertex_;  // half-edges out of each vertex
};

NearestPoint::Search::Search(const Polytope& polytope)
    : polytope_(polytope), of_facet_(polytope.facets.size()), of_vertex_(polytope.vertices.size()) {
  const auto add = [&](std::uint32_t tail, std::uint32_t head, std::uint32_t facet) {
    const auto self = static_cast<std::uint32_t>(half_edges_.size());
    of_facet_[facet].push_back(self);
    of_vertex_[tail].push_back(self);
    half_edges_.push_back({tail, head, self ^ 1u, facet});
  };
  for (const Edge& edge : edges(polytope)) {
    add(edge.tail, edge.head, edge.left);
    add(edge.head, edge.tail, edge.right);
  }
  edge_planes_ = std::vector<EdgePlanes>(half_edges_.size());
  for (const Halfspace& plane : polytope.planes) {
    const Point n = scaled_direction(plane.normal());
    const auto bits = static_cast<long>(bit_length(plane.normal()));
    const Rational at_origin = scale_by_power_of_two(plane(polytope.vertices.front()), -bits);
    near_planes_.push_back({n / n.norm(), to_double(at_origin, Rounding::Nearest) / n.norm()});
  }
}

const Halfspace& NearestPoint::Search::side(std::uint32_t half_edge) const {
  return edge_planes_[half_edge].side.get([&] {
    const HalfEdge& h = half_edges_[half_edge];
    const RationalPoint& a = polytope_.vertices[h.tail];
    const RationalVector3 along = polytope_.vertices[h.head] - a;
    const RationalVector3 normal = polytope_.planes[h.facet].normal().cast<Rational>();
    const RationalVector3 outward = along.cross(normal);  // in the facet's plane, away from it
    return Halfspace(outward, Rational(-outward.dot(a)));
  });
}

const Halfspace& NearestPoint::Search::end(std::uint32_t half_edge) const {
  return edge_planes_[half_edge].end.get([&] {
    const HalfEdge& h = half_edges_[half_edge];
    const RationalPoint& a = polytope_.vertices[h.tail];
    const RationalVector3 along = polytope_.vertices[h.head] - a;
    return Halfspace(along, Rational(-along.dot(a)));
  });
}

// The region of a feature is where x - q, for q the projection of x to the feature's plane or line,
// lies in the cone of the outward normals at q. That makes q the nearest point: the cone is polar
// to the directions from q into the polytope, and these are spanned by those into the facet, the
// two facets or along the edges at q.

bool NearestPoint::Search::in_facet_region(std::uint32_t facet, const HomogeneousPoint& x) const {
  for (const std::uint32_t h : of_facet_[facet]) {
    if (plane_value(side(h), x) > 0) return false;
  }
  return true;
}

bool NearestPoint::Search::in_edge_region(std::uint32_t half_edge,
                                          const HomogeneousPoint& x) const {
  const std::uint32_t twin = half_edges_[half_edge].twin;
  return plane_value(side(half_edge), x) >= 0 && plane_value(side(twin), x) >= 0 &&
         plane_value(end(half_edge), x) >= 0 && plane_value(end(twin), x) >= 0;
}

bool NearestPoint::Search::in_vertex_region(std::uint32_t vertex, const HomogeneousPoint& x) const {
  for (const std::uint32_t h : of_vertex_[vertex]) {
    if (plane_value(end(h), x) > 0) return false;
  }
  return true;
}

namespace {

RationalPoint project_to_plane(const Halfspace& plane, const RationalPoint& x) {
  const RationalVector3 n = plane.normal().cast<Rational>();
  const Rational factor = plane(x) / n.squaredNorm();
  return x - factor * n;
}

RationalPoint project_to_line(const RationalPoint& a, const RationalPoint& b,
                              const RationalPoint& x) {
  const RationalVector3 along = b - a, from = x - a;
  const Rational factor = from.dot(along) / along.squaredNorm();
  return a + factor * along;
}

}  // namespace

RationalPoint NearestPoint::Search::operator()(const RationalPoint& x) const {
  const HomogeneousPoint homogeneous = clear_denominators(x);
  const std::optional<std::uint32_t> visible = visible_facet(x, homogeneous);
  return visible ? nearest_around(*visible, x, homogeneous) : x;
}

// Doubles discard the facets that x is surely below, and name the one that it is farthest beyond:
// the nearest feature is seldom far from there. With u = kUnitRoundoff a component of n suffers two
// roundings and a factor without influence on the sign, that of x - v one, its product one and the
// sums three, so 8u of |n| |x - v| + |d| bounds the error, 16u that of this bound as well; what
// underflows adds less than the second term. A NaN is discarded by no comparison.
std::optional<std::uint32_t> NearestPoint::Search::visible_facet(
    const RationalPoint& x, const HomogeneousPoint& homogeneous) const {
  constexpr double kRelative = 16 * kUnitRoundoff, kAbsolute = 0x1p-1060;
  Vector3<double> from;
  for (int k = 0; k < 3; ++k) {
    from[k] = to_double(Rational(x[k] - polytope_.vertices.front()[k]), Rounding::Nearest);
  }
  const double size = from.lpNorm<1>();
  std::vector<std::uint32_t> open;
  double most = -std::numeric_limits<double>::infinity();
  for (std::uint32_t f = 0; f < near_planes_.size(); ++f) {
    const UnitPlane& plane = near_planes_[f];
    const double beyond = plane.n.dot(from) + plane.d;
    const double error = kRelative * (size + std::abs(plane.d)) + kAbsolute * (1 + size);
    if (beyond < -error) continue;
    open.push_back(f);
    if (beyond > most) {
      most = beyond;
      std::swap(open.front(), open.back());
    }
  }
  for (const std::uint32_t f : open) {
    if (plane_value(polytope_.planes[f], homogeneous) > 0) return f;
  }
  return {};
}

// Only features of visible facets are tested. With q nearest to x, x - q = sum of y_f n_f over the
// facets at q, y_f >= 0, so 0 < |x - q|^2 = sum of y_f n_f.(x - q): one of these facets is visible
// from x. As seen from x the visible facets tile a convex region, so that edges lead from each to
// every other.
RationalPoint NearestPoint::Search::nearest_around(std::uint32_t visible, const RationalPoint& x,
                                                   const HomogeneousPoint& homogeneous) const {
  std::vector<std::uint32_t> queue{visible};
  std::vector<bool> is_known(polytope_.facets.size(), false);
  is_known[visible] = true;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::uint32_t f = queue[next];
    if (in_facet_region(f, homogeneous)) return project_to_plane(polytope_.planes[f], x);
    for (const std::uint32_t h : of_facet_[f]) {
      const HalfEdge& edge = half_edges_[h];
      if (in_edge_region(h, homogeneous)) {
        return project_to_line(polytope_.vertices[edge.tail], polytope_.vertices[edge.head], x);
      }
      if (in_vertex_region(edge.tail, homogeneous)) return polytope_.vertices[edge.tail];
      const std::uint32_t neighbor = half_edges_[edge.twin].facet;
      if (is_known[neighbor]) continue;
      is_known[neighbor] = true;
      if (plane_value(polytope_.planes[neighbor], homogeneous) > 0) {
        queue.push_back(neighbor);
      }
    }
  }
  throw Error(ErrorCode::InvalidArgument, "the facets of a polytope are not convex");
}

NearestPoint::NearestPoint(const Polytope& polytope)
    : search_(std::make_unique<const Search>(polytope)) {}
NearestPoint::~NearestPoint() = default;

RationalPoint NearestPoint::operator()(const RationalPoint& x) const { return (*search_)(x); }

HausdorffDistance hausdorff_distance(const Polytope& outer, const Polytope& inner,
                                     const Watch& watch) {
  std::optional<NearestPoint> nearest_point;  // hulls often share all vertices
  std::vector<RationalPoint> shared = inner.vertices;
  std::sort(shared.begin(), shared.end(), precedes<RationalPoint>);
  std::optional<HausdorffDistance> best;
  for (std::uint32_t v = 0; v < outer.vertices.size(); ++v) {
    watch.ask();
    const RationalPoint& vertex = outer.vertices[v];
    // For a vertex of both, the facets do not matter.
    const bool is_shared =
        std::binary_search(shared.begin(), shared.end(), vertex, precedes<RationalPoint>);
    if (!is_shared && !nearest_point) nearest_point.emplace(inner);
    RationalPoint nearest = is_shared ? vertex : (*nearest_point)(vertex);
    const RationalVector3 gap = outer.vertices[v] - nearest;
    Rational squared = gap.squaredNorm();
    if (!best || squared > best->squared) {
      best = HausdorffDistance{std::move(squared), v, std::move(nearest)};
    }
  }
  if (!best) throw Error(ErrorCode::InvalidArgument, "a polytope has no vertices");
  return *best;
}

}  // namespace convexact
