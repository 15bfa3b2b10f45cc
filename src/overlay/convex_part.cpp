// SPDX-License-Identifier: MIT
// Convex parts: hulls of any dimension as closed halfspaces, and common interiors.
#include <algorithm>
#include <variant>

#include "convexact/error.hpp"
#include "convexact/overlay.hpp"
#include "number/arithmetic.hpp"
#include "overlay/union_boundary.hpp"

namespace convexact {
namespace {

Halfspace halfspace_at(const RationalVector3& normal, const RationalPoint& p) {
  return {normal, Rational(-normal.dot(p))};
}

void add_both_sides(const Halfspace& plane, std::vector<Halfspace>& halfspaces) {
  halfspaces.push_back(plane);
  halfspaces.emplace_back(IntegerVector3(-plane.normal()), Integer(-plane.offset()));
}

// The corners of the hull of distinct coplanar points, counter-clockwise seen from where the normal
// points, by a monotone chain in the projection along an axis k with n_k != 0, which keeps
// distinct points of the plane distinct.
std::vector<RationalPoint> planar_hull(std::vector<RationalPoint> points,
                                       const IntegerVector3& normal) {
  const int k = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  const int u = (k + 1) % 3, v = (k + 2) % 3;
  std::sort(points.begin(), points.end(), [&](const RationalPoint& a, const RationalPoint& b) {
    return a[u] != b[u] ? a[u] < b[u] : a[v] < b[v];
  });
  const auto turns_left = [&](const RationalPoint& a, const RationalPoint& b,
                              const RationalPoint& c) {
    return (b[u] - a[u]) * (c[v] - a[v]) > (b[v] - a[v]) * (c[u] - a[u]);
  };
  std::vector<RationalPoint> chain;
  const auto add = [&](const RationalPoint& p, std::size_t first) {
    while (chain.size() >= first + 2 && !turns_left(chain[chain.size() - 2], chain.back(), p)) {
      chain.pop_back();
    }
    chain.push_back(p);
  };
  for (const RationalPoint& p : points) add(p, 0);
  const std::size_t lower = chain.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  chain.pop_back();  // the first point again
  // The projection along k keeps the orientation if n_k > 0.
  if (normal[k] < 0) std::reverse(chain.begin(), chain.end());
  return chain;
}

void make_flat(const FlatInput& flat, const PointSet& points, ConvexPart& part) {
  std::vector<RationalPoint> distinct;
  for (std::size_t i = 0; i < points.size(); ++i) distinct.push_back(points[PointId(i)]);
  std::sort(distinct.begin(), distinct.end(), precedes<RationalPoint>);
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  part.dimension = flat.dimension;
  for (const Halfspace& plane : flat.equations) add_both_sides(plane, part.halfspaces);
  if (flat.dimension == 0) {
    part.vertices = {distinct.front()};
  } else if (flat.dimension == 1) {
    part.vertices = {distinct.front(), distinct.back()};
    const RationalVector3 along = distinct.back() - distinct.front();
    part.halfspaces.push_back(halfspace_at(-along, distinct.front()));
    part.halfspaces.push_back(halfspace_at(along, distinct.back()));
  } else {
    const IntegerVector3& normal = flat.equations.front().normal();
    part.vertices = planar_hull(std::move(distinct), normal);
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      const RationalPoint& a = part.vertices[i];
      const RationalVector3 side = part.vertices[(i + 1) % part.vertices.size()] - a;
      const RationalVector3 outward = side.cross(normal.cast<Rational>());
      part.halfspaces.push_back(halfspace_at(outward, a));
    }
  }
}

}  // namespace

ConvexPart convex_part(const PointSet& points, const Watch& watch) {
  if (points.size() == 0) {
    throw Error(ErrorCode::InvalidArgument, "a convex part needs a point");
  }
  watch.ask();
  ConvexPart part;
  const HullOutcome outcome = convex_hull(points);
  if (const auto* hull = std::get_if<Hull>(&outcome)) {
    part.dimension = 3;
    part.solid = to_polytope(*hull, points);
    part.vertices = part.solid->vertices;
    part.halfspaces = part.solid->planes;
  } else {
    make_flat(std::get<FlatInput>(outcome), points, part);
  }
  part.box = bounding_box(part.vertices);
  return part;
}

bool holds(const ConvexPart& part, const RationalPoint& x) {
  const HomogeneousPoint p = to_homogeneous(x);
  return std::all_of(part.halfspaces.begin(), part.halfspaces.end(),
                     [&](const Halfspace& h) { return plane_value(h, p) <= 0; });
}

