// SPDX-License-Identifier: MIT
// run.hpp - proofs of runs: planes that hold points, removed one after another.
//
// The numbers in parentheses are the steps of docs/proof-format.md.
#pragma once
#include <deque>
#include <map>
#include <set>

#include "exact.hpp"
#include "mesh_file.hpp"
#include "root_sum.hpp"
#include "text.hpp"

namespace check {

using Triangle = std::array<std::size_t, 3>;

// A surface of triangles of planes, counter-clockwise from outside. Each directed edge has the
// third corner of the triangle on its left, and the point where the planes of that triangle meet.
struct Side {
  std::size_t third;
  Row vertex;
};
using Surface = std::map<std::pair<std::size_t, std::size_t>, Side>;

inline void add(Surface& surface, const Triangle& t, const Row& vertex) {
  for (std::size_t e = 0; e < 3; ++e) {
    const bool is_new = surface.insert({{t[e], t[(e + 1) % 3]}, {t[(e + 2) % 3], vertex}}).second;
    require(is_new, "two triangles lie on the same side of an edge");
  }
}
inline const Side& left_of(const Surface& surface, std::size_t a, std::size_t b) {
  const auto found = surface.find({a, b});
  require(found != surface.end(), "an edge has no triangle on one side");
  return found->second;
}

// The measure of the costs of a proof. None makes no claim about costs.
enum class Measure { Volume, Area, None };

// The data on the removal of a plane.
struct Removal {
  bool fresh = false;      // its ring has not changed since the evaluation
  bool unbounded = false;  // for good: fewer planes bound no more
  bool kept = false;       // for good, and not in the queue
  // The terms of its cost as evaluated last, each kept while the plane that it names is there: 0 or
  // more, and never falling while that plane is there.
  std::map<std::size_t, RootSum> terms;
  Cost cost;  // their sum, a lower bound
  Ids ring;
  std::vector<Triangle> triangles;
};

class RunProof {
 public:
  explicit RunProof(const std::string& bytes) : words_(bytes) {}

  // The proven facts, in sentences.
  // @throws Failure with its line.
  std::string check() {
    return with_line(words_, [&] { return check_statements(); });
  }

  // (17) The points, or the rows of halfspaces, are those of a file, as sets: neither order nor
  // repeats change what they bound. Decimals mean the same in the whole file.
  std::string require_same(const std::string& path) const {
    const std::string bytes = bytes_of_file(path);
    const std::string proven = "proven: the " + std::string(rows_.empty() ? "points" : "rows") +
                               " are those of " + path + ", decimals as ";
    const auto difference = [&](Decimals decimals) {
      return difference_to(parse_mesh_file(bytes, path, decimals));
    };
    const std::string why = difference(Decimals::Nearest);
    if (why.empty()) return proven + "the nearest doubles\n";
    if (difference(Decimals::Spelt).empty()) return proven + "spelt\n";
    throw Failure{1, "not proven: that the proof is about this file: " + why, path};
  }

