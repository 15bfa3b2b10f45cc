// SPDX-License-Identifier: MIT
#include "oracle/cone_location.hpp"

#include <algorithm>
#include <tuple>

#include "convexact/error.hpp"
#include "convexact/predicates.hpp"

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

}  // namespace convexact::oracle
