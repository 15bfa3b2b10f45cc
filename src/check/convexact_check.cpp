// SPDX-License-Identifier: MIT
// convexact-check reads a proof (docs/proof-format.md) and proves a run of convexact again, from it
// alone, with GMP's numbers and nothing of convexact. What is not proven is refused, with its line.
#include <algorithm>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <vector>

#include "mesh_file.hpp"
#include "words.hpp"

namespace {

using namespace check;
using Triangle = std::array<std::size_t, 3>;

// A surface of triangles of planes, counter-clockwise from outside. Each directed edge has the
// third corner of the triangle on its left, and the point where the planes of that triangle meet.
struct Side {
  std::size_t third;
  Row vertex;
};
using Surface = std::map<std::pair<std::size_t, std::size_t>, Side>;

void add(Surface& surface, const Triangle& t, const Row& vertex) {
  for (std::size_t e = 0; e < 3; ++e) {
    const bool is_new = surface.insert({{t[e], t[(e + 1) % 3]}, {t[(e + 2) % 3], vertex}}).second;
    require(is_new, "two triangles lie on the same side of an edge");
  }
}
const Side& left_of(const Surface& surface, std::size_t a, std::size_t b) {
  const auto found = surface.find({a, b});
  require(found != surface.end(), "an edge has no triangle on one side");
  return found->second;
}

struct Proof : Words {
  using Words::Words;
  // What is proven, in sentences.
  std::string check() {
    expect(take_if("convexact-proof") && take_if("1"), "convexact-proof 1");
    greedy_ = take_if("greedy");
    expect(greedy_ || take_if("costs"), "greedy or costs");
    read_hull();
    removals_.resize(planes_.size());
    while (at("evaluate") || at("remove")) take() == "evaluate" ? evaluate() : remove();
    read_result();
    expect(take_if("end") && id(line + 1) == line, "end and its line number");
    expect(take().empty(), "nothing after the end");
    const auto count = [](std::size_t n, const char* what) { return std::to_string(n) + what; };
    return "proven: " + count(planes_.size(), " planes bound exactly the ") +
           (rows_.empty() ? "hull of " : "input halfspaces, with ") +
           count(points_.size(), " points\nproven: each of ") +
           count(steps_, " removals adds the stated volume\n") +
           (greedy_ ? "proven" : "not claimed") + ": each was the cheapest, " +
           count(ties_, " of them tied, by ") + count(evaluations_, " evaluations\nproven: the ") +
           count(left_.size(), " planes left are bounded and hold every point\n") + stored_;
  }

  // Whether the points, or the rows of halfspaces, are those of a file: as sets, since neither
  // order nor repeats change what they bound. Decimals mean the same in all of the file.
  std::string require_same(const std::string& path) const {
    std::string why;
    for (const Decimals decimals : {Decimals::Nearest, Decimals::Spelt}) {
      const MeshFile file = read_mesh_file(path, decimals);
      require(file.is_mesh == rows_.empty(), path + " is of another kind than the proof's input");
      const std::string difference = difference_to(file);
      const bool is_nearest = decimals == Decimals::Nearest;
      if (difference.empty()) {
        return "proven: the " + std::string(file.is_mesh ? "points" : "rows") + " are those of " +
               path + ", decimals " + (is_nearest ? "as the nearest doubles\n" : "as spelt\n");
      }
      if (is_nearest) why = difference;
    }
    throw Failure{1, "not proven: that the proof is about this file: " + why, path};
  }

  // What is known of the removal of a plane.
  struct Removal {
    bool fresh = false;      // its ring has not changed since it was evaluated
    bool unbounded = false;  // for ever: fewer planes bound no more
    Rational cost = 0;       // the last one proven, or 0: a lower bound, as costs never decrease
    Ids ring;
    std::vector<Triangle> triangles;
  };

