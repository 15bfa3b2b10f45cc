// SPDX-License-Identifier: MIT
#include "surface/flat_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "geometry/area_vector.hpp"

namespace convexact {
namespace {

using PolygonCorners = std::vector<PointId>;

bool is_planar(const PointSet& points, const PolygonCorners& corners, const RationalVector3& area) {
  const Rational at_first = area.dot(points[corners[0]]);
  return std::all_of(corners.begin(), corners.end(),
                     [&](PointId p) { return area.dot(points[p]) == at_first; });
}

// Twice the area, along its normal.
RationalVector3 area_of(const PointSet& points, const PolygonCorners& corners) {
  RationalVector3 sum = RationalVector3::Zero();
  const RationalPoint first = points[corners[0]];
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    sum += RationalVector3(points[corners[k]] - first)
               .cross(RationalVector3(points[corners[k + 1]] - first));
  }
  return sum;
}

int longest_axis(const RationalVector3& v) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (abs(v[k]) > abs(v[axis])) axis = k;
  }
  return axis;
}

bool is_simple(const PlaneView& view, const PolygonCorners& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const PointId a = corners[i], b = corners[(i + 1) % n];
    // The next edge may only have the corner in common.
    const PointId c = corners[(i + 2) % n];
    if (view.turn(a, b, c) == Sign::Zero && (a < b) != (b < c)) return false;
    for (std::size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k == n - 1) continue;
      if (view.meet(a, b, corners[k], corners[(k + 1) % n])) return false;
    }
  }
  return true;
}

// Whether the boundary may repeat corners, and run along an edge once each way, but bounds a region
// once: so files write a face with a hole, as a loop that goes to the hole, around it, and back.
class WeaklySimple {
 public:
  WeaklySimple(const PointSet& points, const PlaneView& view, int axis,
               const PolygonCorners& corners)
      : view_(view), corners_(corners), u_((axis + 1) % 3), v_((axis + 2) % 3) {
    for (const PointId p : corners) at_.push_back(points[p]);
  }

  /// @param inward  How the polygon turns.
  bool holds(Sign inward) const {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      bool has_back = false;  // an edge that runs along this one the other way
      for (std::size_t k = 0; k < corners_.size(); ++k) {
        if (i == k) continue;
        if (head(k) == tail(i) && tail(k) == head(i)) {
          has_back = true;
        } else if (!may_touch(i, k)) {
          return false;
        }
      }
      // The region lies on the inner side of an edge, and on both sides of a bridge.
      const int inner = inward == Sign::Positive ? 1 : -1;
      const int left = inner > 0 || has_back ? inner : 0;
      const int right = inner < 0 || has_back ? inner : 0;
      if (winding_beside(i, true) != left || winding_beside(i, false) != right) return false;
    }
    return true;
  }

 private:
  PointId tail(std::size_t k) const { return corners_[k]; }
  PointId head(std::size_t k) const { return corners_[next(k)]; }
  std::size_t next(std::size_t k) const { return (k + 1) % corners_.size(); }

  // Edges with a common corner may have nothing else in common, which two that are the same have;
  // others nothing at all.
  bool may_touch(std::size_t i, std::size_t k) const {
    const PointId a = tail(i), b = head(i), c = tail(k), d = head(k);
    for (const auto& [common, x] : {std::pair(a, b), std::pair(b, a)}) {
      for (const auto& [other, y] : {std::pair(c, d), std::pair(d, c)}) {
        if (common != other) continue;
        return view_.turn(common, x, y) != Sign::Zero || (common < x) != (common < y);
      }
    }
    return !view_.meet(a, b, c, d);
  }

  // How often the polygon winds about a point beside the middle of an edge, to its left or right. A
  // ray goes up from it, moved to the side by less than any number, so that it meets no corner.
  int winding_beside(std::size_t edge, bool to_left) const {
    const RationalPoint &a = at_[edge], &b = at_[next(edge)];
    const Rational u = (a[u_] + b[u_]) / 2, v = (a[v_] + b[v_]) / 2;
    const bool is_upright = a[u_] == b[u_];
    // Left of an edge that goes right is up, of one that goes up is left.
    const bool to_low = is_upright && (b[v_] > a[v_]) == to_left;
    const bool is_above = !is_upright && (b[u_] > a[u_]) == to_left;
    const auto is_before = [&](const RationalPoint& p) { return to_low ? p[u_] < u : p[u_] <= u; };
    int winding = 0;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const RationalPoint &c = at_[k], &d = at_[next(k)];
      if (is_before(c) == is_before(d)) continue;
      // Positive if the middle lies to the left of the edge; zero on the edge itself.
      const Sign side =
          sign_of(Rational((d[u_] - c[u_]) * (v - c[v_]) - (d[v_] - c[v_]) * (u - c[u_])));
      const bool goes_right = is_before(c);
      const bool is_below = side == Sign::Zero ? !is_above : (side == Sign::Negative) == goes_right;
      if (is_below) winding += goes_right ? -1 : 1;
    }
    return winding;
  }

  const PlaneView& view_;
  const PolygonCorners& corners_;
  int u_, v_;
  std::vector<RationalPoint> at_;
};

}  // namespace

