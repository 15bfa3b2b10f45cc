// SPDX-License-Identifier: MIT
// Halfspaces as JSON. Expected values are written out by hand; any list comes back.
#include <doctest/doctest.h>

#include <cmath>

#include "convexact/conform.hpp"
#include "convexact/error.hpp"
#include "expect_error.hpp"
#include "integer_halfspace.hpp"
#include "io/halfspace_formats.hpp"
#include "property.hpp"
#include "wire/removal_order_file.hpp"

using namespace convexact;

namespace {
HalfspaceList from_json(std::string_view text, Decimal decimal = Decimal::Nearest) {
  return read_halfspaces_json(text, decimal);
}
}  // namespace

TEST_CASE("read_halfspaces_json: numbers and strings, objects and bare arrays") {
  const std::vector<Halfspace> expected = {halfspace(1, 0, 0, -1), halfspace(0, -2, 0, 3)};
  for (const char* text : {
           R"({"halfspaces": [["1", "0", "0", "-1"], [0, -1, 0, 1.5]]})",
           R"([["1","0","0","-1"],["0","-2/1","0.0","3"]])",
           R"({"a": {"halfspaces": [[1]]}, "halfspaces": [[2, 0, 0, -2.0], [0, -20e-1, 0, "+3"]],
               "steps": [{"removed": 1, "tie": [[], {}]}], "b": [[1, 2]]})",
       }) {
    CAPTURE(text);
    const HalfspaceList list = from_json(text);
    CHECK(list.halfspaces == expected);
    CHECK(list.rows == std::vector<std::size_t>{0, 1});
    CHECK_FALSE(list.impossible_row.has_value());
  }
}

TEST_CASE("read_halfspaces_json: integers of any length are exact, decimals by choice") {
  const std::string large = "123456789012345678901234567890";
  for (const std::string& number : {large, "\"" + large + "\""}) {
    const HalfspaceList list = from_json("[[1, 0, 0, " + number + "]]");
    CHECK(to_string(list.halfspaces.at(0).offset()) == large);
  }
  CHECK(from_json("[[1, 0, 0, 0.1]]", Decimal::Exact).halfspaces.at(0) == halfspace(10, 0, 0, 1));
  const Halfspace nearest = from_json("[[1, 0, 0, 0.1]]").halfspaces.at(0);
  CHECK(Rational(nearest.offset(), nearest.normal()[0]) == to_rational(0.1));
}

TEST_CASE("read_halfspaces_json: rows with zero normal") {
  const HalfspaceList list = from_json("[[0,0,0,-1],[1,0,0,0],[0,0,0,0],[0,0,0,2],[0,0,0,3]]");
  CHECK(list.halfspaces.size() == 1);
  CHECK(list.rows == std::vector<std::size_t>{1});
  CHECK(list.trivial_rows == std::vector<std::size_t>{0, 2});
  CHECK(list.impossible_row == 3);
}

TEST_CASE("read_halfspaces_json: every error has its line and says what was expected") {
  struct Case {
    std::string text;
    std::optional<std::size_t> line;
    const char* expected;
  };
  for (const Case& c : std::vector<Case>{
           {"", 1, "expected JSON"},
           {"{\"halfspaces\": [\n[1, 0, 0, 1],\n[1, 0,", 3, "expected JSON"},
           {"[[1, 0, 0, 1]]\n]", 2, "expected JSON"},
           {"[[1, 0, 0, 01]]", 1, "expected JSON"},
           {"[[1, 0, 0, NaN]]", 1, "expected JSON"},
           {"3", {}, "expected an object with a key 'halfspaces'"},
           {"{\"planes\": [[1, 0, 0, 1]]}", {}, "expected an object with a key 'halfspaces'"},
           {"{\"halfspaces\":\n7}", 2, "expected an array of halfspaces, found '7'"},
           {"{\"halfspaces\": {}}", 1, "expected an array of halfspaces, found an object"},
           {"{\"halfspaces\": [], \"halfspaces\": []}", 1, "found two"},
           {"{\"halfspaces\":\n[]\n}\n", 2, "expected halfspaces [n1, n2, n3, d], found none"},
           {"[\n]", 1, "expected halfspaces [n1, n2, n3, d], found none"},
           {"[\n[1, 0, 0, 1],\n[1, 0, 0]]", 3, "halfspace 1: expected 4 numbers, found 3"},
           {"[[1, 0, 0, 1, 1]]", 1, "halfspace 0: expected 4 numbers, found 5"},
           {"[[1, 0, [0], 1]]", 1, "halfspace 0: expected a number, found a list or object"},
           {"[[1, 0, null, 1]]", 1, "halfspace 0: expected a number, found null"},
           {"[[1, 0, true, 1]]", 1, "halfspace 0: expected a number, found true"},
           {"[[1, 0, \"x\", 1]]", 1, "halfspace 0: expected a number, found 'x'"},
           {"[[1, 0, \"1/0\", 1]]", 1, "halfspace 0: expected a number, found '1/0'"},
           {"[[1, 0, \"nan\", 1]]", 1, "halfspace 0: expected a finite number, found 'nan'"},
           {"[\n\"x\"]", 2, "expected a halfspace [n1, n2, n3, d], found 'x'"},
           {"[{}]", 1, "expected a halfspace [n1, n2, n3, d], found an object"},
           {"[[1, 0, 0, 1e400]]", 1, "within the doubles"},
           {"[[1, 0, 0, \"1e400\"]]", 1, "expected a finite number"},
       }) {
    CAPTURE(c.text);
    const Error error = error_of([&] { return from_json(c.text); });
    CAPTURE(std::string(error.what()));
    CHECK(exit_code(error.code()) == 3);
    CHECK(error.line() == c.line);
    CHECK(std::string(error.what()).find(c.expected) != std::string::npos);
  }
}

