// SPDX-License-Identifier: MIT
// same_mesh.hpp - whether two meshes are equal to the last bit, signs of zeros included.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>

#include "convexact/mesh.hpp"

inline bool same_points(const convexact::PointSet& a, const convexact::PointSet& b) {
  if (a.size() != b.size() || a.is_binary() != b.is_binary()) return false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const convexact::PointId id(k);
    for (int axis = 0; axis < 3; ++axis) {
      const double x = a.doubles()[k][axis], y = b.doubles()[k][axis];
      if (std::bit_cast<std::uint64_t>(x) != std::bit_cast<std::uint64_t>(y)) return false;
    }
    if (!a.is_binary() && a[id] != b[id]) return false;
  }
  return true;
}

inline bool same_parts(const convexact::Mesh& a, const convexact::Mesh& b) {
  return std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                    [](const convexact::MeshPart& p, const convexact::MeshPart& q) {
                      return p.name == q.name && p.first_polygon == q.first_polygon &&
                             p.last_polygon == q.last_polygon;
                    });
}
