// SPDX-License-Identifier: MIT
// request_line.hpp - the common parts of the requests of `verify --stdio` and `decompose --stdio`:
// their id, points, numbers and time limit, and the answers to faults.
#pragma once
#include <functional>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/number.hpp"
#include "convexact/scene.hpp"
#include "io/json_document.hpp"
#include "io/names.hpp"
#include "wire/field.hpp"

namespace convexact {

/// @throws Error Malformed: "expected ..."
[[noreturn]] void reject_request(const std::string& expected);

/// @throws Error Malformed unless `object` is an object without any other key than those known and
///               the names of fields.
void require_known_keys(const nlohmann::json& object, std::initializer_list<const char*> known,
                        const char* what, const BoundFields& fields = {});

/// Gives each field whose name is a key of the object its value: a flag is true or false, a count
/// a number, a choice its word, or the number that the word spells, and a text a string or a
/// number.
/// @throws Error Malformed for any other value; as Field::read.
void read_fields(const nlohmann::json& object, const BoundFields& fields);

/// The number, or true or false, under a key, if the request has it. @throws Error Malformed.
[[nodiscard]] std::optional<std::size_t> count_in(const nlohmann::json& request, const char* key);
[[nodiscard]] std::optional<bool> flag_in(const nlohmann::json& request, const char* key);

/// The text under a key, if the request has it. @throws Error Malformed.
[[nodiscard]] std::optional<std::string> word_in(const nlohmann::json& request, const char* key);

/// The texts under a key, none if the request does not have it. @throws Error Malformed unless it
/// is a list of texts that are `accepted`: "expected `expected`, found ...".
[[nodiscard]] std::vector<std::string> texts_in(
    const nlohmann::json& request, const char* key, const std::string& expected,
    const std::function<bool(const std::string&)>& accepted);

/// One of a few words under a key, if the request has it. @throws Error Malformed.
template <class Value, std::size_t N>
std::optional<Value> choice_in(const nlohmann::json& request, const char* key,
                               const NameTable<Value, N>& table) {
  const std::optional<std::string> word = word_in(request, key);
  if (!word) return std::nullopt;
  if (const std::optional<Value> value = value_in(table, *word)) return value;
  std::string names;
  for (const auto& entry : table) {
    names += (names.empty() ? "" : " or ") + std::string(entry.second);
  }
  reject_request(std::string(key) + " as " + names);
}

/// The text of a string, or of a number below a spelled key (JsonDocument).
/// @throws Error Malformed for any other value.
[[nodiscard]] std::string_view number_text(const nlohmann::json& value);

/// The meaning of numbers according to `decimal` and `numbers`. @throws Error Malformed.
[[nodiscard]] Decimal decimal_of(const nlohmann::json& request);

/// The points of a request. @throws Error as coordinate_of_json() and points_of_json().
[[nodiscard]] PointSet points_of_request(const nlohmann::json& request, Decimal decimal);

/// A number of a plane, as in a list of halfspaces: integers, fractions and hexadecimal floats are
/// exact. @throws Error Malformed.
[[nodiscard]] Rational coefficient_of_json(const nlohmann::json& value, Decimal decimal);

/// The shorter one of the limits of the caller and of the request, in seconds.
/// @throws Error Malformed.
[[nodiscard]] std::optional<double> time_limit_of(const nlohmann::json& request,
                                                  std::optional<double> limit);

/// {"error": ...} with the proof that the input encloses no volume.
[[nodiscard]] Json not_solid_answer(const NotSolid& reason);

/// Answers a line with one line, without its line end: the request's id, then the text that
/// `answer` returns for the request, which is an object with a key, on one line. Each Error is an
/// answer, too.
/// @param spelled  Keys below which numbers are kept as their text, "id" among them.
[[nodiscard]] std::string answer_line(
    std::string_view line, std::initializer_list<std::string_view> spelled,
    const std::function<std::string(const nlohmann::json& request)>& answer);

}  // namespace convexact