Sign PlaneView::turn(PointId a, PointId b, PointId c) const {
  // The error of this determinant of differences is below (3 + 16 u) u times the sum of its two
  // products' sizes, u = 2^-53, unless a product underflows [Shewchuk1997]; 2^-51 is larger than
  // 3 u (1 + 6 u), and below 2^-900 nothing is decided.
  if (points_.is_binary()) {
    const auto p = points_.doubles();
    const Point &x = p[a.index()], &y = p[b.index()], &z = p[c.index()];
    const double left = (x[u_] - z[u_]) * (y[v_] - z[v_]);
    const double right = (x[v_] - z[v_]) * (y[u_] - z[u_]);
    const double value = left - right, size = std::abs(left) + std::abs(right);
    if (size > 0x1p-900 && std::abs(value) > 0x1p-51 * size) return sign_of(value);
    // As a determinant of space: its third point lies straight below c.
    const auto flat = [&](const Point& q, double height) { return Point(q[u_], q[v_], height); };
    return orient3d(flat(x, 0), flat(y, 0), flat(z, 0), flat(z, -1));
  }
  const RationalPoint x = points_[a], y = points_[b], z = points_[c];
  return sign_of(Rational((x[u_] - z[u_]) * (y[v_] - z[v_]) - (x[v_] - z[v_]) * (y[u_] - z[u_])));
}

bool PlaneView::overlap(int axis, PointId a, PointId b, PointId c, PointId d) const {
  if (points_.is_binary()) {
    const auto x = [&](PointId p) { return points_.doubles()[p.index()][axis]; };
    return std::max(std::min(x(a), x(b)), std::min(x(c), x(d))) <=
           std::min(std::max(x(a), x(b)), std::max(x(c), x(d)));
  }
  const auto x = [&](PointId p) { return Rational(points_[p][axis]); };
  return std::max(std::min(x(a), x(b)), std::min(x(c), x(d))) <=
         std::min(std::max(x(a), x(b)), std::max(x(c), x(d)));
}

bool PlaneView::meet(PointId a, PointId b, PointId c, PointId d) const {
  if (!overlap(u_, a, b, c, d) || !overlap(v_, a, b, c, d)) return false;
  return turn(a, b, c) * turn(a, b, d) != Sign::Positive &&
         turn(c, d, a) * turn(c, d, b) != Sign::Positive;
}

bool PlaneView::is_beside(int axis, const Triangle& t, PointId p) const {
  if (!points_.is_binary()) return false;
  const auto x = [&](PointId q) { return points_.doubles()[q.index()][axis]; };
  const double a = x(t[0]), b = x(t[1]), c = x(t[2]), at = x(p);
  return (at < a && at < b && at < c) || (at > a && at > b && at > c);
}

bool PlaneView::is_in(const Triangle& t, PointId p) const {
  if (is_beside(u_, t, p) || is_beside(v_, t, p)) return false;
  const Sign inward = turn(t[0], t[1], t[2]);
  for (int k = 0; k < 3; ++k) {
    if (turn(t[k], t[(k + 1) % 3], p) == -inward) return false;
  }
  return true;
}

bool has_no_area(const PointSet& points, const Triangle& t) {
  for (int axis = 0; axis < 3; ++axis) {
    if (PlaneView(points, axis).turn(t[0], t[1], t[2]) != Sign::Zero) return false;
  }
  return true;
}

int seen_along(const PointSet& points, const Triangle& t) {
  int axis = 0;
  while (axis < 2 && PlaneView(points, axis).turn(t[0], t[1], t[2]) == Sign::Zero) ++axis;
  return axis;
}

RationalVector3 area_vector(const PointSet& points, const Triangle& t) {
  return area_vector(points, t[0], t[1], t[2]);
}