 private:
  std::string check_statements() {
    read_claim();
    while (words_.take_if("row")) rows_.insert(scaled(words_.halfspace()));
    while (words_.take_if("point")) points_.push_back(words_.point());
    read_planes();
    require_one_cover(read_vertices());
    require_convex();
    read_other_points();
    require_input_rows();
    read_kept();
    if (optimal_) read_tree();
    for (;;) {
      if (words_.take_if("evaluate")) {
        evaluate();
      } else if (words_.take_if("remove")) {
        remove();
      } else {
        break;
      }
    }
    if (optimal_) require_least();
    read_survivors();
    const std::string stored = read_stored();
    words_.end();
    const auto count = [](std::size_t n, const char* what) { return std::to_string(n) + what; };
    return "proven: " + count(planes_.size(), " planes bound exactly the ") +
           (rows_.empty() ? "hull of " : "input halfspaces, with ") +
           count(points_.size(), " points\nproven: each of ") + count(steps_, " removals ") +
           said_of_costs() + "proven: the " +
           count(left_.size(), " planes left are bounded and hold every point\n") + stored;
  }
  std::string said_of_costs() const {
    if (optimal_) {
      return "adds the stated volume\nproven: no other " + std::to_string(left_.size()) +
             " planes" + (kept_ == 0 ? "" : ", " + std::to_string(kept_) + " of them kept,") +
             " bound a smaller volume, by " + std::to_string(states_) + " states and " +
             std::to_string(evaluations_) + " evaluations\n";
    }
    if (measure_ == Measure::None) {
      return "leaves a bounded solid\nnot claimed: what a removal adds, or that it was the "
             "cheapest\n";
    }
    const std::string others =
        kept_ == 0 ? "" : " but for " + std::to_string(kept_) + " planes to be kept";
    return "adds the stated " + name_of_measure() + "\n" + (greedy_ ? "proven" : "not claimed") +
           ": each was the cheapest" + others + ", " + std::to_string(ties_) +
           " of them tied, by " + std::to_string(evaluations_) + " evaluations\n";
  }
  std::string name_of_measure() const { return measure_ == Measure::Volume ? "volume" : "area"; }

  // Version 1 has two of the claims, planes are kept from version 3 on, and version 5 is about an
  // optimum.
  void read_claim() {
    expect(words_.take_if("convexact-proof"), "convexact-proof");
    WordList claims{"greedy", "costs"};
    optimal_ = may_keep_ = words_.take_if("5");
    if (optimal_) {
      claims = {"optimal"};
    } else if (!words_.take_if("1")) {
      may_keep_ = words_.take_if("3");
      expect(may_keep_ || words_.take_if("2"), "version 1, 2, 3 or 5");
      claims.insert(claims.end(), {"greedy-area", "costs-not-shown"});
    }
    const std::string claim = words_.take();
    expect(is_one_of(claim, claims), "a claim");
    greedy_ = claim.starts_with("greedy");
    if (claim == "greedy-area") measure_ = Measure::Area;
    if (claim == "costs-not-shown") measure_ = Measure::None;
  }

  // (1) The interior point is strictly inside each plane. The planes stand in canonical order.
  void read_planes() {
    expect(words_.take_if("interior"), "interior");
    interior_ = words_.point();
    std::array<Integer, 3> previous, direction;
    for (; words_.take_if("plane"); previous = direction) {
      const Row plane = scaled(words_.halfspace());
      require(dot(plane, interior_) < 0, "the interior point is not inside");
      const Integer common = gcd(gcd(plane[0], plane[1]), plane[2]);
      for (int k = 0; k < 3; ++k) direction[k] = plane[k] / common;
      require(planes_.empty() || previous < direction, "the order is not canonical");
      left_.insert(planes_.size());
      queue_.insert({Cost(), planes_.size()});
      planes_.push_back(plane);
    }
    removals_.resize(planes_.size());
  }

  // (2) Planes meet in an input point, by threes whose normals span cones. Each plane has three
  // such points: it bounds a facet.
  std::vector<Triangle> read_vertices() {
    std::vector<Triangle> triangles;
    known_.resize(points_.size(), false);
    std::vector<std::set<Row>> corners(planes_.size());
    while (words_.take_if("triangle")) {
      const Triangle t = triangle();
      const std::size_t p = words_.id(points_.size());
      require_vertex(points_[p], t);
      add(surface_, t, points_[p]);
      triangles.push_back(t);
      for (const std::size_t i : t) corners[i].insert(points_[p]);
      known_[p] = true;
    }
    for (const auto& of_plane : corners) require(of_plane.size() >= 3, "a plane bounds no facet");
    return triangles;
  }
  Triangle triangle() {
    return {words_.id(planes_.size()), words_.id(planes_.size()), words_.id(planes_.size())};
  }
  Row vertex_of(const Triangle& t) const {
    Row vertex = meet(planes_[t[0]], planes_[t[1]], planes_[t[2]]);
    require(vertex[3] > 0, "the normals span no cone");
    return vertex;
  }
  void require_vertex(const Row& point, const Triangle& t) const {
    const Row v = vertex_of(t);
    for (int k = 0; k < 3; ++k) {
      require(point[k] * v[3] == v[k] * point[3], "the planes of the triangle meet elsewhere");
    }
  }

