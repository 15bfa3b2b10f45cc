// SPDX-License-Identifier: MIT
#include "surface/common_point.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "convexact/geometry.hpp"

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

// On which side of t's plane, or in it, all of s lies; Zero also if t has no area. Nothing if s has
// corners on two sides, or on one and in the plane.
std::optional<Sign> side_of(const PointSet& points, const Triangle& s, const Triangle& t) {
  const auto at = [&](PointId p) { return orient(points, t[0], t[1], t[2], p); };
  const Sign side = at(s[0]);
  if (side != at(s[1]) || side != at(s[2])) return std::nullopt;
  return side;
}

// Whether an edge of one of two triangles in a plane has the other one strictly beyond it: if the
// triangles have no common point, one has. Precondition: both have an area.
bool are_apart(const PlaneView& view, const Triangle& s, const Triangle& t) {
  const auto separates = [&](const Triangle& own, const Triangle& other) {
    const Sign inner = view.turn(own[0], own[1], own[2]);
    for (int k = 0; k < 3; ++k) {
      const auto is_beyond = [&](PointId p) {
        return view.turn(own[k], own[(k + 1) % 3], p) * inner == Sign::Negative;
      };
      if (std::all_of(other.begin(), other.end(), is_beyond)) return true;
    }
    return false;
  };
  return separates(t, s) || separates(s, t);
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
  const std::optional<Sign> s_at_t = side_of(points, s, t), t_at_s = side_of(points, t, s);
  for (const auto& side : {s_at_t, t_at_s}) {
    if (side && *side != Sign::Zero) return false;
  }
  if (s_at_t && t_at_s && !has_no_area(points, s) && !has_no_area(points, t)) {
    return !are_apart(PlaneView(points, seen_along(points, t)), s, t);
  }
  return an_edge_meets(points, s, t) || an_edge_meets(points, t, s);
}

bool cross(const PointSet& points, const Triangle& s, const Triangle& t) {
  // The corners that both have come first in each.
  const auto shared_first = [](Triangle own, const Triangle& other) {
    const auto end = std::stable_partition(own.begin(), own.end(), [&](PointId p) {
      return std::find(other.begin(), other.end(), p) != other.end();
    });
    return std::pair(own, end - own.begin());
  };
  const auto [a, shared] = shared_first(s, t);
  const Triangle b = shared_first(t, s).first;
  switch (shared) {
    case 0:
      return have_common_point(points, s, t);
    case 1:  // The common set is convex, and leaves one of them through the opposite edge.
      return segment_meets(points, a[1], a[2], t) || segment_meets(points, b[1], b[2], s);
    case 2: {  // In one plane, and on the same side of the edge.
      if (orient(points, a[0], a[1], a[2], b[2]) != Sign::Zero) return false;
      const PlaneView view(points, seen_along(points, s));
      return view.turn(a[0], a[1], a[2]) == view.turn(a[0], a[1], b[2]);
    }
    default:
      return true;
  }
}

}  // namespace convexact
