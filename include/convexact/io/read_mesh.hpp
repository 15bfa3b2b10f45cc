// SPDX-License-Identifier: MIT
// read_mesh.hpp - meshes from OBJ, OFF, PLY and STL; docs/formats.md says what of each is read.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "convexact/io/mesh.hpp"
#include "convexact/io/mesh_format.hpp"
#include "convexact/number/decimal.hpp"

namespace convexact {

struct ReadOptions {
  /// What the decimals of text formats mean; Nearest32 rounds the numbers of binary formats too.
  Decimal decimal = Decimal::Nearest;
  /// Unset: by the path's extension if it is a known one, else by content.
  std::optional<MeshFormat> format = {};
};

/// The mesh that the bytes of a file spell.
/// @throws Error Malformed, naming line (binary: byte offset) and what was expected; NotFinite for
///         NaN, infinity and numbers beyond the largest double or, if asked, binary32 number.
/// @par Cost  Linear. A declared count is compared with the size of the input before anything is
///            allocated for it, so memory is linear in the bytes too.
[[nodiscard]] Mesh read_mesh_bytes(std::string_view bytes, const ReadOptions& options = {});

/// The mesh in a file; "-" is standard input.
/// @throws Error as read_mesh_bytes, with the path in front; Unreadable as read_bytes.
[[nodiscard]] Mesh read_mesh(const std::string& path, const ReadOptions& options = {});

}  // namespace convexact
