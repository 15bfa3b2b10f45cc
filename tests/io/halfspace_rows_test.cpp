// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "expect_error.hpp"
#include "io/halfspace_formats.hpp"

using namespace convexact;

namespace {

HalfspaceList from_rows(std::string_view text, Decimal decimal = Decimal::Nearest) {
  return read_halfspace_rows(text, decimal);
}

}  // namespace

TEST_CASE("read_halfspace_rows: rows, comments, blank lines, rows that bound nothing") {
  const HalfspaceList list =
      from_rows("# a wedge\r\n\n1 0 0 -1 # x <= 1\n0 0 0 -2\n1/3 0 2 -7/2\n");
  REQUIRE(list.halfspaces.size() == 2);
  CHECK(list.halfspaces[0] == Halfspace(IntegerVector3(1, 0, 0), Integer(-1)));
  CHECK(list.halfspaces[1] == Halfspace(IntegerVector3(2, 0, 12), Integer(-21)));
  CHECK(list.rows == std::vector<std::size_t>{0, 2});
  CHECK(list.trivial_rows == std::vector<std::size_t>{1});
  CHECK(from_rows("0 0 0 1\n").impossible_row == 0);
}

TEST_CASE("read_halfspace_rows: decimals by the rule that was asked for") {
  CHECK(from_rows("1 0 0 0.1\n").halfspaces[0] ==
        Halfspace(RationalVector3(1, 0, 0), to_rational(0.1)));
  CHECK(from_rows("1 0 0 0.1\n", Decimal::Exact).halfspaces[0] ==
        Halfspace(IntegerVector3(10, 0, 0), Integer(1)));
}

TEST_CASE("read_halfspace_rows: what is wrong, and in which line") {
  struct Case {
    const char* text;
    std::size_t line;
    ErrorCode code;
  };
  for (const Case& c :
       {Case{"1 0 0 1\n1 2 3\n", 2, ErrorCode::Malformed},
        Case{"1 0 0 1 5\n", 1, ErrorCode::Malformed},
        Case{"\n1 0 zero 1\n", 2, ErrorCode::Malformed},
        Case{"1 0 0 1/0\n", 1, ErrorCode::Malformed}, Case{"1 0 nan 1\n", 1, ErrorCode::NotFinite},
        Case{"1 0 0 1e999\n", 1, ErrorCode::NotFinite}}) {
    CAPTURE(c.text);
    const Error error = error_of([&] { return from_rows(c.text); });
    CHECK(error.code() == c.code);
    CHECK(error.line() == c.line);
  }
  CHECK(error_of([] { return from_rows("# nothing\n"); }).code() == ErrorCode::Malformed);
  CHECK(error_of([] { return from_rows(""); }).code() == ErrorCode::Malformed);
}
