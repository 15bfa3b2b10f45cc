// SPDX-License-Identifier: MIT
// polyhedron_table.hpp - the table between begin and end in files of cdd and lrs, of either
// representation.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "convexact/number.hpp"

namespace convexact {

enum class Representation {
  H,  ///< A row b a1 a2 a3 is the inequality b + a.x >= 0.
  V,  ///< A row 1 x y z is a point, a row 0 x y z a ray.
};

struct PolyhedronTable {
  std::vector<std::array<Rational, 4>> rows;
  std::vector<std::size_t> linear = {};  ///< Rows of a linearity: equations, or lines.

  bool is_linear(std::size_t row) const {
    return std::find(linear.begin(), linear.end(), row) != linear.end();
  }
};

/// Reads a table of four columns. Integers and fractions are exact; decimals (type real only) are
/// read by `decimal`. The number of rows may be "*****", as lrs writes it. Other options before
/// `begin` and after `end` are ignored, except for those that make inequalities strict.
/// @throws Error Malformed with the line, also for the other representation, another dimension and
///               no row at all; NotFinite for decimals beyond the largest double.
/// @par Source   [Fukuda-cddlib, sec. 2], [Avis-lrs]
[[nodiscard]] PolyhedronTable read_polyhedron_table(std::string_view bytes, Decimal decimal,
                                                    Representation wanted);

}  // namespace convexact
