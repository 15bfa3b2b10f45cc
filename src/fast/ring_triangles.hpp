// SPDX-License-Identifier: MIT
// ring_triangles.hpp - a triangulation of a one-ring as a tree of triangles.
#pragma once
#include <cstdint>

namespace convexact {

inline constexpr std::uint32_t kNone = 0xffffffff;

/// A triangle of the polygon 0, 1, ..., k - 1 (positions in a one-ring): low < middle < high,
/// counter-clockwise. It hangs below its edge (low, high) on the triangle `parent`, an earlier
/// position in the list, whose (low, middle) or (middle, high) that edge is; for the first
/// triangle that edge is (0, k - 1) and `parent` is kNone.
struct RingTriangle {
  std::uint32_t low, middle, high;
  std::uint32_t parent;
};

}  // namespace convexact
