// SPDX-License-Identifier: MIT
// same_mesh.hpp - whether two meshes are equal to the last bit, signs of zeros included.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>

#include "convexact/io.hpp"

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

// Parts of points only are not written, so two of one name may follow each other then: they are
// one.
inline std::vector<convexact::MeshPart> written_parts(const convexact::Mesh& mesh) {
  std::vector<convexact::MeshPart> parts;
  for (const convexact::MeshPart& part : mesh.parts) {
    if (part.first_polygon == part.last_polygon) continue;
    if (!parts.empty() && parts.back().name == part.name) {
      parts.back().last_polygon = part.last_polygon;
    } else {
      parts.push_back(part);
    }
  }
  return parts;
}

inline bool same_parts(const convexact::Mesh& a, const convexact::Mesh& b) {
  const auto first = written_parts(a), second = written_parts(b);
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const convexact::MeshPart& p, const convexact::MeshPart& q) {
                      return p.name == q.name && p.first_polygon == q.first_polygon &&
                             p.last_polygon == q.last_polygon;
                    });
}