  // (3) There is a surface, and (4) finds it closed. So each direction lies in as many cones as any
  // other: in one, as a direction inside the first cone does.
  void require_one_cover(const std::vector<Triangle>& triangles) const {
    require(!triangles.empty(), "there is no surface");
    Row u{};
    for (const std::size_t i : triangles[0]) {
      for (int k = 0; k < 3; ++k) u[k] += planes_[i][k];
    }
    std::size_t cones = 0;  // that hold u
    for (const Triangle& t : triangles) {
      const Row &a = planes_[t[0]], &b = planes_[t[1]], &c = planes_[t[2]];
      if (det(u, b, c) >= 0 && det(a, u, c) >= 0 && det(a, b, u) >= 0) ++cones;
    }
    require(cones == 1, "cones of normals overlap");
  }

  // (4) No vertex is beyond the plane across an edge.
  void require_convex() const {
    for (const auto& [edge, left] : surface_) {
      const std::size_t across = left_of(surface_, edge.second, edge.first).third;
      require(dot(planes_[across], left.vertex) <= 0, "the surface is not convex");
    }
  }

  // (5) Every other point is a repeat, or lies in a tetrahedron of the interior point and three
  // points that are known to be inside.
  void read_other_points() {
    while (words_.take_if("inside")) {
      const std::size_t p = words_.id(points_.size());
      const Ids by = words_.ids(points_.size());
      for (const std::size_t q : by) require(known_[q], "it rests on a point not yet known inside");
      const bool is_repeat = by.size() == 1 && points_[p] == points_[by[0]];
      require(is_repeat || (by.size() == 3 && is_in_tetrahedron(points_[p], by)),
              "this does not show another point inside");
      require(!known_[p], "this does not show another point inside");
      known_[p] = true;
    }
    for (const bool is_known : known_) require(is_known, "some point is not proven inside");
  }
  bool is_in_tetrahedron(const Row& point, const Ids& q) const {
    const std::array<Row, 4> corners{interior_, points_[q[0]], points_[q[1]], points_[q[2]]};
    for (std::size_t k = 0; k < 4; ++k) {
      const Row face = meet(corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4]);
      const int inner = sgn(dot(face, corners[k]));
      if (inner == 0 || sgn(dot(face, point)) * inner < 0) return false;
    }
    return true;
  }

  // (6) Every input halfspace holds the points, and every plane is one of them.
  void require_input_rows() const {
    for (const Row& row : rows_) require_points_inside(row);
    for (const Row& plane : planes_) {
      require(rows_.empty() || rows_.count(plane) == 1, "a plane is none of the input's");
    }
  }
  void require_points_inside(const Row& plane) const {
    for (const Row& p : points_) require(dot(plane, p) <= 0, "a point of the input is outside");
  }

  // For (12): planes that are not to be removed. They leave the queue, since nothing is compared
  // with their costs, and are never evaluated, so that no removal of theirs can be shown.
  void read_kept() {
    for (; may_keep_ && words_.take_if("keep"); ++kept_) {
      const std::size_t i = words_.id(planes_.size());
      require(!removals_[i].kept, "it is kept already");
      removals_[i].kept = true;
      queue_.erase({Cost(), i});
    }
  }

  // The state that the branches of a tree restore.
  struct State {
    Surface surface;
    std::set<std::size_t> left;
    std::vector<Removal> removals;
    std::set<std::pair<Cost, std::size_t>> queue;
    Rational added;
    std::size_t branch;
  };
  State state(std::size_t branch) const {
    return {surface_, left_, removals_, queue_, added_, branch};
  }
  void restore(State state) {
    surface_ = std::move(state.surface);
    left_ = std::move(state.left);
    removals_ = std::move(state.removals);
    queue_ = std::move(state.queue);
    added_ = std::move(state.added);
  }

