// SPDX-License-Identifier: MIT
// mesh.hpp - the contents of a mesh file, and the formats.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "convexact/point_set.hpp"

namespace convexact {

/// A named part of a file: the polygons [first, last) under one `o` or `g` line of an OBJ, or one
/// `solid` of an STL. Other formats have a single part with an empty name. A part is the points of
/// its polygons and its loose points.
struct MeshPart {
  std::string name;
  std::size_t first_polygon;
  std::size_t last_polygon;
  /// Of an OBJ with `o` or `g`: the points under that line which no polygon of the file uses,
  /// ascending. A part may have nothing else.
  std::vector<std::uint32_t> loose = {};
};

/// Points and polygons as the file gives them; polygons index points from 0.
struct Mesh {
  PointSet points;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<MeshPart> parts;
};

/// Which points of a mesh count.
enum class MeshPoints {
  All,
  Used,  ///< Those that some polygon has as a corner. Without polygons, a mesh is its points.
};

/// For each of so many points, whether some polygon has it as a corner.
[[nodiscard]] std::vector<bool> used_points(std::size_t count,
                                            std::span<const std::vector<std::uint32_t>> polygons);

/// Leaves out the points that no polygon uses, and numbers the others anew, in their order. A mesh
/// without polygons stays as it is.
void drop_unused_points(Mesh& mesh);

enum class MeshFormat {
  Obj,
  Off,
  Ply,
  Stl,
  Xyz,  ///< Points only.
};

/// By the extension .obj, .off, .ply, .stl or .xyz in any case; nothing for any other path.
[[nodiscard]] std::optional<MeshFormat> mesh_format_of_path(const std::string& path);

/// By the first bytes, and for a binary STL by its size; OBJ if no other format matches.
[[nodiscard]] MeshFormat mesh_format_of_content(std::string_view bytes);

}  // namespace convexact
