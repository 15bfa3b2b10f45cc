// SPDX-License-Identifier: MIT
// lesson_page.hpp - the page that shows a lesson.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace convexact {

/// One HTML file that needs no other. @param lesson  As docs/schema/lesson.schema.json describes
/// it.
[[nodiscard]] std::string lesson_page(std::string_view name, const nlohmann::ordered_json& lesson);

}  // namespace convexact
