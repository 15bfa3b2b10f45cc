// SPDX-License-Identifier: MIT
#include "io/halfspace_rows.hpp"

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

HalfspaceList read_halfspace_rows(std::string_view bytes, Decimal decimal) {
  TextCursor cursor(bytes, {.comment = '#'});
  HalfspaceList list;
  while (cursor.next_line()) {
    RationalVector3 normal;
    for (int k = 0; k < 3; ++k) {
      normal[k] = to_number(cursor.expect_token("a row n1 n2 n3 d"), cursor, decimal);
    }
    const Rational offset = to_number(cursor.expect_token("a row n1 n2 n3 d"), cursor, decimal);
    cursor.expect_line_end();
    list.add(normal, offset);
  }
  if (list.row_count() == 0) cursor.fail("expected rows n1 n2 n3 d, found none");
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

}  // namespace convexact
