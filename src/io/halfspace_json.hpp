// SPDX-License-Identifier: MIT
// halfspace_json.hpp - lists of halfspaces as JSON.
#pragma once
#include "convexact/io.hpp"

namespace convexact {

/// Reads {"halfspaces": [[n1, n2, n3, d], ...]}, or the array alone. Each number is a JSON number
/// or a string that holds one or a fraction "p/q"; a number spelled with a point or an exponent is
/// read by `decimal`, any other is exact. Other keys of the object are ignored, so a trace can be
/// read, too.
/// @throws Error Malformed with the line, for a number that of the row's opening bracket; NotFinite
///               for decimals beyond the largest double.
[[nodiscard]] HalfspaceList read_halfspaces_json(std::string_view bytes, Decimal decimal);

/// Integers as strings, since JSON readers round large numbers; one halfspace per line.
[[nodiscard]] std::string write_halfspaces_json(std::span<const Halfspace> halfspaces);
/// Doubles as JSON numbers.
[[nodiscard]] std::string write_halfspaces_json(std::span<const BinaryHalfspace> halfspaces);

}  // namespace convexact
