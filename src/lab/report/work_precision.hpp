// SPDX-License-Identifier: MIT
// work_precision.hpp - the error and the time of each way of computing, and where it breaks down as
// shapes become stiff or extreme.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "convexact/scene.hpp"
#include "lab/report/errors.hpp"
#include "lab/report/rounded_dual.hpp"
#include "lab/report/timing.hpp"
#include "solid/solid.hpp"

namespace convexact {

/// The first removal that was none of the cheapest where it was made.
struct WrongStep {
  std::size_t step;              ///< Counted from 0.
  std::optional<double> regret;  ///< (cost - minimum) / minimum; none if it is infinite.
};

/// One way of computing on one solid, against exact numbers.
struct WayResult {
  std::string way;           ///< "exact", "filtered", "float", "mpfr-24", ...
  std::optional<long> bits;  ///< The bits of its numbers; none: it decides exactly.
  /// Of the removals alone, from one dual hull; the verification of each step included where the
  /// way has one. None if it took longer than the effort allows; then nothing below is known.
  std::optional<Spread> seconds;
  std::size_t left = 0;  ///< Halfspaces at the end.
  StopReason stop = StopReason::Reached;

  ErrorSize planes;      ///< Largest relative error of a coordinate of a dual point, as it is held.
  ErrorSize cost_worst;  ///< Of the cost of each removal that it made, relative.
  ErrorSize cost_median;  ///< Likewise.
  /// Of the volume of what it left, relative; none where it could not compute it.
  std::optional<ErrorSize> volume;
  /// The largest distance of an input point outside a plane as it is held, before any outward
  /// rounding; relative to the diameter of the input.
  ErrorSize outside;

  /// The first step, from 0, that does not remove what exact removes there.
  std::optional<std::size_t> first_other;
  bool is_tied = false;  ///< Both cost exactly the same there.
  std::optional<WrongStep> first_wrong;
  /// Volume of what it left, over that of exact's run after as many removals, minus 1.
  double excess = 0;
  /// For MPFR in the formats of C's float and double: whether these gave the same, bit for bit.
  std::optional<bool> agrees_with_c;
};

struct WorkPrecision {
  std::size_t halfspaces = 0;
  std::string reference;  ///< "exact"; "filtered", which promises the same, if that took too long.
  std::vector<WayResult> ways;
};

/// Runs the engines and the loops on one dual hull, down to `faces` halfspaces.
/// @param ways  Names of ways; empty: all of them.
[[nodiscard]] WorkPrecision measure_work_precision(const Solid& solid, std::size_t faces,
                                                   const std::vector<std::string>& ways,
                                                   const Effort& effort);

/// Every way of computing at one value of a family's parameter.
struct BreakdownPoint {
  double value = 0;
  std::string why_not;  ///< Why there is no solid to measure on; empty if there is.
  std::optional<WorkPrecision> precision;
};

/// A family of shapes, swept over the parameter that makes it stiff.
struct Breakdown {
  std::string family, parameter;  ///< As `convexact generate` names them.
  std::vector<BreakdownPoint> points;
};

/// The families that can be swept, by name.
[[nodiscard]] std::vector<std::string> breakdown_families();

/// A few dozen points per shape, down to four halfspaces.
/// @param family  One of breakdown_families(). @throws Error InvalidArgument if it is not.
[[nodiscard]] Breakdown measure_breakdown(const std::string& family, const Effort& effort);

}  // namespace convexact
