// SPDX-License-Identifier: MIT
// ine.hpp - lists of halfspaces as .ine, the H-representation of cdd and lrs.
#pragma once
#include "convexact/io.hpp"

namespace convexact {

/// Reads a file of dimension three. A row (b, a1, a2, a3) means b + a.x >= 0, so n = -a and d = -b.
/// Integers and fractions are exact; decimals (type real only) are read by `decimal`. Options
/// before `begin` and behind `end` are ignored, except for those that turn rows into equations or
/// strict inequalities.
/// @throws Error Malformed with the line, also for a V-representation, another dimension or
///               linearity; NotFinite for decimals beyond the largest double.
/// @par Source   [Fukuda-cddlib, sec. 2], [Avis-lrs]
[[nodiscard]] HalfspaceList read_ine(std::string_view bytes, Decimal decimal);

/// Rows of type integer.
[[nodiscard]] std::string write_ine(std::span<const Halfspace> halfspaces);
/// Rows of type real.
[[nodiscard]] std::string write_ine(std::span<const BinaryHalfspace> halfspaces);

}  // namespace convexact
