// SPDX-License-Identifier: MIT
// Each chapter of a lesson against the definition of what it tells: points that wait beyond a
// triangle or are proven inside, optima of linear programs, caps, roundings; and a step that fails.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "convexact/error.hpp"
#include "definitional_greedy.hpp"
#include "integer_halfspace.hpp"
#include "lessons.hpp"
#include "shapes/makers.hpp"
#include "teach/chapters.hpp"

using namespace convexact;
using namespace lessons;

namespace {

using Corners = std::array<std::size_t, 3>;

// Lowest corner first.
Corners turned(Corners t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

Corners corners_in(const json& t, std::size_t first = 0) {
  return {t[first].get<std::size_t>(), t[first + 1].get<std::size_t>(),
          t[first + 2].get<std::size_t>()};
}

Rational determinant(const RationalVector3& a, const RationalVector3& b, const RationalVector3& c) {
  const RationalVector3 cross = a.cross(b);
  return cross.dot(c);
}

// Replays the chapter about the hull and judges each insertion by the definition.
class HullReplay {
 public:
  HullReplay(const json& hull, std::vector<RationalPoint> points) : points_(std::move(points)) {
    center_ = RationalPoint::Zero();
    std::set<std::size_t> simplex;
    for (const json& t : hull["triangles"]) {
      REQUIRE(surface_.insert(turned(corners_in(t))).second);
      for (const json& corner : t) simplex.insert(corner.get<std::size_t>());
    }
    REQUIRE(simplex.size() == 4);
    for (const std::size_t p : simplex) center_ += points_[p] / Rational(4);
    file(hull["conflicts"]);
    give_up(hull["inside"]);
    check_all_points();
    for (const json& insertion : hull["insertions"]) replay(insertion);
    CHECK(waiting_.empty());
    check_facets(hull["facets"]);
  }

  const std::set<Corners>& surface() const { return surface_; }

 private:
  // Positive: strictly beyond the triangle, seen from the center.
  Rational height(const Corners& t, std::size_t p) const {
    const RationalPoint& a = points_[t[0]];
    return determinant(points_[t[1]] - a, points_[t[2]] - a, points_[p] - a);
  }

  void file(const json& list) {
    for (const json& entry : list) {
      const std::size_t p = entry[0].get<std::size_t>();
      const Corners t = turned(corners_in(entry, 1));
      CHECK(surface_.count(t) == 1);
      CHECK(height(t, p) > 0);
      CHECK(waiting_.emplace(p, t).second);
    }
  }

  // In the closed tetrahedron of the center and the triangle.
  void give_up(const json& list) {
    for (const json& entry : list) {
      const std::size_t p = entry[0].get<std::size_t>();
      const Corners t = corners_in(entry, 1);
      CHECK(inside_.insert(p).second);
      if (t[0] == t[1]) {
        CHECK(points_[p] == points_[t[0]]);
        continue;
      }
      CHECK(height(t, p) <= 0);
      for (int k = 0; k < 3; ++k) {
        CHECK(determinant(points_[t[k]] - center_, points_[t[(k + 1) % 3]] - center_,
                          points_[p] - center_) >= 0);
      }
    }
  }

  void replay(const json& insertion) {
    const std::size_t apex = insertion["point"].get<std::size_t>();
    std::set<Corners> visible;
    for (const json& t : insertion["visible"]) visible.insert(turned(corners_in(t)));
    for (const Corners& t : surface_) CHECK((height(t, apex) > 0) == (visible.count(t) == 1));
    REQUIRE(waiting_.count(apex) == 1);
    CHECK(visible.count(waiting_.at(apex)) == 1);
    waiting_.erase(apex);
    // Who waited at a triangle that goes must be told of anew.
    std::erase_if(waiting_, [&](const auto& entry) { return visible.count(entry.second) == 1; });
    for (const Corners& t : visible) CHECK(surface_.erase(t) == 1);
    for (const json& t : insertion["added"]) CHECK(surface_.insert(turned(corners_in(t))).second);
    const json& horizon = insertion["horizon"];
    CHECK(insertion["added"].size() == horizon.size());
    file(insertion["conflicts"]);
    give_up(insertion["inside"]);
    check_all_points();
  }

  // Each point is a corner of the surface, waits, or was given up: one of the three.
  void check_all_points() const {
    std::set<std::size_t> corners;
    for (const Corners& t : surface_) corners.insert(t.begin(), t.end());
    for (std::size_t p = 0; p < points_.size(); ++p) {
      CHECK(corners.count(p) + waiting_.count(p) + inside_.count(p) == 1);
    }
    CHECK(surface_.size() == 2 * corners.size() - 4);  // Euler
  }

  // The surface is the hull, and each of its triangles lies in a facet.
  void check_facets(const json& facets) const {
    for (const Corners& t : surface_) {
      for (std::size_t p = 0; p < points_.size(); ++p) CHECK(height(t, p) <= 0);
      CHECK(std::any_of(facets.begin(), facets.end(), [&](const json& facet) {
        return std::all_of(t.begin(), t.end(), [&](std::size_t corner) {
          return height(corners_in(facet), corner) == 0;
        });
      }));
    }
  }

  std::vector<RationalPoint> points_;
  RationalPoint center_;
  std::set<Corners> surface_;
  std::map<std::size_t, Corners> waiting_;
  std::set<std::size_t> inside_;
};

std::vector<RationalPoint> points_of(const json& lesson) {
  std::vector<RationalPoint> points;
  if (lesson["hull"]["of"] == "points") {
    for (const json& point : lesson["input"]["points"]) points.push_back(point_in(point["exact"]));
  } else {
    for (const json& row : lesson["hull"]["rows"]) {
      points.push_back(point_in(row["dual"]) / number_in(row["dual"][3]));
    }
  }
  return points;
}

// a + b M for a symbol M above every number, as (b, a).
using Value = std::pair<Rational, Rational>;

// The rows of the program, and one optimum after another.
void check_center(const json& lesson) {
  const json& center = lesson["center"];
  const std::size_t count = lesson["halfspaces"].size();
  const auto value = [&](const json& row, const json& point) -> Value {
    if (row == "t>=0") {
      return {Rational(-number_in(point["direction"][3])), Rational(-number_in(point["x"][3]))};
    }
    const std::size_t i = row.get<std::size_t>();
    const json& plane = lesson["halfspaces"][i]["plane"];
    const Rational norm = number_in(center["norms"][i]);
    Value sum{norm * number_in(point["direction"][3]),
              number_in(plane[3]) + norm * number_in(point["x"][3])};
    for (int k = 0; k < 3; ++k) {
      sum.first += number_in(plane[k]) * number_in(point["direction"][k]);
      sum.second += number_in(plane[k]) * number_in(point["x"][k]);
    }
    return sum;
  };
  const Value zero(0, 0);
  json optimum = center["start"];
  std::vector<json> rows;
  for (const json& insertion : center["insertions"]) {
    rows.push_back(insertion["row"]);
    CHECK(insertion["moved"] == (value(rows.back(), optimum) > zero));
    if (!insertion["moved"].get<bool>()) continue;
    optimum = insertion;
    for (const json& row : rows) {
      CHECK(value(row, optimum) <= zero);
      const json& tight = optimum["tight"];
      const bool is_named = std::find(tight.begin(), tight.end(), row) != tight.end();
      CHECK(is_named == (value(row, optimum) == zero));
    }
  }
  CHECK(rows.size() == count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const RationalPoint n = point_in(lesson["halfspaces"][i]["plane"]);
    const Rational norm = number_in(center["norms"][i]);
    CHECK(norm * norm >= n.dot(n));
  }
  CHECK(number_in(optimum["x"][3]) == number_in(center["optimum_radius"]));
  for (int k = 0; k < 3; ++k) CHECK(optimum["x"][k] == center["optimum"][k]);
}

// Caps from the halfspaces alone.
void check_removals(const json& lesson) {
  std::vector<Halfspace> planes;
  for (const json& h : lesson["halfspaces"]) {
    planes.emplace_back(point_in(h["plane"]), number_in(h["plane"][3]));
  }
  const RationalPoint center = point_in(lesson["frame"]["center"]);
  std::string volume = lesson["topology"]["volume"];
  for (const json& removal : lesson["removals"]) {
    const std::size_t removed = removal["removed"].get<std::size_t>();
    std::vector<RationalPoint> corners;
    for (std::size_t t = 0; t < removal["ring"].size(); ++t) {
      corners.push_back(point_in(removal["base"][t]["exact"]));
      const std::size_t a = removal["ring"][t].get<std::size_t>(),
                        b = removal["ring"][(t + 1) % removal["ring"].size()].get<std::size_t>();
      CHECK(corners.back() == meet(planes[removed], planes[a], planes[b]));
    }
    // Chew's insertions lead from the first triangle to T_i.
    std::set<Corners> roof = {turned(corners_in(removal["first"]))};
    for (const json& insertion : removal["insertions"]) {
      for (const json& t : insertion["lost"]) CHECK(roof.erase(turned(corners_in(t))) == 1);
      for (const json& t : insertion["gained"]) {
        CHECK(std::find(t.begin(), t.end(), insertion["corner"]) != t.end());
        CHECK(roof.insert(turned(corners_in(t))).second);
      }
    }
    CHECK(roof.size() == removal["triangles"].size());
    for (const json& t : removal["triangles"]) {
      CHECK(roof.count(turned(corners_in(t["corners"]))) == 1);
      const Corners ids = corners_in(t["corners"]);
      corners.push_back(point_in(t["vertex"]["exact"]));
      CHECK(corners.back() == meet(planes[ids[0]], planes[ids[1]], planes[ids[2]]));
      const json& n = lesson["halfspaces"][removed]["dual"];
      const Rational height =
          point_in(t["x"]).dot(point_in(n)) - number_in(t["d"]) * number_in(n[3]);
      CHECK(number_in(t["height"]) == height);
      CHECK(RationalPoint(center + point_in(t["x"]) / number_in(t["d"])) == corners.back());
    }
    Rational six = 0;
    for (const json& t : removal["tetrahedra"]) {
      const Corners c = corners_in(t["corners"]);
      CHECK(number_in(t["six"]) == determinant(corners[c[0]] - corners[0],
                                               corners[c[1]] - corners[0],
                                               corners[c[2]] - corners[0]));
      six += number_in(t["six"]);
    }
    CHECK(number_in(removal["cap_volume"]) == six / 6);
    if (lesson["cost"] == "volume") CHECK(removal["cost"]["exact"] == removal["cap_volume"]);
    CHECK(number_in(removal["volume_after"]) - number_in(volume) == six / 6);
    volume = removal["volume_after"];
    CHECK(std::all_of(removal["checks"].begin(), removal["checks"].end(), [](const json& check) {
      if (check["value"].is_null()) return check["holds"] == true;
      const Rational value = number_in(check["value"]);
      const std::string wants = check["wants"];
      return wants == ">0" ? value > 0 : wants == ">=0" ? value >= 0 : value <= 0;
    }));
  }
}

void check_storing(const json& lesson, const std::vector<RationalPoint>& points) {
  const json& storing = lesson["storing"];
  const bool is_single = storing["precision"] == "binary32";
  const auto nearest = [&](const Rational& x) {
    const Precision precision = is_single ? Precision::Binary32 : Precision::Binary64;
    return to_rational(round_to(precision, x, Rounding::Nearest));
  };
  std::set<std::size_t> outside;
  for (const json& plane : storing["planes"]) {
    const json& exact = lesson["halfspaces"][plane["halfspace"].get<std::size_t>()]["plane"];
    const RationalVector3 normal = point_in(plane["normal"]), scaled = point_in(plane["scaled"]);
    RationalVector3 naive_normal;
    for (int k = 0; k < 3; ++k) {
      naive_normal[k] = nearest(scaled[k]);
      CHECK(scaled[k] * number_in(exact[3]) == number_in(exact[k]) * number_in(plane["scaled"][3]));
    }
    CHECK(plane["turned"] == (normal != naive_normal));
    const Rational naive = number_in(plane["naive"]), stored = number_in(plane["stored"]);
    CHECK(naive == nearest(number_in(plane["scaled"][3])));
    Rational support = normal.dot(points[0]);
    for (std::size_t p = 0; p < points.size(); ++p) {
      support = std::max(support, Rational(normal.dot(points[p])));
      if (naive_normal.dot(points[p]) + naive > 0) outside.insert(p);
    }
    CHECK(number_in(plane["support"]) == support);
    CHECK(normal.dot(point_in(plane["witness"])) == support);
    CHECK(number_in(plane["cut"]) == std::max(Rational(0), Rational(support + naive)));
    // The largest number of the format that keeps the witness inside.
    CHECK(support + stored <= 0);
    const Rational next = stored + number_in(plane["ulp"]);
    CHECK(support + next > 0);
    CHECK(nearest(next) == next);
    CHECK(nearest(stored) == stored);
  }
  CHECK(storing["naive_outside"] == outside.size());
}

}  // namespace

TEST_CASE("lesson: points wait beyond their triangle or are proven inside, at any time") {
  const std::vector<std::vector<Point>> inputs = {
      shapes::in_ball(30, 1), shapes::grid(3), shapes::lattice(30, 2, 5),
      shapes::repeated_sphere(8, 3, 1), shapes::tetrahedron()};
  for (const std::vector<Point>& input : inputs) {
    const json lesson = lesson_of(Shape(PointSet(input)), {});
    const HullReplay replay(lesson["hull"], points_of(lesson));
    // Facet k is halfspace k.
    REQUIRE(lesson["hull"]["facets"].size() == lesson["halfspaces"].size());
    for (std::size_t f = 0; f < lesson["halfspaces"].size(); ++f) {
      const json& plane = lesson["halfspaces"][f]["plane"];
      for (const json& corner : lesson["hull"]["facets"][f]) {
        const RationalPoint p =
            point_in(lesson["input"]["points"][corner.get<std::size_t>()]["exact"]);
        CHECK(point_in(plane).dot(p) + number_in(plane[3]) == 0);
      }
    }
  }
}

TEST_CASE("lesson: the hull of dual points") {
  for (const std::uint64_t seed : {1, 2}) {
    std::vector<Halfspace> halfspaces = dual_of_points(shapes::in_ball(20, seed), 1).halfspaces;
    halfspaces.push_back(halfspace(1, 0, 0, -9));  // redundant
    LessonRequest request;
    request.seed = seed;
    const json lesson = lesson_of(Shape(halfspaces), request);
    CHECK(lesson["input"]["redundant"] == json::array({halfspaces.size() - 1}));
    CHECK(lesson["hull"]["rows"].size() == halfspaces.size());
    const HullReplay replay(lesson["hull"], points_of(lesson));
  }
}

TEST_CASE("lesson: the linear program of the center, row by row") {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    LessonRequest request;
    request.seed = seed;
    check_center(lesson_of(Shape(PointSet(shapes::cut_cube(3, 0.25))), request));
    check_center(lesson_of(Shape(PointSet(shapes::in_ball(20, seed))), request));
  }
  // Of many rows those that do not move the optimum are counted.
  const json lesson = lesson_of(Shape(PointSet(shapes::on_sphere(60, 1))), {.faces = 100});
  std::size_t rows = 0;
  for (const json& insertion : lesson["center"]["insertions"]) {
    rows += insertion.contains("unmoved") ? insertion["unmoved"].get<std::size_t>() : 1;
  }
  CHECK(rows == lesson["halfspaces"].size() + 1);
}

