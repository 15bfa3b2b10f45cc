// SPDX-License-Identifier: MIT
// Winding numbers: from a ray upwards, which starts at the point after an infinitesimal shift.
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/surface.hpp"
#include "number/arithmetic.hpp"
#include "number/roundoff.hpp"
#include "surface/box_tree.hpp"
#include "surface/flat_polygon.hpp"

namespace convexact {
namespace {

// A query point: exact, and rounded to nearest doubles with the bound of their errors.
struct Query {
  explicit Query(const RationalPoint& x) : exact(x), cleared(clear_denominators(x)) {
    for (int k = 0; k < 3; ++k) {
      near[k] = to_double(x[k], Rounding::Nearest);
      low[k] = to_double(x[k], Rounding::Down);
      high[k] = to_double(x[k], Rounding::Up);
    }
    is_binary = low == high;
  }

  const RationalPoint& exact;
  IntegerFraction cleared;
  Point near, low, high;
  bool is_binary = false;
};

// The infinitesimal shift of a query point: first along `first`, if there is one, then by far less
// along x, and by still less along y and then z. The shift leaves the triangles' lines and planes
// through the point in this order.
struct Shift {
  const RationalVector3* first = nullptr;

  // The sign of a linear function with this value at the point and with this gradient.
  template <class Gradient>
  Sign sign(Sign at_point, const Gradient& gradient) const {
    if (at_point != Sign::Zero) return at_point;
    const RationalVector3 g = gradient();
    if (first != nullptr) {
      const Sign along = sign_of(Rational(g.dot(*first)));
      if (along != Sign::Zero) return along;
    }
    for (int k = 0; k < 3; ++k) {
      if (g[k] != 0) return sign_of(g[k]);
    }
    return Sign::Zero;
  }
};

// A ray goes up to infinity, and triangles below do no harm, so boxes are seen from above. All have
// the same height, 0, so that the tree is halved along x and y.
void flatten(NearBox& box) { box.low[2] = box.high[2] = 0; }

std::vector<NearBox> boxes_of(const Surface& surface) {
  std::vector<NearBox> boxes;
  for (const Triangle& triangle : surface.triangles) {
    boxes.push_back(box_of(surface.points, triangle));
    flatten(boxes.back());
  }
  return boxes;
}

}  // namespace

class Winding::Search {
 public:
  explicit Search(const Surface& surface) : surface_(surface), tree_(boxes_of(surface)) {}

  std::optional<long> at(const RationalPoint& x) const {
    const Query query(x);
    const std::vector<std::uint32_t> near = find_near(query);
    for (const std::uint32_t t : near) {
      if (is_on(t, query)) return std::nullopt;
    }
    return count(near, query, {});
  }

  long at_shifted(const RationalPoint& x, const RationalVector3& direction) const {
    const Query query(x);
    return count(find_near(query), query, {&direction});
  }

  const Surface& surface() const { return surface_; }

 private:
  // The triangles whose boxes lie above or below the point.
  std::vector<std::uint32_t> find_near(const Query& query) const {
    NearBox column{query.low, query.high};
    flatten(column);
    std::vector<std::uint32_t> found;
    tree_.find(column, found);
    return found;
  }

  // Of these triangles: +1 for each that lies above and faces up, -1 for each that faces
  // down.
  long count(const std::vector<std::uint32_t>& near, const Query& query, const Shift& shift) const {
    long sum = 0;
    for (const std::uint32_t t : near) {
      const Triangle& triangle = surface_.triangles[t];
      const Sign up = PlaneView(surface_.points, 2).turn(triangle[0], triangle[1], triangle[2]);
      if (up == Sign::Zero || !is_over(triangle, up, query, shift)) continue;
      // orient3d is positive where the corners look clockwise from the point: for triangles that
      // face up, below them.
      const Sign beside = shift.sign(orient(triangle, query), [&] {
        return RationalVector3(-area_vector(surface_.points, triangle));
      });
      if (beside * up == Sign::Positive) sum += up == Sign::Positive ? 1 : -1;
    }
    return sum;
  }

  // Whether the line upwards through the moved point meets the triangle.
  bool is_over(const Triangle& t, Sign up, const Query& query, const Shift& shift) const {
    for (int k = 0; k < 3; ++k) {
      const PointId a = t[k], b = t[(k + 1) % 3];
      const Sign side = shift.sign(turn(a, b, query, 2), [&] {
        const RationalVector3 edge = surface_.points[b] - surface_.points[a];
        return RationalVector3(-edge[1], edge[0], 0);
      });
      if (side != up) return false;
    }
    return true;
  }

