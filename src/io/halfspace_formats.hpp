// SPDX-License-Identifier: MIT
// halfspace_formats.hpp - lists of halfspaces as JSON, as .ine and as plain rows: readers and
// writers.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "convexact/geometry.hpp"
#include "convexact/io.hpp"

namespace convexact {

// JSON.

/// Reads {"halfspaces": [[n1, n2, n3, d], ...]}, or the array alone. Each number is a JSON number
/// or a string that holds one or a fraction "p/q"; a number spelled with a point or an exponent is
/// read by `decimal`, any other is exact. Other keys of the object are ignored, so a trace can be
/// read, too.
/// @throws Error Malformed with the line (for a number, the line of its row's opening bracket) and
///               for a list without a row; NotFinite for decimals beyond the largest double.
[[nodiscard]] HalfspaceList read_halfspaces_json(std::string_view bytes, Decimal decimal);

/// Integers as strings, since JSON readers round large numbers; one halfspace per line.
[[nodiscard]] std::string write_halfspaces_json(std::span<const Halfspace> halfspaces);
/// Doubles as JSON numbers.
[[nodiscard]] std::string write_halfspaces_json(std::span<const BinaryHalfspace> halfspaces);

// .ine, the H-representation of cdd and lrs.

/// Reads a file of dimension three. A row (b, a1, a2, a3) means b + a.x >= 0, so n = -a and d = -b.
/// A row of a linearity is an equation: its other halfspace follows all rows. The rest as
/// read_polyhedron_table().
/// @throws Error As read_polyhedron_table().
/// @par Source   [Fukuda-cddlib, sec. 2], [Avis-lrs]
[[nodiscard]] HalfspaceList read_ine(std::string_view bytes, Decimal decimal);

/// Rows of type integer.
[[nodiscard]] std::string write_ine(std::span<const Halfspace> halfspaces);
/// Rows of type real.
[[nodiscard]] std::string write_ine(std::span<const BinaryHalfspace> halfspaces);

// Plain text, the format for writing by hand.

/// Reads one halfspace n1 x + n2 y + n3 z + d <= 0 from each line "n1 n2 n3 d". Integers and
/// fractions are exact; a number spelled with a point or an exponent is read by `decimal`. A token
/// that starts with # ends its line. The lines "4" and a count in front, as qhull's option n writes
/// them, are read, too.
/// @throws Error Malformed with the line, also if there is no row at all; NotFinite for decimals
///               beyond the largest double.
[[nodiscard]] HalfspaceList read_halfspace_rows(std::string_view bytes, Decimal decimal);

/// A row of integers for each halfspace.
[[nodiscard]] std::string write_halfspace_rows(std::span<const Halfspace> halfspaces);
/// The same for finite doubles, as shortest decimals.
[[nodiscard]] std::string write_halfspace_rows(std::span<const BinaryHalfspace> halfspaces);

}  // namespace convexact
