// SPDX-License-Identifier: MIT
#include "io/ply_header.hpp"

#include <algorithm>
#include <utility>

#include "number/text.hpp"

namespace convexact {
namespace {

PlyType to_type(std::string_view token, const TextCursor& cursor) {
  constexpr std::pair<std::string_view, PlyType> kTypes[] = {
      {"float", PlyType::Float32},   {"float32", PlyType::Float32}, {"double", PlyType::Float64},
      {"float64", PlyType::Float64}, {"char", PlyType::Int8},       {"int8", PlyType::Int8},
      {"uchar", PlyType::UInt8},     {"uint8", PlyType::UInt8},     {"short", PlyType::Int16},
      {"int16", PlyType::Int16},     {"ushort", PlyType::UInt16},   {"uint16", PlyType::UInt16},
      {"int", PlyType::Int32},       {"int32", PlyType::Int32},     {"uint", PlyType::UInt32},
      {"uint32", PlyType::UInt32}};
  const auto found = std::find_if(std::begin(kTypes), std::end(kTypes),
                                  [&](const auto& entry) { return entry.first == token; });
  if (found == std::end(kTypes)) cursor.fail_expected("a PLY type such as float or int", token);
  return found->second;
}

std::optional<ByteOrder> read_format(TextCursor& cursor) {
  const std::string_view format = cursor.expect_token("ascii or a binary byte order");
  std::optional<ByteOrder> order;
  if (format == "binary_little_endian") {
    order = ByteOrder::Little;
  } else if (format == "binary_big_endian") {
    order = ByteOrder::Big;
  } else if (format != "ascii") {
    cursor.fail_expected("ascii, binary_little_endian or binary_big_endian", format);
  }
  const std::string_view version = cursor.token();
  if (version != "1.0") cursor.fail_expected("version 1.0", version);
  return order;
}

PlyElement read_element(TextCursor& cursor, const PlyHeader& header) {
  PlyElement element;
  element.name = cursor.expect_token("the name of an element");
  if (header.find(element.name) != nullptr) {
    cursor.fail("expected each element once, found " + in_quotes(element.name) + " again");
  }
  constexpr std::string_view kCount = "the number of elements";
  element.count = cursor.to_count(cursor.expect_token(kCount), kCount);
  return element;
}

PlyProperty read_property(TextCursor& cursor, const PlyElement& element) {
  PlyProperty property;
  std::string_view type = cursor.expect_token("a type or list");
  if (type == "list") {
    const std::string_view count = cursor.expect_token("a type");
    property.count_type = to_type(count, cursor);
    if (!is_integer(*property.count_type)) cursor.fail_expected("an integer type", count);
    type = cursor.expect_token("a type");
  }
  property.type = to_type(type, cursor);
  property.name = cursor.expect_token("the name of a property");
  for (const PlyProperty& other : element.properties) {
    if (other.name == property.name) {
      cursor.fail("expected each property once, found " + in_quotes(property.name) + " again");
    }
  }
  return property;
}

// The body starts after a line end of the same kind as that of the first line: in a file whose
// lines end with "\r", the bytes "\r\n" are a line end and a byte of data.
std::size_t body_offset(std::string_view bytes, std::size_t header_end) {
  const std::size_t first = bytes.find_first_of("\r\n");
  const bool two = bytes.substr(first, 2) == "\r\n" && bytes.substr(header_end, 2) == "\r\n";
  return std::min(header_end + (two ? 2 : 1), bytes.size());
}

}  // namespace

const PlyElement* PlyHeader::find(std::string_view element) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const PlyElement& e) { return e.name == element; });
  return found == elements.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(std::string_view bytes, TextCursor& cursor) {
  if (const auto magic = cursor.expect_line("ply"); magic != "ply") {
    cursor.fail_expected("ply", magic);
  }
  cursor.expect_line_end();
  if (const auto format = cursor.expect_line("format"); format != "format") {
    cursor.fail_expected("format", format);
  }
  PlyHeader header;
  header.binary = read_format(cursor);
  cursor.expect_line_end();
  while (true) {
    const std::string_view keyword = cursor.expect_line("end_header");
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "element") {
      header.elements.push_back(read_element(cursor, header));
    } else if (keyword == "property" && !header.elements.empty()) {
      PlyElement& element = header.elements.back();
      element.properties.push_back(read_property(cursor, element));
    } else if (keyword != "end_header") {
      cursor.fail_expected("element, property, comment or end_header", keyword);
    }
    if (keyword == "end_header") break;
    cursor.expect_line_end();
  }
  header.body = body_offset(bytes, cursor.offset());
  return header;
}

}  // namespace convexact