  // The planes bound exactly the convex hull of the points: a polytope P.
  void read_hull() {
    while (take_if("row")) rows_.insert(scaled(halfspace()));
    while (take_if("point")) points_.push_back(point());
    // (1) An interior point, strictly inside each plane. The planes stand in canonical order.
    expect(take_if("interior"), "interior");
    const Row interior = point();
    std::array<Integer, 3> previous, direction;
    for (; take_if("plane"); previous = direction) {
      left_.insert(planes_.size());
      queue_.insert({0, planes_.size()});
      const Row& plane = planes_.emplace_back(scaled(halfspace()));
      const Integer common = gcd(gcd(plane[0], plane[1]), plane[2]);
      require(dot(plane, interior) < 0, "the interior point is not inside");
      for (int k = 0; k < 3; ++k) direction[k] = plane[k] / common;
      require(planes_.size() == 1 || previous < direction, "the order is not canonical");
    }
    // (2) Planes that meet in an input point, by threes. Their normals span cones: it is a vertex.
    std::vector<bool> known(points_.size(), false);
    std::vector<Triangle> triangles;
    std::vector<std::set<Row>> corners(planes_.size());
    while (take_if("triangle")) {
      const Triangle t = triangle();
      const std::size_t p = id(points_.size());
      require_vertex(points_[p], t);
      add(fan_, t, points_[p]);
      for (const std::size_t i : t) corners[i].insert(points_[p]);
      triangles.push_back(t);
      known[p] = true;
    }
    // (3) The surface is closed (4), so each direction lies in as many cones as any other: in one,
    // as inside the first. Cones of normals cover everything: bounded. Euler: no plane is left out.
    require(planes_.size() >= 4 && triangles.size() == 2 * planes_.size() - 4,
            "the surface is no sphere of all planes");
    require_one_cover(triangles[0], triangles);
    for (const auto& of_plane : corners) require(of_plane.size() >= 3, "a plane bounds no facet");
    // (4) No vertex is beyond the plane across an edge. So the function that is linear on each
    // cone, -d at each normal, is convex: it is P's support function, and the vertices lie in P.
    for (const auto& [edge, left] : fan_)
      require(dot(planes_[left_of(fan_, edge.second, edge.first).third], left.vertex) <= 0,
              "the surface is not convex");
    // (5) P holds every other point: a repeat, or one in a tetrahedron of the interior point and
    // three that P is known to hold. So P is the hull of the points.
    while (take_if("inside")) {
      const std::size_t p = id(points_.size());
      const Ids by = ids(points_.size());
      for (const std::size_t q : by) require(known[q], "it rests on a point not yet known inside");
      require(!known[p] && (by.size() == 1 ? points_[p] == points_[by[0]]
                                           : by.size() == 3 && is_inside(p, interior, by)),
              "this does not show another point inside");
      known[p] = true;
    }
    for (const bool is_known : known) require(is_known, "some point is not proven inside");
    // (6) Every input halfspace holds P, and every plane of P is one of them: they bound P.
    for (const Row& row : rows_) require_points_inside(row);
    for (const Row& plane : planes_)
      require(rows_.empty() || rows_.count(plane) == 1, "a plane is none of the input's");
  }

