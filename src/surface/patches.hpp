// SPDX-License-Identifier: MIT
// patches.hpp - triangles of a surface beside which the winding numbers are the same.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/surface.hpp"

namespace convexact {

struct Patches {
  /// By triangle: whether it has the same corners as the one before it.
  std::vector<bool> repeats_last;
  /// By triangle: whether it has an area and meets another one with an area elsewhere than at
  /// common corners and edges.
  std::vector<bool> is_crossed;
  /// By triangle that is not crossed: the lowest triangle of its patch. Just before all triangles
  /// of a patch the winding number is the same, and so it is just behind them.
  std::vector<std::uint32_t> patch;
};

/// @throws Error Stopped when the watch ends the call.
/// @par Cost  O(n log n), and one exact test for each two triangles whose boxes meet.
[[nodiscard]] Patches find_patches(const Surface& surface, const Watch& watch = {});

/// The triangles of a closed surface without those that lie in the interior of its solid,
/// ascending: surface and solid have the same points without them. Crossed triangles all stay.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] std::vector<std::uint32_t> without_inner_triangles(const Surface& surface,
                                                                 const Winding& winding,
                                                                 const Watch& watch = {});

}  // namespace convexact
