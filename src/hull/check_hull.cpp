// SPDX-License-Identifier: MIT
// The checker of hulls, after [Mehlhorn1999]. It shares the points, their predicates and filters
// (exact_points.hpp) with the construction, and no other code. docs/design/hull.md proves that
// these checks suffice.
#include <algorithm>
#include <numeric>

#include "convexact/hull.hpp"
#include "hull/exact_points.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

template <class Points>
class HullCheck {
 public:
  HullCheck(const Hull& hull, Points points) : hull_(hull), points_(std::move(points)) {}

  bool passes() {
    if (!ids_are_valid() || !simplex_spans()) return false;
    points_.center_at(hull_.certificate.simplex);
    return facets_turn_left() && ridges_are_convex() && listed_ones_are_corners() &&
           the_rest_is_inside() && one_ray_meets_one_triangle();
  }

 private:
  bool ids_are_valid() const {
    const auto valid = [&](PointId p) { return p.index() < points_.size(); };
    const auto& v = hull_.vertices;
    const auto not_ascending = [](PointId a, PointId b) { return a >= b; };
    if (!std::ranges::all_of(v, valid) || std::ranges::adjacent_find(v, not_ascending) != v.end())
      return false;
    for (std::size_t f = 0; f < hull_.facets.size(); ++f) {
      if (hull_.facets[f].size() < 3 || !std::ranges::all_of(hull_.facets[f], valid)) return false;
    }
    for (const InsideProof& proof : hull_.certificate.inside) {
      if (!valid(proof.point) || !std::ranges::all_of(proof.triangle, valid)) return false;
    }
    return std::ranges::all_of(hull_.certificate.simplex, valid);
  }

  // Then its centroid o is an interior point of the true hull.
  bool simplex_spans() const {
    const auto& s = hull_.certificate.simplex;
    return points_.side(s[0], s[1], s[2], s[3]) != Sign::Zero;
  }

  Sign turn(PointId a, PointId b, PointId c) const { return center_side_of(points_, a, b, c); }

  bool facets_turn_left() const {
    for (std::size_t f = 0; f < hull_.facets.size(); ++f) {
      if (!turns_left(hull_.facets[f])) return false;
    }
    return true;
  }

  // A polygon in one plane, with o strictly below: a fan of triangles that all turn left about o.
  bool turns_left(std::span<const PointId> c) const {
    const NearPlane plane = NearPlane::through(
        points_.near()[c[0].index()], points_.near()[c[1].index()], points_.near()[c[2].index()]);
    for (std::size_t k = 2; k < c.size(); ++k) {
      if (turn(c[0], c[k - 1], c[k]) != Sign::Positive) return false;
      if (k >= 3 && side_of(points_, plane, {c[0], c[1], c[2]}, c[k]) != Sign::Zero) return false;
    }
    return true;
  }

  // A directed edge of a facet, and the corner after its end.
  struct Edge {
    PointId from, to, next;
    std::size_t facet;
  };

  // Stable, linear.
  std::vector<Edge> sorted_by(PointId Edge::*key, const std::vector<Edge>& edges) const {
    std::vector<std::size_t> place(points_.size() + 1, 0);
    for (const Edge& e : edges) ++place[(e.*key).index() + 1];
    std::partial_sum(place.begin(), place.end(), place.begin());
    std::vector<Edge> sorted(edges.size());
    for (const Edge& e : edges) sorted[place[(e.*key).index()]++] = e;
    return sorted;
  }