namespace {

bool is_inside(const ConvexPart& part, const HomogeneousPoint& p) {
  return std::all_of(part.halfspaces.begin(), part.halfspaces.end(),
                     [&](const Halfspace& h) { return plane_value(h, p) < 0; });
}

bool boxes_overlap(const BoundingBox& a, const BoundingBox& b) {
  for (int k = 0; k < 3; ++k) {
    if (a.high[k] <= b.low[k] || b.high[k] <= a.low[k]) return false;
  }
  return true;
}

// Whether all vertices of `b` lie beyond or on some facet of `a`.
bool parts(const LaidPart& a, const LaidPart& b) {
  for (std::size_t h = 0; h < a.planes.size(); ++h) {
    bool has_inside = false;
    for (std::size_t i = 0; i < b.vertices.size() && !has_inside; ++i) {
      has_inside = a.side(h, b.vertices, i) == Sign::Negative;
    }
    if (!has_inside) return true;
  }
  return false;
}

// A point inside both, behind a facet of the first that has an area inside the second.
std::optional<RationalPoint> behind_facet_inside(const LaidPart& one, const LaidPart& other,
                                                 long exponent) {
  const Polytope& solid = *one.part->solid;
  for (std::size_t f = 0; f < solid.facets.size(); ++f) {
    const Meeting met = meeting(other, one.vertices, solid.facets[f]);
    if (met.kind == Meeting::Apart || met.coplanar) continue;
    PlanePieces facet = whole_facet(one, f);
    std::vector<std::uint32_t> rows;
    for (const std::size_t h : met.planes) {
      rows.push_back(facet.arrangement.add(other.part->halfspaces[h]));
    }
    const auto taken = subtract<3>(facet.arrangement, facet.pieces, rows);
    if (taken.empty()) continue;
    // x is on the boundary of one part and inside the other, so small steps inward stay inside
    // both.
    const RationalPoint x = facet.arrangement.point(interior_of(facet.arrangement, taken.front()));
    const IntegerVector3& normal = solid.planes[f].normal();
    const long length = exponent - static_cast<long>(bit_length(normal));
    for (long j = 2;; j += 1 + j / 8) {
      RationalPoint y = x;
      for (int k = 0; k < 3; ++k) {
        y[k] -= scale_by_power_of_two(Rational(normal[k]), length - j);
      }
      const HomogeneousPoint p = to_homogeneous(y);
      if (is_inside(*one.part, p) && is_inside(*other.part, p)) return y;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<RationalPoint> common_interior(const ConvexPart& a, const ConvexPart& b) {
  if (!a.solid || !b.solid || !boxes_overlap(a.box, b.box)) return std::nullopt;
  // (1) A facet that separates them.
  const std::array<BoundingBox, 2> boxes{a.box, b.box};
  const long exponent = common_exponent(boxes);
  const LaidPart first(a, exponent), second(b, exponent);
  if (parts(first, second) || parts(second, first)) return std::nullopt;
  // (2) The middle of one of them, or of the common box, rounded, may be inside both.
  RationalPoint middle_of[3];
  middle_of[2] = RationalPoint::Zero();
  const ConvexPart* both[2] = {&a, &b};
  for (int s = 0; s < 2; ++s) {
    Point sum = Point::Zero();
    const LaidPart& part = s == 0 ? first : second;
    for (std::size_t i = 0; i < part.vertices.size(); ++i) sum += part.vertices.near(i);
    const Point mean = sum / static_cast<double>(part.vertices.size());
    for (int k = 0; k < 3; ++k) {
      middle_of[s][k] = scale_by_power_of_two(to_rational(mean[k]), exponent);
    }
  }
  for (int k = 0; k < 3; ++k) {
    middle_of[2][k] = (std::max<Rational>(both[0]->box.low[k], both[1]->box.low[k]) +
                       std::min<Rational>(both[0]->box.high[k], both[1]->box.high[k])) /
                      2;
  }
  for (const RationalPoint& middle : middle_of) {
    const HomogeneousPoint p = to_homogeneous(middle);
    if (is_inside(a, p) && is_inside(b, p)) return middle;
  }
  // (3) A facet of one with an area inside the other: the interior of both is near it. If there is
  // none, then either the interiors have no common point, or the second part lies in the first,
  // which (2) or the exact middle of its vertices shows.
  for (const auto& [one, other] : {std::pair(&first, &second), std::pair(&second, &first)}) {
    if (auto found = behind_facet_inside(*one, *other, exponent)) return found;
  }
  for (const ConvexPart* part : {&a, &b}) {
    RationalPoint sum = RationalPoint::Zero();
    for (const RationalPoint& v : part->vertices) sum += v;
    const RationalPoint mean = sum / Rational(part->vertices.size());
    const HomogeneousPoint p = to_homogeneous(mean);
    if (is_inside(a, p) && is_inside(b, p)) return mean;
  }
  return std::nullopt;
}

}  // namespace convexact
