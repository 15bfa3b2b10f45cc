// SPDX-License-Identifier: MIT
// json_parts.hpp - exact numbers, planes and points as JSON: strings.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>

#include "convexact/format/result_json.hpp"
#include "convexact/geometry/halfspace.hpp"

namespace convexact {

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
