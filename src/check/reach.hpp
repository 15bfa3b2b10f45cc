// SPDX-License-Identifier: MIT
// reach.hpp - proofs that convex parts lie within a distance T of a surface and, if it is closed,
// of what it winds about: a tree of cells, those of which that a part meets are near or inside.
//
// The numbers in parentheses are the steps of docs/decomposition-proof.md.
#pragma once
#include <map>
#include <optional>

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
};

// How often the surface winds about a point beside x along a direction u: the triangles above it,
// counted by the way they face. Farther on the point is moved by little along x, by far less along
// y, and by still less along z. For a point off the surface u may be 0.
inline long winding_beside(const std::vector<PlacedTriangle>& triangles, const Vector& x,
                           const Vector& u) {
  long sum = 0;
  for (const PlacedTriangle& t : triangles) {
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
    if (!is_over) continue;
    // Below its plane, seen along z.
    int above = sgn(dot(t.normal, x - t.corners[0]));
    if (above == 0) above = sgn(dot(t.normal, u));
    for (std::size_t k = 0; k < 3 && above == 0; ++k) above = sgn(t.normal[k]);
    if (above == -up) sum += up;
  }
  return sum;
}

class ReachProof {
 public:
  ReachProof(Words& words, const std::vector<Row>& points,
             const std::vector<std::array<std::size_t, 3>>& triangles)
      : words_(words) {
    for (const auto& [a, b, c] : triangles) {
      triangles_.emplace_back(
          std::array<Vector, 3>{vector_of(points[a]), vector_of(points[b]), vector_of(points[c])});
    }
    is_closed_ = is_closed(triangles);
  }

  // (11) to (13), after the word `reach` and the distance. Returns the number of cells.
  std::size_t check(const Rational& squared, const std::vector<PlacedPart>& parts) {
    squared_ = squared;
    expect(words_.take_if("root"), "root");
    Cube root;
    for (Rational& x : root.center) x = words_.rational();
    root.half = words_.rational();
    require(root.half > 0, "the root has no size");
    Ids all(triangles_.size());
    for (std::size_t t = 0; t < all.size(); ++t) all[t] = t;
    read_cell(root, all, 0);
    while (words_.take_if("beyond")) read_beyond(parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p) check_part(p, parts[p]);
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

  // (11) The cells in preorder. `near` has the triangles whose boxes meet this one.
  void read_cell(const Cube& cube, const Ids& near, int depth) {
    expect(words_.take_if("cell"), "cell");
    const std::size_t number = cells_.size();
    const std::string kind = words_.take();
    expect(is_one_of(kind, {"split", "near", "inside", "open"}), "split, near, inside or open");
    cells_.push_back({cube, Kind::Open});
    if (kind == "near") {
      require_near(cube, words_.id(triangles_.size()));
      cells_[number].kind = Kind::Near;
    } else if (kind == "inside") {
      require_inside(cube, near);
      cells_[number].kind = Kind::Inside;
    } else if (kind == "split") {
      expect(depth < kDeepest, "fewer halvings");
      cells_[number].kind = Kind::Split;
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
      require(winding_beside(triangles_, cube.center, {}) != 0, "a cell is outside");
    }
  }

  void read_beyond(std::size_t parts) {
    const std::size_t cell = words_.id(cells_.size()), part = words_.id(parts);
    Vector direction;
    for (Rational& x : direction) x = words_.rational();
    require(beyond_.emplace(std::pair(cell, part), direction).second,
            "a cell is beyond a part already");
  }

  // (13) Each cell of the tree that the part may meet is near or inside. What lies in the root lies
  // in its cells.
  void check_part(std::size_t p, const PlacedPart& part) const {
    const Cube& root = cells_[0].cube;
    for (const Vector& x : part.corners) {
      require(Cube{x, 0}.touches(root), "a part reaches out of the root");
    }
    for (std::size_t c = 0; c < cells_.size();) {
      const Cell& cell = cells_[c];
      if (cell.kind == Kind::Near || cell.kind == Kind::Inside ||
          is_beyond(cell.cube, c, p, part)) {
        c = cell.end;
        continue;
      }
      require(cell.kind == Kind::Split, "a part may reach into an open cell");
      ++c;
    }
  }

  bool is_beyond(const Cube& cube, std::size_t c, std::size_t p, const PlacedPart& part) const {
    for (const Row& plane : part.planes) {
      const Vector n{plane[0], plane[1], plane[2]};
      if (dot(n, cube.center) + plane[3] > cube.width(n)) return true;
    }
    const auto found = beyond_.find({c, p});
    if (found == beyond_.end()) return false;
    const Vector& n = found->second;
    const Rational least = dot(n, cube.center) - cube.width(n);
    return std::all_of(part.corners.begin(), part.corners.end(),
                       [&](const Vector& x) { return dot(n, x) < least; });
  }

  Words& words_;
  std::vector<PlacedTriangle> triangles_;
  bool is_closed_ = false;
  Rational squared_;
  std::vector<Cell> cells_;
  std::map<std::pair<std::size_t, std::size_t>, Vector> beyond_;  // by cell and part
};

}  // namespace check
