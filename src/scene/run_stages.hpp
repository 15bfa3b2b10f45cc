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
#include "solid/solid.hpp"
#include "solid/stage_log.hpp"

namespace convexact {

/// @throws Error InvalidArgument for a request that is invalid for every shape.
void require_sensible(const SimplifyRequest& request);

/// A shape in the form in which removals begin. Its members refer to each other, so it is not
/// moved.
struct RunInput {
  explicit RunInput(const Shape& given) : shape(given) {}
  RunInput(const RunInput&) = delete;
  RunInput& operator=(const RunInput&) = delete;

  /// Of the input's hull.
  std::size_t halfspaces() const { return dual ? dual->size() : solid->dual.halfspaces.size(); }
  /// One of them.
  const Halfspace& halfspace(HalfspaceId i) const {
    return solid ? solid->dual.halfspaces[i.index()] : dual->exact(i);
  }
  /// A point strictly inside all of them.
  const RationalPoint& inside() const { return solid ? center : dual->center(); }

  const Shape& shape;
  std::optional<Hull> hull;    ///< Of points, if no exact solid of them is needed.
  std::optional<Solid> solid;  ///< Otherwise; then also the next two.
  RationalPoint center;
  std::vector<HalfspaceId> keep;
  std::optional<FastDual> dual;  ///< For engines that keep no record; the others make one
                                 ///< themselves.
};

/// Runs the stages before the removals.
[[nodiscard]] std::variant<std::unique_ptr<RunInput>, NotSolid> prepare_run(
    const Shape& shape, const SimplifyRequest& request, StageLog& log);

/// The options of the engines, without progress.
[[nodiscard]] SimplifyOptions options_of(const SimplifyRequest& request, const RunInput& input);

/// The end of a run, for every engine.
struct RunEnd {
  std::size_t steps = 0;
  StopReason stop = StopReason::Reached;
  Polytope polytope;
  std::vector<DualTriangle> triangles = {};  ///< The dual hull of the halfspaces that are left.
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

/// The measures that a result is compared with.
struct InputMeasures {
  Measured volume;
  std::optional<Enclosure> measure = {};  ///< The one that the run keeps small, unless it is the
                                          ///< volume.
  std::optional<Enclosure> limited = {};  ///< The one whose growth is limited, unless it is one of
                                          ///< those.

  /// The measure of this kind, which is one of them.
  const Enclosure& of(CostMeasure kind, CostMeasure cost) const;
};

[[nodiscard]] InputMeasures measure_input(const RunInput& input, const SimplifyRequest& request,
                                          StageLog& log);

/// Runs the stages after the removals, and proves containment. It moves points out of the input.
[[nodiscard]] SimplifyResult finish_run(RunInput& input, InputMeasures before, RunEnd end,
                                        const SimplifyRequest& request, StageLog& log);

/// For a float engine's run with a growth limit, which it compared in doubles: whether enclosures
/// prove that the limit is kept, and that the next removal would have exceeded it.
/// @param least_next  A lower bound of the amount that the next removal adds; none if there is no
///                    next one.
[[nodiscard]] bool is_growth_proven(std::size_t steps, StopReason stop,
                                    const std::optional<Rational>& least_next,
                                    const std::array<Enclosure, 2>& measure,
                                    const Rational& max_growth);

/// The float engine's lower bound for the cost of any further removal, in the caller's units; none
/// if there is no further removal.
[[nodiscard]] std::optional<Rational> least_next(const FloatBound& bound, const RunInput& input,
                                                 CostMeasure cost);

}  // namespace convexact