  Triangle triangle() { return {id(planes_.size()), id(planes_.size()), id(planes_.size())}; }
  Row vertex_of(const Triangle& t) const {
    const Row vertex = meet(planes_[t[0]], planes_[t[1]], planes_[t[2]]);
    require(vertex[3] > 0, "the normals span no cone");
    return vertex;
  }
  void require_vertex(const Row& point, const Triangle& t) const {
    const Row v = vertex_of(t);
    for (int k = 0; k < 3; ++k)
      require(point[k] * v[3] == v[k] * point[3], "the planes of the triangle meet elsewhere");
  }
  // No cone of the triangles but `cone` itself holds a direction inside the cone of `cone`.
  void require_one_cover(const Triangle& cone, const std::vector<Triangle>& triangles) const {
    const Row &p = planes_[cone[0]], &q = planes_[cone[1]], &r = planes_[cone[2]];
    const Row u{p[0] + q[0] + r[0], p[1] + q[1] + r[1], p[2] + q[2] + r[2], 0};
    for (const Triangle& t : triangles) {
      const Row &a = planes_[t[0]], &b = planes_[t[1]], &c = planes_[t[2]];
      const bool holds = det(u, b, c) >= 0 && det(a, u, c) >= 0 && det(a, b, u) >= 0;
      require(t == cone || !holds, "cones of normals overlap");
    }
  }
  bool is_inside(std::size_t p, const Row& interior, const Ids& q) const {
    const std::array<Row, 4> corners{interior, points_[q[0]], points_[q[1]], points_[q[2]]};
    for (std::size_t k = 0; k < 4; ++k) {
      const Row face = meet(corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4]);
      const int inner = sgn(dot(face, corners[k]));
      if (inner == 0 || sgn(dot(face, points_[p])) * inner < 0) return false;
    }
    return true;
  }
  void require_points_inside(const Row& plane) const {
    for (const Row& p : points_) require(dot(plane, p) <= 0, "a point of the input is outside");
  }

  // What the removal of i would add, in the state at hand.
  void evaluate() {
    const std::size_t i = id(planes_.size());
    Removal& removal = removals_[i];
    const bool is_open = left_.count(i) == 1 && !removal.unbounded && !removal.fresh;
    require(is_open, "it has been evaluated in this state, or is gone");
    ++evaluations_;
    queue_.erase({removal.cost, i});
    removal.unbounded = take_if("unbounded");
    if (removal.unbounded) {  // from any point of the solid this ray meets no plane but i
      const Row ray = scaled({rational(), rational(), rational(), 0});
      for (const std::size_t j : left_)
        require(ray != Row{} && (j == i || dot(planes_[j], ray) <= 0), "the ray meets a plane");
      return;
    }
    expect(take_if("cost"), "cost or unbounded");
    const Rational stated = rational();
    expect(take_if("ring"), "ring");
    removal.ring = ids(planes_.size());
    expect(take_if("triangles"), "triangles");
    removal.triangles.clear();
    while (at_number()) removal.triangles.push_back(triangle());
    const Rational cost = volume_of_cap(i, removal.ring, removal.triangles);
    require(stated == cost && cost >= removal.cost, "the volume of the cap is another one");
    removal.cost = cost, removal.fresh = true;
    queue_.insert({cost, i});
  }

  // The volume between plane i and the planes of its ring: what the solid gains without i.
  Rational volume_of_cap(std::size_t i, const Ids& ring,
                         const std::vector<Triangle>& triangles) const {
    // (1) The ring is the cycle of neighbours of i, counter-clockwise.
    const std::size_t k = ring.size();
    require(k >= 3, "a ring of fewer than three");
    for (std::size_t t = 0; t < k; ++t) {
      const bool closes = t > 0 && ring[t] == ring[0];
      require(!closes && left_of(fan_, i, ring[t]).third == ring[(t + 1) % k], "not the ring");
    }
    // (2) The triangles have the ring as their rim, and their normals span cones. No vertex is
    // beyond the plane across an edge, inside or on the rim.
    Surface roof;
    for (const Triangle& t : triangles) add(roof, t, vertex_of(t));
    std::size_t rim = 0;
    for (const auto& [edge, left] : roof) {
      const bool on_rim = roof.count({edge.second, edge.first}) == 0;
      require(!on_rim || left_of(fan_, edge.first, edge.second).third == i, "not within the ring");
      rim += on_rim;
      const Side& across = left_of(on_rim ? fan_ : roof, edge.second, edge.first);
      require(dot(planes_[across.third], left.vertex) <= 0, "the triangles are not convex");
    }
    require(rim == k && roof.size() == 3 * (k - 2), "the triangles do not fill the ring");
    // (3) Every direction is still covered once: they cover none inside the cone across an edge. So
    // without i the solid is bounded, its vertices are known, and it gains the cap.
    require_one_cover({ring[1], ring[0], left_of(fan_, ring[1], ring[0]).third}, triangles);
    // (4) Pyramids from an apex on plane i to the sides. Around the side in plane r, an edge leads
    // from the vertex left of (s, r) to that left of (r, s); with a corner it makes a triangle.
    for (std::size_t t = 0; t < k; ++t)
      add(roof, {ring[(t + 1) % k], ring[t], i}, left_of(fan_, i, ring[t]).vertex);
    const Row& apex = left_of(fan_, i, ring[0]).vertex;
    std::deque<Rational> terms{0};  // summed from the front to the back, as denominators grow
    for (const auto& [edge, left] : roof) {
      if (edge.first == i) continue;
      const Row &corner = left_of(roof, edge.first, i).vertex, &end = left.vertex,
                &start = left_of(roof, edge.second, edge.first).vertex;
      terms.emplace_back(dot(meet(corner, start, end), apex),
                         6 * corner[3] * start[3] * end[3] * apex[3]);
      terms.back().canonicalize();
    }
    for (; terms.size() > 1; terms.erase(terms.begin(), terms.begin() + 2))
      terms.push_back(terms[0] + terms[1]);
    return terms[0];
  }

