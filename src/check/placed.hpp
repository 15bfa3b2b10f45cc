// SPDX-License-Identifier: MIT
// placed.hpp - triangles, cubes and convex parts with fractions as coordinates: how they lie to
// each other, and how often a surface winds about a point.
#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "text.hpp"

namespace check {

using Vector = std::array<Rational, 3>;

inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Rational dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational value(const Row& plane, const Vector& x) {
  return plane[0] * x[0] + plane[1] * x[1] + plane[2] * x[2] + plane[3];
}
inline Vector vector_of(const Row& p) {
  return {quotient(p[0], p[3]), quotient(p[1], p[3]), quotient(p[2], p[3])};
}

struct Box {
  Vector low, high;

  // Around some points, at least one.
  static Box around(const std::vector<Vector>& points) {
    Box box{points[0], points[0]};
    for (const Vector& x : points) {
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = std::min(box.low[k], x[k]);
        box.high[k] = std::max(box.high[k], x[k]);
      }
    }
    return box;
  }
};

// A triangle with what its distances need.
struct PlacedTriangle {
  std::array<Vector, 3> corners, edges;
  Vector normal;
  Rational squared_normal;

  explicit PlacedTriangle(const std::array<Vector, 3>& at) : corners(at) {
    for (std::size_t k = 0; k < 3; ++k) edges[k] = corners[(k + 1) % 3] - corners[k];
    normal = cross(edges[0], edges[1]);
    squared_normal = dot(normal, normal);
  }

  template <class Holds>
  bool all_of(const Holds& holds) const {
    return std::all_of(corners.begin(), corners.end(), holds);
  }
  // Whether it lies beyond a side of the box, or in that side: it does not meet the interior.
  bool is_beside(const Box& box) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (all_of([&](const Vector& x) { return x[k] <= box.low[k]; })) return true;
      if (all_of([&](const Vector& x) { return x[k] >= box.high[k]; })) return true;
    }
    return false;
  }

  // Whether x is within the root of `squared`: above the triangle that is the distance of the
  // plane, elsewhere that of a side.
  bool is_near(const Vector& x, const Rational& squared) const {
    bool is_above = squared_normal > 0;
    for (std::size_t k = 0; k < 3 && is_above; ++k) {
      is_above = dot(cross(edges[k], x - corners[k]), normal) >= 0;
    }
    if (is_above) {
      const Rational height = dot(normal, x - corners[0]);
      return height * height <= squared * squared_normal;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_near_side(k, x, squared)) return true;
    }
    return false;
  }

 private:
  bool is_near_side(std::size_t k, const Vector& x, const Rational& squared) const {
    const Rational length = dot(edges[k], edges[k]);
    const Vector from = x - corners[k];
    Rational along = length > 0 ? Rational(dot(from, edges[k]) / length) : Rational(0);
    along = std::min(std::max(along, Rational(0)), Rational(1));
    Vector gap = from;
    for (std::size_t i = 0; i < 3; ++i) gap[i] -= along * edges[k][i];
    return dot(gap, gap) <= squared;
  }
};

// A closed cube.
struct Cube {
  Vector center;
  Rational half;

  Vector corner(int k) const {
    Vector x = center;
    for (std::size_t i = 0; i < 3; ++i) x[i] += (k >> i & 1) != 0 ? half : Rational(-half);
    return x;
  }
  // How far its corners reach along a direction from its center.
  Rational width(const Vector& n) const { return half * (abs(n[0]) + abs(n[1]) + abs(n[2])); }
  bool is_inside(const Vector& x) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (abs(Rational(x[i] - center[i])) >= half) return false;
    }
    return true;
  }
  bool touches(const Cube& other) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (abs(Rational(center[i] - other.center[i])) > half + other.half) return false;
    }
    return true;
  }
  // Whether the direction does not show that a triangle is beside it.
  bool may_meet(const PlacedTriangle& t, const Vector& n) const {
    const Rational at = dot(n, center), reach = width(n);
    Rational low = dot(n, t.corners[0]), high = low;
    for (const Vector& x : t.corners) {
      low = std::min<Rational>(low, dot(n, x));
      high = std::max<Rational>(high, dot(n, x));
    }
    return low <= at + reach && high >= at - reach;
  }
  bool may_meet_box_of(const PlacedTriangle& t) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [a, b, c] = t.corners;
      if (std::min({a[i], b[i], c[i]}) > center[i] + half) return false;
      if (std::max({a[i], b[i], c[i]}) < center[i] - half) return false;
    }
    return true;
  }
  // A triangle beside a cube is so along a normal of one of them, or across an edge of each.
  bool meets(const PlacedTriangle& t) const {
    if (!may_meet_box_of(t) || !may_meet(t, t.normal)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      Vector axis;
      axis[i] = 1;
      for (const Vector& edge : t.edges) {
        if (!may_meet(t, cross(axis, edge))) return false;
      }
    }
    return true;
  }
};

// A convex part: where all of its planes hold, and the hull of its corners.
struct PlacedPart {
  std::vector<Row> planes;
  std::vector<Vector> corners;

