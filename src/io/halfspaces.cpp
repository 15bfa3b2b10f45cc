// SPDX-License-Identifier: MIT
// Files of halfspaces in any format, and plain rows, the shortest of these.
#include <charconv>

#include "convexact/io.hpp"
#include "io/halfspace_formats.hpp"
#include "io/output_buffer.hpp"
#include "io/text_cursor.hpp"

namespace convexact {

namespace {

Rational to_number(std::string_view token, const TextCursor& cursor, Decimal decimal) {
  try {
    return parse_number(token, decimal);
  } catch (const Error& error) {
    cursor.fail(error.what(), error.code());
  }
}

}  // namespace

namespace {

// The number of rows, where a text begins as qhull's option n writes: the dimension and one more,
// then how many halfspaces there are, a line each. The cursor is after both then.
std::optional<std::uint32_t> read_qhull_counts(TextCursor& cursor) {
  TextCursor ahead = cursor;
  std::uint32_t counts[2];
  for (std::uint32_t& count : counts) {
    if (!ahead.next_line()) return {};
    const std::string_view token = ahead.token();
    // (A number that is too large is no count; the file is then read, or refused, as rows.)
    const char* const last = token.data() + token.size();
    const auto [end, failure] = std::from_chars(token.data(), last, count);
    if (failure != std::errc() || end != last || !ahead.token().empty()) return {};
  }
  if (counts[0] != 4) return {};
  cursor = ahead;
  return counts[1];
}

}  // namespace

HalfspaceList read_halfspace_rows(std::string_view bytes, Decimal decimal) {
  TextCursor cursor(bytes, {.comment = '#'});
  HalfspaceList list;
  const std::optional<std::uint32_t> announced = read_qhull_counts(cursor);
  while (cursor.next_line()) {
    RationalVector3 normal;
    for (int k = 0; k < 3; ++k) {
      normal[k] = to_number(cursor.expect_token("a row n1 n2 n3 d"), cursor, decimal);
    }
    const std::string_view last = cursor.token();
    if (last.empty()) {
      cursor.fail("expected a row n1 n2 n3 d, found three numbers; points are read from a .xyz");
    }
    const Rational offset = to_number(last, cursor, decimal);
    cursor.expect_line_end();
    list.add(normal, offset);
  }
  if (list.row_count() == 0) cursor.fail("expected rows n1 n2 n3 d, found none");
  if (announced && *announced != list.row_count()) {
    cursor.fail("expected " + std::to_string(*announced) +
                " halfspaces, as the second line says, " + "found " +
                std::to_string(list.row_count()));
  }
  return list;
}

std::string write_halfspace_rows(std::span<const Halfspace> halfspaces) {
  OutputBuffer out;
  for (const Halfspace& h : halfspaces) {
    for (const Integer& n : h.normal()) out.text(to_string(n)).text(" ");
    out.text(to_string(h.offset())).text("\n");
  }
  return out.finish();
}

std::string write_halfspace_rows(std::span<const BinaryHalfspace> halfspaces) {
  OutputBuffer out;
  for (const auto& [n1, n2, n3, d] : halfspaces) {
    for (const double n : {n1, n2, n3}) out.number(n).text(" ");
    out.number(d).text("\n");
  }
  return out.finish();
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
  if (ends_with(".txt")) return HalfspaceFormat::Rows;
  return {};
}

namespace {

bool starts_with_a_row(std::string_view bytes) {
  TextCursor cursor(bytes, {.comment = '#'});
  (void)read_qhull_counts(cursor);
  if (!cursor.next_line()) return false;
  try {
    for (int k = 0; k < 4; ++k) (void)parse_number(cursor.token(), Decimal::Nearest);
    return cursor.token().empty();
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

std::optional<HalfspaceFormat> halfspace_format_of_content(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 4096);
  TextCursor cursor(start, {.comment = '*'});
  for (bool first = true; cursor.next_line(); first = false) {
    const std::string_view token = cursor.token();
    if (first && (token.front() == '{' || token.front() == '[')) return HalfspaceFormat::Json;
    if (token == "H-representation" || token == "begin") return HalfspaceFormat::Ine;
  }
  if (starts_with_a_row(start)) return HalfspaceFormat::Rows;
  return {};
}

HalfspaceList read_halfspaces_bytes(std::string_view bytes, HalfspaceFormat format,
                                    Decimal decimal) {
  switch (format) {
    case HalfspaceFormat::Json:
      return read_halfspaces_json(bytes, decimal);
    case HalfspaceFormat::Ine:
      return read_ine(bytes, decimal);
    case HalfspaceFormat::Rows:
      break;
  }
  return read_halfspace_rows(bytes, decimal);
}

HalfspaceList read_halfspaces(const std::string& path, HalfspaceFormat format, Decimal decimal) {
  const std::string bytes = read_bytes(path);
  try {
    return read_halfspaces_bytes(bytes, format, decimal);
  } catch (const Error& error) {
    throw error.in_file(display_name(path));
  }
}

namespace {

template <class Plane>
std::string write_any(std::span<const Plane> halfspaces, HalfspaceFormat format) {
  switch (format) {
    case HalfspaceFormat::Json:
      return write_halfspaces_json(halfspaces);
    case HalfspaceFormat::Ine:
      return write_ine(halfspaces);
    case HalfspaceFormat::Rows:
      break;
  }
  return write_halfspace_rows(halfspaces);
}

}  // namespace

std::string write_halfspaces(std::span<const Halfspace> halfspaces, HalfspaceFormat format) {
  return write_any(halfspaces, format);
}

std::string write_halfspaces(std::span<const BinaryHalfspace> halfspaces, HalfspaceFormat format) {
  return write_any(halfspaces, format);
}

}  // namespace convexact
