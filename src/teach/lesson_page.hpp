// SPDX-License-Identifier: MIT
// lesson_page.hpp - a lesson as a page that can be walked through.
#pragma once
#include <string>
#include <string_view>

#include "io/json_document.hpp"

namespace convexact {

/// A self-contained HTML page of a lesson (docs/schema/lesson.schema.json); it opens from disk and
/// needs no network. @param name  Of the input, plain text in any encoding.
[[nodiscard]] std::string lesson_page(std::string_view name, const Json& lesson);

}  // namespace convexact
