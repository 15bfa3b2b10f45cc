// SPDX-License-Identifier: MIT
#include "teach/lesson_request.hpp"

#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"
#include "scene/time_limit.hpp"
#include "simplify/run_names.hpp"
#include "teach/lesson.hpp"
#include "teach/lesson_page.hpp"
#include "teach/plane_lesson.hpp"
#include "wire/request_line.hpp"
#include "wire/simplify_options.hpp"
#include "wire/solid_request.hpp"

namespace convexact {
namespace {

using nlohmann::json;

std::vector<CostMeasure> measures_in(const json& request) {
  std::vector<CostMeasure> measures;
  const auto is_known = [](const std::string& name) {
    return value_in(kCostMeasureNames, name).has_value();
  };
  for (const std::string& name :
       texts_in(request, "measures", "measures out of volume, area and mean-width", is_known)) {
    measures.push_back(*value_in(kCostMeasureNames, name));
  }
  return measures;
}

LessonRequest lesson_request_of(const json& request) {
  require_known_keys(
      request,
      {"id", "name", "points", "planes", "triangles", "decimal", "numbers", "time_limit", "seed",
       "faces", "cost", "measures", "center", "precision", "plane"},
      "the request");
  LessonRequest wanted;
  wanted.faces = count_in(request, "faces").value_or(wanted.faces);
  wanted.cost = choice_in(request, "cost", kCostMeasureNames).value_or(wanted.cost);
  wanted.measures = measures_in(request);
  if (request.contains("center")) {
    wanted.center = parse_center("center", std::string(number_text(request["center"])));
  }
  const std::size_t bits = count_in(request, "precision").value_or(32);
  if (bits != 64 && bits != 32) reject_request("precision as 64 or 32");
  wanted.precision = bits == 64 ? Precision::Binary64 : Precision::Binary32;
  wanted.seed = count_in(request, "seed").value_or(wanted.seed);
  return wanted;
}

// Its page computes itself: it takes no option of an engine.
std::string plane_lesson_answer(const json& request) {
  require_known_keys(request, {"id", "name", "points", "triangles", "decimal", "numbers", "plane"},
                     "a request for a lesson in the plane");
  return write_json(
      Json{{"page", plane_lesson_page(shape_in_request(request))}, {"left_out", Json::array()}});
}

std::string lesson_answer(const json& request, std::optional<double> time_limit) {
  if (flag_in(request, "plane").value_or(false)) return plane_lesson_answer(request);
  LessonRequest wanted = lesson_request_of(request);
  const SceneObject input = shape_in_request(request);
  return in_time(time_limit_of(request, time_limit), "lesson", [&](const StageWatch& watch) {
    wanted.watch = watch;
    const auto outcome = make_lesson(input, wanted);
    if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
      return write_json(not_solid_answer(of_typed_rows(*reason, input.rows)));
    }
    const auto& lesson = std::get<Lesson>(outcome);
    if (lesson.failure) throw Error(ErrorCode::Internal, *lesson.failure);
    return write_json(Json{{"page", lesson_page(lesson.document["name"].text(), lesson.document)},
                           {"left_out", lesson.document["left_out"]}});
  });
}

}  // namespace

std::string answer_lesson_request(std::string_view line, std::optional<double> time_limit) {
  return answer_line(line, {"id", "points", "planes", "center"},
                     [&](const json& request) { return lesson_answer(request, time_limit); });
}

}  // namespace convexact