  void remove() {
    const std::size_t i = id(planes_.size());
    const Removal removal = removals_[i];
    require(removal.fresh, "it is not evaluated in this state");
    // Greedy: the queue has no lower cost, and each that is equal is evaluated in this state.
    Ids tie;
    for (auto entry = queue_.begin(); greedy_ && entry->first == queue_.begin()->first;) {
      require(removals_[entry->second].fresh, "another may be as cheap: it is not evaluated");
      tie.push_back(entry->second);
      if (++entry == queue_.end()) break;
    }
    require(!greedy_ || tie[0] == i, "it is not the cheapest, or not the first of the tie");
    expect(!greedy_ || take_if("tie"), "tie");
    require(ids(planes_.size()) == tie, "the tie is another one");
    ties_ += tie.size() > 1;
    for (const Triangle& t : removal.triangles) {
      expect(take_if("vertex"), "the vertex of each new triangle");
      require_vertex(point(), t);
    }
    for (std::size_t t = 0, k = removal.ring.size(); t < k; ++t) {
      const std::size_t a = removal.ring[t], b = removal.ring[(t + 1) % k];
      fan_.erase({i, a}), fan_.erase({a, b}), fan_.erase({b, i});
      removals_[a].fresh = false;
    }
    for (const Triangle& t : removal.triangles) add(fan_, t, vertex_of(t));
    queue_.erase({removal.cost, i});
    removals_[i] = {}, left_.erase(i), ++steps_;
  }

  void read_result() {
    expect(take_if("survive"), "survive");
    require(ids(planes_.size()) == Ids(left_.begin(), left_.end()), "others survive");
    for (const std::size_t i : left_) require_points_inside(planes_[i]);
    stored_ = "not claimed: anything about stored planes, as the proof has none\n";
    if (take_if("stored")) read_stored();
  }

  // Planes that hold every point. Positive multiples of the normals cancel, so a ray that meets no
  // plane is orthogonal to them all; they span space, so there is none: bounded.
  void read_stored() {
    std::vector<Row> stored;
    std::array<Rational, 3> total;
    while (take_if("halfspace")) {
      const Numbers x = halfspace();
      require_points_inside(stored.emplace_back(scaled(x)));
      const Rational weight = rational();
      require(weight > 0, "a weight that is not positive");
      for (std::size_t k = 0; k < 3; ++k) total[k] += weight * x[k];
    }
    bool spans = false;
    for (const Row& b : stored)
      for (const Row& c : stored) spans = spans || det(stored[0], b, c) != 0;
    spans = spans && total == std::array<Rational, 3>{} && stored.size() == left_.size();
    require(spans, "the stored planes are not bounded");
    stored_ = "proven: the " + std::to_string(stored.size()) +
              " planes stored are bounded, hold every point and " + reach_text(stored) + "\n";
  }

