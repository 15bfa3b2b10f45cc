// SPDX-License-Identifier: MIT
// scaling.hpp - how the time of a run grows with its input.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "convexact/simplify.hpp"
#include "report/effort.hpp"

namespace convexact {

struct ScalingPoint {
  std::size_t size;
  Spread seconds;
};

/// One stage of simplify(), on inputs of growing size.
struct ScalingSeries {
  std::string stage;  ///< "hull", "simplify".
  std::string
      run;  ///< The engine: "float", "filtered", "exact"; of the hull, which has none, "hull".
  std::string
      counts;  ///< What `size` counts: "points" for the hull, else "halfspaces" of the hull.
  std::vector<ScalingPoint> points;  ///< Ascending by size.
  std::optional<PowerLaw> law;       ///< Through the least times of each size.
};

/// Random subsets of n, n/2, n/4, ... points that span a volume; at least `least` points.
[[nodiscard]] std::vector<PointSet> nested_subsets(const PointSet& points, std::size_t least,
                                                   std::uint64_t seed);
/// Points on a sphere, all of them on the hull: n = least, 2 least, ... up to `most`.
[[nodiscard]] std::vector<PointSet> growing_spheres(std::size_t least, std::size_t most,
                                                    std::uint64_t seed);

/// Runs of simplify() down to four halfspaces. An engine does not go on to a larger input once a
/// run took a tenth of the effort's budget.
/// @param sets  Each larger than the one before.
[[nodiscard]] std::vector<ScalingSeries> measure_scaling(const std::vector<PointSet>& sets,
                                                         const Effort& effort);

}  // namespace convexact
