// SPDX-License-Identifier: MIT
// mesh.hpp - what a mesh file holds: points, polygons and named parts.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "convexact/geometry/point_set.hpp"

namespace convexact {

/// A named part of a file: the polygons [first, last) under one `o` or `g` line of an OBJ, or one
/// `solid` of an STL. Other formats have a single part with an empty name.
struct MeshPart {
  std::string name;
  std::size_t first_polygon;
  std::size_t last_polygon;
};

/// Points and polygons as the file gives them; polygons index points from 0.
struct Mesh {
  PointSet points;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<MeshPart> parts;
};

}  // namespace convexact
