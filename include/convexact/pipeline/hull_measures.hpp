// SPDX-License-Identifier: MIT
// hull_measures.hpp - the exact hull of a shape with its measures.
#pragma once
#include <variant>
#include <vector>

#include "convexact/measure/bounding_box.hpp"
#include "convexact/pipeline/measured.hpp"
#include "convexact/pipeline/solid.hpp"
#include "convexact/pipeline/stored_solid.hpp"

namespace convexact {

struct HullRequest {
  int digits = 10;            ///< Certain decimal digits of each measure, 1 to 10000.
  bool exact_volume = false;  ///< As a rational too.
  std::uint64_t seed = 1;     ///< Of every random order. The answer is the same.
  StoreRequest store;
};

struct HullResult {
  std::size_t input_points = 0;               ///< 0 where the input is halfspaces.
  std::vector<RedundantHalfspace> redundant;  ///< Of halfspace input.
  StoredSolid solid;
  std::size_t edges = 0;
  BoundingBox box;      ///< Of the hull.
  Measured diameter;    ///< Diagonal of the box, in length units.
  Measured volume;      ///< Cubed length units.
  Measured area;        ///< Squared length units.
  Measured mean_width;  ///< Length units.
};

using HullReport = std::variant<HullResult, NotSolid>;

/// The hull of points, or the solid that halfspaces bound, measured. @throws Error as simplify().
[[nodiscard]] HullReport measure_hull(const Shape& shape, const HullRequest& request,
                                      StageLog& log);

}  // namespace convexact
