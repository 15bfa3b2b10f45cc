// SPDX-License-Identifier: MIT
// simplify.hpp - the main job: enclose a shape in few halfspaces and prove that they hold it.
#pragma once
#include <atomic>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "convexact/fast/float_bound.hpp"
#include "convexact/pipeline/measured.hpp"
#include "convexact/pipeline/run_record.hpp"
#include "convexact/pipeline/solid.hpp"
#include "convexact/pipeline/stored_solid.hpp"
#include "convexact/simplify/exact_engine.hpp"

namespace convexact {

enum class Engine {
  Exact,     ///< Rationals and integers everywhere: the reference.
  Filtered,  ///< The same answer; exact numbers only where doubles cannot decide.
  Float,     ///< Doubles decide which halfspaces go. What is left is proven all the same.
};

/// What is wanted. At least one of `faces` and `max_growth` must be given.
struct SimplifyRequest {
  std::optional<std::size_t> faces;    ///< Halfspaces to keep, >= 4.
  std::optional<Rational> max_growth;  ///< Volume may grow to (1 + max_growth) times; >= 0.
  Engine engine = Engine::Filtered;
  bool trace = false;   ///< Keep the full record of every step. Not for the float engine.
  bool record = false;  ///< Keep what a proof of the run needs. For every engine.
  /// How much of each step is proven again. The float engine proves no steps, only the result; Full
  /// makes the filtered engine keep the record that it needs.
  VerifyLevel verify = VerifyLevel::Local;
  std::optional<RationalPoint> center;  ///< Unset: the Chebyshev center. The answer is the same.
  std::uint64_t seed = 1;               ///< Of every random order. The answer is the same.
  StoreRequest store;
  bool exact_volumes = false;  ///< As rationals too, not only their certain digits.
  /// Called after each removal with the number of halfspaces left and at the start.
  std::function<void(std::size_t left, std::size_t at_start)> progress;
  const std::atomic<bool>* stop = nullptr;  ///< When it becomes true: Error Stopped.
};

struct SimplifyResult {
  std::size_t input_points = 0;  ///< 0 where the input is halfspaces.
  std::size_t hull_vertices = 0;
  std::vector<RedundantHalfspace> redundant;  ///< Of halfspace input.
  std::size_t input_halfspaces = 0;           ///< Of the hull, redundant ones not counted.
  std::size_t steps = 0;                      ///< Halfspaces removed.
  StopReason stop = StopReason::Reached;
  std::optional<Trace> trace;       ///< If it was asked for, and by the exact engine.
  std::optional<RunRecord> record;  ///< If it was asked for.
  StoredSolid solid;                ///< What encloses the input.
  Measured input_volume;            ///< Of the input's hull, in cubed length units.
  Measured output_volume;
  std::size_t tested_points = 0;  ///< Points tested directly against every survivor.
  Engine engine = Engine::Filtered;
  VerifyLevel verified = VerifyLevel::Local;
  std::optional<FloatBound> float_bound;  ///< Of the float engine: what it proves of its errors.
};

using SimplifyOutcome = std::variant<SimplifyResult, NotSolid>;

/// Runs the stages that the request and the shape need; `log` gets each with its time, or the
/// reason why it was left out.
/// @throws Error InvalidArgument for a request that makes no sense or a center that is not strictly
///         inside; Unrepresentable if a stored format cannot hold the result; Stopped; Internal if
///         a verification fails.
[[nodiscard]] SimplifyOutcome simplify(const Shape& shape, const SimplifyRequest& request,
                                       StageLog& log);

}  // namespace convexact
