// SPDX-License-Identifier: MIT
#include "teach/lesson_page.hpp"

#include "io/json.hpp"
#include "report/page_parts.hpp"

namespace convexact {

std::string lesson_page(std::string_view name, const nlohmann::ordered_json& lesson) {
  return "<!doctype html><meta charset=\"utf-8\"><title>" + escaped_html(name) +
         "</title><script type=\"application/json\">" + for_script_element(write_json(lesson)) +
         "</script>\n";
}

}  // namespace convexact
