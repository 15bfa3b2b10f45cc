// SPDX-License-Identifier: MIT
#include "wire/request_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"
#include "wire/field.hpp"
#include "wire/json_mesh.hpp"
#include "wire/stage_report.hpp"

namespace convexact {

using nlohmann::json;

void reject_request(const std::string& expected) {
  throw Error(ErrorCode::Malformed, "expected " + expected);
}

void require_known_keys(const json& object, std::initializer_list<const char*> known,
                        const char* what, const BoundFields& fields) {
  if (!object.is_object()) reject_request(std::string(what) + " as an object");
  for (const auto& entry : object.items()) {
    const std::string& key = entry.key();
    const bool is_field = std::any_of(fields.begin(), fields.end(), [&](const BoundField& field) {
      return field.info->name == key;
    });
    if (!is_field && std::find(known.begin(), known.end(), key) == known.end()) {
      reject_request(std::string("only known keys in ") + what + ", found '" + key + "'");
    }
  }
}

namespace {

// The value of a field as users spell it.
std::string spelled_value(const FieldInfo& field, const json& value) {
  switch (field.kind) {
    case FieldKind::Flag:
      if (!value.is_boolean()) reject_request(field.name + " as true or false");
      return value.get<bool>() ? "true" : "false";
    case FieldKind::Count:
      if (!value.is_number_unsigned()) reject_request(field.name + " as a count");
      return dump_json(value);
    case FieldKind::Choice:
      break;
    case FieldKind::Text:
      return std::string(number_text(value));
  }
  const bool are_numbers = std::isdigit(static_cast<unsigned char>(field.words.front()[0])) != 0;
  const bool has_type = are_numbers ? value.is_number_unsigned() : value.is_string();
  std::string word = !has_type ? "" : are_numbers ? dump_json(value) : value.get<std::string>();
  if (std::find(field.words.begin(), field.words.end(), word) == field.words.end()) {
    reject_request(fmt::format("{} as {}", field.name, fmt::join(field.words, " or ")));
  }
  return word;
}

}  // namespace

void read_fields(const json& object, const BoundFields& fields) {
  for (const auto& [info, read, present] : fields) {
    if (object.contains(info->name)) read(info->name, spelled_value(*info, object[info->name]));
  }
}

std::optional<std::size_t> count_in(const json& request, const char* key) {
  if (!request.contains(key)) return std::nullopt;
  if (!request[key].is_number_unsigned()) reject_request(std::string(key) + " as a count");
  return narrowed<std::size_t>(request[key].get<std::uint64_t>());
}

std::optional<bool> flag_in(const json& request, const char* key) {
  if (!request.contains(key)) return std::nullopt;
  if (!request[key].is_boolean()) reject_request(std::string(key) + " as true or false");
  return request[key].get<bool>();
}

std::vector<std::string> texts_in(const json& request, const char* key, const std::string& expected,
                                  const std::function<bool(const std::string&)>& accepted) {
  const auto list = request.find(key);
  if (list == request.end()) return {};
  const auto refuse = [&](const json& found) {
    reject_request(expected + ", found " + in_quotes(dump_json(found)));
  };
  if (!list->is_array()) refuse(*list);
  std::vector<std::string> texts;
  for (const json& text : *list) {
    if (!text.is_string() || !accepted(text.get<std::string>())) refuse(text);
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

std::optional<std::string> word_in(const json& request, const char* key) {
  if (!request.contains(key)) return std::nullopt;
  if (!request[key].is_string()) reject_request(std::string(key) + " as a string");
  return request[key].get<std::string>();
}

std::string_view number_text(const json& value) {
  const std::string_view text = spelling_of(value);
  if (text.empty()) reject_request("a number, or a string that holds one");
  return text;
}

Decimal decimal_of(const json& request) {
  const json name = request.value("decimal", json("nearest"));
  if (name != "nearest" && name != "exact") reject_request("decimal as nearest or exact");
  const json numbers = request.value("numbers", json("binary64"));
  if (numbers != "binary64" && numbers != "binary32") {
    reject_request("numbers as binary64 or binary32");
  }
  if (numbers == "binary64") return name == "exact" ? Decimal::Exact : Decimal::Nearest;
  if (name == "exact") reject_request("decimals as nearest with numbers in binary32");
  return Decimal::Nearest32;
}

PointSet points_of_request(const json& request, Decimal decimal) {
  return points_of_json(request["points"], "point",
                        [&](const json& x) { return coordinate_of_json(x, decimal); });
}

Rational coefficient_of_json(const json& value, Decimal decimal) {
  const std::string_view text = number_text(value);
  return is_hex_float(text) ? parse_hex_float(text) : parse_number(text, decimal);
}

std::optional<double> time_limit_of(const json& request, std::optional<double> limit) {
  constexpr double kLongest = 1e6;
  if (!request.contains("time_limit")) return limit;
  const json& seconds = request["time_limit"];
  if (!seconds.is_number() || !(seconds > 0) || seconds > kLongest) {
    reject_request("time_limit as a number of seconds, more than 0 and at most a million");
  }
  return std::min(seconds.get<double>(), limit.value_or(kLongest));
}

Json not_solid_answer(const NotSolid& reason) {
  Json error = error_json(Error(ErrorCode::NoInterior, describe(reason)));
  error["proof"] = proof_json(reason);
  return {{"error", error}};
}

namespace {

// The id of a request as it goes into the answer: a number as spelled, and empty if there is none.
std::string id_text(const json& request) {
  if (!request.is_object() || !request.contains("id")) return {};
  const json& id = request["id"];
  if (id.is_structured()) return {};
  return id.is_binary() ? std::string(spelling_of(id)) : dump_json(id);
}

std::string with_id(const json& request, const std::string& body) {
  const std::string id = id_text(request);
  return id.empty() ? body : "{\"id\":" + id + "," + body.substr(1);
}

// Invalid UTF-8 in a message is replaced, so that a line is always JSON.
std::string failure_text(const Error& error) {
  return write_json(Json{{"error", error_json(error)}});
}

void require_simple_id(const json& request) {
  if (request.is_object() && request.contains("id") && request["id"].is_structured()) {
    reject_request("an id that is a number, a string, true, false or null");
  }
}

}  // namespace

std::string answer_line(std::string_view line, std::initializer_list<std::string_view> spelled,
                        const std::function<std::string(const json& request)>& answer) {
  JsonDocument reader(spelled);
  try {
    parse_json_events(line, reader);
  } catch (const Error& error) {
    return with_id(
        reader.document,
        failure_text(Error(error.code(), std::string("not a request: ") + error.what())));
  }
  try {
    require_simple_id(reader.document);
    return with_id(reader.document, answer(reader.document));
  } catch (const Error& error) {
    return with_id(reader.document, failure_text(error));
  }
}

}  // namespace convexact