namespace {

// The corners of a polygon that are left while its ears are cut off. A triangle of three corners in
// a row is an ear if it turns as the polygon does and holds no other corner. When an ear is cut
// off, only the corners beside its tip may become ears or cease to be some: the diagonal of any
// other triangle is inside of the rest iff it was inside before, since near the tip, which is
// convex, nothing else of the polygon is left; and two ears that are not neighbours do not overlap.
class Ears {
 public:
  Ears(const PlaneView& view, Sign inward, const PolygonCorners& corners)
      : view_(view),
        inward_(inward),
        corners_(corners),
        before_(corners.size()),
        after_(corners.size()) {
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      before_[k] = (k + n - 1) % n;
      after_[k] = (k + 1) % n;
      left_.push_back(k);
    }
    for (std::size_t k = 0; k < n; ++k) test(k);
  }

  bool has_ear() const { return !tips_.empty(); }
  // The ear with the lowest tip: it does not depend on where the polygon begins.
  Triangle cut_lowest() {
    const std::size_t tip = tips_.begin()->second;
    const Triangle ear = triangle(tip);
    tips_.erase(tips_.begin());
    std::erase(left_, tip);
    const std::size_t a = before_[tip], b = after_[tip];
    after_[a] = b;
    before_[b] = a;
    test(a);
    test(b);
    return ear;
  }
  // Takes away a corner between two that are one point, and one of these: the edges there and back
  // cancel. Only where corners repeat.
  bool drop_spur() {
    const auto found = std::find_if(left_.begin(), left_.end(), [&](std::size_t k) {
      return corners_[before_[k]] == corners_[after_[k]];
    });
    if (found == left_.end()) return false;
    const std::size_t tip = *found, twin = after_[tip], a = before_[tip], b = after_[twin];
    for (const std::size_t k : {tip, twin}) {
      tips_.erase({corners_[k], k});
      std::erase(left_, k);
    }
    after_[a] = b;
    before_[b] = a;
    if (left_.size() > 2) {
      test(a);
      test(b);
    }
    return true;
  }
  std::size_t size() const { return left_.size(); }
  Triangle last() const { return {corners_[left_[0]], corners_[left_[1]], corners_[left_[2]]}; }

 private:
  Triangle triangle(std::size_t k) const {
    return {corners_[before_[k]], corners_[k], corners_[after_[k]]};
  }
  bool is_ear(std::size_t k) const {
    const Triangle ear = triangle(k);
    if (view_.turn(ear[0], ear[1], ear[2]) != inward_) return false;
    return std::none_of(left_.begin(), left_.end(), [&](std::size_t other) {
      const PointId p = corners_[other];
      return p != ear[0] && p != ear[1] && p != ear[2] && view_.is_in(ear, p);
    });
  }
  void test(std::size_t k) {
    if (is_ear(k)) {
      tips_.emplace(corners_[k], k);
    } else {
      tips_.erase({corners_[k], k});
    }
  }

  const PlaneView& view_;
  Sign inward_;
  const PolygonCorners& corners_;
  std::vector<std::size_t> before_, after_;         // by corner
  std::vector<std::size_t> left_;                   // ascending
  std::set<std::pair<PointId, std::size_t>> tips_;  // of ears
};

}  // namespace

// All triangles turn as the polygon does, and their directed edges add up to its own. So as many of
// them hold a point as the polygon winds about it: one inside, none outside. This is the reason why
// the triangles are right if no ear is missed, also where corners repeat.
std::variant<std::vector<Triangle>, NotCut> clip_ears(const PointSet& points,
                                                      std::span<const PointId> given) {
  const PolygonCorners corners(given.begin(), given.end());
  const RationalVector3 area = area_of(points, corners);
  const int axis = longest_axis(area);
  if (!is_planar(points, corners, area)) return NotCut::Bent;
  if (area[axis] == 0) return NotCut::Crossed;
  const PlaneView view(points, axis);
  const Sign inward = sign_of(area[axis]);
  const bool repeats = std::set(corners.begin(), corners.end()).size() < corners.size();
  const bool is_cut =
      repeats ? WeaklySimple(points, view, axis, corners).holds(inward) : is_simple(view, corners);
  if (!is_cut) return NotCut::Crossed;
  Ears ears(view, inward, corners);
  std::vector<Triangle> triangles;
  while (ears.size() > 2) {
    if (repeats && ears.drop_spur()) continue;
    if (ears.size() == 3) break;
    if (ears.has_ear()) {
      triangles.push_back(ears.cut_lowest());
    } else if (repeats) {
      return NotCut::Crossed;
    } else {
      throw Error(ErrorCode::Internal, "a simple polygon without an ear");
    }
  }
  if (ears.size() < 3) return triangles;
  // The last three of a simple polygon do not lie on a line: the cut beside such a corner would
  // have passed through it.
  const Triangle last = ears.last();
  if (view.turn(last[0], last[1], last[2]) != inward) return NotCut::Crossed;
  triangles.push_back(last);
  return triangles;
}

}  // namespace convexact
