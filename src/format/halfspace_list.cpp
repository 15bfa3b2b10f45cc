// SPDX-License-Identifier: MIT
#include "convexact/format/halfspace_list.hpp"

#include "../io/text_cursor.hpp"
#include "convexact/format/halfspace_json.hpp"
#include "convexact/format/ine.hpp"
#include "convexact/io/read_bytes.hpp"

namespace convexact {

void HalfspaceList::add(const RationalVector3& normal, const Rational& offset) {
  ++row_count_;
  if (normal != RationalVector3::Zero()) {
    halfspaces.emplace_back(normal, offset);
    rows.push_back(row_count_);
  } else if (offset <= 0) {
    trivial_rows.push_back(row_count_);
  } else if (!impossible_row) {
    impossible_row = row_count_;
  }
}

std::optional<HalfspaceFormat> halfspace_format_of_path(const std::string& path) {
  const auto ends_with = [&path](std::string_view extension) {
    if (path.size() < extension.size()) return false;
    const std::size_t start = path.size() - extension.size();
    for (std::size_t k = 0; k < extension.size(); ++k) {
      const char c = path[start + k];
      if (c != extension[k] && !(c >= 'A' && c <= 'Z' && c + 32 == extension[k])) return false;
    }
    return true;
  };
  if (ends_with(".json")) return HalfspaceFormat::Json;
  if (ends_with(".ine")) return HalfspaceFormat::Ine;
  return {};
}

std::optional<HalfspaceFormat> halfspace_format_of_content(std::string_view bytes) {
  TextCursor cursor(bytes.substr(0, 4096), {.comment = '*'});
  for (bool first = true; cursor.next_line(); first = false) {
    const std::string_view token = cursor.token();
    if (first && (token.front() == '{' || token.front() == '[')) return HalfspaceFormat::Json;
    if (token == "H-representation" || token == "begin") return HalfspaceFormat::Ine;
  }
  return {};
}

HalfspaceList read_halfspaces_bytes(std::string_view bytes, HalfspaceFormat format,
                                    Decimal decimal) {
  return format == HalfspaceFormat::Json ? read_halfspaces_json(bytes, decimal)
                                         : read_ine(bytes, decimal);
}

HalfspaceList read_halfspaces(const std::string& path, HalfspaceFormat format, Decimal decimal) {
  const std::string bytes = read_bytes(path);
  try {
    return read_halfspaces_bytes(bytes, format, decimal);
  } catch (const Error& error) {
    throw error.in_file(display_name(path));
  }
}

std::string write_halfspaces(std::span<const Halfspace> halfspaces, HalfspaceFormat format) {
  return format == HalfspaceFormat::Json ? write_halfspaces_json(halfspaces)
                                         : write_ine(halfspaces);
}

std::string write_halfspaces(std::span<const BinaryHalfspace> halfspaces, HalfspaceFormat format) {
  return format == HalfspaceFormat::Json ? write_halfspaces_json(halfspaces)
                                         : write_ine(halfspaces);
}

}  // namespace convexact
