// SPDX-License-Identifier: MIT
#include "cut/notches.hpp"

#include <algorithm>
#include <cmath>

#include "surface/edges.hpp"

namespace convexact {
namespace {

constexpr std::size_t kStrongest = 15;  // edges whose planes are tried

// Twice the area vector, in the frame; off by less than kCutError in each component.
Point area_of(const Surface& surface, const CutPoints& points, std::uint32_t triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  const Point& x = points.near(a.value);
  const Point u = points.near(b.value) - x, v = points.near(c.value) - x;
  return u.cross(v);
}

bool is_flat(const CutPoints& points, const Point& area, std::uint32_t triangle) {
  return (points.is_exact() || !(area.lpNorm<Eigen::Infinity>() > kCutError)) &&
         has_no_area(points.surface().points, points.surface().triangles[triangle]);
}

// On which side of a triangle's plane a point lies.
Sign side_of_triangle(const CutPoints& points, const Point& area, std::uint32_t triangle,
                      PointId p) {
  const Surface& surface = points.surface();
  const Point& from = points.near(surface.triangles[triangle][0].value);
  const double height = area.dot(points.near(p.value) - from);
  if (!points.is_exact() && std::abs(height) > 8 * kCutError)
    return height > 0 ? Sign::Positive : Sign::Negative;
  return points.side(CutPlane(triangle_plane(surface, triangle), points.frame()), p.value);
}

// A direction as integers of 16 bits; 0 if it is so short that it is none.
RationalVector3 in_short_integers(const Point& direction) {
  constexpr double kMost = 32767;
  const double share = kMost / direction.lpNorm<Eigen::Infinity>();
  RationalVector3 vector(0, 0, 0);
  for (int k = 0; k < 3 && std::isfinite(share); ++k) vector[k] = std::lround(direction[k] * share);
  return vector;
}

PointId opposite(const Triangle& triangle, PointId a, PointId b) {
  for (const PointId p : triangle) {
    if (p != a && p != b) return p;
  }
  return triangle[0];
}

}  // namespace

Notches::Notches(const Surface& surface, const CutPoints& points, CutPlanes kind)
    : surface_(surface), points_(points), kind_(kind) {
  EdgeTable(surface.triangles).for_each([&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2 && kind_ != CutPlanes::Facets) return;
    for (std::size_t k = 1; k < uses.size(); ++k) add(uses[k - 1], uses[k], uses.size() == 2);
  });
}

void Notches::add(const EdgeUse& one, const EdgeUse& other, bool if_concave) {
  const std::uint32_t left = one.triangle, right = other.triangle;
  const Point m = area_of(surface_, points_, left), n = area_of(surface_, points_, right);
  if (is_flat(points_, m, left) || is_flat(points_, n, right)) return;
  const PointId tip = opposite(surface_.triangles[right], one.low, one.high);
  const Sign above = side_of_triangle(points_, m, left, tip);
  if (above == Sign::Zero || (if_concave && above == Sign::Negative && surface_.is_closed)) return;
  const double cosine = m.dot(n) / (m.norm() * n.norm());
  edges_.push_back({one.low, one.high, left, right, 1 - cosine * std::abs(cosine)});
}

std::vector<NotchEdge> Notches::all() const {
  std::vector<NotchEdge> list;
  for (std::uint32_t e = 0; e < edges_.size(); ++e) list.push_back({e, 0, 1});
  return list;
}

std::vector<NotchEdge> Notches::clipped(const std::vector<NotchEdge>& notches,
                                        const CutPlane& plane, Sign side) const {
  constexpr double kNothing = 0x1p-30;
  std::vector<NotchEdge> list;
  for (NotchEdge notch : notches) {
    const double sign = side == Sign::Positive ? 1 : -1;
    const double at_low = sign * plane(points_.near(edges_[notch.edge].low.value)),
                 at_high = sign * plane(points_.near(edges_[notch.edge].high.value));
    // Edges in the plane are cut already.
    if (std::max(at_low, at_high) <= kCutError) continue;
    if (at_low < 0) notch.from = std::max(notch.from, at_low / (at_low - at_high));
    if (at_high < 0) notch.to = std::min(notch.to, at_low / (at_low - at_high));
    if (notch.to - notch.from > kNothing) list.push_back(notch);
  }
  return list;
}

std::vector<Halfspace> Notches::planes(const std::vector<NotchEdge>& notches) const {
  std::vector<std::pair<double, const NotchEdge*>> order;
  for (const NotchEdge& notch : notches) {
    const Edge& edge = edges_[notch.edge];
    const Point along = points_.near(edge.high.value) - points_.near(edge.low.value);
    const double share = notch.to - notch.from;
    order.emplace_back(share * share * along.squaredNorm() * edge.sharpness, &notch);
  }
  const auto last = order.begin() + static_cast<long>(std::min(kStrongest, order.size()));
  std::partial_sort(order.begin(), last, order.end(), [](const auto& a, const auto& b) {
    return a.first > b.first || (a.first == b.first && a.second->edge < b.second->edge);
  });
  std::vector<Halfspace> list;
  for (auto it = order.begin(); it != last; ++it) {
    const Edge& edge = edges_[it->second->edge];
    if (kind_ != CutPlanes::Bisectors) {
      list.push_back(turned(triangle_plane(surface_, edge.left)));
      list.push_back(turned(triangle_plane(surface_, edge.right)));
    }
    if (kind_ == CutPlanes::Facets) continue;
    if (const auto plane = bisector(edge)) list.push_back(*plane);
  }
  return list;
}

// It holds the edge exactly, else what lies on one side would reach a little around the edge: only
// the direction across the edge is rounded.
std::optional<Halfspace> Notches::bisector(const Edge& edge) const {
  const Point m = area_of(surface_, points_, edge.left).normalized(),
              n = area_of(surface_, points_, edge.right).normalized();
  const Point along = points_.near(edge.high.value) - points_.near(edge.low.value);
  const RationalPoint low = surface_.points[edge.low];
  const RationalVector3 exact_edge = surface_.points[edge.high] - low;
  const RationalVector3 normal = exact_edge.cross(in_short_integers(along.cross(m - n)));
  if (normal.isZero()) return {};
  return turned(Halfspace(normal, Rational(-normal.dot(low))));
}

Halfspace plane_across(const Point& direction, const Point& through, const NearFrame& frame) {
  const RationalVector3 normal = in_short_integers(direction);
  return turned(Halfspace(normal, Rational(-normal.dot(frame.point(through)))));
}

Halfspace turned(const Halfspace& plane) {
  for (const Integer& x : plane.normal()) {
    if (x == 0) continue;
    return x > 0 ? plane : Halfspace(IntegerVector3(-plane.normal()), -plane.offset());
  }
  return plane;
}

}  // namespace convexact
