// SPDX-License-Identifier: MIT
// cells.hpp - meshes and parts of grid cells, whose coverage and volumes can be counted by hand.
#pragma once
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "convexact/io.hpp"
#include "convexact/verify_parts.hpp"

namespace support {

using convexact::Mesh;
using convexact::Point;
using convexact::PointSet;

/// The unit cube [x, x + 1] x [y, y + 1] x [z, z + 1].
using Cell = std::array<int, 3>;

/// An axis-aligned box.
struct Box {
  std::array<double, 3> low, high;
};

/// Corners by the bits of their numbers, and faces counter-clockwise from outside.
inline const std::vector<std::vector<std::uint32_t>>& box_faces() {
  static const std::vector<std::vector<std::uint32_t>> faces = {
      {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return faces;
}

inline std::vector<Point> box_corners(const Box& box) {
  std::vector<Point> corners;
  for (int k = 0; k < 8; ++k) {
    corners.emplace_back((k & 1 ? box.high : box.low)[0], (k & 2 ? box.high : box.low)[1],
                         (k & 4 ? box.high : box.low)[2]);
  }
  return corners;
}

inline Mesh box_mesh(const Box& box) {
  return {PointSet(box_corners(box)), box_faces(), {{"", 0, 6}}};
}

/// The boundary of the union of cells, as squares: those faces of cells with no other cell beside
/// them.
inline Mesh mesh_of_cells(const std::set<Cell>& cells) {
  std::vector<Point> points;
  std::map<std::array<int, 3>, std::uint32_t> ids;
  Mesh mesh;
  for (const Cell& cell : cells) {
    for (int face = 0; face < 6; ++face) {
      Cell beside = cell;
      beside[face / 2] += face % 2 == 0 ? -1 : 1;
      if (cells.contains(beside)) continue;
      auto& polygon = mesh.polygons.emplace_back();
      for (const std::uint32_t corner : box_faces()[face]) {
        std::array<int, 3> at = cell;
        for (int axis = 0; axis < 3; ++axis) at[axis] += corner >> axis & 1;
        const auto [entry, is_new] = ids.try_emplace(at, std::uint32_t(points.size()));
        if (is_new) points.emplace_back(at[0], at[1], at[2]);
        polygon.push_back(entry->second);
      }
    }
  }
  mesh.parts = {{"", 0, mesh.polygons.size()}};
  mesh.points = PointSet(points);
  return mesh;
}

inline std::vector<convexact::NamedPart> parts_of_boxes(const std::vector<Box>& boxes) {
  std::vector<convexact::NamedPart> parts;
  for (const Box& box : boxes) {
    parts.push_back({"box_" + std::to_string(parts.size()), box_mesh(box)});
  }
  return parts;
}

/// A cell as a box.
inline Box box_of(const Cell& c) {
  return {{double(c[0]), double(c[1]), double(c[2])},
          {double(c[0] + 1), double(c[1] + 1), double(c[2] + 1)}};
}

inline std::vector<Box> boxes_of(const std::set<Cell>& cells) {
  std::vector<Box> boxes;
  for (const Cell& cell : cells) boxes.push_back(box_of(cell));
  return boxes;
}

// The shapes of design pages: cells of height 1.
inline std::set<Cell> l_cells() { return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}; }
inline std::set<Cell> ring_cells() {
  std::set<Cell> cells;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (x != 1 || y != 1) cells.insert({x, y, 0});
    }
  }
  return cells;
}
/// Seven cells: one in the middle, and one on each of its faces.
inline std::set<Cell> cross_cells() {
  return {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

}  // namespace support