  // (18) In each state the choices with one more removal are looked at in a branch, and after that
  // its plane stays, until the rest is shown to add no less. The tree ends in the state where it
  // began.
  void read_tree() {
    expect(words_.take_if("least"), "least");
    wanted_ = words_.id(planes_.size() + 1);
    least_ = words_.rational();
    const State start = state(0);
    std::vector<State> above;
    for (;;) {
      if (words_.take_if("evaluate")) {
        evaluate();
      } else if (words_.take_if("branch")) {
        const std::size_t i = words_.id(planes_.size());
        require(left_.size() > wanted_, "no more removals are to go");
        require(removals_[i].fresh, "it is not evaluated in this state");
        above.push_back(state(i));
        take(i);
      } else {
        expect(words_.take_if("close"), "evaluate, branch or close");
        require_no_less();
        if (above.empty()) break;
        const std::size_t i = above.back().branch;
        restore(std::move(above.back()));
        above.pop_back();
        queue_.erase({removals_[i].cost, i});
        removals_[i].kept = true;
      }
    }
    restore(start);
  }
  // Costs never fall, so the lowest of them give a bound for all choices of the removals to go. If
  // there are fewer planes than removals, there is no choice.
  void require_no_less() {
    ++states_;
    Rational bound = added_;
    std::size_t to_go = left_.size() - wanted_;
    for (const auto& [cost, i] : queue_) {
      if (to_go == 0) break;
      bound += volume_of(i);
      --to_go;
    }
    require(to_go > 0 || bound >= least_, "a choice of removals may add less");
  }
  // The lower bound of its cost.
  Rational volume_of(std::size_t i) const {
    Rational sum = 0;
    for (const auto& [plane, term] : removals_[i].terms) {
      for (const auto& [radicand, factor] : term) sum += factor;
    }
    return sum;
  }
  void take(std::size_t i) {
    if (optimal_) added_ += volume_of(i);
    replace(i, removals_[i]);
  }
  // (19) The removals lead to as many planes as the tree is about, and add the volume that it
  //      states as the least.
  void require_least() const {
    require(left_.size() == wanted_, "another number of planes is left than the tree is about");
    require(added_ == least_, "the removals add another volume than the least");
  }

  // The amount that the removal of i would add in the present state. A plane that is gone has no
  // ring and bounds no ray, so (7) or (8) refuses it.
  void evaluate() {
    const std::size_t i = words_.id(planes_.size());
    Removal& removal = removals_[i];
    require(!removal.kept, "it is kept");
    require(!removal.fresh && !removal.unbounded, "it has been evaluated in this state");
    ++evaluations_;
    queue_.erase({removal.cost, i});
    removal.terms.clear();
    removal.unbounded = words_.take_if("unbounded");
    if (removal.unbounded) return require_ray(i, words_.direction());
    const RootSum stated = read_cost();
    expect(words_.take_if("ring"), "ring");
    removal.ring = words_.ids(planes_.size());
    expect(words_.take_if("triangles"), "triangles");
    removal.triangles.clear();
    while (words_.at_number()) removal.triangles.push_back(triangle());
    require_ring(i, removal.ring);
    const Surface cap = closed_cap(i, removal);
    require_cap_convex(i, removal, cap);
    if (measure_ == Measure::Volume) add_term(removal.terms[i], 1, volume(i, cap));
    if (measure_ == Measure::Area) removal.terms = areas(i, cap);
    update_cost(i);
    require(removal.cost == Cost(stated),
            "the " + name_of_measure() + " of the cap is another one");
    removal.fresh = true;
  }
  // A volume, or an area: factors and radicands of square roots.
  RootSum read_cost() {
    RootSum sum;
    if (measure_ == Measure::Volume) {
      expect(words_.take_if("cost"), "cost or unbounded");
      add_term(sum, 1, words_.rational());
    } else if (measure_ == Measure::Area) {
      expect(words_.take_if("area"), "area or unbounded");
      while (words_.at_number()) {
        const Rational factor = words_.rational(), radicand = words_.rational();
        expect(radicand > 0 && radicand.get_den() == 1, "a radicand, an integer > 0");
        add_term(sum, radicand.get_num(), factor);
      }
    }
    return sum;
  }
  // The cost is the sum of its terms; so is the lower bound once some of them are gone.
  void update_cost(std::size_t i) {
    Removal& removal = removals_[i];
    queue_.erase({removal.cost, i});
    RootSum sum;
    for (const auto& [plane, term] : removal.terms) {
      for (const auto& [radicand, factor] : term) add_term(sum, radicand, factor);
    }
    removal.cost = Cost(sum);
    queue_.insert({removal.cost, i});
  }

