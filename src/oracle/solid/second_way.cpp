// SPDX-License-Identifier: MIT
#include "oracle/solid/second_way.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/number.hpp"
#include "number/arithmetic.hpp"

namespace convexact::oracle {
namespace {

PointSet all_in_doubles(const PointSet& mesh, const PointSet& points,
                        const std::array<PointId, 4>& simplex) {
  std::vector<Point> all(mesh.doubles().begin(), mesh.doubles().end());
  all.insert(all.end(), points.doubles().begin(), points.doubles().end());
  Point center = Point::Zero();
  for (const PointId id : simplex) center += 0.25 * mesh.doubles()[id.index()];
  all.push_back(center);
  return PointSet(std::move(all));
}

PointSet all_in_rationals(const PointSet& mesh, const PointSet& points,
                          const std::array<PointId, 4>& simplex) {
  std::vector<RationalPoint> all;
  for (std::size_t i = 0; i < mesh.size(); ++i) all.push_back(mesh[PointId(i)]);
  for (std::size_t i = 0; i < points.size(); ++i) all.push_back(points[PointId(i)]);
  RationalPoint center = RationalPoint::Zero();
  for (const PointId id : simplex) center += mesh[id] / Rational(4);
  all.push_back(center);
  return PointSet(std::move(all));
}

// In the direction of n, of a length that doubles hold.
Vector3<double> to_direction(const IntegerVector3& n) {
  const auto bits = static_cast<long>(bit_length(n));
  Vector3<double> direction;
  for (int k = 0; k < 3; ++k) {
    direction[k] = to_double(scale_by_power_of_two(Rational(n[k]), -bits), Rounding::Nearest);
  }
  return direction;
}

}  // namespace

ConeLocation::ConeLocation(const Hull& hull, const PointSet& mesh, const PointSet& points)
    : first_point_(mesh.size()), center_(mesh.size() + points.size()) {
  add_triangles(hull.facets);
  join_neighbors();
  // The centroid of four corners that span a volume is strictly inside; rounded, it may not be.
  const auto& simplex = hull.certificate.simplex;
  const bool is_binary = mesh.is_binary() && points.is_binary();
  if (is_binary) all_ = all_in_doubles(mesh, points, simplex);
  if (!is_binary || !is_center_inside(simplex)) all_ = all_in_rationals(mesh, points, simplex);
}

void ConeLocation::add_triangles(const FacetList& facets) {
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto corners = facets[f];
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      triangles_.push_back({{corners[0].value, corners[k].value, corners[k + 1].value}, {}});
    }
  }
}

void ConeLocation::join_neighbors() {
  struct Side {
    std::uint32_t low, high, triangle;
    std::size_t slot;
  };
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& c = triangles_[t].corners;
      const auto [low, high] = std::minmax(c[k], c[(k + 1) % 3]);
      sides.push_back({low, high, t, k});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  });
  for (std::size_t s = 0; s + 1 < sides.size(); s += 2) {
    const Side &one = sides[s], &other = sides[s + 1];
    CONVEXACT_ASSERT(one.low == other.low && one.high == other.high);
    triangles_[one.triangle].neighbors[one.slot] = other.triangle;
    triangles_[other.triangle].neighbors[other.slot] = one.triangle;
  }
}

// Opposite each corner, o and the corner are strictly on the same side of the other three.
bool ConeLocation::is_center_inside(const std::array<PointId, 4>& simplex) const {
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t a = simplex[(k + 1) % 4].index(), b = simplex[(k + 2) % 4].index(),
                      c = simplex[(k + 3) % 4].index(), apex = simplex[k].index();
    if (is_beyond(a, b, c, center_) != is_beyond(a, b, c, apex)) return false;
    if (is_beyond(a, c, b, center_) != is_beyond(a, c, b, apex)) return false;
  }
  return true;
}

bool ConeLocation::is_beyond(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const {
  if (all_.is_binary()) {
    const auto points = all_.doubles();
    return convexact::is_beyond(points[a], points[b], points[c], points[p]);
  }
  const RationalPoint origin = all_[PointId(a)];
  const RationalVector3 u = all_[PointId(b)] - origin, v = all_[PointId(c)] - origin,
                        w = all_[PointId(p)] - origin;
  return u.cross(v).dot(w) > 0;
}

std::uint32_t ConeLocation::locate(std::size_t point, std::uint32_t start) const {
  std::uint32_t at = start;
  for (std::size_t k = 0; k < 3;) {
    const auto& [corners, neighbors] = triangles_[at];
    if (is_beyond(corners[(k + 1) % 3], corners[k], center_, first_point_ + point)) {
      at = neighbors[k];
      k = 0;
    } else {
      ++k;
    }
  }
  return at;
}

bool ConeLocation::is_outside(std::size_t point, std::uint32_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle].corners;
  return is_beyond(a, b, c, first_point_ + point);
}

