// SPDX-License-Identifier: MIT
// json.hpp - JSON as the program writes it: the forms of numbers, planes, points and errors.
#pragma once
#include <optional>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "io/json_document.hpp"
#include "number/precision.hpp"

namespace convexact {

/// {"code": "malformed", "message": one sentence, "exit": 3} and, if it is known, "line".
[[nodiscard]] Json error_json(const Error& error);

/// {"value": nearest double of the digits, or null beyond the largest; "decimal": `digits` certain
/// digits} and, where it is known, "exact": "p/q". The bounds must be narrow enough for the digits.
[[nodiscard]] Json measured_json(const Measured& x, int digits);

[[nodiscard]] Json plane_json(const Halfspace& h);
[[nodiscard]] Json vector_json(const RationalVector3& v);

/// A value, or null.
template <class T>
Json or_null(const std::optional<T>& x) {
  return x ? Json(*x) : Json(nullptr);
}

/// JSON has no infinity.
[[nodiscard]] Json value_or_null(double x);

/// The ends as the doubles around them.
[[nodiscard]] Json bounds_json(const Enclosure& x);

/// An exact number with its decimal, or null.
[[nodiscard]] Json quantity_json(const std::optional<Rational>& x);

}  // namespace convexact