  // (7) From any point of the solid the ray meets no plane but i.
  void require_ray(std::size_t i, const Row& ray) const {
    require(ray != Row{}, "the ray has no direction");
    for (const std::size_t j : left_) {
      require(j == i || dot(planes_[j], ray) <= 0, "the ray meets a plane");
    }
  }

  // (8) The ring is the cycle of neighbours of i, counter-clockwise. It has three or more, as no
  // two planes span both (i, a, b) and (i, b, a). A ring that goes around twice fails in (9).
  void require_ring(std::size_t i, const Ids& ring) const {
    const std::size_t k = ring.size();
    for (std::size_t t = 0; t < k; ++t) {
      require(left_of(surface_, i, ring[t]).third == ring[(t + 1) % k], "not the ring");
    }
  }

  // (9) The new triangles, whose normals span cones, and those around i turned round are a closed
  // surface, with the triangles of a sphere.
  Surface closed_cap(std::size_t i, const Removal& removal) const {
    const std::size_t k = removal.ring.size();
    Surface cap;
    for (std::size_t t = 0; t < k; ++t) {
      const Row& corner = left_of(surface_, i, removal.ring[t]).vertex;
      add(cap, {removal.ring[(t + 1) % k], removal.ring[t], i}, corner);
    }
    for (const Triangle& t : removal.triangles) add(cap, t, vertex_of(t));
    for (const auto& [edge, left] : cap) left_of(cap, edge.second, edge.first);
    require(removal.triangles.size() == k - 2, "the triangles do not fill the ring");
    return cap;
  }

  // (10) No new vertex is beyond the plane across an edge, of another new triangle or, on the
  // ring, of the triangle outside.
  void require_cap_convex(std::size_t i, const Removal& removal, const Surface& cap) const {
    for (const Triangle& t : removal.triangles) {
      for (std::size_t e = 0; e < 3; ++e) {
        const std::size_t from = t[e], to = t[(e + 1) % 3];
        std::size_t across = left_of(cap, to, from).third;
        if (across == i) across = left_of(surface_, to, from).third;
        require(dot(planes_[across], left_of(cap, from, to).vertex) <= 0,
                "the triangles are not convex");
      }
    }
  }

  // (11) The sides of the cap in triangles. Around the side in plane r, an edge leads from the
  // vertex left of (s, r) to that left of (r, s). Together with a corner of the side, it forms a
  // triangle. The normal of the plane through it points inward, and is as long as twice the area
  // times w.
  struct SideTriangle {
    std::size_t side;
    Row plane;
    Integer w;
  };
  std::vector<SideTriangle> side_triangles(std::size_t i, const Surface& cap) const {
    std::vector<SideTriangle> triangles;
    for (const auto& [edge, left] : cap) {
      if (edge.first == i || edge.second == i) continue;
      const Row& corner = left_of(cap, edge.first, i).vertex;
      const Row& start = left_of(cap, edge.second, edge.first).vertex;
      const Row& end = left.vertex;
      triangles.push_back(
          {edge.first, meet(corner, start, end), Integer(corner[3] * start[3] * end[3])});
    }
    return triangles;
  }

