// SPDX-License-Identifier: MIT
#include "convexact/measure/distance.hpp"

#include <algorithm>
#include <optional>

#include "convexact/error.hpp"

namespace convexact {

// x = numerators / denominator with a common denominator > 0, so that the sign of n.x + d takes
// four products of integers and no greatest common divisor.
struct NearestPoint::Homogeneous {
  IntegerVector3 numerators;
  Integer denominator = 1;

  explicit Homogeneous(const RationalPoint& x) {
    for (int k = 0; k < 3; ++k) {
      denominator = lcm(denominator, boost::multiprecision::denominator(x[k]));
    }
    for (int k = 0; k < 3; ++k) {
      numerators[k] = numerator(x[k]) * (denominator / boost::multiprecision::denominator(x[k]));
    }
  }

  Sign side_of(const Halfspace& plane) const {
    Integer sum;
    mpz_mul(sum.backend().data(), plane.offset().backend().data(), denominator.backend().data());
    for (int k = 0; k < 3; ++k) {
      mpz_addmul(sum.backend().data(), plane.normal()[k].backend().data(),
                 numerators[k].backend().data());
    }
    return sign_of(sum);
  }
};

NearestPoint::NearestPoint(const Polytope& polytope)
    : polytope_(polytope), of_facet_(polytope.facets.size()), of_vertex_(polytope.vertices.size()) {
  const auto add = [&](std::uint32_t tail, std::uint32_t head, std::uint32_t facet) {
    const RationalPoint& a = polytope.vertices[tail];
    const RationalVector3 along = polytope.vertices[head] - a;
    const RationalVector3 normal = polytope.planes[facet].normal().cast<Rational>();
    const RationalVector3 outward = along.cross(normal);  // in the facet's plane, away from it
    const auto self = static_cast<std::uint32_t>(half_edges_.size());
    of_facet_[facet].push_back(self);
    of_vertex_[tail].push_back(self);
    half_edges_.push_back({tail, head, self ^ 1u, Halfspace(outward, Rational(-outward.dot(a))),
                           Halfspace(along, Rational(-along.dot(a)))});
  };
  for (const Edge& edge : edges(polytope)) {
    add(edge.tail, edge.head, edge.left);
    add(edge.head, edge.tail, edge.right);
  }
}

// The region of a feature is where x - q, for q the projection of x to the feature's plane or line,
// lies in the cone of the outward normals at q. That makes q the nearest point: the cone is polar
// to the directions from q into the polytope, and these are spanned by those into the facet, the
// two facets or along the edges at q.

bool NearestPoint::in_facet_region(std::uint32_t facet, const Homogeneous& x) const {
  for (const std::uint32_t h : of_facet_[facet]) {
    if (x.side_of(half_edges_[h].side) == Sign::Positive) return false;
  }
  return true;
}

bool NearestPoint::in_edge_region(std::uint32_t half_edge, const Homogeneous& x) const {
  const HalfEdge& h = half_edges_[half_edge];
  const HalfEdge& twin = half_edges_[h.twin];
  return x.side_of(h.side) != Sign::Negative && x.side_of(twin.side) != Sign::Negative &&
         x.side_of(h.end) != Sign::Negative && x.side_of(twin.end) != Sign::Negative;
}

bool NearestPoint::in_vertex_region(std::uint32_t vertex, const Homogeneous& x) const {
  for (const std::uint32_t h : of_vertex_[vertex]) {
    if (x.side_of(half_edges_[h].end) == Sign::Positive) return false;
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

RationalPoint NearestPoint::operator()(const RationalPoint& x) const {
  const Homogeneous homogeneous(x);
  std::vector<std::uint32_t> visible;
  for (std::uint32_t f = 0; f < polytope_.planes.size(); ++f) {
    if (homogeneous.side_of(polytope_.planes[f]) == Sign::Positive) visible.push_back(f);
  }
  if (visible.empty()) return x;
  return nearest_on_visible(visible, x, homogeneous);
}

// Only features of visible facets are asked. With q nearest to x, x - q = sum of y_f n_f over the
// facets at q, y_f >= 0, so 0 < |x - q|^2 = sum of y_f n_f.(x - q): one of these facets is visible
// from x.
RationalPoint NearestPoint::nearest_on_visible(const std::vector<std::uint32_t>& visible,
                                               const RationalPoint& x,
                                               const Homogeneous& homogeneous) const {
  for (const std::uint32_t f : visible) {
    if (in_facet_region(f, homogeneous)) return project_to_plane(polytope_.planes[f], x);
  }
  for (const std::uint32_t f : visible) {
    for (const std::uint32_t h : of_facet_[f]) {
      const HalfEdge& edge = half_edges_[h];
      if (in_edge_region(h, homogeneous)) {
        return project_to_line(polytope_.vertices[edge.tail], polytope_.vertices[edge.head], x);
      }
      if (in_vertex_region(edge.tail, homogeneous)) return polytope_.vertices[edge.tail];
    }
  }
  throw Error(ErrorCode::InvalidArgument, "the facets of a polytope are not convex");
}

namespace {

bool comes_before(const RationalPoint& a, const RationalPoint& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

HausdorffDistance hausdorff_distance(const Polytope& outer, const Polytope& inner) {
  const NearestPoint nearest_point(inner);
  std::vector<RationalPoint> shared = inner.vertices;
  std::sort(shared.begin(), shared.end(), comes_before);
  std::optional<HausdorffDistance> best;
  for (std::uint32_t v = 0; v < outer.vertices.size(); ++v) {
    const RationalPoint& vertex = outer.vertices[v];
    // A vertex of both needs no look at the facets: hulls often share most of them.
    const bool is_shared = std::binary_search(shared.begin(), shared.end(), vertex, comes_before);
    RationalPoint nearest = is_shared ? vertex : nearest_point(vertex);
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
