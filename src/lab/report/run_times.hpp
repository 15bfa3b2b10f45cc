// SPDX-License-Identifier: MIT
// run_times.hpp - the time of a run by stage, the time that skipping stages saves, and the growth
// of the time with the input.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "convexact/simplify.hpp"
#include "lab/report/timing.hpp"

namespace convexact {

struct StageTime {
  std::string name;
  std::optional<Spread> seconds;  ///< None if the stage was left out.
  std::string skipped;            ///< Why it was; empty if it ran.
};

/// One kind of run of the pipeline, repeated.
struct RunTimes {
  /// "exact", "filtered", "float": only down to a number of halfspaces. "everything": by the
  /// filtered engine, with no stage left out.
  std::string run;
  /// From the input in memory to the result; none if it took longer than the effort allows.
  std::optional<Spread> seconds;
  std::vector<StageTime> stages;
};

/// Runs of simplify() by each engine, with the verification that is its default, and one of
/// everything: exact planes, certificate and Chebyshev center; record and ties of each step; the
/// result as planes and as a mesh in binary64; area, mean width and exact volumes; and the detour
/// through the halfspaces, which points do not need. So "filtered" against "everything" shows the
/// time that planning saves.
[[nodiscard]] std::vector<RunTimes> measure_stage_times(const Shape& shape, std::size_t faces,
                                                        const Effort& effort);

struct ScalingPoint {
  std::size_t size;
  Spread seconds;
};

/// One stage of simplify(), on inputs of growing size.
struct ScalingSeries {
  std::string stage;   ///< stage::kHull or stage::kSimplify.
  std::string run;     ///< The engine: "float", "filtered", "exact"; of the hull, "hull".
  std::string counts;  ///< What `size` counts: "points" for the hull, else its "halfspaces".
  std::vector<ScalingPoint> points;  ///< Ascending by size.
  std::optional<PowerLaw> law;       ///< Through the least times of each size.
};

/// Random subsets of n, n/2, n/4, ... points that span a volume; at least `least` points.
[[nodiscard]] std::vector<PointSet> nested_subsets(const PointSet& points, std::size_t least,
                                                   std::uint64_t seed);
/// Points on a sphere, all of them on the hull: n = least, 2 least, ... up to `most`.
[[nodiscard]] std::vector<PointSet> growing_spheres(std::size_t least, std::size_t most,
                                                    std::uint64_t seed);

/// Runs of simplify() down to four halfspaces. An engine does not continue with a larger input
/// after a run took a tenth of the effort's budget.
/// @param sets  Each larger than the one before.
[[nodiscard]] std::vector<ScalingSeries> measure_scaling(const std::vector<PointSet>& sets,
                                                         const Effort& effort);

}  // namespace convexact
