// SPDX-License-Identifier: MIT
// halfspace_file.hpp - files of halfspaces: JSON, .ine and plain rows.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "convexact/geometry/halfspace_list.hpp"
#include "convexact/number/decimal.hpp"

namespace convexact {

/// A halfspace in binary64 or binary32: n1, n2, n3, d.
using BinaryHalfspace = std::array<double, 4>;

enum class HalfspaceFormat {
  Json,  ///< {"halfspaces": [[n1, n2, n3, d], ...]}, see halfspace_json.hpp
  Ine,   ///< cdd and lrs, see ine.hpp
  Rows,  ///< Lines "n1 n2 n3 d", see halfspace_rows.hpp
};

/// By the extension .json, .ine or .txt in any case; nothing for any other path.
[[nodiscard]] std::optional<HalfspaceFormat> halfspace_format_of_path(const std::string& path);

/// JSON if the first character opens an object or array; .ine if a line says so; rows if the first
/// line that is not a comment has four numbers; else no halfspaces.
[[nodiscard]] std::optional<HalfspaceFormat> halfspace_format_of_content(std::string_view bytes);

/// @throws Error as read_halfspaces_json, read_ine and read_halfspace_rows.
[[nodiscard]] HalfspaceList read_halfspaces_bytes(std::string_view bytes, HalfspaceFormat format,
                                                  Decimal decimal = Decimal::Nearest);

/// @throws Error as read_halfspaces_bytes, with the path in front; Unreadable as read_bytes.
[[nodiscard]] HalfspaceList read_halfspaces(const std::string& path, HalfspaceFormat format,
                                            Decimal decimal = Decimal::Nearest);

/// The bytes from which the same halfspaces are read.
[[nodiscard]] std::string write_halfspaces(std::span<const Halfspace> halfspaces,
                                           HalfspaceFormat format);
/// The same for finite doubles, as shortest decimals: to be read with Decimal::Nearest.
[[nodiscard]] std::string write_halfspaces(std::span<const BinaryHalfspace> halfspaces,
                                           HalfspaceFormat format);

}  // namespace convexact
