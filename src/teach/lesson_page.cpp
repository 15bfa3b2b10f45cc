// SPDX-License-Identifier: MIT
#include "teach/lesson_page.hpp"

#include "io/json.hpp"
#include "number/text.hpp"
#include "pages/page_parts.hpp"
#include "teach/lesson_parts.hpp"

namespace convexact {

std::string lesson_page(std::string_view name, const Json& lesson) {
  return fill_page(kLessonPage, {{"TITLE", escaped_markup(as_utf8(std::string(name)))},
                                 {"STYLE", kLessonStyle},
                                 {"DATA", for_script_element(write_json(lesson))},
                                 {"SCRIPT", kLessonScript}});
}

}  // namespace convexact
