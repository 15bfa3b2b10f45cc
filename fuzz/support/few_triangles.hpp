// SPDX-License-Identifier: MIT
// few_triangles.hpp - a mesh of a few triangles on a small grid, most of them joined along edges.
#pragma once
#include "convexact/io.hpp"
#include "fuzz_input.hpp"

/// At most 20 triangles on 14 points with integer coordinates from -3 to 3. None if the input
/// is too short.
inline convexact::Mesh few_triangles(FuzzInput& in) {
  convexact::Mesh mesh;
  const std::vector<convexact::Point> points = in.grid_points(14, 3);
  mesh.points = convexact::PointSet(points);
  if (points.empty()) return mesh;
  // Each triangle shares an edge with an earlier one, or begins anew.
  for (std::size_t count = 1 + in.below(20); count > 0; --count) {
    std::vector<std::uint32_t> triangle(3);
    for (auto& corner : triangle) corner = static_cast<std::uint32_t>(in.below(points.size()));
    if (!mesh.polygons.empty() && in.below(4) != 0) {
      const auto& before = mesh.polygons[in.below(mesh.polygons.size())];
      const std::size_t k = in.below(3);
      triangle[0] = before[(k + 1) % 3];
      triangle[1] = before[k];
    }
    mesh.polygons.push_back(std::move(triangle));
  }
  return mesh;
}