  bool is_inside(const Vector& x) const {
    return !planes.empty() && std::all_of(planes.begin(), planes.end(),
                                          [&](const Row& plane) { return value(plane, x) < 0; });
  }
  // Each point x of it moves to x + share (middle - x).
  void shrink(const Vector& middle, const Rational& share) {
    for (Row& plane : planes) {
      plane = scaled({plane[0], plane[1], plane[2], plane[3] - share * value(plane, middle)});
    }
    for (Vector& x : corners) {
      for (std::size_t k = 0; k < 3; ++k) x[k] += share * (middle[k] - x[k]);
    }
  }
  // Whether a plane shows that a triangle does not meet its interior.
  bool has_beyond(const PlacedTriangle& t) const {
    return std::any_of(planes.begin(), planes.end(), [&](const Row& plane) {
      return t.all_of([&](const Vector& x) { return value(plane, x) >= 0; });
    });
  }
  // Whether a triangle may meet the interior of what it has in common with a cube: if not, nothing
  // of the triangle is left within some plane or wall when it was cut at the others before.
  bool may_run_through(const PlacedTriangle& t, const Cube& cube) const {
    std::vector<Vector> left(t.corners.begin(), t.corners.end());
    for (std::size_t k = 0; k < 3; ++k) {
      for (const int side : {-1, 1}) {
        const auto beyond_wall = [&](const Vector& x) {
          return Rational(side * (x[k] - cube.center[k]) - cube.half);
        };
        if (!cut(left, beyond_wall)) return false;
      }
    }
    return std::all_of(planes.begin(), planes.end(), [&](const Row& plane) {
      return cut(left, [&](const Vector& x) { return value(plane, x); });
    });
  }

 private:
  // Leaves of a convex polygon what is not beyond a plane; whether something is strictly within.
  template <class Beyond>
  static bool cut(std::vector<Vector>& polygon, const Beyond& beyond) {
    std::vector<Vector> kept;
    bool has_inner = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const Rational at_a = beyond(a), at_b = beyond(b);
      if (at_a <= 0) kept.push_back(a);
      has_inner = has_inner || at_a < 0;
      if (sgn(at_a) * sgn(at_b) >= 0) continue;
      Vector& x = kept.emplace_back(a);
      for (std::size_t k = 0; k < 3; ++k) x[k] += at_a / (at_a - at_b) * (b[k] - a[k]);
    }
    polygon = std::move(kept);
    return has_inner;
  }
};

inline std::vector<PlacedTriangle> placed(const std::vector<Row>& points,
                                          const std::vector<std::array<std::size_t, 3>>& corners) {
  std::vector<PlacedTriangle> triangles;
  for (const auto& [a, b, c] : corners) {
    triangles.emplace_back(
        std::array<Vector, 3>{vector_of(points[a]), vector_of(points[b]), vector_of(points[c])});
  }
  return triangles;
}

// How often a surface winds about points.
class WindingNumbers {
 public:
  // Walls across x divide space into slabs: only triangles of its slab can be above a point.
  explicit WindingNumbers(std::vector<PlacedTriangle> triangles)
      : triangles_(std::move(triangles)) {
    std::vector<Rational> lows;
    for (const PlacedTriangle& t : triangles_) lows.push_back(range(t).first);
    std::sort(lows.begin(), lows.end());
    for (std::size_t k = 1; k < kSlabs; ++k) {
      if (!lows.empty()) walls_.push_back(lows[k * lows.size() / kSlabs]);
    }
    slabs_.resize(kSlabs);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto [low, high] = range(triangles_[t]);
      for (std::size_t k = slab(low); k <= slab(high); ++k) slabs_[k].push_back(t);
    }
  }
  const std::vector<PlacedTriangle>& triangles() const { return triangles_; }

  // About a point beside x along a direction u: the triangles above it, counted by the way they
  // face. Farther on the point is moved by little along x, by far less along y, and by still less
  // along z. For a point off the surface u may be 0.
  long beside(const Vector& x, const Vector& u) const {
    long sum = 0;
    for (const std::size_t t : slabs_[slab(x[0])]) sum += count(triangles_[t], x, u);
    return sum;
  }

 private:
  static constexpr std::size_t kSlabs = 64;

  static std::pair<Rational, Rational> range(const PlacedTriangle& t) {
    const auto& [a, b, c] = t.corners;
    return {std::min({a[0], b[0], c[0]}), std::max({a[0], b[0], c[0]})};
  }
  std::size_t slab(const Rational& x) const {
    return std::upper_bound(walls_.begin(), walls_.end(), x) - walls_.begin();
  }
  // 1 or -1 for a triangle above the point, by the way it faces; else 0.
  static int count(const PlacedTriangle& t, const Vector& x, const Vector& u) {
    const int up = sgn(t.normal[2]);
    bool is_over = up != 0;
    for (std::size_t k = 0; k < 3 && is_over; ++k) {
      const Vector &e = t.edges[k], from = x - t.corners[k];
      int side = sgn(Rational(e[0] * from[1] - e[1] * from[0]));
      if (side == 0) side = sgn(Rational(e[0] * u[1] - e[1] * u[0]));
      if (side == 0) side = -sgn(e[1]);
      if (side == 0) side = sgn(e[0]);
      is_over = side == up;
    }
    if (!is_over) return 0;
    // Below its plane, seen along z.
    int above = sgn(dot(t.normal, x - t.corners[0]));
    if (above == 0) above = sgn(dot(t.normal, u));
    for (std::size_t k = 0; k < 3 && above == 0; ++k) above = sgn(t.normal[k]);
    return above == -up ? up : 0;
  }

  std::vector<PlacedTriangle> triangles_;
  std::vector<Rational> walls_;  // ascending
  std::vector<Ids> slabs_;       // before the first wall, between two, and from the last on
};

}  // namespace check
