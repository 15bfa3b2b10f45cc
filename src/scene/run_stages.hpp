// SPDX-License-Identifier: MIT
// run_stages.hpp - the stages of simplify() before and after the removals, for one run and for
// several that share a budget.
#pragma once
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "convexact/hull.hpp"
#include "convexact/simplify.hpp"
#include "fast/engines.hpp"
#include "scene/solid.hpp"
#include "scene/stage_log.hpp"

namespace convexact {

/// @throws Error InvalidArgument for what no shape makes sensible.
void require_sensible(const SimplifyRequest& request);

/// A shape as removals begin with it. Its members refer to each other, so it stays where it is.
struct RunInput {
  explicit RunInput(const Shape& given) : shape(given) {}
  RunInput(const RunInput&) = delete;
  RunInput& operator=(const RunInput&) = delete;

  /// Of the input's hull.
  std::size_t halfspaces() const { return dual ? dual->size() : solid->dual.halfspaces.size(); }

  const Shape& shape;
  std::optional<Hull> hull;    ///< Of points, if their exact planes are not needed.
  std::optional<Solid> solid;  ///< Otherwise; then also the next two.
  RationalPoint center;
  std::vector<HalfspaceId> keep;
  std::optional<FastDual> dual;  ///< For engines that keep no record; the others have their own.
};

/// Runs the stages before the removals.
[[nodiscard]] std::variant<std::unique_ptr<RunInput>, NotSolid> prepare_run(
    const Shape& shape, const SimplifyRequest& request, StageLog& log);

/// What the engines are asked for, without progress.
[[nodiscard]] SimplifyOptions options_of(const SimplifyRequest& request, const RunInput& input);

/// Where a run led, whichever engine made it.
struct RunEnd {
  std::size_t steps = 0;
  StopReason stop = StopReason::Reached;
  Polytope polytope;
  std::vector<DualTriangle> triangles = {};  ///< The dual hull of what is left.
  std::vector<HalfspaceId> removed = {};     ///< By an engine that keeps no record.
  std::optional<Run> run = {};
  std::optional<FloatBound> bound = {};
  TieTally ties = {};
  long growth_bits = 0;
  std::optional<SearchResult> search = {};
};

/// Of an engine that keeps no record, and of one that does.
[[nodiscard]] RunEnd end_of(const FastResult& result, const FastDual& dual, Engine engine,
                            StageLog& log);
[[nodiscard]] RunEnd end_of(Run run, StageLog& log);

/// What a result is measured against.
struct InputMeasures {
  Measured volume;
  std::optional<Enclosure> measure = {};  ///< That the run keeps small, unless it is the volume.
  std::optional<Enclosure> limited = {};  ///< Whose growth is limited, unless it is one of those.

  /// The measure of this kind, which is one of them.
  const Enclosure& of(CostMeasure kind, CostMeasure cost) const;
};

[[nodiscard]] InputMeasures measure_input(const RunInput& input, const SimplifyRequest& request,
                                          StageLog& log);

/// Runs the stages after the removals, and proves containment. It takes points out of the input.
[[nodiscard]] SimplifyResult finish_run(RunInput& input, InputMeasures before, RunEnd end,
                                        const SimplifyRequest& request, StageLog& log);

/// Of a float engine's run with a growth limit, which it compared in doubles: whether enclosures
/// prove that the limit is kept, and that the next removal would have exceeded it.
/// @param least_next  A lower bound of what that adds; none if there is no further one.
[[nodiscard]] bool is_growth_proven(std::size_t steps, StopReason stop,
                                    const std::optional<Rational>& least_next,
                                    const std::array<Enclosure, 2>& measure,
                                    const Rational& max_growth);

/// The lower bound of a result's float engine for any further removal, in the caller's units; none
/// if there is no further one.
[[nodiscard]] std::optional<Rational> least_next(const FloatBound& bound, const RunInput& input,
                                                 CostMeasure cost);

}  // namespace convexact