  // How far the stored solid reaches beyond the solid of the planes left, at most. Three stored
  // planes stand for each vertex v of the latter and meet in a point w. If all normals span cones,
  // these cover every direction, as the surface is closed. In the direction u of a cone, a positive
  // sum of its normals, the stored solid reaches u.w at most: so it lies in the hull of all w.
  std::string reach_text(const std::vector<Row>& stored) const {
    std::map<std::size_t, Row> stored_of;
    for (const std::size_t i : left_) stored_of[i] = stored[stored_of.size()];
    Rational farthest = 0;  // |w - v|, squared
    for (const auto& [edge, left] : fan_) {
      const Row w =
          meet(stored_of.at(edge.first), stored_of.at(edge.second), stored_of.at(left.third));
      if (w[3] <= 0)
        return "differ too much from the planes left for a bound on how far they reach";
      farthest = std::max(farthest, squared_distance(w, left.vertex));
    }
    if (farthest == 0) return "reach nowhere beyond the planes left";
    Numbers low, high;  // the box of the points
    for (int k = 0; k < 3; ++k) {
      const auto less = [k](const Row& p, const Row& q) { return p[k] * q[3] < q[k] * p[3]; };
      const auto [first, last] = std::minmax_element(points_.begin(), points_.end(), less);
      low[k] = quotient((*first)[k], (*first)[3]), high[k] = quotient((*last)[k], (*last)[3]);
    }
    low[3] = high[3] = 1;
    return "reach at most " +
           root_from_above(farthest / squared_distance(scaled(low), scaled(high))) +
           " of the points' diameter beyond the planes left";
  }

  // Empty if the file has the same, in any order and any number of times.
  std::string difference_to(const MeshFile& file) const {
    std::vector<Row> mine = points_, theirs = file.rows;
    if (!file.is_mesh) mine.clear();
    for (const Row& row : rows_) mine.push_back(primitive(row));
    std::sort(mine.begin(), mine.end());
    std::sort(theirs.begin(), theirs.end());
    const char* const what = file.is_mesh ? "its point " : "its halfspace ";
    for (std::size_t k = 0; k < file.rows.size(); ++k) {
      if (!std::binary_search(mine.begin(), mine.end(), file.rows[k]))
        return what + std::to_string(k + 1) + " is not in the proof";
    }
    for (const Row& row : mine) {
      if (!std::binary_search(theirs.begin(), theirs.end(), row))
        return "the proof has " + text_of(row) + ", and the file has not";
    }
    return "";
  }

  bool greedy_ = false;
  std::set<Row> rows_;
  std::vector<Row> points_, planes_;
  Surface fan_;  // of all planes that are left
  std::set<std::size_t> left_;
  std::vector<Removal> removals_;
  std::set<std::pair<Rational, std::size_t>> queue_;  // by last proven cost, equal ones by id
  std::size_t steps_ = 0, evaluations_ = 0, ties_ = 0;
  std::string stored_;  // what is proven of it
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3 || argv[1][0] == '-' || argv[argc - 1][0] == '-') {
    std::cerr << "usage: convexact-check PROOF [MESH] (exit 0 proven, 1 not proven, 3 malformed)\n";
    return 2;
  }
  check::end_where_memory_is_short();
  std::ifstream file(argv[1], std::ios::binary);
  Proof proof(file);
  try {
    expect(file.is_open(), "a file that can be read");
    std::string proven = proof.check();
    if (argc == 3) proven += proof.require_same(argv[2]);
    std::cout << proven;
    return 0;
  } catch (const Failure& failure) {
    const std::string line = "line " + std::to_string(proof.line);
    std::cerr << "convexact-check: " << (failure.where.empty() ? line : failure.where) << ": "
              << failure.what << "\n";
    return failure.exit_code;
  }
}
