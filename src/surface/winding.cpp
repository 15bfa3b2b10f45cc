// SPDX-License-Identifier: MIT
// Winding numbers: from a ray upwards, which starts at the point after an infinitesimal shift.
#include <algorithm>
#include <array>
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
      low[k] = high[k] = near[k];
      is_double[k] = std::isfinite(near[k]) && to_rational(near[k]) == x[k];
      if (is_double[k]) continue;
      low[k] = std::nextafter(near[k], -HUGE_VAL);
      high[k] = std::nextafter(near[k], HUGE_VAL);
    }
  }

  const RationalPoint& exact;
  HomogeneousPoint cleared;
  Point near, low, high;  // low <= x <= high
  std::array<bool, 3> is_double{};
  bool is_binary() const { return is_double[0] && is_double[1] && is_double[2]; }
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

double scale_of(const PointSet& points) {
  double largest = 0;
  for (const Point& p : points.doubles()) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return std::ldexp(1.0, std::clamp(-exponent_of(largest), -1000, 1000));
}

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
  explicit Search(const Surface& surface)
      : surface_(surface), tree_(boxes_of(surface)), scale_(scale_of(surface.points)) {
    const PlaneView from_above(surface.points, 2);
    for (const auto& [a, b, c] : surface.triangles) up_.push_back(from_above.turn(a, b, c));
  }

  std::optional<long> at(const RationalPoint& x) const {
    const Query query(x);
    const std::vector<std::uint32_t> near = find_near(query);
    for (const std::uint32_t t : near) {
      if (is_on(t, query)) return std::nullopt;
    }
    long sum = 0;
    for (const std::uint32_t t : near) {
      if (const std::optional<Sides> sides = sides_of(t, query)) sum += counted(t, *sides, {});
    }
    return sum;
  }

  // Just beside x.
  long towards(const RationalPoint& x, const RationalVector3& direction) const {
    const Query query(x);
    long sum = 0;
    for (const std::uint32_t t : find_near(query)) {
      if (const std::optional<Sides> sides = sides_of(t, query)) {
        sum += counted(t, *sides, {&direction});
      }
    }
    return sum;
  }

  // Just before and just behind a triangle that has x strictly inside.
  std::pair<long, long> beside(std::uint32_t own, const RationalPoint& x) const {
    const Query query(x);
    const RationalVector3 front = area_vector(surface_.points, surface_.triangles[own]),
                          back = -front;
    long before = 0, behind = 0;
    for (const std::uint32_t t : find_near(query)) {
      if (t == own) {  // it is above the one of the two points that is below it
        before -= up_[t] == Sign::Negative ? 1 : 0;
        behind += up_[t] == Sign::Positive ? 1 : 0;
      } else if (const std::optional<Sides> sides = sides_of(t, query)) {
        before += counted(t, *sides, {&front});
        behind += counted(t, *sides, {&back});
      }
    }
    return {before, behind};
  }

 private:
  // The triangles whose boxes lie above or below the point.
  std::vector<std::uint32_t> find_near(const Query& query) const {
    NearBox column{query.low, query.high};
    flatten(column);
    std::vector<std::uint32_t> found;
    tree_.find(column, found);
    return found;
  }

  // On which sides of a triangle's edges, seen from above, and of its plane the query point lies.
  struct Sides {
    std::array<Sign, 3> edges;
    Sign plane;
  };
  // Nothing if the triangle is not above the point, wherever an infinitesimal shift moves it.
  std::optional<Sides> sides_of(std::uint32_t t, const Query& query) const {
    const Triangle& triangle = surface_.triangles[t];
    const Sign up = up_[t];
    if (up == Sign::Zero) return std::nullopt;
    Sides sides;
    for (int k = 0; k < 3; ++k) {
      sides.edges[k] = turn(triangle[k], triangle[(k + 1) % 3], query, 2);
      if (sides.edges[k] * up == Sign::Negative) return std::nullopt;
    }
    // orient3d is positive where the corners look clockwise from the point: for triangles that
    // face up, below them.
    sides.plane = orient(triangle, query);
    if (sides.plane * up == Sign::Negative) return std::nullopt;
    return sides;
  }

  // +1 if the triangle lies above the moved point and faces up, -1 if it faces down, else 0.
  long counted(std::uint32_t t, const Sides& sides, const Shift& shift) const {
    const Triangle& triangle = surface_.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const Sign side = shift.sign(sides.edges[k], [&] {
        const RationalVector3 edge =
            surface_.points[triangle[(k + 1) % 3]] - surface_.points[triangle[k]];
        return RationalVector3(-edge[1], edge[0], 0);
      });
      if (side != up_[t]) return 0;
    }
    const Sign below = shift.sign(
        sides.plane, [&] { return RationalVector3(-area_vector(surface_.points, triangle)); });
    return below != up_[t] ? 0 : below == Sign::Positive ? 1 : -1;
  }

  // The sign of the area of a, b, x, seen along an axis.
  Sign turn(PointId a, PointId b, const Query& query, int axis) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (surface_.points.is_binary()) {
      const Point &from = surface_.points.doubles()[a.index()],
                  &to = surface_.points.doubles()[b.index()];
      const Point p = scale_ * from, q = scale_ * to, x = scale_ * query.near;
      // Differences to x are off by a relative 2^-53 of themselves and by half a unit of x; the
      // other roundings are as in PlaneView::turn(). 2^-50 covers all of them.
      const bool is_exact = query.is_double[u] && query.is_double[v];
      const double x_error = is_exact ? 0 : kUnitRoundoff;
      const double left = (p[u] - x[u]) * (q[v] - x[v]), right = (p[v] - x[v]) * (q[u] - x[u]);
      const double value = left - right;
      const double own = std::abs(x[u]) * (std::abs(q[v] - x[v]) + std::abs(p[v] - x[v])) +
                         std::abs(x[v]) * (std::abs(q[u] - x[u]) + std::abs(p[u] - x[u])) +
                         2 * kUnitRoundoff * std::abs(x[u]) * std::abs(x[v]);
      // The last two are for underflow.
      const double size = std::abs(p[u] - x[u]) + std::abs(p[v] - x[v]) + std::abs(q[u] - x[u]) +
                          std::abs(q[v] - x[v]);
      const double error = 0x1p-50 * (std::abs(left) + std::abs(right)) + 2 * x_error * own +
                           0x1p-1000 * size + 0x1p-900;
      if (std::abs(value) > error) return sign_of(value);
      // Edges along an axis through x, as boxes have them.
      for (const int k : {u, v}) {
        const double at = query.near[k];
        if (query.is_double[k] && from[k] == at && to[k] == at) return Sign::Zero;
      }
    }
    const IntegerVector3 p = vector_to(a, query), q = vector_to(b, query);
    return sign_of(Integer(p[u] * q[v] - p[v] * q[u]));
  }

  // The vector from the query point to a point of the surface, times a positive number. Integers,
  // because fractions of long numbers spend their time on greatest common divisors.
  IntegerVector3 vector_to(PointId point, const Query& query) const {
    const HomogeneousPoint p = clear_denominators(surface_.points[point]);
    return p.n * query.cleared.w - query.cleared.n * p.w;
  }

  // orient3d of the corners and x.
  Sign orient(const Triangle& t, const Query& query) const {
    const auto& [a, b, c] = t;
    if (surface_.points.is_binary()) {
      const auto points = surface_.points.doubles();
      const auto to = [&](PointId id) -> Point {
        return scale_ * (points[id.index()] - query.near);
      };
      const Point p = to(a), q = to(b), r = to(c);
      // Where x is no double, each difference may be off by half a unit of x more. With s a bound
      // of x's coordinates, m one of the differences', the determinant of 6 products of three is
      // off by at most 6 ((m + e)^3 - m^3) for e = 2^-53 (s + 2 m), and by roundings below
      // 2^-46 m^3; the term below 2^-1000 is for underflow.
      const double m =
          std::max({p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff(), r.cwiseAbs().maxCoeff()});
      const double s = query.is_binary() ? 0 : scale_ * query.near.cwiseAbs().maxCoeff();
      const double e = 2 * kUnitRoundoff * (s + m) + 0x1p-1000;
      const double value = p.dot(q.cross(r));
      const double error = 0x1p-46 * m * m * m + 32 * e * (m + e) * (m + e) + 0x1p-900;
      if (std::abs(value) > error) return sign_of(value);
    }
    const IntegerVector3 normal = vector_to(b, query).cross(vector_to(c, query));
    return sign_of(Integer(vector_to(a, query).dot(normal)));
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
  // A power of two that brings the surface near 1, so that products in doubles neither overflow nor
  // underflow; the terms for underflow cover what it does to smaller coordinates.
  double scale_;
  std::vector<Sign> up_;  // by triangle: whether it faces up
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
  return search_->beside(triangle.value, x);
}

long Winding::towards(const RationalPoint& x, const RationalVector3& direction) const {
  return search_->towards(x, direction);
}

}  // namespace convexact