  // The volume: pyramids from an apex on plane i to the sides.
  Rational volume(std::size_t i, const Surface& cap) const {
    const Row& apex = left_of(surface_, i, removals_[i].ring[0]).vertex;
    std::deque<Rational> terms;
    for (const auto& [side, plane, w] : side_triangles(i, cap)) {
      terms.push_back(quotient(dot(plane, apex), 6 * w * apex[3]));
    }
    // In pairs, since denominators grow with each sum.
    while (terms.size() > 1) {
      terms.push_back(terms[0] + terms[1]);
      terms.erase(terms.begin(), terms.begin() + 2);
    }
    return terms[0];
  }

  // The area: that of each side, less that of its image on plane i, along the normal of i. The
  // images cover the base. With n.n = N, the side in a plane of normal n has the area s sqrt(N).
  std::map<std::size_t, RootSum> areas(std::size_t i, const Surface& cap) const {
    std::map<std::size_t, RootSum> terms;
    const Row& base = planes_[i];
    for (const auto& [side, plane, w] : side_triangles(i, cap)) {
      const Row& n = planes_[side];
      const Rational s = quotient(-dot3(plane, n), 2 * w * dot3(n, n));
      add_term(terms[side], dot3(n, n), s);
      add_term(terms[side], dot3(base, base), -s * quotient(dot3(base, n), dot3(base, base)));
    }
    return terms;
  }

  void remove() {
    const std::size_t i = words_.id(planes_.size());
    require_cheapest(i);
    take(i);
    ++steps_;
  }

  // (12) The removal is evaluated in this state. If it is to be the cheapest, the queue has no
  // lower cost, each entry that is equal is evaluated in this state, and i is the first of them.
  void require_cheapest(std::size_t i) {
    require(removals_[i].fresh, "it is not evaluated in this state");
    Ids tie;
    for (const auto& [cost, j] : queue_) {
      if (!greedy_ || cost != queue_.begin()->first) break;
      require(removals_[j].fresh, "another may be as cheap: it is not evaluated");
      tie.push_back(j);
    }
    require(!greedy_ || tie[0] == i, "it is not the cheapest, or not the first of the tie");
    expect(!greedy_ || words_.take_if("tie"), "tie");
    require(words_.ids(planes_.size()) == tie, "the tie is another one");
    if (tie.size() > 1) ++ties_;
  }

  // (13) The new triangles meet in the stated vertices and take the place of those around i. The
  // costs of its ring are stale now, and those of their terms that name i are gone.
  void replace(std::size_t i, const Removal& removal) {
    const std::size_t k = removal.ring.size();
    for (std::size_t t = 0; t < k; ++t) {
      const std::size_t a = removal.ring[t], b = removal.ring[(t + 1) % k];
      surface_.erase({i, a});
      surface_.erase({a, b});
      surface_.erase({b, i});
      removals_[a].fresh = false;
      if (removals_[a].terms.erase(i) > 0) update_cost(a);
    }
    for (const Triangle& t : removal.triangles) {
      expect(words_.take_if("vertex"), "the vertex of each new triangle");
      const Row vertex = words_.point();
      require_vertex(vertex, t);
      add(surface_, t, vertex);
    }
    queue_.erase({removal.cost, i});
    left_.erase(i);
    removals_[i] = {};
  }

  // (14) The planes that are left. They hold the points since P does; this proves it again, without
  // using a surface.
  void read_survivors() {
    expect(words_.take_if("survive"), "survive");
    require(words_.ids(planes_.size()) == Ids(left_.begin(), left_.end()), "others survive");
    for (const std::size_t i : left_) require_points_inside(planes_[i]);
  }

