// SPDX-License-Identifier: MIT
#include "io/json.hpp"

#include "io/names.hpp"

namespace convexact {

using nlohmann::ordered_json;

std::string write_json(const ordered_json& document, int indent) {
  return document.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

std::string write_lines(const ordered_json& document) {
  std::string text = "{";
  const char* comma = "\n";
  for (const auto& [key, value] : document.items()) {
    text += comma + write_json(key) + ": ";
    comma = ",\n";
    const bool is_list = value.is_array() && !value.empty() && value[0].is_structured();
    if (!is_list) {
      text += write_json(value);
      continue;
    }
    for (std::size_t k = 0; k < value.size(); ++k) {
      text += (k == 0 ? "[\n  " : ",\n  ") + write_json(value[k]);
    }
    text += "\n]";
  }
  return text + "\n}\n";
}

std::string as_utf8(const std::string& text) {
  return ordered_json::parse(write_json(text)).get<std::string>();
}

namespace {

constexpr auto kErrorNames =
    name_table<ErrorCode>({{ErrorCode::InvalidArgument, "invalid-argument"},
                           {ErrorCode::Unreadable, "unreadable"},
                           {ErrorCode::Malformed, "malformed"},
                           {ErrorCode::NotFinite, "not-finite"},
                           {ErrorCode::NoInterior, "no-interior"},
                           {ErrorCode::Unwritable, "unwritable"},
                           {ErrorCode::Unrepresentable, "unrepresentable"},
                           {ErrorCode::Stopped, "stopped"},
                           {ErrorCode::Internal, "internal"}});

}  // namespace

nlohmann::ordered_json error_json(const Error& error) {
  nlohmann::ordered_json json = {{"code", name_in(kErrorNames, error.code())},
                                 {"message", error.what()},
                                 {"exit", exit_code(error.code())}};
  if (error.line()) json["line"] = *error.line();
  return json;
}

nlohmann::ordered_json measured_json(const Measured& x, int digits) {
  const std::optional<std::string> decimal = to_decimal(x.bounds, digits);
  if (!decimal) throw Error(ErrorCode::Internal, "the bounds of a measure are too wide to print");
  const double value = to_double(parse_rational(*decimal), Rounding::Nearest);
  nlohmann::ordered_json json = {{"value", value_or_null(value)}, {"decimal", *decimal}};
  if (x.exact) json["exact"] = to_string(*x.exact);
  return json;
}

}  // namespace convexact
