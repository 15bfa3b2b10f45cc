// SPDX-License-Identifier: MIT
// stored_part.hpp - from the hulls of clusters to the parts that are stored.
#pragma once
#include <vector>

#include "convexact/decompose.hpp"
#include "solid/stage_log.hpp"

namespace convexact {

/// Fills in form, faces, mesh and halfspaces of parts whose hulls are known, as the request wants
/// them: thickened, simplified, rounded outward.
/// @return By part the hull of its stored points.
/// @throws Error InvalidArgument if `total_faces` is less than 4 for each part with a volume;
///               Unrepresentable if the format cannot hold a part; Stopped.
[[nodiscard]] std::vector<ConvexPart> store_parts(std::vector<Part>& parts,
                                                  const Rational& squared_diameter,
                                                  const DecomposeRequest& request, StageLog& log);

/// Numbers of the format as points whose hull holds that of some corners, thickened if it is flat.
/// @param corners  Its extreme points.
/// @throws Error Unrepresentable if there are none.
[[nodiscard]] PointSet stored_corners(const PointSet& corners, bool is_flat,
                                      const Rational& squared_diameter, Precision precision,
                                      const Watch& watch);

}  // namespace convexact
