// SPDX-License-Identifier: MIT
// json.hpp - JSON as the program writes it: its text, and the forms of numbers, planes, points and
// errors.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "convexact/error.hpp"
#include "convexact/halfspace.hpp"
#include "number/precision.hpp"

// Exact numbers are strings, "p/q" or an integer; ids are numbers; a plane is its four integers.
template <>
struct nlohmann::adl_serializer<convexact::Rational> {
  template <class Json>
  static void to_json(Json& json, const convexact::Rational& x) {
    json = convexact::to_string(x);
  }
  template <class Json>
  static convexact::Rational from_json(const Json& json) {
    return convexact::parse_rational(json.template get_ref<const std::string&>());
  }
};

template <>
struct nlohmann::adl_serializer<convexact::HalfspaceId> {
  template <class Json>
  static void to_json(Json& json, convexact::HalfspaceId id) {
    json = id.index();
  }
  template <class Json>
  static convexact::HalfspaceId from_json(const Json& json) {
    return convexact::HalfspaceId(json.template get<std::size_t>());
  }
};

template <>
struct nlohmann::adl_serializer<convexact::Halfspace> {
  template <class Json>
  static void to_json(Json& json, const convexact::Halfspace& h) {
    using convexact::to_string;
    json = {to_string(h.normal()[0]), to_string(h.normal()[1]), to_string(h.normal()[2]),
            to_string(h.offset())};
  }
  template <class Json>
  static convexact::Halfspace from_json(const Json& json) {
    const auto number = [&json](std::size_t i) {
      return json.at(i).template get<convexact::Rational>();
    };
    return {convexact::RationalVector3(number(0), number(1), number(2)), number(3)};
  }
};

namespace convexact {

/// The text of a document, without a newline at its end. File names, option values and names of
/// objects are bytes: any part of them that is not UTF-8 becomes U+FFFD, since JSON allows nothing
/// else.
/// @param indent  Spaces for each level; -1 for all on one line.
[[nodiscard]] std::string write_json(const nlohmann::ordered_json& document, int indent = -1);

/// `text` as write_json() would spell it, for pages and tables.
[[nodiscard]] std::string as_utf8(const std::string& text);

/// {"code": "malformed", "message": one sentence, "exit": 3} and, if it is known, "line".
[[nodiscard]] nlohmann::ordered_json error_json(const Error& error);

/// {"value": nearest double of the digits, or null beyond the largest; "decimal": `digits` certain
/// digits} and, where it is known, "exact": "p/q". The bounds must be narrow enough for the digits.
[[nodiscard]] nlohmann::ordered_json measured_json(const Measured& x, int digits);

inline nlohmann::ordered_json plane_json(const Halfspace& h) { return h; }

inline nlohmann::ordered_json vector_json(const RationalVector3& v) {
  return {to_string(v[0]), to_string(v[1]), to_string(v[2])};
}

/// A value, or null.
template <class T>
nlohmann::ordered_json or_null(const std::optional<T>& x) {
  return x ? nlohmann::ordered_json(*x) : nlohmann::ordered_json(nullptr);
}

/// As many certain digits as a double needs.
inline constexpr int kDigits = 17;

/// An exact number with its decimal, or null.
inline nlohmann::ordered_json quantity_json(const std::optional<Rational>& x) {
  if (!x) return nullptr;
  return measured_json({Enclosure(*x, kMeasureBits), *x}, kDigits);
}

}  // namespace convexact
