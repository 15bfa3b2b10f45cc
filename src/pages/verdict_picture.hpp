// SPDX-License-Identifier: MIT
// verdict_picture.hpp - the picture of a verdict about one solid.
#pragma once
#include <string>

#include "convexact/scene.hpp"
#include "convexact/verify.hpp"
#include "pages/picture.hpp"

namespace convexact {

/// The input, the candidate as far as it is a solid, its faces where they are not its surface, and
/// the witness of the first claim that is violated and has a place, in a ball: as large as its
/// distance, or large enough to be seen.
/// @param answer  What was found, in one line.
[[nodiscard]] Picture verdict_picture(const SceneObject& input, const Candidate& candidate,
                                      const Verdict& verdict, const std::string& title,
                                      const std::string& answer);

}  // namespace convexact
