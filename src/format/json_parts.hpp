// SPDX-License-Identifier: MIT
// json_parts.hpp - exact planes and points as JSON: arrays of strings.
#pragma once
#include <nlohmann/json.hpp>

#include "convexact/geometry/halfspace.hpp"

namespace convexact {

inline nlohmann::ordered_json plane_json(const Halfspace& h) {
  return {to_string(h.normal()[0]), to_string(h.normal()[1]), to_string(h.normal()[2]),
          to_string(h.offset())};
}

inline nlohmann::ordered_json vector_json(const RationalVector3& v) {
  return {to_string(v[0]), to_string(v[1]), to_string(v[2])};
}

}  // namespace convexact
