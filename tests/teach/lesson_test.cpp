// SPDX-License-Identifier: MIT
// Lessons: the numbers of docs/construction.md, what is left out of large inputs, what is drawn of
// huge and tiny ones, and that a lesson changes nothing of the run that it shows.
#include "teach/lesson.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "expect_error.hpp"
#include "integer_halfspace.hpp"
#include "json_schema.hpp"
#include "lessons.hpp"
#include "shapes/makers.hpp"
#include "simplify/exact_engine.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace lessons;

namespace {

const std::vector<Halfspace> kCutCube = {
    halfspace(-1, 0, 0, 0), halfspace(0, -1, 0, 0), halfspace(0, 0, -1, 0), halfspace(0, 0, 1, -1),
    halfspace(0, 1, 0, -1), halfspace(1, 0, 0, -1), halfspace(2, 2, 2, -5)};

// Its vertices.
std::vector<Point> cut_cube_points() {
  std::vector<Point> points;
  for (int k = 0; k < 7; ++k) points.emplace_back(k & 1, k >> 1 & 1, k >> 2);
  points.insert(points.end(), {{1, 0.5, 1}, {1, 1, 0.5}, {0.5, 1, 1}});
  return points;
}

LessonRequest from_the_middle() {
  LessonRequest request;
  request.center = RationalPoint::Constant(Rational(1, 2));
  return request;
}

// The latest evaluation of a halfspace before the first removal.
const json& first_evaluation(const json& lesson, std::size_t id) {
  for (const json& evaluation : lesson["evaluations"]) {
    if (evaluation["step"] == 0 && evaluation["halfspace"] == id) return evaluation;
  }
  FAIL("no evaluation of " << id);
  return lesson;
}

// Of all numbers that a lesson draws.
void for_each_drawn(const json& value, const std::function<void(double)>& take) {
  if (value.is_number_float()) return take(value.get<double>());
  if (!value.is_structured()) return;
  for (const json& part : value) for_each_drawn(part, take);
}

}  // namespace

TEST_CASE("lesson: the cube without a corner has the numbers of the worked example") {
  for (const Shape& shape : {Shape(PointSet(cut_cube_points())), Shape(kCutCube)}) {
    LessonRequest request = from_the_middle();
    request.measures = {CostMeasure::Area, CostMeasure::MeanWidth, CostMeasure::Volume};
    const json lesson = lesson_of(shape, request);
    CHECK(lesson["measures"] == json{"area", "mean-width"});  // the cost is no other measure
    CHECK(lesson["frame"] ==
          json::parse(R"({"center": ["1/2", "1/2", "1/2"], "scale": ["2", "2", "2"]})"));
    CHECK(lesson["halfspaces"].size() == 7);
    CHECK(lesson["halfspaces"][5]["plane"] == json{"1", "0", "0", "-1"});
    CHECK(lesson["halfspaces"][5]["dual"] == json{"2", "0", "0", "1"});
    CHECK(lesson["halfspaces"][6]["plane"] == json{"2", "2", "2", "-5"});
    CHECK(lesson["halfspaces"][6]["dual"] == json{"1", "1", "1", "1"});
    // In the drawing the side at 1 is x = 1, and the cut is x + y + z = 2.
    CHECK(lesson["halfspaces"][5]["drawn"] == json{1.0, 0.0, 0.0, -1.0});
    CHECK(lesson["halfspaces"][6]["drawn"] == json{1.0, 1.0, 1.0, -2.0});
    CHECK(lesson["topology"]["step"] == 0);
    CHECK(lesson["topology"]["triangles"].size() == 10);
    CHECK(lesson["topology"]["vertices"].size() == 10);
    // Costs: 1/48 for the cut, 25/48 for the sides at 1, none for those at 0.
    for (const std::size_t side : {0, 1, 2}) {
      CHECK(first_evaluation(lesson, side)["cost"].is_null());
      CHECK(lesson["polar"]["costs"][side].is_null());
    }
    for (const std::size_t side : {3, 4, 5}) {
      CHECK(first_evaluation(lesson, side)["cost"]["exact"] == "25/48");
    }
    CHECK(lesson["polar"]["costs"] == lesson["polar"]["other"]["costs"]);
    CHECK(lesson["polar"]["other"]["center"] != lesson["frame"]["center"]);

    REQUIRE(lesson["removals"].size() == 1);
    const json& removal = lesson["removals"][0];
    CHECK(removal["removed"] == 6);
    CHECK(removal["cost"]["exact"] == "1/48");
    CHECK(removal["tie"] == json{6});
    // The three sides of area 1/8 less the base, a regular triangle of side sqrt(1/2).
    CHECK(removal["others"]["area"]["roots"] == json::parse(R"([["3/8", "1"], ["-1/8", "3"]])"));
    CHECK(removal["others"]["mean-width"]["value"].get<double>() ==
          doctest::Approx(0.0262).epsilon(0.002));
    CHECK(removal["ring"] == json{3, 5, 4});
    CHECK(removal["first"] == json{3, 5, 4});
    CHECK(removal["insertions"].empty());
    REQUIRE(removal["triangles"].size() == 1);
    CHECK(removal["triangles"][0] == json::parse(R"({
      "corners": [3, 5, 4], "x": ["1", "1", "1"], "d": "2", "height": "1",
      "vertex": {"exact": ["1", "1", "1"], "at": [1.0, 1.0, 1.0]}})"));
    CHECK(removal["base"][0]["exact"] == json{"1", "1/2", "1"});
    CHECK(removal["base"][1]["exact"] == json{"1", "1", "1/2"});
    CHECK(removal["base"][2]["exact"] == json{"1/2", "1", "1"});
    REQUIRE(removal["tetrahedra"].size() == 1);
    CHECK(removal["tetrahedra"][0]["six"] == "1/8");
    CHECK(removal["cap_volume"] == "1/48");
    CHECK(lesson["topology"]["volume"] == "47/48");
    CHECK(removal["volume_after"] == "1");
    CHECK(lesson["stop"] == "all-unbounded");
    CHECK(lesson["end"]["present"] == json{0, 1, 2, 3, 4, 5});
    CHECK(lesson["storing"]["naive_outside"] == 0);
    CHECK(lesson["storing"]["push"] == 0.0);
    CHECK_FALSE(lesson.contains("failed"));
    CHECK_FALSE(lesson.contains("center"));
  }
}

