// SPDX-License-Identifier: MIT
// plane_lesson.hpp - lessons in the plane, where everything is seen at once.
#pragma once
#include <string>

#include "convexact/scene.hpp"

namespace convexact {

/// A self-contained HTML page. Of points: how they are enclosed in few halfplanes; of one face: how
/// that polygon is cut into few convex parts that stay near it. The page computes in exact
/// rationals itself, so that things can be dragged.
/// @param object  With one z, which is ignored.
/// @throws Error InvalidArgument for halfspaces, points of two z, more than kMostPlanePoints, more
///               than one face, or a face that crosses itself; NoInterior unless three points are
///               not in line.
[[nodiscard]] std::string plane_lesson_page(const SceneObject& object);

/// More would hide each other.
inline constexpr std::size_t kMostPlanePoints = 60;

}  // namespace convexact
