// SPDX-License-Identifier: MIT
// partition.hpp - proofs that convex parts hold the solid of a surface: planes cut space into
// regions, and one part holds what a region has of the solid.
//
// The numbers in parentheses are the steps of docs/decomposition-proof.md.
#pragma once
#include <cmath>
#include <sstream>

#include "surface.hpp"

namespace check {

class PartitionProof : public SurfaceProof {
 public:
  explicit PartitionProof(const std::string& bytes) : SurfaceProof(bytes) {}

 private:
  // A convex polygon of a triangle, or of a side of a region: corners in order, as ids.
  struct Polygon {
    std::size_t of;  // the triangle
    Ids corners;
  };
  using Polygons = std::vector<Polygon>;

  std::string check_statements() override {
    expect(words_.take_if("convexact-proof") && words_.take_if("6") && words_.take_if("partition"),
           "convexact-proof 6 partition");
    read_triangles();
    for (const Row& p : points_) places_.push_back(vector_of(p));
    winding_.emplace(placed(points_, triangles_));
    is_closed_ = ReachProof::is_closed(triangles_);
    while (words_.take_if("part")) read_part();
    Polygons all;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      all.push_back({t, {triangles_[t].begin(), triangles_[t].end()}});
    }
    read_node(box(), all, 0);
    const std::string reach = read_reach(parts_);
    const std::string apart = read_apart();
    words_.end();
    return "proven: " + count(parts_.size(), " convex parts hold the ") +
           (is_closed_ ? "solid, all that the surface winds about, and its " : "surface, all ") +
           count(triangles_.size(), " triangles, by ") +
           count(leaves_, leaves_ == 1 ? " region\n" : " regions\n") + reach + apart;
  }

  // (14) A part is the hull of its corners, whose facets follow.
  void read_part() {
    std::vector<Row> stored;
    while (words_.take_if("corner")) stored.push_back(words_.point());
    std::vector<std::array<Row, 3>> facets;
    while (words_.take_if("facet")) {
      const Corners f = corners(stored.size());
      facets.push_back({stored[f[0]], stored[f[1]], stored[f[2]]});
    }
    PlacedPart& part = parts_.emplace_back(PlacedPart{planes_of_hull(stored, facets), {}});
    for (const Row& corner : stored) part.corners.push_back(vector_of(corner));
  }

