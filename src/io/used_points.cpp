// SPDX-License-Identifier: MIT
// The points of a mesh that its polygons use.
#include "io/used_points.hpp"

namespace convexact {

std::vector<bool> used_points(std::size_t count,
                              std::span<const std::vector<std::uint32_t>> polygons) {
  std::vector<bool> is_used(count, false);
  for (const auto& polygon : polygons) {
    for (const std::uint32_t corner : polygon) is_used[corner] = true;
  }
  return is_used;
}

void drop_unused_points(Mesh& mesh) {
  if (mesh.polygons.empty()) return;
  const std::vector<bool> is_used = used_points(mesh.points.size(), mesh.polygons);
  std::vector<PointId> kept;
  std::vector<std::uint32_t> number(is_used.size());
  for (std::size_t p = 0; p < is_used.size(); ++p) {
    if (!is_used[p]) continue;
    number[p] = static_cast<std::uint32_t>(kept.size());
    kept.emplace_back(p);
  }
  mesh.points = subset(mesh.points, kept);
  for (auto& polygon : mesh.polygons) {
    for (std::uint32_t& corner : polygon) corner = number[corner];
  }
  for (MeshPart& part : mesh.parts) part.loose.clear();
}

}  // namespace convexact
