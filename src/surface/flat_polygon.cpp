// SPDX-License-Identifier: MIT
#include "surface/flat_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"

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
  const RationalPoint a = points[t[0]];
  return RationalVector3(points[t[1]] - a).cross(RationalVector3(points[t[2]] - a));
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

  // The ear with the lowest tip: it does not depend on where the polygon begins.
  Triangle cut_lowest() {
    if (tips_.empty()) throw Error(ErrorCode::Internal, "a simple polygon without an ear");
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

std::optional<std::vector<Triangle>> clip_ears(const PointSet& points,
                                               std::span<const PointId> given) {
  const PolygonCorners corners(given.begin(), given.end());
  const RationalVector3 area = area_of(points, corners);
  const int axis = longest_axis(area);
  if (area[axis] == 0 || !is_planar(points, corners, area)) return std::nullopt;
  const PlaneView view(points, axis);
  if (!is_simple(view, corners)) return std::nullopt;
  Ears ears(view, sign_of(area[axis]), corners);
  std::vector<Triangle> triangles;
  while (ears.size() > 3) triangles.push_back(ears.cut_lowest());
  // The last three do not lie on a line: the cut beside such a corner would have passed through it.
  triangles.push_back(ears.last());
  return triangles;
}

}  // namespace convexact
