// SPDX-License-Identifier: MIT
// Halfspaces as .ine. A row (b, a) means b + a.x >= 0, as the manuals of cddlib and lrslib say;
// expected values are written out by hand.
#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "expect_error.hpp"
#include "integer_halfspace.hpp"
#include "io/halfspace_formats.hpp"

using namespace convexact;

namespace {
HalfspaceList from_ine(std::string_view text, Decimal decimal = Decimal::Nearest) {
  return read_ine(text, decimal);
}
}  // namespace

TEST_CASE("read_ine: 1 - x >= 0 is x - 1 <= 0") {
  const HalfspaceList list = from_ine("begin\n2 4 integer\n1 -1 0 0\n0 0 0 1\nend\n");
  CHECK(list.halfspaces == std::vector<Halfspace>{halfspace(1, 0, 0, -1), halfspace(0, 0, -1, 0)});
}

TEST_CASE("read_ine: the solid whose vertices lrslib 7.1 lists") {
  const HalfspaceList list = from_ine(
      "H-representation\nbegin\n5 4 rational\n-1 1 0 0\n2 -1/3 0 0\n-5 0 1 0\n0 0 0 1\n"
      "7 0 -1/2 -4\nend\n");
  const Rational top(9, 8);
  const std::vector<RationalPoint> vertices = {{6, 14, 0},  {1, 14, 0}, {6, 5, top},
                                               {1, 5, top}, {6, 5, 0},  {1, 5, 0}};
  std::vector<int> tight(vertices.size(), 0);
  REQUIRE(list.halfspaces.size() == 5);
  for (const Halfspace& h : list.halfspaces) {
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      CHECK(h(vertices[k]) <= 0);
      if (h(vertices[k]) == 0) ++tight[k];
    }
  }
  CHECK(tight == std::vector<int>(6, 3));
}

TEST_CASE("read_ine: names, comments, options, fractions, decimals") {
  const char* text =
      "a name\r\n* a comment\r\nH-representation\r\nlinearity 0\r\nbegin\r\n 3 4 rational\r\n"
      " 1/2 -1 0 0\r\n\r\n* in between\r\n1 0 -2/4 0\r\n0 0 0 +1\r\nend\r\nlponly\r\n";
  CHECK(from_ine(text).halfspaces == std::vector<Halfspace>{halfspace(2, 0, 0, -1),
                                                            halfspace(0, 1, 0, -2),
                                                            halfspace(0, 0, -1, 0)});
  const char* real = "begin\n1 4 real\n1.E-01 -1.0 0 0\nend";
  CHECK(from_ine(real, Decimal::Exact).halfspaces.at(0) == halfspace(10, 0, 0, -1));
  const Halfspace nearest = from_ine(real).halfspaces.at(0);
  CHECK(Rational(nearest.offset(), nearest.normal()[0]) == -to_rational(0.1));
}

TEST_CASE("read_ine: rows with zero normal") {
  const HalfspaceList list =
      from_ine("begin\n4 4 integer\n1 0 0 0\n0 0 0 0\n0 1 0 0\n-1 0 0 0\nend\n");
  CHECK(list.halfspaces.size() == 1);
  CHECK(list.rows == std::vector<std::size_t>{2});
  CHECK(list.trivial_rows == std::vector<std::size_t>{0, 1});
  CHECK(list.impossible_row == 3);
}

