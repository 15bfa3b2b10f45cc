// SPDX-License-Identifier: MIT
// inner.hpp - simplification from inside: removes vertices of a shape's hull one after another, so
// that the hull of those left keeps as much of the volume as such removals can.
#pragma once
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "convexact/inner_run.hpp"
#include "convexact/scene.hpp"
#include "convexact/simplify.hpp"

namespace convexact {

/// A request. At least one of `vertices` and `max_loss` must be given.
struct InnerRequest {
  std::optional<std::size_t> vertices;  ///< To keep, >= 4.
  /// The volume stays at least (1 - max_loss) times that of the hull, exactly; >= 0.
  std::optional<Rational> max_loss;
  Engine engine = Engine::Filtered;  ///< Not Float.
  VerifyLevel verify = VerifyLevel::Local;
  std::uint64_t seed = 1;  ///< Of every random order. The answer does not depend on it.
  /// Keep the exact cost of every step, for a trace. The exact engine and VerifyLevel::Full keep it
  /// in any case.
  bool costs = false;
  bool mesh = false;      ///< Keep the result as a mesh in binary64.
  StageWatch watch = {};  ///< Reports removals as the progress of stage::kSimplify.
};

struct InnerResult {
  std::size_t input_points = 0;
  std::size_t input_halfspaces = 0;  ///< Of the hull.
  VertexHull start;
  InnerRun run;
  std::vector<PointId> kept;                ///< Input ids of the result's vertices, ascending.
  std::vector<Halfspace> hull;              ///< The exact hull of the input.
  Polytope solid;                           ///< The result.
  std::optional<Mesh> mesh;                 ///< Of the input's doubles, unchanged; if asked for.
  Measured input_volume{Enclosure(1), {}};  ///< Exact, as the next.
  Measured output_volume{Enclosure(1), {}};
  Engine engine = Engine::Filtered;
  VerifyLevel verified = VerifyLevel::Local;
  std::vector<Stage> stages;  ///< Each with its time, or the reason why it was left out.
};

using InnerOutcome = std::variant<InnerResult, NotSolid>;

/// Removes vertices of the hull, each time the one whose removal loses the least volume, and proves
/// the result: its vertices are input points and lie in every halfspace of the exact hull of the
/// input; each step is proven again as `verify` says; and where costs are kept, its volume,
/// computed from a separate hull, is that of the input less the sum of all costs.
/// @throws Error InvalidArgument for an invalid request; Unrepresentable if a mesh is wanted and a
///         vertex is no double; Stopped; Internal if a proof fails.
/// @par Source  [Jacobson2026]
[[nodiscard]] InnerOutcome simplify_inner(const PointSet& points, const InnerRequest& request);

}  // namespace convexact