  // Every directed edge occurs in the other direction as well (closed), and the facet across it
  // falls off strictly. Sorted by (from, to) and by (to, from), an edge stands where its opposite
  // does. (An edge that occurs twice belongs to a second sheet, which the ray meets.)
  bool ridges_are_convex() const {
    std::vector<Edge> edges;
    edges.reserve(hull_.facets.corner_count());
    for (std::size_t f = 0; f < hull_.facets.size(); ++f) {
      const auto c = hull_.facets[f];
      for (std::size_t k = 0; k < c.size(); ++k)
        edges.push_back({c[k], c[(k + 1) % c.size()], c[(k + 2) % c.size()], f});
    }
    const auto over = sorted_by(&Edge::to, sorted_by(&Edge::from, edges));
    edges = sorted_by(&Edge::from, sorted_by(&Edge::to, edges));
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Edge& e = edges[i];
      const bool is_opposite = e.from == over[i].to && e.to == over[i].from;
      if (!is_opposite) return false;
      const auto c = hull_.facets[e.facet];
      if (side_of(points_, {c[0], c[1], c[2]}, over[i].next) != Sign::Negative) return false;
    }
    return true;
  }

  // Every listed vertex is a corner. A corner that is not listed is extreme, so no proof from
  // listed ones can say that it is inside.
  bool listed_ones_are_corners() const {
    std::vector<bool> used(points_.size(), false);
    for (std::size_t f = 0; f < hull_.facets.size(); ++f) {
      for (const PointId p : hull_.facets[f]) used[p.index()] = true;
    }
    return std::ranges::all_of(hull_.vertices, [&](PointId p) { return used[p.index()]; });
  }

  // The ray from o through the interior of the first triangle, along r = c0 + c1 + c2 - 3o, stays
  // clear of every other (closed) triangle of the facets' fans.
  bool one_ray_meets_one_triangle() const {
    const auto first = hull_.facets[0];
    const std::array<PointId, 3> ray{first[0], first[1], first[2]};
    std::size_t met = 0;
    for (std::size_t f = 0; f < hull_.facets.size(); ++f) {
      const auto c = hull_.facets[f];
      for (std::size_t k = 2; k < c.size(); ++k) met += is_in_cone({c[0], c[k - 1], c[k]}, ray);
    }
    return met == 1;
  }

  bool is_in_cone(const std::array<PointId, 3>& t, const std::array<PointId, 3>& ray) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (ray_side(t[k], t[(k + 1) % 3], ray) == Sign::Negative) return false;
    }
    return true;
  }

  // The sign of det[a-o; b-o; r], r the sum of three points from o.
  Sign ray_side(PointId a, PointId b, const std::array<PointId, 3>& ray) const {
    const auto near = points_.near();
    const NearPoint normal = cross(near[a.index()], near[b.index()]);
    double sum = 0;
    for (const PointId p : ray) sum += dot(normal, near[p.index()]);
    // Three times the error of one, and two sums of values up to 18.
    if (const auto sign = certain_sign(sum, 3 * kCenterBound + 64 * kUnitRoundoff)) return *sign;
    const RationalPoint center = points_.center();
    const RationalVector3 u = points_.rational(a) - center, v = points_.rational(b) - center;
    const RationalVector3 exact = u.cross(v);
    Rational value = 0;
    for (const PointId p : ray) value += exact.dot(RationalVector3(points_.rational(p) - center));
    return sign_of(value);
  }

  // Backwards, each point lies in a tetrahedron of o and points that are known to be in the hull.
  bool the_rest_is_inside() const {
    std::vector<bool> known(points_.size(), false);
    std::size_t count = hull_.vertices.size();
    for (const PointId p : hull_.vertices) known[p.index()] = true;
    const auto& proofs = hull_.certificate.inside;
    for (auto proof = proofs.rbegin(); proof != proofs.rend(); ++proof, ++count) {
      const auto& [p, t] = *proof;
      if (known[p.index()] || !is_inside(p, t)) return false;
      for (const PointId corner : t) {
        if (!known[corner.index()]) return false;
      }
      known[p.index()] = true;
    }
    return count == points_.size();
  }

  bool is_inside(PointId p, const std::array<PointId, 3>& t) const {
    if (t[0] == t[1] && t[1] == t[2]) return points_.equal(p, t[0]);
    return turn(t[0], t[1], t[2]) == Sign::Positive && turn(t[0], t[1], p) != Sign::Negative &&
           turn(t[1], t[2], p) != Sign::Negative && turn(t[2], t[0], p) != Sign::Negative &&
           side_of(points_, t, p) != Sign::Positive;
  }

  const Hull& hull_;
  Points points_;
};

}  // namespace

bool check_hull(const Hull& hull, const PointSet& points) {
  if (points.is_binary()) return HullCheck(hull, DoublePoints(points.doubles())).passes();
  return HullCheck(hull, HomogeneousPoints(points)).passes();
}

bool check_hull(const Hull& hull, std::span<const HomogeneousPoint> points) {
  return HullCheck(hull, HomogeneousPoints(points)).passes();
}

}  // namespace convexact
