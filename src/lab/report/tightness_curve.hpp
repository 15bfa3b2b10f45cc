// SPDX-License-Identifier: MIT
// tightness_curve.hpp - how tightly k halfspaces enclose a solid, and when a run reaches them.
#pragma once
#include <optional>
#include <vector>

#include "convexact/scene.hpp"
#include "lab/report/timing.hpp"
#include "solid/solid.hpp"

namespace convexact {

/// The solid of k halfspaces after the greedy removals.
struct TightnessPoint {
  std::size_t faces = 0;
  /// The measure of the curve over that of the solid, minus 1; approximately the nearest double.
  double growth = 0;
  /// Hausdorff distance to the solid, over the diameter of its box: the nearest double. None where
  /// the effort's budget was spent before.
  std::optional<double> hausdorff;
  /// From the dual hull on, in one run that goes on to the end.
  Spread seconds;
};

struct TightnessCurve {
  std::size_t halfspaces = 0;                 ///< Of the solid.
  CostMeasure measure = CostMeasure::Volume;  ///< The measure to which each removal adds the least.
  std::vector<TightnessPoint> points;         ///< Ascending by `faces`, from `least` to all.
};

/// About `count` numbers from `most` down to `least`, evenly spaced by their logarithms; both ends
/// included, ascending, each once. Precondition: 1 <= least <= most.
[[nodiscard]] std::vector<std::size_t> spaced_by_ratio(std::size_t least, std::size_t most,
                                                       std::size_t count);

/// The filtered engine's removals, which are the exact engine's, down to `least` >= 4 halfspaces or
/// where they end.
/// @par Cost  The timed runs; for each point a further run, a measure and a Hausdorff distance.
[[nodiscard]] TightnessCurve measure_tightness_curve(const Solid& solid, std::size_t least,
                                                     const Effort& effort,
                                                     CostMeasure measure = CostMeasure::Volume);

}  // namespace convexact
