// SPDX-License-Identifier: MIT
// halfspace_list.hpp - halfspaces as somebody lists them: row by row, the meaningless rows apart.
#pragma once
#include <optional>
#include <vector>

#include "convexact/geometry/halfspace.hpp"

namespace convexact {

/// Where the halfspaces of a list stand in its file, and how they were typed.
struct TypedRows {
  std::vector<std::size_t> rows;  ///< rows[k]: the row of halfspaces[k], counted from 1.
  std::vector<Rational> scales;   ///< halfspaces[k] = scales[k] > 0 times that row as typed.
};

/// Halfspaces n.x + d <= 0 in the order of a file. A row with n = 0 bounds nothing: it holds
/// everywhere if d <= 0, and is dropped; else nowhere, so that the whole list is empty.
struct HalfspaceList : TypedRows {
  std::vector<Halfspace> halfspaces;
  std::vector<std::size_t> trivial_rows;  ///< Rows with n = 0, d <= 0.
  std::optional<std::size_t>
      impossible_row;  ///< The first row with n = 0, d > 0: 0 <= -d is false.

  /// Appends the next row, whichever of the three it is.
  void add(const RationalVector3& normal, const Rational& offset);
  std::size_t row_count() const { return row_count_; }

 private:
  std::size_t row_count_ = 0;
};

}  // namespace convexact
