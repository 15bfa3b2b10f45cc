// SPDX-License-Identifier: MIT
// reach.hpp - proofs that convex parts lie within a distance T of a surface and, if it is closed,
// of what it winds about: a tree of cells, those of which that a part meets are near or inside.
//
// The numbers in parentheses are the steps of docs/decomposition-proof.md.
#pragma once
#include <map>
#include <optional>
#include <set>

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
  // Whether it is at most in a side of the box of some points, or beyond it.
  bool is_beside(const std::vector<Vector>& points) const {
    for (std::size_t k = 0; k < 3; ++k) {
      // (No structured binding: C++20 lets lambdas capture it, Clang 14 does not.)
      const auto ends =
          std::minmax_element(points.begin(), points.end(),
                              [&](const Vector& a, const Vector& b) { return a[k] < b[k]; });
      if (all_of([&](const Vector& x) { return x[k] <= (*ends.first)[k]; })) return true;
      if (all_of([&](const Vector& x) { return x[k] >= (*ends.second)[k]; })) return true;
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
  // Whether a plane, or the box of the corners, shows that a triangle does not meet its interior.
  bool is_beside(const PlacedTriangle& t) const {
    return std::any_of(planes.begin(), planes.end(),
                       [&](const Row& plane) {
                         return t.all_of([&](const Vector& x) { return value(plane, x) >= 0; });
                       }) ||
           t.is_beside(corners);
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

class ReachProof {
 public:
  ReachProof(Words& words, const std::vector<Row>& points,
             const std::vector<std::array<std::size_t, 3>>& triangles)
      : words_(words), winding_(placed(points, triangles)), is_closed_(is_closed(triangles)) {}

  // (11) to (13), (18) and (19), after the word `reach` and the distance. Returns the number of
  // cells.
  std::size_t check(const Rational& squared, std::vector<PlacedPart> parts) {
    squared_ = squared;
    parts_ = std::move(parts);
    expect(words_.take_if("root"), "root");
    Cube root{read_vector(), words_.rational()};
    require(root.half > 0, "the root has no size");
    read_inner();
    Ids all(triangles_.size());
    for (std::size_t t = 0; t < all.size(); ++t) all[t] = t;
    read_cell(root, all, 0);
    while (words_.take_if("beyond")) read_beyond();
    for (std::size_t p = 0; p < parts_.size(); ++p) check_part(p);
    return cells_.size();
  }
  bool has_inside() const { return is_closed_; }

  // Every directed edge runs as often in the other direction.
  static bool is_closed(const std::vector<std::array<std::size_t, 3>>& triangles) {
    std::map<std::pair<std::size_t, std::size_t>, long> uses;
    for (const auto& t : triangles) {
      for (std::size_t e = 0; e < 3; ++e) {
        const std::size_t from = t[e], to = t[(e + 1) % 3];
        if (from != to) uses[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
      }
    }
    return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 0; });
  }

 private:
  enum class Kind { Split, Near, Inside, Open };
  struct Cell {
    Cube cube;
    Kind kind;
    std::size_t end = 0;  // the first cell that is not below it
  };
  static constexpr int kDeepest = 1100;  // halvings of a double

  Vector read_vector() {
    Vector v;
    for (Rational& x : v) x = words_.rational();
    return v;
  }

  // (18) Parts are replaced by smaller ones. Their points moved by at most slack T, so it is enough
  // that the smaller parts are within (1 - slack) T.
  void read_inner() {
    if (!words_.take_if("slack")) return;
    const Rational slack = words_.rational();
    expect(slack >= 0 && slack < 1, "a share below 1");
    const Rational squared_move = slack * slack * squared_;
    squared_ *= (1 - slack) * (1 - slack);
    std::set<std::size_t> seen;
    while (words_.take_if("inner")) {
      const std::size_t p = words_.id(parts_.size());
      const Vector middle = read_vector();
      const Rational share = words_.rational();
      require(seen.insert(p).second, "a part is made smaller twice");
      require(share >= 0 && share < 1 && parts_[p].is_inside(middle),
              "a part is not made smaller towards a point inside of it");
      for (const Vector& x : parts_[p].corners) {
        require(share * share * dot(x - middle, x - middle) <= squared_move,
                "a part is made smaller by too much");
      }
      parts_[p].shrink(middle, share);
    }
  }

  // (11) The cells in preorder. `near` has the triangles whose boxes meet this one.
  void read_cell(const Cube& cube, const Ids& near, int depth) {
    expect(words_.take_if("cell"), "cell");
    const std::size_t number = cells_.size();
    const std::string kind = words_.take();
    expect(is_one_of(kind, {"split", "near", "inside", "open"}), "split, near, inside or open");
    cells_.push_back({cube, kind == "split" ? Kind::Split : Kind::Open});
    if (kind == "near") {
      require_near(cube, words_.id(triangles_.size()));
      cells_[number].kind = Kind::Near;
    } else if (kind == "inside") {
      require_inside(cube, near);
      cells_[number].kind = Kind::Inside;
    }
    while (words_.take_if("clear")) read_clear(cube, near, number);
    if (kind == "split") {
      expect(depth < kDeepest, "fewer halvings");
      for (int k = 0; k < 8; ++k) {
        Cube child{cube.center, Rational(cube.half / 2)};
        child.center = child.corner(k);
        Ids within;
        for (const std::size_t t : near) {
          if (child.may_meet_box_of(triangles_[t])) within.push_back(t);
        }
        read_cell(child, within, depth + 1);
      }
    }
    cells_[number].end = cells_.size();
  }

  // The points within T of a triangle are a convex set.
  void require_near(const Cube& cube, std::size_t t) const {
    for (int k = 0; k < 8; ++k) {
      require(triangles_[t].is_near(cube.corner(k), squared_), "a cell is not near its triangle");
    }
  }

  // (12) No triangle meets the cell, so the surface winds about all of it equally often; and as
  // often as about a cell of the same kind that touches it.
  void require_inside(const Cube& cube, const Ids& near) {
    require(is_closed_, "the surface is not closed: it has no inside");
    for (const std::size_t t : near) {
      require(!cube.meets(triangles_[t]), "a triangle meets a cell of the inside");
    }
    if (words_.at_number()) {
      const Cell& beside = cells_[words_.id(cells_.size() - 1)];
      require(beside.kind == Kind::Inside && beside.cube.touches(cube),
              "a cell does not touch one of the inside");
    } else {
      require(winding_.beside(cube.center, {}) != 0, "a cell is outside");
    }
  }

  // (19) No triangle meets the interior of what a part and the cell have in common, so the surface
  // winds about all of it as often as about a point inside.
  void read_clear(const Cube& cube, const Ids& near, std::size_t cell) {
    const std::size_t p = words_.id(parts_.size());
    const Vector x = read_vector();
    const std::vector<Vector> ends{cube.corner(0), cube.corner(7)};
    require(is_closed_, "the surface is not closed: nothing is clear");
    require(cube.is_inside(x) && parts_[p].is_inside(x), "a point is not inside of part and cell");
    for (const std::size_t t : near) {
      require(triangles_[t].is_beside(ends) || parts_[p].is_beside(triangles_[t]),
              "a triangle runs through what a part has in a cell");
    }
    require(winding_.beside(x, {}) != 0, "what a part has in a cell is outside");
    require(clear_.emplace(cell, p).second, "a cell is clear of a part already");
  }

  void read_beyond() {
    const std::size_t cell = words_.id(cells_.size()), part = words_.id(parts_.size());
    const Vector direction = read_vector();
    require(beyond_.emplace(std::pair(cell, part), direction).second,
            "a cell is beyond a part already");
  }

  // (13) Each cell of the tree that the part may meet is near or inside, or clear. What lies in the
  // root lies in its cells.
  void check_part(std::size_t p) const {
    const PlacedPart& part = parts_[p];
    const Cube& root = cells_[0].cube;
    for (const Vector& x : part.corners) {
      require(Cube{x, 0}.touches(root), "a part reaches out of the root");
    }
    for (std::size_t c = 0; c < cells_.size();) {
      const Cell& cell = cells_[c];
      if (cell.kind == Kind::Near || cell.kind == Kind::Inside || clear_.count({c, p}) == 1 ||
          is_beyond(cell.cube, c, p)) {
        c = cell.end;
        continue;
      }
      require(cell.kind == Kind::Split, "a part may reach into an open cell");
      ++c;
    }
  }

  bool is_beyond(const Cube& cube, std::size_t c, std::size_t p) const {
    for (const Row& plane : parts_[p].planes) {
      if (value(plane, cube.center) > cube.width({plane[0], plane[1], plane[2]})) {
        return true;
      }
    }
    const auto found = beyond_.find({c, p});
    if (found == beyond_.end()) return false;
    const Vector& n = found->second;
    const Rational least = dot(n, cube.center) - cube.width(n);
    const std::vector<Vector>& corners = parts_[p].corners;
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Vector& x) { return dot(n, x) < least; });
  }

  Words& words_;
  WindingNumbers winding_;
  const std::vector<PlacedTriangle>& triangles_ = winding_.triangles();
  bool is_closed_;
  Rational squared_;
  std::vector<PlacedPart> parts_;
  std::vector<Cell> cells_;
  std::set<std::pair<std::size_t, std::size_t>> clear_;           // cell and part
  std::map<std::pair<std::size_t, std::size_t>, Vector> beyond_;  // by cell and part
};

}  // namespace check
