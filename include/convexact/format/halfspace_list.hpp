// SPDX-License-Identifier: MIT
// halfspace_list.hpp - what a file of halfspaces holds, and the files as such.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "convexact/geometry/halfspace.hpp"
#include "convexact/number/decimal.hpp"

namespace convexact {

/// Halfspaces n.x + d <= 0 in the order of a file. A row with n = 0 bounds nothing: it holds
/// everywhere if d <= 0, and is dropped; else nowhere, so that the whole list is empty.
struct HalfspaceList {
  std::vector<Halfspace> halfspaces;
  std::vector<std::size_t> rows;          ///< rows[k]: the row of halfspaces[k], counted from 1.
  std::vector<std::size_t> trivial_rows;  ///< Rows with n = 0, d <= 0.
  std::optional<std::size_t>
      impossible_row;  ///< The first row with n = 0, d > 0: 0 <= -d is false.

  /// Appends the next row, whichever of the three it is.
  void add(const RationalVector3& normal, const Rational& offset);
  std::size_t row_count() const { return row_count_; }

 private:
  std::size_t row_count_ = 0;
};

/// A halfspace in binary64 or binary32: n1, n2, n3, d.
using BinaryHalfspace = std::array<double, 4>;

enum class HalfspaceFormat {
  Json,  ///< {"halfspaces": [[n1, n2, n3, d], ...]}, see halfspace_json.hpp
  Ine,   ///< cdd and lrs, see ine.hpp
};

/// By the extension .json or .ine in any case; nothing for any other path.
[[nodiscard]] std::optional<HalfspaceFormat> halfspace_format_of_path(const std::string& path);

/// JSON if the first character opens an object or array; .ine if a line says so; else no
/// halfspaces.
[[nodiscard]] std::optional<HalfspaceFormat> halfspace_format_of_content(std::string_view bytes);

/// @throws Error as read_halfspaces_json and read_ine.
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