TEST_CASE("lesson: rings, caps and volumes") {
  for (const CostMeasure measure : {CostMeasure::Volume, CostMeasure::Area}) {
    check_removals(lesson_of(Shape(PointSet(shapes::in_ball(16, 2))), {.cost = measure}));
    check_removals(lesson_of(Shape(PointSet(shapes::cut_cube(4, 0.25))), {.cost = measure}));
    check_removals(lesson_of(Shape(PointSet(shapes::icosahedron())), {.cost = measure}));
  }
}

TEST_CASE("lesson: the evaluations are those by the definition") {
  const json lesson = lesson_of(Shape(PointSet(shapes::cut_cube(3, 0.25))), {});
  std::vector<Halfspace> planes;
  for (const json& h : lesson["halfspaces"]) {
    planes.emplace_back(point_in(h["plane"]), number_in(h["plane"][3]));
  }
  const definition::HalfspaceArrangement arrangement(planes);
  const std::uint32_t all = (1u << planes.size()) - 1;
  const Rational volume = arrangement.volume(all).value();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto without = arrangement.volume(all & ~(1u << i));
    const json& cost = lesson["polar"]["costs"][i];
    CHECK(cost.is_null() == !without.has_value());
    if (without) CHECK(number_in(cost["exact"]) == *without - volume);
  }
}

