// SPDX-License-Identifier: MIT
// OFF files as found in the wild and broken ones. Expected values are written out by hand.
#include <doctest/doctest.h>

#include "convexact/io.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {
Mesh off(std::string_view text) { return read_mesh_bytes(text, {.format = MeshFormat::Off}); }
}  // namespace

TEST_CASE("read_off: headers, comments, attributes, colours, line ends") {
  for (const std::string text :
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "# a comment\nOFF 3 1\n\n0 0 0\n1 0 0 # here too\n0 1 0\n3 0 1 2 255 0 0",
        "COFF\r\n3 1 3\r\n0 0 0 1 1 1 1\r\n1 0 0 1 1 1 1\r\n0 1 0 0 0 0 0\r\n3 0 1 2\r\n",
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 .5 .5 .5 1 0 0\n1 0 0 0 0 1 .5 .5 .5 1 0 0\n"
        "0 1 0 0 0 1 .5 .5 .5 1 0 0\n3 0 1 2 0.5 0.5 0.5\n"}) {
    CAPTURE(text);
    const Mesh mesh = off(text);
    REQUIRE(mesh.points.size() == 3);
    CHECK(mesh.points.doubles()[1] == Point(1, 0, 0));
    CHECK(mesh.points.doubles()[2] == Point(0, 1, 0));
    CHECK(mesh.polygons == std::vector<std::vector<std::uint32_t>>{{0, 1, 2}});
    REQUIRE(mesh.parts.size() == 1);
    CHECK(mesh.parts[0].last_polygon == 1);
  }
  CHECK(off("OFF 0 0 0").points.size() == 0);
  CHECK(off("OFF\n1 0 0\n1 2 3").points.size() == 1);
}

TEST_CASE("read_off: every error has its line and says what was expected") {
  struct Case {
    std::string text;
    std::size_t line;
    const char* expected;
  };
  const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  for (const Case& c : std::vector<Case>{
           {"", 1, "expected an OFF header, found the end of the file"},
           {"OF\n", 1, "found 'OF'"},
           {"4OFF\n", 1, "for three dimensions"},
           {"OFF BINARY\n", 1, "found its binary form"},
           {"OFF\n\n", 3, "expected the numbers of points"},
           {"OFF\n3\n", 2, "expected the number of polygons"},
           {"OFF\n-3 1 0\n", 2, "expected the number of points, found '-3'"},
           {"OFF\n3 1 0 0\n", 2, "expected the end of the line, found '0'"},
           {"OFF\n4000000000 4000000000 0\n0 0 0\n", 2, "too short"},
           {"OFF\n3 0 0\n0 0 0\n0 0 0           \n", 5, "expected point 2, found the end"},
           {"OFF\n1 0 0\n0 0\n", 3, "expected three coordinates"},
           {"OFF\n1 0 0\n0 0 0 red\n", 3, "expected a number, found 'red'"},
           {"OFFx\n", 1, "found 'OFFx'"},
           {"OFF\n3 1 0\n0 0 0 1 0 0 0 1 0 3 0 1\n", 4, "expected polygon 0, found the end"},
           {"OFF\n1 0 0\n0 nan 0\n", 3, "expected a finite number"},
           {points + "0\n", 6, "a polygon of at least 3 corners, found '0'"},
           {points + "3 0 1 3\n", 6, "expected an index below 3, found '3'"},
           {points + "3 0 1 -1\n", 6, "the index of a point, from 0, found '-1'"},
           {points + "4 0 1 2\n", 6, "as many corners as announced"},
           {points + "3 0 1 2 red\n", 6, "expected a number, found 'red'"},
           {points + "3 0 1 2\n\n3 0 1 2", 8, "expected the end of the file, found '3'"},
       }) {
    CAPTURE(c.text);
    const Error error = error_of([&] { return off(c.text); });
    CAPTURE(std::string(error.what()));
    CHECK(exit_code(error.code()) == 3);
    CHECK(error.line() == c.line);
    CHECK(std::string(error.what()).find(c.expected) != std::string::npos);
  }
}
