// SPDX-License-Identifier: MIT
// lesson_parts.hpp - the files that the page of a lesson is made of.
#pragma once
#include <string_view>

namespace convexact {

extern const std::string_view kLessonPage, kLessonStyle;
/// Concatenated in this order they are one script.
extern const std::string_view kRationalScript, kPaneScript, kRecordScript, kChaptersScript,
    kRemovalsScript, kFilmScript, kStoringScript, kLessonScript;

// Of the lessons in the plane: on halfplanes, and on parts.
extern const std::string_view kPlanePage, kPlaneStyle, kPolygonScript, kPlanePageScript,
    kPlaneScript, kPiecesScript, kCutsScript;

}  // namespace convexact
