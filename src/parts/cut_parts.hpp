// SPDX-License-Identifier: MIT
// cut_parts.hpp - a solid cut into regions, and what these hold merged into few parts.
#pragma once
#include <vector>

#include "convexact/decompose.hpp"
#include "convexact/partition.hpp"
#include "parts/part_volumes.hpp"

namespace convexact {

struct CutParts {
  Partition partition;
  std::vector<Part> parts;  ///< With `leaves` and `hull`, whose corners are numbers of the format.
  std::size_t merged = 0;   ///< Leaves that joined others.
  std::size_t cells = 0;    ///< The most of any octree that decided.
};

/// Cuts until what each region has of the solid is within half the distance, since finer leaves
/// merge into fewer parts; then merges by the distance. With more effort several such shares are
/// tried. Where parts are simplified, the distance to merge by is lowered until they are within the
/// whole distance then, and their volumes within the limit. Of five attempts of which none is, that
/// with the least volume is kept, or the last one.
/// @param winding           Of the surface; null if it is open.
/// @param squared_distance  > 0.
/// @param volume_limit      Null if there is none.
/// @throws Error Stopped, and as store_parts().
[[nodiscard]] CutParts cut_into_parts(const Surface& surface, const Winding* winding,
                                      const Rational& squared_distance,
                                      const VolumeLimit* volume_limit,
                                      const DecomposeRequest& request, StageLog& log);

}  // namespace convexact
