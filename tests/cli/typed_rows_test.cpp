// SPDX-License-Identifier: MIT
// Proofs that a list of halfspaces is empty or flat, as --json prints them, checked by hand: the
// multipliers, read as fractions, against the rows as they are typed.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "convexact/number.hpp"
#include "process.hpp"

using convexact::parse_rational;
using convexact::Rational;
using nlohmann::json;
using support::run_program;
using support::ScratchFolder;

namespace {

using TypedRow = std::array<Rational, 4>;

std::vector<TypedRow> typed_rows(const std::string& text) {
  std::vector<TypedRow> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    TypedRow& row = rows.emplace_back();
    for (Rational& x : row) {
      std::string word;
      words >> word;
      x = parse_rational(word);
    }
  }
  return rows;
}

// y'(N, d) for multipliers y >= 0 of typed rows.
TypedRow combination(const json& multipliers, const std::vector<TypedRow>& rows) {
  TypedRow sum{0, 0, 0, 0};
  CHECK_FALSE(multipliers.empty());
  for (const json& entry : multipliers) {
    const Rational y = parse_rational(entry["multiplier"].get<std::string>());
    CHECK(y > 0);
    const TypedRow& row = rows.at(entry["halfspace"].get<std::size_t>());
    for (int k = 0; k < 4; ++k) sum[k] += y * row[k];
  }
  return sum;
}

json proof_of(const std::string& command) {
  const auto ran = run_program(command + " --json");
  CHECK(ran.exit == 4);
  return json::parse(ran.out)["error"]["proof"];
}

// Rows of any scale, and rows that bound nothing between them.
const std::string kEmpty =
    "0 0 0 -1\n0.75 0 0 -6\n0 0 0 0\n-1/3 0 0 5\n0 1/7 0 -1\n0 -22 0 -4\n0 0 3 -3\n0 0 -5 1\n";
const std::string kFlat =
    "0 0 0 -7\n2.5 0 0 -5\n-1/3 0 0 2/3\n0 4 0 -1\n0 -6 0 0\n0 0 9 -1\n0 0 -1 0\n";

}  // namespace

TEST_CASE("proofs: multipliers of an empty list hold for the rows as typed (#13)") {
  const ScratchFolder scratch;
  const std::string list = scratch.write("empty.txt", kEmpty);
  for (const std::string& command : {"hull " + list, "simplify --faces 4 " + list,
                                     "verify " + list + " " + list, "diff --faces 4 " + list}) {
    CAPTURE(command);
    const json proof = proof_of(command);
    REQUIRE(proof["kind"] == "empty");
    const TypedRow sum = combination(proof["farkas"], typed_rows(kEmpty));
    for (int k = 0; k < 3; ++k) CHECK(sum[k] == 0);
    CHECK(sum[3] > 0);
  }
}

TEST_CASE("proofs: multipliers of a flat list hold for the rows as typed (#13)") {
  const ScratchFolder scratch;
  const json proof = proof_of("hull " + scratch.write("flat.txt", kFlat));
  REQUIRE(proof["kind"] == "flat-halfspaces");
  for (const Rational& x : combination(proof["multipliers"], typed_rows(kFlat))) CHECK(x == 0);
}

TEST_CASE("proofs: a sentence names rows and multipliers as typed, also of a candidate (#13)") {
  const ScratchFolder scratch;
  const std::string solid = scratch.write("s.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  const std::string list = scratch.write("c.txt", "0 0 0 0\n0.5 0 0 1\n0 1 0 0\n-2 0 0 1\n");
  const auto ran = run_program("verify " + solid + " " + list);
  CHECK(ran.exit == 1);
  // 0.5 x + 1 <= 0 and -2 x + 1 <= 0: four times row 1 and once row 3 give 5 <= 0, or a multiple.
  const bool is_typed =
      ran.out.find("4 times halfspace 1 + 1 times halfspace 3") != std::string::npos ||
      ran.out.find("1 times halfspace 3 + 4 times halfspace 1") != std::string::npos ||
      ran.out.find("2 times halfspace 1 + 1/2 times halfspace 3") != std::string::npos ||
      ran.out.find("1/2 times halfspace 3 + 2 times halfspace 1") != std::string::npos;
  CHECK_MESSAGE(is_typed, ran.out);
  CHECK(ran.out.find("counted from 0") != std::string::npos);
}

TEST_CASE("hull: redundant halfspaces are named by their rows in the file (#13)") {
  const ScratchFolder scratch;
  const std::string list = scratch.write(
      "l.txt", "0 0 0 -1\n1 0 0 -1\n2 0 0 -9\n-1 0 0 0\n0 1 0 -1\n0 -1 0 0\n0 0 1 -1\n0 0 -1 0\n");
  const auto ran = run_program("hull " + list + " --json");
  REQUIRE(ran.exit == 0);
  CHECK(json::parse(ran.out)["input"]["redundant"] == json{2});
}
