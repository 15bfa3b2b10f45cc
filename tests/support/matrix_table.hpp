// SPDX-License-Identifier: MIT
// matrix_table.hpp - an adjacency matrix as text, to be compared with what was written by hand.
#pragma once
#include <optional>
#include <string>

#include "convexact/dual.hpp"

namespace convexact {

/// A row per line, '.' where unset.
inline std::string table_of(const AdjacencyMatrix& matrix) {
  const std::size_t width = std::to_string(matrix.size() == 0 ? 0 : matrix.size() - 1).size();
  std::string table;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      const std::optional<HalfspaceId> k = matrix.at(HalfspaceId(i), HalfspaceId(j));
      const std::string cell = k ? std::to_string(k->value) : ".";
      if (j > 0) table += ' ';
      table.append(width - cell.size(), ' ').append(cell);
    }
    table += '\n';
  }
  return table;
}

}  // namespace convexact
