// SPDX-License-Identifier: MIT
// halfspace_rows.hpp - lists of halfspaces as plain text, the form for writing by hand.
#pragma once
#include "convexact/io.hpp"

namespace convexact {

/// Reads one halfspace n1 x + n2 y + n3 z + d <= 0 from each line "n1 n2 n3 d". Integers and
/// fractions are exact; a number spelled with a point or an exponent is read by `decimal`. A token
/// that starts with # ends its line.
/// @throws Error Malformed with the line, also if there is no row at all; NotFinite for decimals
///               beyond the largest double.
[[nodiscard]] HalfspaceList read_halfspace_rows(std::string_view bytes, Decimal decimal);

/// A row of integers for each halfspace.
[[nodiscard]] std::string write_halfspace_rows(std::span<const Halfspace> halfspaces);
/// The same for finite doubles, as shortest decimals.
[[nodiscard]] std::string write_halfspace_rows(std::span<const BinaryHalfspace> halfspaces);

}  // namespace convexact
