// SPDX-License-Identifier: MIT
// json.hpp - JSON as the program writes it: its text, and what numbers, planes, points and errors
// look like.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "convexact/error.hpp"
#include "convexact/halfspace.hpp"

namespace convexact {

/// The text of a document, without a newline at its end. File names, option values and names of
/// objects are bytes: what is no UTF-8 in them becomes U+FFFD, since JSON knows nothing else.
/// @param indent  Spaces for each level; -1 for all on one line.
[[nodiscard]] std::string write_json(const nlohmann::ordered_json& document, int indent = -1);

/// `text` as write_json() would spell it, for pages and tables.
[[nodiscard]] std::string as_utf8(const std::string& text);

/// {"code": "malformed", "message": one sentence, "exit": 3} and, if it is known, "line".
[[nodiscard]] nlohmann::ordered_json error_json(const Error& error);

/// {"value": nearest double of the digits, or null beyond the largest; "decimal": `digits` certain
/// digits} and, where it is known, "exact": "p/q". The bounds must be narrow enough for the digits.
[[nodiscard]] nlohmann::ordered_json measured_json(const Measured& x, int digits);

inline nlohmann::ordered_json plane_json(const Halfspace& h) {
  return {to_string(h.normal()[0]), to_string(h.normal()[1]), to_string(h.normal()[2]),
          to_string(h.offset())};
}

inline nlohmann::ordered_json vector_json(const RationalVector3& v) {
  return {to_string(v[0]), to_string(v[1]), to_string(v[2])};
}

/// As many certain digits as a double needs.
inline constexpr int kDigits = 17;

/// An exact number with its decimal, or null.
inline nlohmann::ordered_json quantity_json(const std::optional<Rational>& x) {
  if (!x) return nullptr;
  return measured_json({Enclosure(*x, kVolumeBits), *x}, kDigits);
}

}  // namespace convexact