TEST_CASE("lesson: planes are stored as the definition of each number says") {
  for (const Precision precision : {Precision::Binary32, Precision::Binary64}) {
    for (const std::vector<Point>& input : {shapes::in_ball(20, 3), shapes::icosahedron()}) {
      const json lesson = lesson_of(Shape(PointSet(input)), {.faces = 8, .precision = precision});
      std::vector<RationalPoint> points;
      for (const Point& p : input) points.push_back(to_rational(p));
      check_storing(lesson, points);
    }
  }
}

TEST_CASE("lesson: a step that fails its verification is shown, with the check") {
  const DualHull dual = dual_of_points(shapes::in_ball(16, 2), 1);
  const LessonRequest request;
  const RationalPoint center = [&] {
    RationalPoint sum = RationalPoint::Zero();
    for (const RationalPoint& v : dual.vertices) sum += v / Rational(dual.vertices.size());
    return sum;
  }();
  const Run run = simplify_exact(dual, center);
  REQUIRE(run.steps.size() >= 2);
  const LessonFrame frame(dual.vertices, center);
  RemovalRecorder recorder(dual, frame, request);
  StepVerification verification(dual, VerifyLevel::Full, 1, CostMeasure::Volume, &recorder);
  DualSurface surface(dual.halfspaces, dual.triangles, center);
  const auto evaluate_all = [&](std::size_t step) {
    for (std::size_t i = 0; i < dual.halfspaces.size(); ++i) {
      if (surface.has(HalfspaceId(i))) {
        recorder.evaluated(step, surface.removal_of(HalfspaceId(i), &recorder));
      }
    }
  };
  evaluate_all(0);
  recorder.chosen(run.steps[0]);
  verification.check(run.steps[0]);
  surface.apply(surface.removal_of(run.steps[0].removed));
  evaluate_all(1);
  Step wrong = run.steps[1];
  wrong.cost = Cost(Rational(wrong.cost->rational() + 1));
  recorder.chosen(wrong);
  CHECK_THROWS_AS(verification.check(wrong), Error);
  recorder.finish();
  CHECK(recorder.failed()["step"] == 2);
  CHECK(recorder.failed()["check"] == "the volume grew by the cost, modulo two primes");
  REQUIRE(recorder.removals.size() == 2);
  CHECK(recorder.removals[0]["checks"].back()["holds"] == true);
  CHECK(recorder.removals[1]["checks"].back()["holds"] == false);
  recorder.finish("the verification refused it");  // the check says more
  CHECK(recorder.failed()["step"] == 2);
  // The step was not made.
  CHECK(recorder.steps() == 1);
  CHECK(recorder.present().size() == dual.halfspaces.size() - 1);
}

