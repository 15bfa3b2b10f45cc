// SPDX-License-Identifier: MIT
// scene_report.hpp - the verdict about the parts of a scene as JSON and as text.
#pragma once
#include <string>

#include "io/json_document.hpp"
#include "oracle/parts/scene_verdict.hpp"

namespace convexact {

[[nodiscard]] Json scene_verdict_json(const SceneVerdict& verdict);
[[nodiscard]] std::string scene_verdict_text(const SceneVerdict& verdict);

}  // namespace convexact