  // A box around all points, none of which it touches, as the polygons of its sides.
  Polygons box() {
    Vector low = places_[0], high = low;
    for (const Vector& x : places_) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], x[k]);
        high[k] = std::max(high[k], x[k]);
      }
    }
    const std::size_t first = places_.size();
    for (std::size_t c = 0; c < 8; ++c) {
      Vector corner;
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = (c >> k & 1) != 0 ? Rational(high[k] + 1) : Rational(low[k] - 1);
      }
      places_.push_back(corner);
    }
    Polygons sides;
    for (const Ids& side : {Ids{0, 2, 6, 4}, Ids{1, 5, 7, 3}, Ids{0, 4, 5, 1}, Ids{2, 3, 7, 6},
                            Ids{0, 1, 3, 2}, Ids{4, 6, 7, 5}}) {
      Polygon polygon{0, side};
      for (std::size_t& c : polygon.corners) c += first;
      sides.push_back(polygon);
    }
    return sides;
  }

  // (15) The nodes in preorder: a plane cuts a region into two, or one part holds what it has.
  void read_node(const Polygons& region, const Polygons& pieces, std::size_t depth) {
    static constexpr std::size_t kDeepest = 1000;  // for the stack, under sanitizers as well
    expect(words_.take_if("node") && depth < kDeepest, "node");
    if (words_.take_if("part")) {
      require_held(region, pieces, parts_[words_.id(parts_.size())]);
      ++leaves_;
      return;
    }
    if (words_.take_if("empty")) {
      require(pieces.empty(), "a region without a part has a piece of a triangle");
      require_outside(region, nullptr);
      return;
    }
    expect(words_.take_if("cut"), "cut, part or empty");
    const Row plane = scaled(words_.halfspace());
    const Ids upper = words_.ids(triangles_.size());
    const IdSet goes_up(upper.begin(), upper.end());
    std::map<std::size_t, int> sides;  // by corner
    std::map<Pair, std::size_t> crossings;
    Polygons halves[2], pieces_of[2];
    for (const Polygon& side : region) {
      for (const bool is_upper : {false, true}) {
        Polygon half = clip(side, plane, is_upper ? 1 : -1, sides, crossings);
        if (!half.corners.empty()) halves[is_upper].push_back(std::move(half));
      }
    }
    for (const Polygon& piece : pieces) {
      const auto [below, above] = sides_of(piece, plane, sides);
      if (below && above) {
        pieces_of[0].push_back(clip(piece, plane, -1, sides, crossings));
        pieces_of[1].push_back(clip(piece, plane, 1, sides, crossings));
      } else {
        pieces_of[above || (!below && goes_up.count(piece.of) == 1)].push_back(piece);
      }
    }
    for (const bool is_upper : {false, true}) {
      add_cut(halves[is_upper], plane, sides);
    }
    read_node(halves[0], pieces_of[0], depth + 1);
    read_node(halves[1], pieces_of[1], depth + 1);
  }

  // (17) Between each two parts a direction, along which they have no more in common than twice the
  // distance that either may reach beyond the plane in the middle.
  std::string read_apart() {
    if (!words_.take_if("disjoint")) return "";
    const Rational squared = words_.rational();
    expect(squared >= 0, "the square of a length");
    for (std::size_t second = 0; second < parts_.size(); ++second) {
      for (std::size_t first = 0; first < second; ++first) apart_.insert({first, second});
    }
    while (words_.take_if("between")) {
      const std::size_t first = words_.id(parts_.size()), second = words_.id(parts_.size());
      require(apart_.erase({first, second}) == 1, "two parts have no plane, or two");
      Vector n;
      for (Rational& x : n) x = words_.rational();
      require(n[0] != 0 || n[1] != 0 || n[2] != 0, "a plane across no direction");
      const Rational overlap = ends(parts_[first], n).second - ends(parts_[second], n).first;
      require(overlap <= 0 || overlap * overlap <= 4 * squared * along(n, n),
              "a part reaches too far beyond the plane between it and another one");
    }
    require(apart_.empty(), "two parts have no plane between them");
    if (squared == 0) return "proven: no two parts have a common interior point\n";
    std::ostringstream about;
    about << std::sqrt(squared.get_d());
    return "proven: no part reaches farther beyond a plane between it and another one than about " +
           about.str() + ", the root of " + squared.get_str() + "\n";
  }
  static Rational along(const Vector& n, const Vector& x) {
    return n[0] * x[0] + n[1] * x[1] + n[2] * x[2];
  }
  // The least and the most along a direction.
  static std::pair<Rational, Rational> ends(const PlacedPart& part, const Vector& n) {
    std::pair<Rational, Rational> ends{along(n, part.corners[0]), along(n, part.corners[0])};
    for (const Vector& x : part.corners) {
      ends.first = std::min(ends.first, along(n, x));
      ends.second = std::max(ends.second, along(n, x));
    }
    return ends;
  }

  int side(std::size_t corner, const Row& plane, std::map<std::size_t, int>& sides) const {
    const auto [known, is_new] = sides.emplace(corner, 0);
    if (is_new) {
      known->second = corner < points_.size() ? sgn(dot(plane, points_[corner]))
                                              : sgn(value(plane, places_[corner]));
    }
    return known->second;
  }
  std::pair<bool, bool> sides_of(const Polygon& polygon, const Row& plane,
                                 std::map<std::size_t, int>& sides) const {
    bool below = false, above = false;
    for (const std::size_t c : polygon.corners) {
      below = below || side(c, plane, sides) < 0;
      above = above || side(c, plane, sides) > 0;
    }
    return {below, above};
  }

  // What lies on one side of a plane; nothing if that is no more than in the plane.
  Polygon clip(const Polygon& polygon, const Row& plane, int wanted,
               std::map<std::size_t, int>& sides, std::map<Pair, std::size_t>& crossings) {
    Polygon rest{polygon.of, {}};
    const auto [below, above] = sides_of(polygon, plane, sides);
    if (!(wanted < 0 ? below : above)) return rest;
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
      const std::size_t a = polygon.corners[k],
                        b = polygon.corners[(k + 1) % polygon.corners.size()];
      const int at_a = side(a, plane, sides), at_b = side(b, plane, sides);
      if (at_a != -wanted) rest.corners.push_back(a);
      if (at_a * at_b < 0) rest.corners.push_back(crossing(a, b, plane, sides, crossings));
    }
    return rest;
  }
  // Where a plane crosses the segment between two corners. Fractions in lowest terms are as long as
  // the point needs, however it came about.
  std::size_t crossing(std::size_t a, std::size_t b, const Row& plane,
                       std::map<std::size_t, int>& sides, std::map<Pair, std::size_t>& crossings) {
    const auto [known, is_new] = crossings.emplace(sorted(a, b), places_.size());
    if (!is_new) return known->second;
    const Rational at_a = value(plane, places_[a]);
    const Rational share = at_a / (at_a - value(plane, places_[b]));
    Vector x;
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = places_[a][k] + share * (places_[b][k] - places_[a][k]);
    }
    sides[places_.size()] = 0;
    places_.push_back(x);
    return known->second;
  }
  // The new side of a half runs along one side of each polygon that the plane meets.
  void add_cut(Polygons& half, const Row& plane, std::map<std::size_t, int>& sides) const {
    std::map<std::size_t, Ids> beside;
    for (const Polygon& polygon : half) {
      Ids ends;
      for (const std::size_t c : polygon.corners) {
        if (side(c, plane, sides) == 0) ends.push_back(c);
      }
      if (ends.size() != 2) continue;
      beside[ends[0]].push_back(ends[1]);
      beside[ends[1]].push_back(ends[0]);
    }
    require(!beside.empty(), "a plane does not cut its region");
    Polygon cut{0, {beside.begin()->first}};
    for (std::size_t next = beside.begin()->second[0]; next != cut.corners[0];) {
      const Ids& both = beside.at(next);
      require(both.size() == 2 && cut.corners.size() <= beside.size(), "a region has no side");
      const std::size_t before = cut.corners.back();
      cut.corners.push_back(next);
      next = both[0] == before ? both[1] : both[0];
    }
    half.push_back(std::move(cut));
  }

  // (16) The corners of pieces are in the part. So are those of the region, or the surface does not
  // wind about what is beside them towards its middle.
  void require_held(const Polygons& region, const Polygons& pieces, const PlacedPart& part) const {
    IdSet all;
    for (const Polygon& piece : pieces) all.insert(piece.corners.begin(), piece.corners.end());
    for (const std::size_t c : all) {
      require(is_in(part, c), "a piece of a triangle reaches out of the part of its region");
    }
    require_outside(region, &part);
  }
  bool is_in(const PlacedPart& part, std::size_t c) const {
    return std::all_of(part.planes.begin(), part.planes.end(), [&](const Row& plane) {
      return c < points_.size() ? dot(plane, points_[c]) <= 0 : value(plane, places_[c]) <= 0;
    });
  }
  void require_outside(const Polygons& region, const PlacedPart* part) const {
    if (!is_closed_) return;
    IdSet all;
    for (const Polygon& polygon : region) {
      all.insert(polygon.corners.begin(), polygon.corners.end());
    }
    Vector middle;
    for (const std::size_t c : all) {
      for (std::size_t k = 0; k < 3; ++k) middle[k] += places_[c][k] / Rational(all.size());
    }
    for (const std::size_t c : all) {
      if (part != nullptr && is_in(*part, c)) continue;
      require(winding_->beside(places_[c], middle - places_[c]) == 0,
              "a corner of a region is in the solid, and not in the part");
    }
  }

  std::vector<Vector> places_;  // of the points, and of all corners that cuts made
  std::optional<WindingNumbers> winding_;
  bool is_closed_ = false;
  std::vector<PlacedPart> parts_;
  std::set<Pair> apart_;  // pairs of parts without a plane yet
  std::size_t leaves_ = 0;
};

}  // namespace check
