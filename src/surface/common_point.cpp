// SPDX-License-Identifier: MIT
#include "surface/common_point.hpp"

#include <algorithm>

#include "convexact/predicates.hpp"

namespace convexact {
namespace {

// In each of three views: one of them separates points of a common plane or line.
bool segments_meet(const PointSet& points, PointId p, PointId q, PointId a, PointId b) {
  if (orient(points, p, q, a, b) != Sign::Zero) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!PlaneView(points, axis).meet(p, q, a, b)) return false;
  }
  return true;
}

bool segment_meets(const PointSet& points, PointId p, PointId q, const Triangle& t) {
  const auto& [a, b, c] = t;
  if (has_no_area(points, t)) {
    return segments_meet(points, p, q, a, b) || segments_meet(points, p, q, b, c) ||
           segments_meet(points, p, q, c, a);
  }
  const Sign at_p = orient(points, a, b, c, p), at_q = orient(points, a, b, c, q);
  if (at_p != Sign::Zero && at_p == at_q) return false;
  if (at_p == Sign::Zero && at_q == Sign::Zero) {
    const PlaneView view(points, seen_along(points, t));
    return view.is_in(t, p) || view.meet(p, q, a, b) || view.meet(p, q, b, c) ||
           view.meet(p, q, c, a);
  }
  // The segment meets the plane in one point; its line must not pass the edges on different sides.
  const Sign sides[] = {orient(points, p, q, a, b), orient(points, p, q, b, c),
                        orient(points, p, q, c, a)};
  const auto has = [&](Sign sign) {
    return std::find(std::begin(sides), std::end(sides), sign) != std::end(sides);
  };
  return !has(Sign::Positive) || !has(Sign::Negative);
}

bool an_edge_meets(const PointSet& points, const Triangle& s, const Triangle& t) {
  for (int k = 0; k < 3; ++k) {
    if (segment_meets(points, s[k], s[(k + 1) % 3], t)) return true;
  }
  return false;
}

}  // namespace

Sign orient(const PointSet& points, PointId a, PointId b, PointId c, PointId d) {
  if (points.is_binary()) {
    const auto p = points.doubles();
    return orient3d(p[a.index()], p[b.index()], p[c.index()], p[d.index()]);
  }
  const RationalPoint x = points[d];
  return sign_of(
      Rational(RationalVector3(points[a] - x)
                   .dot(RationalVector3(points[b] - x).cross(RationalVector3(points[c] - x)))));
}

bool have_common_point(const PointSet& points, const Triangle& s, const Triangle& t) {
  return an_edge_meets(points, s, t) || an_edge_meets(points, t, s);
}

bool cross(const PointSet& points, const Triangle& s, const Triangle& t) {
  std::vector<PointId> shared, of_s, of_t;
  for (const PointId p : s) {
    const bool is_shared = std::find(t.begin(), t.end(), p) != t.end();
    (is_shared ? shared : of_s).push_back(p);
  }
  for (const PointId p : t) {
    if (std::find(s.begin(), s.end(), p) == s.end()) of_t.push_back(p);
  }
  switch (shared.size()) {
    case 0:
      return have_common_point(points, s, t);
    case 1:  // The common set is convex, and leaves one of them through the opposite edge.
      return segment_meets(points, of_s[0], of_s[1], t) ||
             segment_meets(points, of_t[0], of_t[1], s);
    case 2: {  // In one plane, and on the same side of the edge.
      if (orient(points, shared[0], shared[1], of_s[0], of_t[0]) != Sign::Zero) return false;
      const PlaneView view(points, seen_along(points, s));
      return view.turn(shared[0], shared[1], of_s[0]) == view.turn(shared[0], shared[1], of_t[0]);
    }
    default:
      return true;
  }
}

}  // namespace convexact