  // (15) The stored planes hold every point. Positive multiples of their normals cancel, and the
  // normals span space.
  std::string read_stored() {
    if (!words_.take_if("stored")) {
      return "not claimed: anything about stored planes, as the proof has none\n";
    }
    std::vector<Row> stored;
    const std::array<Rational, 3> none;
    std::array<Rational, 3> total = none;
    while (words_.take_if("halfspace")) {
      const Numbers x = words_.halfspace();
      stored.push_back(scaled(x));
      require_points_inside(stored.back());
      const Rational weight = words_.rational();
      require(weight > 0, "a weight that is not positive");
      for (std::size_t k = 0; k < 3; ++k) total[k] += weight * x[k];
    }
    bool spans = false;
    for (const Row& b : stored) {
      for (const Row& c : stored) spans = spans || det(stored[0], b, c) != 0;
    }
    require(spans && total == none && stored.size() == left_.size(),
            "the stored planes are not bounded");
    return "proven: the " + std::to_string(stored.size()) +
           " planes stored are bounded, hold every point and " + reach(stored) + "\n";
  }

  // (16) An upper bound of how far the stored solid reaches beyond the solid of the planes left.
  // Three stored planes stand for each vertex v of the latter and meet in a point w.
  std::string reach(const std::vector<Row>& stored) const {
    std::map<std::size_t, Row> stored_of;
    for (const std::size_t i : left_) stored_of[i] = stored[stored_of.size()];
    Rational farthest = 0;  // |w - v|, squared
    for (const auto& [edge, left] : surface_) {
      const Row w =
          meet(stored_of.at(edge.first), stored_of.at(edge.second), stored_of.at(left.third));
      if (w[3] <= 0) {
        return "differ too much from the planes left for a bound on how far they reach";
      }
      farthest = std::max(farthest, squared_distance(w, left.vertex));
    }
    if (farthest == 0) return "reach nowhere beyond the planes left";
    Numbers low{0, 0, 0, 1}, high{0, 0, 0, 1};  // the box of the points
    for (int k = 0; k < 3; ++k) {
      const auto less = [k](const Row& p, const Row& q) { return p[k] * q[3] < q[k] * p[3]; };
      const auto [first, last] = std::minmax_element(points_.begin(), points_.end(), less);
      low[k] = quotient((*first)[k], (*first)[3]);
      high[k] = quotient((*last)[k], (*last)[3]);
    }
    const Rational share = farthest / squared_distance(scaled(low), scaled(high));
    return "reach at most " + root_from_above(share) +
           " of the points' diameter beyond the planes left";
  }

  // Empty if the file has the same, in any order and any number of times.
  std::string difference_to(const MeshFile& file) const {
    if (file.is_mesh != rows_.empty()) return "it is of another kind";
    std::set<Row> mine, theirs(file.rows.begin(), file.rows.end());
    if (rows_.empty()) mine.insert(points_.begin(), points_.end());
    for (const Row& row : rows_) mine.insert(primitive(row));
    const std::string what = file.is_mesh ? "its point " : "its halfspace ";
    for (std::size_t k = 0; k < file.rows.size(); ++k) {
      if (mine.count(file.rows[k]) == 1) continue;
      return what + std::to_string(k + 1) + " is not in the proof";
    }
    for (const Row& row : mine) {
      if (theirs.count(row) == 1) continue;
      return "the proof has " + row[0].get_str() + " " + row[1].get_str() + " " + row[2].get_str() +
             " " + row[3].get_str() + ", and the file has not";
    }
    return "";
  }

  Words words_;
  bool greedy_ = false, may_keep_ = false, optimal_ = false;
  Measure measure_ = Measure::Volume;
  Row interior_;
  std::set<Row> rows_;
  std::vector<Row> points_, planes_;
  std::vector<bool> known_;  // which points are proven to be inside
  Surface surface_;          // of all planes that are left
  std::set<std::size_t> left_;
  std::vector<Removal> removals_;
  std::set<std::pair<Cost, std::size_t>> queue_;  // by proven lower bound, equal ones by id
  std::size_t steps_ = 0, evaluations_ = 0, ties_ = 0, kept_ = 0;
  // For a tree: the volume that the removals so far add, the least volume, and for how many planes.
  Rational added_, least_;
  std::size_t wanted_ = 0, states_ = 0;
};

}  // namespace check