TEST_CASE("lesson: the icosahedron ties by its symmetries") {
  // Rotations of the axes and mirror images map the twenty faces onto each other in two orbits: the
  // eight that face an octant evenly, and twelve others. Doubles keep these symmetries.
  const json lesson = lesson_of(Shape(PointSet(shapes::icosahedron())), {});
  REQUIRE(lesson["halfspaces"].size() == 20);
  std::set<std::string> costs;
  for (std::size_t i = 0; i < 20; ++i) {
    costs.insert(first_evaluation(lesson, i)["cost"]["exact"].get<std::string>());
  }
  CHECK(costs.size() <= 2);
  const std::size_t tied = lesson["removals"][0]["tie"].size();
  const bool is_an_orbit = tied == 8 || tied == 12 || tied == 20;
  CHECK(is_an_orbit);
  CHECK(lesson["removals"][0].contains("tie_proof"));
}

TEST_CASE("lesson: the run is that of the engine without a lesson" * sweep) {
  const std::vector<std::vector<Point>> inputs = {shapes::icosahedron(), shapes::in_ball(80, 3),
                                                  shapes::grid(3), shapes::cut_cube(5, 0.25)};
  for (const std::vector<Point>& input : inputs) {
    for (const CostMeasure measure :
         {CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth}) {
      LessonRequest request;
      request.seed = 5;
      request.cost = measure;
      const json lesson = lesson_of(Shape(PointSet(input)), request);
      const DualHull dual = dual_of_points(input, request.seed);
      SimplifyOptions options{.cost = measure, .seed = request.seed, .keep_evaluations = true};
      const Run run = simplify_exact(dual, point_in(lesson["frame"]["center"]), options);
      REQUIRE(lesson["removals"].size() == run.steps.size());
      for (std::size_t s = 0; s < run.steps.size(); ++s) {
        const json& removal = lesson["removals"][s];
        CHECK(removal["removed"] == run.steps[s].removed.index());
        CHECK(removal["left"] == run.steps[s].left);
        CHECK(ids_in(removal["ring"]) == run.steps[s].ring);
        CHECK(ids_in(removal["tie"]) == run.steps[s].tie);
        CHECK(removal["triangles"].size() == run.steps[s].triangles.size());
        for (std::size_t t = 0; t < run.steps[s].triangles.size(); ++t) {
          const auto& triangle = run.steps[s].triangles[t];
          CHECK(ids_in(removal["triangles"][t]["corners"]) ==
                std::vector<HalfspaceId>(triangle.begin(), triangle.end()));
        }
      }
      REQUIRE(lesson["evaluations"].size() == run.evaluations.size());
      for (std::size_t e = 0; e < run.evaluations.size(); ++e) {
        const json& evaluation = lesson["evaluations"][e];
        CHECK(evaluation["step"] == run.evaluations[e].step);
        CHECK(evaluation["halfspace"] == run.evaluations[e].halfspace.index());
        CHECK(ids_in(evaluation["ring"]) == run.evaluations[e].ring);
      }
      CHECK(ids_in(lesson["end"]["present"]) == survivors(run));
    }
  }
}

