// SPDX-License-Identifier: MIT
// lesson.hpp - the polar-dual construction of one shape, step by step, as the engine recorded it.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/scene.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// For larger inputs a lesson leaves a part out, and says so.
inline constexpr std::size_t kMostLessonHalfspaces = 200;  ///< At the start of the removals that
                                                           ///< are shown.
inline constexpr std::size_t kMostLessonPoints = 3000;     ///< Of a hull shown being built.
inline constexpr std::size_t kMostLessonInsertions = 300;  ///< Likewise.
/// Above this number, the steps are verified at level local; the whole dual would take long.
inline constexpr std::size_t kMostFullyVerified = 60;

struct LessonRequest {
  std::size_t faces = 4;
  CostMeasure cost = CostMeasure::Volume;
  std::vector<CostMeasure> measures = {};     ///< Further costs to show of each evaluation.
  std::optional<RationalPoint> center = {};   ///< Of the dual; unset: the Chebyshev center.
  Precision precision = Precision::Binary32;  ///< In which the result is stored.
  std::uint64_t seed = 1;
  StageWatch watch = {};
};

struct Lesson {
  Json document;  ///< As docs/schema/lesson.schema.json describes it.
  /// Why the engine gave up: as a rule, the verification refused a step. The document ends there.
  std::optional<std::string> failure;
  std::vector<Stage> stages;
};

/// Runs the stages of `simplify --engine exact` on an object, watches them, and records what they
/// do. The removals are those of the same request without a lesson.
/// @throws Error InvalidArgument as simplify(); Internal if a certificate before the removals
///               fails; Stopped when the watch ends the call.
[[nodiscard]] std::variant<Lesson, NotSolid> make_lesson(const SceneObject& object,
                                                         const LessonRequest& request);

}  // namespace convexact