TEST_CASE("read_ine: every error has its line and says what was expected") {
  struct Case {
    std::string text;
    std::size_t line;
    const char* expected;
  };
  for (const Case& c : std::vector<Case>{
           {"", 1, "expected begin, found the end of the file"},
           {"H-representation\n", 2, "expected begin, found the end of the file"},
           {"V-representation\nbegin\n", 1, "expected H-representation"},
           {"strict_inequality\nbegin\n", 1, "equations only, found 'strict_inequality'"},
           {"linearity 1 0\nbegin\n", 1, "expected a row, from 1, found 0"},
           {"linearity 2 1\nbegin\n", 1, "expected as many rows as announced"},
           {"begin\n1 4 integer\n1 0 0 1\nend\nlinearity 1 2\n", 6, "one of 1 rows, found 2"},
           {"begin\n***** 4 rational\n1 0 0 1\n", 4, "expected halfspace 1, found the end"},
           {"begin\n***** 4 rational\nend\n", 3, "expected rows b a1 a2 a3, found none"},
           {"begin\nm 4 integer\n", 2, "expected the number of rows, found 'm'"},
           {"begin\n1 5 integer\n", 2, "expected 4 columns for three dimensions, found '5'"},
           {"begin\n1 4 float\n", 2, "expected integer, rational or real, found 'float'"},
           {"begin\n0 4 integer\nend\n", 2, "expected rows b a1 a2 a3, found none"},
           {"begin\n4294967295 4 integer\n0 0 0 1\n", 2, "found a file too short"},
           {"begin\n1 4 integer\n0 0 1         \n", 3, "expected four numbers"},
           {"begin\n1 4 integer\n0 0 0 1 1\n", 3, "expected the end of the line"},
           {"begin\n1 4 integer\n0 0 0 1.5\n", 3, "expected an integer or a fraction"},
           {"begin\n1 4 rational\n0 0 0 1/0\n", 3, "expected a number, found '1/0'"},
           {"begin\n1 4 real\n0 0 0 1e999\n", 3, "expected a finite number"},
           {"begin\n2 4 integer\n0 0 0 1         \nend\n", 4, "found 'end'"},
           {"begin\n1 4 integer\n0 0 0 1\n0 0 0 1\nend\n", 4, "expected end, found '0'"},
           {"begin\n1 4 integer\n0 0 0 1\n", 4, "expected end, found the end of the file"},
       }) {
    CAPTURE(c.text);
    const Error error = error_of([&] { return from_ine(c.text); });
    CAPTURE(std::string(error.what()));
    CHECK(exit_code(error.code()) == 3);
    CHECK(error.line() == c.line);
    CHECK(std::string(error.what()).find(c.expected) != std::string::npos);
  }
}

TEST_CASE("write_ine: the bytes") {
  CHECK(write_ine(std::vector<Halfspace>{halfspace(1, 0, 0, -1), halfspace(0, -2, 0, 3)}) ==
        "H-representation\nbegin\n2 4 integer\n1 -1 0 0\n-3 0 2 0\nend\n");
  CHECK(write_ine(std::vector<BinaryHalfspace>{{1, -0.5, 0, -5e-324}}) ==
        "H-representation\nbegin\n1 4 real\n5e-324 -1 0.5 -0\nend\n");
}

TEST_CASE("halfspace formats: by path and by content") {
  CHECK(halfspace_format_of_path("a.JSON") == HalfspaceFormat::Json);
  CHECK(halfspace_format_of_path("a.ine") == HalfspaceFormat::Ine);
  CHECK(halfspace_format_of_path("a.Txt") == HalfspaceFormat::Rows);
  CHECK_FALSE(halfspace_format_of_path("ine").has_value());
  CHECK(halfspace_format_of_content(" \n {") == HalfspaceFormat::Json);
  CHECK(halfspace_format_of_content("* x\nH-representation\n") == HalfspaceFormat::Ine);
  CHECK(halfspace_format_of_content("# x\n1 0 -1/2 1e3 # y\n") == HalfspaceFormat::Rows);
  CHECK_FALSE(halfspace_format_of_content("1 0 0\n").has_value());
  CHECK_FALSE(halfspace_format_of_content("v 0 0 0\n").has_value());
  CHECK_FALSE(halfspace_format_of_content("").has_value());
}

TEST_CASE("read_halfspaces: the file is named") {
  const Error error = error_of([] { return read_halfspaces("no/such.ine", HalfspaceFormat::Ine); });
  CHECK(error.code() == ErrorCode::Unreadable);
  CHECK(std::string(error.what()).starts_with("no/such.ine: cannot be read: "));
}