TEST_CASE("read_halfspaces_json: a file cut off anywhere is refused") {
  const std::string text = "{\"halfspaces\": [[1, \"-2/3\", 0.5, 1e-3]], \"x\": [null, \"y\"]}";
  for (std::size_t size = 0; size < text.size(); ++size) {
    CHECK(error_of([&] { return from_json(text.substr(0, size)); }).code() == ErrorCode::Malformed);
  }
}

TEST_CASE("write_halfspaces_json: the bytes") {
  CHECK(write_halfspaces_json(
            std::vector<Halfspace>{halfspace(1, 0, 0, -1), halfspace(0, -2, 0, 3)}) ==
        "{\"halfspaces\": [\n[\"1\", \"0\", \"0\", \"-1\"],\n[\"0\", \"-2\", \"0\", \"3\"]\n]}\n");
  CHECK(write_halfspaces_json(std::vector<BinaryHalfspace>{{1, -0.1, 0, 5e-324}}) ==
        "{\"halfspaces\": [\n[1, -0.1, 0, 5e-324]\n]}\n");
}

TEST_CASE("halfspaces: any list comes back, in every format") {
  check_property("integers and doubles come back", [](const std::vector<std::uint64_t>& bits) {
    std::vector<Halfspace> exact;
    std::vector<BinaryHalfspace> binary;
    for (std::size_t k = 0; k + 4 <= bits.size(); k += 4) {
      BinaryHalfspace h;
      for (std::size_t i = 0; i < 4; ++i) {
        const double x = std::bit_cast<double>(bits[k + i]);
        h[i] = std::isfinite(x) ? x : 1.0;
      }
      if (h[0] == 0 && h[1] == 0 && h[2] == 0) continue;
      binary.push_back(h);
      exact.emplace_back(to_rational(Vector3<double>(h[0], h[1], h[2])), to_rational(h[3]));
    }
    if (exact.empty()) return;  // no format may be without a row
    for (const HalfspaceFormat format :
         {HalfspaceFormat::Json, HalfspaceFormat::Ine, HalfspaceFormat::Rows}) {
      const std::string integers = write_halfspaces(std::span<const Halfspace>(exact), format);
      for (const Decimal decimal : {Decimal::Nearest, Decimal::Exact}) {
        RC_ASSERT(read_halfspaces_bytes(integers, format, decimal).halfspaces == exact);
      }
      const std::string reals = write_halfspaces(std::span<const BinaryHalfspace>(binary), format);
      RC_ASSERT(read_halfspaces_bytes(reals, format).halfspaces == exact);
      RC_ASSERT(halfspace_format_of_content(integers) == format);
    }
  });
}

TEST_CASE("json: every reader refuses nesting without end, with its line (#13)") {
  const auto line_of = [](auto read) -> std::size_t {
    try {
      read();
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::Malformed);
      return error.line().value_or(0);
    }
    return 0;
  };
  for (const char* bracket : {"[", "{\"a\":"}) {
    for (const std::size_t depth : {64u, 1000u, 300000u}) {
      CAPTURE(depth);
      std::string text = "{\"halfspaces\": [],\n\"steps\": [],\n\"note\": ";
      for (std::size_t k = 0; k < depth; ++k) text += bracket;
      CHECK(line_of([&] { (void)read_halfspaces_json(text, Decimal::Nearest); }) == 3);
      CHECK(line_of([&] { (void)read_removal_order(text, {}, {}, Decimal::Nearest); }) == 3);
      CHECK(line_of([&] { (void)read_test_vectors_bytes(text, "nowhere"); }) == 3);
    }
  }
  // 64 levels are read: the object and 63 lists in it.
  const std::string lists = std::string(63, '[') + std::string(63, ']');
  CHECK(read_halfspaces_json("{\"note\": " + lists + ", \"halfspaces\": [[1, 0, 0, -1]]}",
                             Decimal::Nearest)
            .row_count() == 1);
}
