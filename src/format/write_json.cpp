// SPDX-License-Identifier: MIT
#include "convexact/format/write_json.hpp"

#include <nlohmann/json.hpp>

namespace convexact {

using nlohmann::ordered_json;

std::string write_json(const ordered_json& document, int indent) {
  return document.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

std::string as_utf8(const std::string& text) {
  return ordered_json::parse(write_json(text)).get<std::string>();
}

}  // namespace convexact