TEST_CASE("lesson: an engine that gives up between steps is shown so far") {
  const DualHull dual = dual_of_points(shapes::in_ball(16, 2), 1);
  const LessonRequest request;
  const LessonFrame frame(dual.vertices, RationalPoint::Zero());
  RemovalRecorder recorder(dual, frame, request);
  recorder.finish("a dual point is lost");
  CHECK(recorder.failed()["step"].is_null());
  CHECK(recorder.failed()["check"] == "a dual point is lost");
  CHECK(recorder.topology["present"].size() == dual.halfspaces.size());
}

TEST_CASE("observers of a run change nothing") {
  const DualHull dual = dual_of_points(shapes::in_ball(30, 7), 1);
  const RationalPoint center = RationalPoint::Zero();
  for (const VerifyLevel level : {VerifyLevel::None, VerifyLevel::Local, VerifyLevel::Full}) {
    SimplifyOptions options;
    options.verify = level;
    options.keep_evaluations = true;
    const LessonFrame frame(dual.vertices, center);
    const LessonRequest request;
    RemovalRecorder recorder(dual, frame, request);
    const Run alone = simplify_exact(dual, center, options);
    const Run seen = simplify_exact(dual, center, options, &recorder);
    REQUIRE(alone.steps.size() == seen.steps.size());
    for (std::size_t s = 0; s < alone.steps.size(); ++s) {
      CHECK(alone.steps[s].removed == seen.steps[s].removed);
      CHECK(alone.steps[s].cost == seen.steps[s].cost);
      CHECK(alone.steps[s].ring == seen.steps[s].ring);
      CHECK(alone.steps[s].triangles == seen.steps[s].triangles);
    }
    CHECK(alone.triangles == seen.triangles);
    REQUIRE(alone.evaluations.size() == seen.evaluations.size());
    for (std::size_t e = 0; e < alone.evaluations.size(); ++e) {
      CHECK(alone.evaluations[e].triangles == seen.evaluations[e].triangles);
    }
  }
}
