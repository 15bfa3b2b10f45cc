// SPDX-License-Identifier: MIT
// lesson_parts.hpp - what pages of lessons are made of, from the files that meson.build lists.
#pragma once
#include <string_view>

namespace convexact {

extern const std::string_view kLessonPage, kLessonStyle, kLessonScript;

// Of the lessons in the plane: on halfplanes, and on parts.
extern const std::string_view kPlanePage, kPlaneStyle, kHalfplanesScript, kPartsScript;

}  // namespace convexact