TEST_CASE("lesson: redundant rows of halfspaces are named as the file counts them") {
  SceneObject object = object_of(Shape(kCutCube));
  auto& rows = std::get<std::vector<Halfspace>>(object.shape);
  rows.insert(rows.begin(), halfspace(1, 1, 1, -3));  // touches the cube's corner, which is cut off
  object.rows = {{2, 3, 4, 5, 6, 7, 8, 9}, std::vector<Rational>(8, Rational(1))};
  const auto outcome = make_lesson(object, {});
  const json lesson = json::parse(write_json(std::get<Lesson>(outcome).document));
  CHECK(lesson["input"]["redundant"] == json{2});
  CHECK(lesson["hull"]["rows"].size() == 7);  // of one direction only the tightest
  CHECK(lesson["halfspaces"].size() == 7);
}

TEST_CASE("lesson: inputs without a volume are no lesson") {
  const auto flat = make_lesson(object_of(Shape(PointSet(shapes::coplanar(9, 1)))), {});
  CHECK(std::holds_alternative<NotSolid>(flat));
  const std::vector<Halfspace> open = {halfspace(1, 0, 0, -1), halfspace(-1, 0, 0, -1)};
  CHECK(std::holds_alternative<NotSolid>(make_lesson(object_of(Shape(open)), {})));
}

TEST_CASE("lesson: a center that is not inside is refused") {
  LessonRequest request;
  request.center = RationalPoint::Constant(Rational(2));
  const Error error = error_of([&] { return make_lesson(object_of(Shape(kCutCube)), request); });
  CHECK(error.code() == ErrorCode::InvalidArgument);
}

TEST_CASE("lesson: of large inputs parts are left out, and why" * sweep) {
  const auto missing = [](const json& lesson) {
    std::set<std::string> chapters;
    for (const json& part : lesson["left_out"]) chapters.insert(part["chapter"].get<std::string>());
    return chapters;
  };
  // 240 facets and more than 60: local verification, and the first removals are not shown.
  const std::vector<Point> sphere = shapes::on_sphere(130, 1);
  LessonRequest request;
  request.faces = 190;
  json lesson = lesson_of(Shape(PointSet(sphere)), request);
  const std::size_t count = lesson["halfspaces"].size();
  REQUIRE(count > kMostLessonHalfspaces);
  CHECK(missing(lesson) == std::set<std::string>{"polar", "removal", "verification"});
  CHECK(lesson["topology"]["step"] == count - kMostLessonHalfspaces);
  CHECK(lesson["topology"]["present"].size() == kMostLessonHalfspaces);
  CHECK(lesson["removals"].size() == 10);
  CHECK(lesson["removals"][0]["step"] == count - kMostLessonHalfspaces + 1);
  // First the latest evaluation of each halfspace that is present.
  for (std::size_t e = 0; e < kMostLessonHalfspaces; ++e) {
    CHECK(lesson["evaluations"][e]["halfspace"] == lesson["topology"]["present"][e]);
    CHECK(lesson["evaluations"][e]["step"] <= lesson["topology"]["step"]);
  }
  CHECK(lesson["end"]["present"].size() == 190);
  // A run that ends before: nothing is shown of it.
  request.faces = 220;
  lesson = lesson_of(Shape(PointSet(sphere)), request);
  CHECK(missing(lesson) ==
        std::set<std::string>{"polar", "removal", "topology", "verification", "storing"});
  CHECK_FALSE(lesson.contains("removals"));
  CHECK(lesson["end"]["present"].size() == 220);
  // Many points, and many insertions.
  std::vector<Point> many = shapes::in_box(3001, 2);
  lesson = lesson_of(Shape(PointSet(many)), {});
  CHECK(missing(lesson).count("hull") == 1);
  CHECK_FALSE(lesson["input"].contains("points"));
  lesson = lesson_of(Shape(PointSet(shapes::on_sphere(320, 4))), {});
  CHECK(missing(lesson).count("hull") == 1);
}

TEST_CASE("lesson: huge, tiny and long solids are drawn in about [-1, 1]") {
  for (const double size : {1e300, 1.0, 1e-300, 4.94e-324 * 1024}) {
    std::vector<Point> points = shapes::cube();
    for (Point& p : points) p *= size;
    points.push_back(Point(0.5, 0.5, 0.5) * size);
    const json lesson = lesson_of(Shape(PointSet(points)), {});
    double farthest = 0;
    for (const json& point : lesson["input"]["points"]) {
      for_each_drawn(point["at"], [&](double x) { farthest = std::max(farthest, std::abs(x)); });
    }
    CHECK(farthest <= 1);
    CHECK(farthest > 0.5);
    for_each_drawn(lesson, [](double x) { CHECK(std::isfinite(x)); });
    // binary32 holds neither the huge one nor the tiny ones, and that is said.
    CHECK(lesson.contains("storing") == (size == 1.0));
  }
  // Each axis for itself if one is more than sixteen times as long as another.
  for (const double length : {16.0, 17.0}) {
    const json lesson = lesson_of(Shape(PointSet(shapes::box({length, 1, 1}))), {});
    const json& scale = lesson["frame"]["scale"];
    CHECK((scale[0] == scale[1]) == (length == 16.0));
    CHECK(scale[1] == scale[2]);
  }
}