  // The sign of the area of a, b, x, seen along an axis.
  Sign turn(PointId a, PointId b, const Query& query, int axis) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (surface_.points.is_binary()) {
      const Point &p = surface_.points.doubles()[a.index()],
                  &q = surface_.points.doubles()[b.index()], &x = query.near;
      // Differences to x are off by a relative 2^-53 of themselves and by half a unit of x; the
      // other roundings are as in PlaneView::turn(). 2^-50 covers all of them.
      const double x_error = query.is_binary ? 0 : kUnitRoundoff;
      const double left = (p[u] - x[u]) * (q[v] - x[v]), right = (p[v] - x[v]) * (q[u] - x[u]);
      const double value = left - right;
      const double own = std::abs(x[u]) * (std::abs(q[v] - x[v]) + std::abs(p[v] - x[v])) +
                         std::abs(x[v]) * (std::abs(q[u] - x[u]) + std::abs(p[u] - x[u])) +
                         0x1p-52 * std::abs(x[u]) * std::abs(x[v]);
      // The last two terms are for underflow.
      const double size = std::abs(p[u] - x[u]) + std::abs(p[v] - x[v]) + std::abs(q[u] - x[u]) +
                          std::abs(q[v] - x[v]);
      const double error = 0x1p-50 * (std::abs(left) + std::abs(right)) + 2 * x_error * own +
                           0x1p-1000 * size + 0x1p-900;
      if (std::abs(value) > error) return sign_of(value);
    }
    const IntegerVector3 p = from(query, a), q = from(query, b);
    return sign_of(Integer(p[u] * q[v] - p[v] * q[u]));
  }

  // The vector from the query point to a point of the surface, times a positive number. Integers,
  // because fractions of long numbers spend their time on greatest common divisors.
  IntegerVector3 from(const Query& query, PointId point) const {
    const IntegerFraction p = clear_denominators(surface_.points[point]);
    return p.x * query.cleared.d - query.cleared.x * p.d;
  }

  // orient3d of the corners and x.
  Sign orient(const Triangle& t, const Query& query) const {
    const auto& [a, b, c] = t;
    if (surface_.points.is_binary()) {
      const auto points = surface_.points.doubles();
      const Point p = points[a.index()] - query.near, q = points[b.index()] - query.near,
                  r = points[c.index()] - query.near;
      // Where x is no double, each difference may be off by half a unit of x more. With s a bound
      // of x's coordinates, m one of the differences', the determinant of 6 products of three is
      // off by at most 6 ((m + e)^3 - m^3) for e = 2^-53 (s + 2 m), and by roundings below
      // 2^-46 m^3; the term below 2^-1000 is for underflow.
      const double m =
          std::max({p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff(), r.cwiseAbs().maxCoeff()});
      const double s = query.is_binary ? 0 : query.near.cwiseAbs().maxCoeff();
      const double e = 0x1p-52 * (s + m) + 0x1p-1000;
      const double value = p.dot(q.cross(r));
      const double error = 0x1p-46 * m * m * m + 32 * e * (m + e) * (m + e) + 0x1p-900;
      if (std::abs(value) > error) return sign_of(value);
    }
    return sign_of(
        Integer(from(query, a).dot(IntegerVector3(from(query, b).cross(from(query, c))))));
  }

  bool is_on(std::uint32_t index, const Query& query) const {
    const Triangle& t = surface_.triangles[index];
    if (orient(t, query) != Sign::Zero) return false;
    // Seen along each axis the point lies in the triangle, which may be seen as a segment.
    for (int axis = 0; axis < 3; ++axis) {
      bool left = false, right = false;
      for (int k = 0; k < 3; ++k) {
        const Sign side = turn(t[k], t[(k + 1) % 3], query, axis);
        left = left || side == Sign::Positive;
        right = right || side == Sign::Negative;
      }
      if (left && right) return false;
    }
    for (int k = 0; k < 3; ++k) {
      Rational low = surface_.points[t[0]][k], high = low;
      for (const PointId p : t) {
        low = std::min<Rational>(low, surface_.points[p][k]);
        high = std::max<Rational>(high, surface_.points[p][k]);
      }
      if (query.exact[k] < low || high < query.exact[k]) return false;
    }
    return true;
  }

  const Surface& surface_;
  BoxTree tree_;
};

Winding::Winding(const Surface& surface) {
  if (!surface.is_closed) {
    throw Error(ErrorCode::InvalidArgument, "winding numbers need a closed surface");
  }
  search_ = std::make_unique<const Search>(surface);
}

Winding::~Winding() = default;

std::optional<long> Winding::operator()(const RationalPoint& x) const { return search_->at(x); }

std::pair<long, long> Winding::beside(TriangleId triangle, const RationalPoint& x) const {
  const Surface& surface = search_->surface();
  const RationalVector3 normal = area_vector(surface.points, surface.triangles[triangle.index()]);
  return {search_->at_shifted(x, normal), search_->at_shifted(x, RationalVector3(-normal))};
}

}  // namespace convexact
