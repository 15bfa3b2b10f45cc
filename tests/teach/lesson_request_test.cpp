// SPDX-License-Identifier: MIT
// Requests for lessons, on a cube.
#include "teach/lesson_request.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "teach/lesson.hpp"
#include "teach/lesson_page.hpp"
#include "teach/plane_lesson.hpp"

using namespace convexact;
using nlohmann::json;

namespace {

json cube() {
  json points = json::array();
  for (int k = 0; k < 8; ++k) points.push_back({k & 1, k >> 1 & 1, k >> 2});
  return {{"points", points}, {"name", "<cube>"}, {"faces", 6}};
}

json answered(json request, const json& options) {
  request.update(options);
  return json::parse(answer_lesson_request(request.dump()));
}

}  // namespace

TEST_CASE("lesson request: the page is that of the same lesson, and the id comes back") {
  std::vector<Point> points;
  for (int k = 0; k < 8; ++k) points.emplace_back(k & 1, k >> 1 & 1, k >> 2);
  const SceneObject object{
      .name = "<cube>", .part = "<cube>", .shape = PointSet(points), .polygons = {}};
  const auto lesson = std::get<Lesson>(make_lesson(object, {.faces = 6}));
  const json answer = answered(cube(), {{"id", 3}});
  CHECK(answer["id"] == 3);
  CHECK(answer["page"] == lesson_page("<cube>", lesson.document));
  CHECK(answer["left_out"].empty());
  CHECK(answer["page"].get<std::string>().find("&lt;cube&gt;") != std::string::npos);
}

TEST_CASE("lesson request: a chapter that is left out has its reason") {
  const json answer = answered(cube(), {{"center", "1/2,1/2,1/3"}});
  CHECK(answer["left_out"][0]["chapter"] == "center");
}

TEST_CASE(
    "lesson request: in the plane, points have the lesson on halfplanes, a face that on parts") {
  const json triangle = {{"points", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {"plane", true}};
  const std::vector<Point> points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)};
  SceneObject object{.name = "input", .part = "input", .shape = PointSet(points), .polygons = {}};
  CHECK(answered(triangle, json::object())["page"] == plane_lesson_page(object));
  object.polygons = {{0, 1, 2}};
  const json answer = answered(triangle, {{"triangles", {{0, 1, 2}}}, {"id", 4}});
  CHECK(answer["page"] == plane_lesson_page(object));
  CHECK(answer["id"] == 4);
  CHECK(answer["left_out"].empty());
  const json with_faces = answered(triangle, {{"faces", 4}});
  CHECK(with_faces["error"]["message"] ==
        "expected only known keys in a request for a lesson in the plane, found 'faces'");
}

TEST_CASE("lesson request: faults name what was expected") {
  const auto message = [](const json& options) {
    return answered(cube(), options).at("error").at("message").get<std::string>();
  };
  CHECK(message({{"picture", true}}) == "expected only known keys in the request, found 'picture'");
  CHECK(message({{"measures", {"width"}}})
            .starts_with("expected measures out of volume, area and mean-width"));
  CHECK(message({{"precision", 16}}) == "expected precision as 64 or 32");
  CHECK(message({{"center", "5,5,5"}}).find("center") != std::string::npos);
  const json flat = answered({{"points", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}, json::object());
  CHECK(flat["error"]["code"] == "no-interior");
}
