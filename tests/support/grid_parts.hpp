// SPDX-License-Identifier: MIT
// grid_parts.hpp - convex parts that together hold a mesh's faces: a hull for each cell of a grid.
#pragma once
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "convexact/io.hpp"
#include "convexact/overlay.hpp"

/// The hulls of the faces by cell, `cells` along the longest side of the box. A face belongs to the
/// cell of the mean of its corners, and to each cell within `margin` cells of it: parts overlap by
/// their faces' sizes at margin 0, and by more above.
inline std::vector<convexact::ConvexPart> grid_parts(const convexact::Mesh& mesh, int cells,
                                                     double margin) {
  using namespace convexact;
  const auto points = mesh.points.doubles();
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).maxCoeff() / cells;
  std::map<std::array<int, 3>, std::vector<Point>> by_cell;
  for (const auto& polygon : mesh.polygons) {
    Point mean = Point::Zero();
    for (const std::uint32_t i : polygon) mean += points[i];
    mean /= static_cast<double>(polygon.size());
    std::array<int, 3> first{}, last{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double at = (mean[axis] - low[axis]) / size;
      first[k] = static_cast<int>(std::floor(at - margin));
      last[k] = static_cast<int>(std::floor(at + margin));
    }
    for (int x = first[0]; x <= last[0]; ++x) {
      for (int y = first[1]; y <= last[1]; ++y) {
        for (int z = first[2]; z <= last[2]; ++z) {
          auto& list = by_cell[{x, y, z}];
          for (const std::uint32_t i : polygon) list.push_back(points[i]);
        }
      }
    }
  }
  std::vector<ConvexPart> parts;
  for (const auto& [cell, list] : by_cell) parts.push_back(convex_part(PointSet(list)));
  return parts;
}
