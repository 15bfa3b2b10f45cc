// SPDX-License-Identifier: MIT
// lessons.hpp - lessons for tests, and what their JSON spells.
#pragma once
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/hull.hpp"
#include "json_schema.hpp"
#include "teach/lesson.hpp"

namespace lessons {

using namespace convexact;
using nlohmann::json;

inline SceneObject object_of(Shape shape) {
  return {"folder/shape.obj", "shape", std::move(shape), {}};
}

/// Long numbers cut off: the standard library's regular expressions, which test the pattern of a
/// number, call themselves for each character.
inline json with_short_numbers(json document) {
  constexpr std::size_t kMost = 200;
  if (document.is_structured()) {
    for (json& part : document) part = with_short_numbers(std::move(part));
  } else if (document.is_string() && document.get_ref<std::string&>().size() > kMost) {
    std::string& text = document.get_ref<std::string&>();
    text.resize(text[kMost - 1] == '/' ? kMost - 1 : kMost);
  }
  return document;
}

/// The lesson of a solid that passes its verification, valid by the schema.
inline json lesson_of(Shape shape, const LessonRequest& request) {
  const auto outcome = make_lesson(object_of(std::move(shape)), request);
  REQUIRE(std::holds_alternative<Lesson>(outcome));
  const Lesson& lesson = std::get<Lesson>(outcome);
  CHECK_FALSE(lesson.failure.has_value());
  json document = json::parse(write_json(lesson.document));
  CHECK(schema_complaint("lesson", with_short_numbers(document)) == "");
  CHECK(document["name"] == "shape.obj");
  return document;
}

inline Rational number_in(const json& text) {
  return parse_rational(text.get_ref<const std::string&>());
}

inline RationalPoint point_in(const json& numbers) {
  return {number_in(numbers[0]), number_in(numbers[1]), number_in(numbers[2])};
}

inline std::vector<HalfspaceId> ids_in(const json& numbers) {
  std::vector<HalfspaceId> ids;
  for (const json& number : numbers) ids.emplace_back(number.get<std::size_t>());
  return ids;
}

inline DualHull dual_of_points(const std::vector<Point>& points, std::uint64_t seed) {
  const PointSet set(points);
  return dual_of(std::get<Hull>(convex_hull(set, {.seed = seed})), set);
}

}  // namespace lessons
