// SPDX-License-Identifier: MIT
// STL files as text and binary, and broken ones. Expected values are written out by hand.
#include <doctest/doctest.h>

#include <bit>

#include "convexact/io.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

using Polygons = std::vector<std::vector<std::uint32_t>>;

Mesh stl(std::string_view text, Decimal decimal = Decimal::Nearest) {
  return read_mesh_bytes(text, {.decimal = decimal, .format = MeshFormat::Stl});
}

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return " facet normal nan 0 1\n  outer loop\n   vertex " + a + "\n   vertex " + b +
         "\n   vertex " + c + "\n  endloop\n endfacet\n";
}

void append_integer(std::string& bytes, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>((value >> (8 * k)) & 0xFF);
}

std::string binary(std::string start, std::uint32_t count,
                   const std::vector<std::array<float, 9>>& triangles) {
  start.resize(80, ' ');
  append_integer(start, count);
  for (const auto& triangle : triangles) {
    for (int k = 0; k < 3; ++k) append_integer(start, 0x7FC00000);  // a normal of NaN is no matter
    for (const float x : triangle) append_integer(start, std::bit_cast<std::uint32_t>(x));
    start += "\1\2";
  }
  return start;
}

}  // namespace

TEST_CASE("read_stl: text with several solids; equal points become one") {
  const Mesh mesh =
      stl("solid first one\n" + facet("0 0 0", "1 0 0", "0 1 0") +
          facet("-0.0 0 0", "0 1 0", "0 0 1e0") + "endsolid first one\n\n" +
          "SOLID\r\nendsolid\r\nsolid last\n" + facet("0 0 1", "0 0 0", "2 2 2") + "endsolid");
  CHECK(mesh.points.size() == 5);
  CHECK(mesh.polygons == Polygons{{0, 1, 2}, {0, 2, 3}, {3, 0, 4}});
  REQUIRE(mesh.parts.size() == 3);
  CHECK(mesh.parts[0].name == "first one");
  CHECK(mesh.parts[1].first_polygon == 2);
  CHECK(mesh.parts[1].last_polygon == 2);
  CHECK(mesh.parts[2].name == "last");
}

TEST_CASE("read_stl: points that differ only as rationals stay apart") {
  const std::string text =
      "solid\n" + facet("0.1 0 0", "0.10000000000000000001 0 0", "0 1 0") + "endsolid\n";
  CHECK(stl(text).points.size() == 2);
  CHECK(stl(text, Decimal::Exact).points.size() == 3);
}

TEST_CASE("read_stl: binary, also when it begins with solid") {
  for (const std::string start : {"", "solid of a careless writer\nfacet"}) {
    const std::string bytes =
        binary(start, 2, {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 1, 0, 0, 0, 0.1f}});
    const Mesh mesh = stl(bytes);
    CHECK(mesh.points.size() == 4);
    CHECK(mesh.points.doubles()[3].z() == double(0.1f));
    CHECK(mesh.polygons == Polygons{{0, 1, 2}, {0, 2, 3}});
    CHECK(mesh_format_of_content(bytes) == MeshFormat::Stl);
  }
  CHECK(stl(binary("", 0, {})).points.size() == 0);
}

TEST_CASE("read_stl: every error says where it is and what was expected") {
  struct Case {
    std::string text;
    std::optional<std::size_t> line;
    const char* expected;
  };
  const std::string good = facet("0 0 0", "1 0 0", "0 1 0");
  const float infinity = std::numeric_limits<float>::infinity();
  for (const Case& c : std::vector<Case>{
           {"", {}, "expected STL: text that begins with solid, or 84 + 50 n bytes"},
           {binary("", 2, {{}}), {}, "expected 184 bytes"},
           {binary("", 4000000000u, {{}}), {}, "expected 200000000084 bytes"},
           // 50 times this is 0 in 32 bits.
           {binary("", 2147483648u, {}), {}, "expected 107374182484 bytes"},
           {std::string(134, ' '), {}, "found neither in 134 bytes"},
           {binary("", 2, {{}, {0, 0, 0, 0, infinity, 0, 0, 0, 0}}),
            {},
            "at byte 166: expected a finite number in triangle 1"},
           {"solid\n" + good, 9, "expected facet or endsolid, found the end of the file"},
           {"solid\nloop\n", 2, "expected facet or endsolid, found 'loop'"},
           {"solid\nfacet\nouter lop\n", 3, "expected loop, found 'lop'"},
           {"solid\n" + facet("0 0", "1 0 0", "0 1 0"), 4, "expected three coordinates"},
           {"solid\n" + facet("0 0 0 0", "1 0 0", "0 1 0"), 4, "expected the end of the line"},
           {"solid\n" + facet("0 0 0", "1 0 nan", "0 1 0"), 5, "expected a finite number"},
           {"solid\n" + facet("0 0 0", "1 0 0", "0 1 0\nvertex 1 1 1"), 7, "expected endloop"},
           {"solid\n" + good + "endsolid\n" + good, 10, "expected solid, found 'facet'"},
       }) {
    CAPTURE(c.text);
    const Error error = error_of([&] { return stl(c.text); });
    CAPTURE(std::string(error.what()));
    CHECK(exit_code(error.code()) == 3);
    CHECK(error.line() == c.line);
    CHECK(std::string(error.what()).find(c.expected) != std::string::npos);
  }
}

TEST_CASE(
    "read_stl: a binary file that begins with solid is told by its size, not as a text (#13)") {
  const std::array<float, 9> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  for (const std::string start : {"solid", "solid part\n facet", "exported by a scanner"}) {
    CAPTURE(start);
    const std::string whole = binary(start, 2, {triangle, triangle});
    CHECK(stl(whole).polygons.size() == 2);
    for (const std::string& wrong : {whole.substr(0, whole.size() - 1), whole.substr(0, 84)}) {
      const Error error = error_of([&] { return stl(wrong); });
      CHECK(error.code() == ErrorCode::Malformed);
      CHECK(std::string(error.what()) ==
            "expected 184 bytes of binary STL for the 2 triangles that bytes 80 to 83 announce, "
            "found " +
                std::to_string(wrong.size()) + " bytes");
    }
    const Mesh longer = stl(whole + "\n");
    CHECK(longer.polygons.size() == 2);
    CHECK(longer.notes == std::vector<std::string>{"1 byte behind the last facet was skipped"});
  }
}
