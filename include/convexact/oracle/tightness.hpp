// SPDX-License-Identifier: MIT
// tightness.hpp - how much larger a solid is than the one that it should enclose.
#pragma once
#include <atomic>

#include "convexact/geometry/polytope.hpp"
#include "convexact/number/enclosure.hpp"

namespace convexact {

/// A candidate against the hull of the input. Ratios are candidate over hull; at least 1 if it
/// contains the input, since all three measures grow with the set.
struct Tightness {
  Enclosure volume_ratio, area_ratio, mean_width_ratio;
  /// Hausdorff distance between the two solids, in squared length units; exact.
  Rational squared_hausdorff;
};

/// @param contained  Whether the candidate is known to contain the hull, so that the distance need
///                   be measured one way only.
/// @throws Error Stopped when `stop` becomes true.
/// @par Cost  The measures of both, and hausdorff_distance().
[[nodiscard]] Tightness measure_tightness(const Polytope& candidate, const Polytope& hull,
                                          bool contained, const std::atomic<bool>* stop = nullptr);

}  // namespace convexact
