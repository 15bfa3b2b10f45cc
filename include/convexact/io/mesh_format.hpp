// SPDX-License-Identifier: MIT
// mesh_format.hpp - the mesh formats, and how a file tells which one it is.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace convexact {

enum class MeshFormat {
  Obj,
  Off,
  Ply,
  Stl,
  Xyz,  ///< Points only.
};

/// By the extension .obj, .off, .ply, .stl or .xyz in any case; nothing for any other path.
[[nodiscard]] std::optional<MeshFormat> mesh_format_of_path(const std::string& path);

/// By the first bytes, and for a binary STL by its size; what nothing else claims is OBJ.
[[nodiscard]] MeshFormat mesh_format_of_content(std::string_view bytes);

}  // namespace convexact
