// SPDX-License-Identifier: MIT
// hull_measures.hpp - the exact hull of a shape with its measures.
#pragma once
#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "convexact/measure/bounding_box.hpp"
#include "convexact/pipeline/measured.hpp"
#include "convexact/pipeline/solid.hpp"
#include "convexact/pipeline/stored_solid.hpp"

namespace convexact {

struct HullRequest {
  bool volume = true, area = true, mean_width = true;  ///< Which measures are asked for.
  int digits = 10;            ///< Certain decimal digits of each measure, 1 to 10000.
  bool exact_volume = false;  ///< The volume as a rational too.
  std::uint64_t seed = 1;     ///< Of every random order. The answer is the same.
  StoreRequest store;
  /// Told how many of how many facets or edges a measure has been through.
  std::function<void(const char* stage, std::size_t done, std::size_t total)> progress = {};
};

struct HullResult {
  std::size_t input_points = 0;               ///< 0 where the input is halfspaces.
  std::vector<RedundantHalfspace> redundant;  ///< Of halfspace input.
  StoredSolid solid;
  std::size_t edges = 0;
  BoundingBox box;    ///< Of the hull.
  Measured diameter;  ///< Diagonal of the box, in length units.
  // In cubed, squared and plain length units; each if asked for.
  std::optional<Measured> volume, area, mean_width;
};

using HullReport = std::variant<HullResult, NotSolid>;

/// The hull of points, or the solid that halfspaces bound, measured. @throws Error as simplify().
[[nodiscard]] HullReport measure_hull(const Shape& shape, const HullRequest& request,
                                      StageLog& log);

}  // namespace convexact