SupportProgram::SupportProgram(const Polytope& polytope)
    : polytope_(polytope), around_(polytope.vertices.size()), neighbors_(polytope.vertices.size()) {
  for (const RationalPoint& v : polytope.vertices) {
    Vector3<double> near;
    for (int k = 0; k < 3; ++k) near[k] = to_double(v[k], Rounding::Nearest);
    near_.push_back(near);
  }
  // Counter-clockwise around a vertex, a facet is followed by the one that leaves the vertex along
  // the edge by which this facet enters it.
  struct Corner {
    std::uint32_t vertex, next, previous, facet;
  };
  std::vector<Corner> corners;
  for (std::uint32_t f = 0; f < polytope.facets.size(); ++f) {
    const auto& around = polytope.facets[f];
    for (std::size_t k = 0, n = around.size(); k < n; ++k) {
      corners.push_back({around[k], around[(k + 1) % n], around[(k + n - 1) % n], f});
    }
  }
  const auto place = [](const Corner& c) { return std::pair(c.vertex, c.next); };
  std::sort(corners.begin(), corners.end(),
            [&](const Corner& a, const Corner& b) { return place(a) < place(b); });
  for (const Corner& start : corners) {
    const std::uint32_t v = start.vertex;
    if (!around_[v].empty()) continue;
    const Corner* at = &start;
    do {
      around_[v].push_back(at->facet);
      neighbors_[v].push_back(at->next);
      const std::pair wanted(v, at->previous);
      const auto found =
          std::lower_bound(corners.begin(), corners.end(), wanted,
                           [&](const Corner& c, const auto& key) { return place(c) < key; });
      CONVEXACT_ASSERT(found != corners.end() && place(*found) == wanted);
      at = &*found;
    } while (at != &start);
  }
}

Rational SupportProgram::maximum(const IntegerVector3& n) {
  last_ = climb_in_doubles(to_direction(n));
  const RationalVector3 exact = n.cast<Rational>();
  while (!is_optimal(last_, n)) last_ = better_neighbor(last_, exact);
  return polytope_.vertices[last_].dot(exact);
}

std::uint32_t SupportProgram::climb_in_doubles(const Vector3<double>& direction) const {
  std::uint32_t at = last_;
  double highest = direction.dot(near_[at]);
  for (bool climbs = true; climbs;) {
    climbs = false;
    for (const std::uint32_t v : neighbors_[at]) {
      const double height = direction.dot(near_[v]);
      if (height <= highest || std::isnan(height)) continue;
      at = v;
      highest = height;
      climbs = true;
      break;
    }
  }
  return at;
}

// A vertex that is not optimal has an edge that leads strictly higher.
std::uint32_t SupportProgram::better_neighbor(std::uint32_t vertex,
                                              const RationalVector3& n) const {
  const Rational height = polytope_.vertices[vertex].dot(n);
  for (const std::uint32_t v : neighbors_[vertex]) {
    if (polytope_.vertices[v].dot(n) > height) return v;
  }
  throw Error(ErrorCode::Internal, "no vertex of a polytope is the largest one");
}

// The normals of the facets at a vertex, counter-clockwise, span the cone of the functionals that
// are largest there; it falls into the cones of a fan of triples (0, k, k + 1). Of the three signs
// that place n in one of them, det(k + 1, 0, n) is the first sign of the next one, turned around.
bool SupportProgram::is_optimal(std::size_t vertex, const IntegerVector3& n) const {
  const auto normal = [&](std::size_t k) -> const IntegerVector3& {
    return polytope_.planes[around_[vertex][k]].normal();
  };
  IntegerVector3 turned = normal(1).cross(n);
  Sign from_first = sign_of(Integer(normal(0).dot(turned)));  // of det(0, k, n)
  for (std::size_t k = 1; k + 1 < around_[vertex].size(); ++k) {
    turned = normal(k + 1).cross(n);
    const Sign from_next = sign_of(Integer(normal(0).dot(turned)));
    if (from_first != Sign::Negative && from_next != Sign::Positive &&
        sign_of(Integer(normal(k).dot(turned))) != Sign::Negative) {
      return true;
    }
    from_first = from_next;
  }
  return false;
}

}  // namespace convexact::oracle
