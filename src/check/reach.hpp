// SPDX-License-Identifier: MIT
// reach.hpp - proofs that convex parts lie within a distance T of a surface and, if it is closed,
// of what it winds about: a tree of cells, those of which that a part meets are near or inside.
//
// The numbers in parentheses are the steps of docs/decomposition-proof.md.
#pragma once
#include <map>
#include <optional>
#include <set>

#include "placed.hpp"

namespace check {

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
    const Box walls{cube.corner(0), cube.corner(7)};
    require(is_closed_, "the surface is not closed: nothing is clear");
    require(cube.is_inside(x) && parts_[p].is_inside(x), "a point is not inside of part and cell");
    const Box around = Box::around(parts_[p].corners);
    for (const std::size_t t : near) {
      const PlacedTriangle& triangle = triangles_[t];
      require(triangle.is_beside(walls) || triangle.is_beside(around) ||
                  parts_[p].has_beyond(triangle) || !parts_[p].may_run_through(triangle, cube),
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
    Ids planes(part.planes.size());
    for (std::size_t k = 0; k < planes.size(); ++k) planes[k] = k;
    check_cell(0, p, planes);
  }

  // `planes` are those of the part beyond which something of the cell may be.
  void check_cell(std::size_t c, std::size_t p, const Ids& planes) const {
    const Cell& cell = cells_[c];
    if (cell.kind == Kind::Near || cell.kind == Kind::Inside || clear_.count({c, p}) == 1) return;
    Ids left;
    for (const std::size_t k : planes) {
      const Row& plane = parts_[p].planes[k];
      const Rational at = value(plane, cell.cube.center),
                     width = cell.cube.width({plane[0], plane[1], plane[2]});
      if (at > width) return;
      if (at > -width) left.push_back(k);
    }
    if (is_beyond(c, p)) return;
    require(cell.kind == Kind::Split, "a part may reach into an open cell");
    for (std::size_t child = c + 1; child < cell.end; child = cells_[child].end) {
      check_cell(child, p, left);
    }
  }

  // Whether a direction that the proof gives separates the part from the cell.
  bool is_beyond(std::size_t c, std::size_t p) const {
    const auto found = beyond_.find({c, p});
    if (found == beyond_.end()) return false;
    const Vector& n = found->second;
    const Cube& cube = cells_[c].cube;
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
