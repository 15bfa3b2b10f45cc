// SPDX-License-Identifier: MIT
// convexact query: answers as the schema says and true by closed forms, exit codes, and files that
// are refused with their lines.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "convexact/number.hpp"
#include "json_schema.hpp"
#include "process.hpp"
#include "program_json.hpp"

using convexact::parse_rational;
using convexact::Rational;
using nlohmann::json;
using support::data;
using support::program_json;
using support::Ran;
using support::run_program;
using support::ScratchFolder;

namespace {

// |x_k - center_k| <= 1 as rows.
std::string cube_rows(int x, int y, int z) {
  std::string rows;
  const int center[] = {x, y, z};
  for (int k = 0; k < 3; ++k) {
    for (const int side : {1, -1}) {
      for (int i = 0; i < 3; ++i) rows += std::to_string(i == k ? side : 0) + " ";
      rows += std::to_string(-1 - side * center[k]) + "\n";
    }
  }
  return rows;
}

json answer_of(const std::string& arguments) { return program_json("query " + arguments, "query"); }

Rational number(const json& text) { return parse_rational(text.get<std::string>()); }

json error_of_query(const std::string& arguments, int exit) {
  json document = program_json("query " + arguments, "query", exit);
  CHECK(document["error"]["exit"] == exit);
  return document["error"];
}

}  // namespace

TEST_CASE("query overlap: both answers, from rows and from meshes, and what each proves") {
  const ScratchFolder scratch;
  const std::string a = scratch.write("a.txt", cube_rows(0, 0, 0));
  const std::string touching = scratch.write("b.txt", cube_rows(2, 2, -2));
  const json yes = answer_of("overlap " + a + " " + touching);
  CHECK(yes["overlap"] == true);
  CHECK(yes["a"]["halfspaces"] == 6);
  CHECK(yes["witness"][0]["exact"] == "1");
  CHECK(yes["witness"][1]["value"] == 1.0);
  CHECK(yes["witness"][2]["exact"] == "-1");

  const std::string apart = scratch.write("c.txt", cube_rows(5, -4, 3));
  const json no = answer_of("overlap " + a + " " + apart);
  CHECK(no["overlap"] == false);
  // The multipliers prove it with the planes that stand beside them.
  Rational sum[4] = {0, 0, 0, 0};
  for (const json& entry : no["farkas"]) {
    CHECK(number(entry["multiplier"]) > 0);
    for (int k = 0; k < 4; ++k) sum[k] += number(entry["multiplier"]) * number(entry["plane"][k]);
  }
  for (int k = 0; k < 3; ++k) CHECK(sum[k] == 0);
  CHECK(sum[3] > 0);
  // The plane is negative on every corner of A and positive on every corner of B.
  for (int corner = 0; corner < 8; ++corner) {
    const Rational sides[] = {corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1};
    const Rational center[] = {5, -4, 3};
    Rational at_a = number(no["separating_plane"][3]), at_b = at_a;
    for (int k = 0; k < 3; ++k) {
      const Rational n = number(no["separating_plane"][k]);
      at_a += n * sides[k];
      at_b += n * (center[k] + sides[k]);
    }
    CHECK(at_a < 0);
    CHECK(at_b > 0);
  }
  CHECK(run_program("query overlap " + a + " " + apart).out.find("overlap: no") !=
        std::string::npos);

  const json meshes = answer_of("overlap " + data("bunny.obj") + " " + data("spot.obj"));
  CHECK(meshes["overlap"] == true);
  CHECK(answer_of("overlap " + data("spot.obj") + " " + a)["overlap"] == true);
}

TEST_CASE("query rays: entry, exit and halfspaces of a cube, decimals of either meaning") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("a.txt", cube_rows(0, 0, 0));
  const std::string rays =
      scratch.write("rays.txt",
                    "# five rays\n-3 0 0 1 0 0\n-3 -3 -3 2 2 2\n0 0 0.5 0 0 -1/3\n5 0 0 1 0 0\n"
                    "3 0.1 0 0 1 0\n");
  const json answer = answer_of("rays " + cube + " " + rays);
  const json& list = answer["rays"];
  REQUIRE(list.size() == 5);
  CHECK(answer["hits"] == 3);
  CHECK(list[0]["t"]["exact"] == "2");
  CHECK(list[0]["line"]["exit"]["exact"] == "4");
  // In canonical order the first plane is that of -x, the last one that of x.
  CHECK(list[0]["line"]["entry_halfspaces"] == json{0});
  CHECK(list[0]["line"]["exit_halfspaces"] == json{5});
  CHECK(list[1]["line"]["entry"]["exact"] == "1");
  CHECK(list[1]["line"]["entry_halfspaces"] == json{0, 1, 2});
  CHECK(list[1]["line"]["exit_halfspaces"] == json{3, 4, 5});
  CHECK(list[2]["t"]["exact"] == "0");
  CHECK(list[2]["line"]["entry"]["exact"] == "-3/2");
  CHECK(list[2]["line"]["exit"]["exact"] == "9/2");
  CHECK(list[3]["missed"] == json{5});
  CHECK(list[3]["line"]["exit"]["exact"] == "-4");
  CHECK(list[4]["missed"] == json{5});
  CHECK(list[4]["line"].is_null());

  const std::string tenth = scratch.write("tenth.txt", "0.1 0 0 1 0 0\n");
  CHECK(answer_of("rays " + cube + " " + tenth +
                  " --decimal exact")["rays"][0]["line"]["exit"]["exact"] == "9/10");
  CHECK(answer_of("rays " + cube + " " + tenth)["rays"][0]["line"]["exit"]["exact"] != "9/10");
  const Ran ran = run_program("query rays " + cube + " - <" + rays);
  CHECK(ran.exit == 0);
  CHECK(ran.out.find("3 of 5 rays hit") != std::string::npos);
}

TEST_CASE("query rays: a malformed file is exit code 3 with file and line") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("a.txt", cube_rows(0, 0, 0));
  const std::string zero = scratch.write("zero.txt", "0 0 0 1 0 0\n\n1 2 3 0 0 0\n");
  const json error = error_of_query("rays " + cube + " " + zero, 3);
  CHECK(error["line"] == 3);
  CHECK(error["message"].get<std::string>().starts_with(zero + ":3: "));
  (void)error_of_query("rays " + cube + " " + scratch.write("five.txt", "1 2 3 4 5\n"), 3);
  (void)error_of_query("rays " + cube + " " + scratch.write("empty.txt", ""), 3);
  (void)error_of_query("rays " + cube + " " + scratch.write("nan.txt", "1 2 3 nan 0 0\n"), 3);
  (void)error_of_query("rays " + cube + " " + scratch.file("none.txt"), 3);
  (void)error_of_query("rays " + scratch.write("bad.obj", "v 1 2\n") + " " + zero, 3);
}

TEST_CASE("query false-positives: counts, prediction, another seed, a solid that is not inside") {
  const ScratchFolder scratch;
  const std::string a = scratch.write("a.txt", cube_rows(0, 0, 0));
  const std::string b =
      scratch.write("b.txt", "1 0 0 -2\n-1 0 0 -2\n0 1 0 -2\n0 -1 0 -2\n0 0 1 -2\n0 0 -1 -2\n");
  const json first = answer_of("false-positives " + a + " " + b);
  CHECK(first["inside"] == true);
  const std::pair<const char*, double> rates[] = {
      {"lines", 0.75}, {"planes", 0.5}, {"points", 0.875}};
  for (const auto& rate : rates) {
    const json& tally = first[rate.first];
    CHECK(tally["samples"] == 1000);
    CHECK(tally["predicted"]["low"].get<double>() <= rate.second);
    CHECK(tally["predicted"]["high"].get<double>() >= rate.second);
    const double off = tally["rate"].get<double>() - rate.second;
    CHECK(std::abs(off) <= 4 * tally["sigma"].get<double>());
    CHECK(tally["only_a"] == 0);
  }
  CHECK(answer_of("false-positives " + a + " " + b)["lines"] == first["lines"]);
  CHECK(answer_of("false-positives --seed 2 " + a + " " + b)["lines"] != first["lines"]);
  const json few = answer_of("false-positives --lines 0 --points 7 --planes 0 " + a + " " + b);
  CHECK_FALSE(few.contains("lines"));
  CHECK_FALSE(few.contains("planes"));
  CHECK(few["points"]["samples"] == 7);

  const json swapped = answer_of("false-positives " + b + " " + a);
  CHECK(swapped["inside"] == false);
  CHECK(swapped["points"]["predicted"].is_null());
  CHECK(swapped["points"]["only_b"] == 0);
  CHECK(swapped["points"]["only_a"] == first["points"]["only_b"]);
  CHECK(run_program("query false-positives " + b + " " + a).out.find("A is not inside B") !=
        std::string::npos);
}

TEST_CASE("query: shapes without volume are exit code 4 with the proof, wrong usage is 2") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("a.txt", cube_rows(0, 0, 0));
  const std::string flat = scratch.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  const std::string open = scratch.write("open.txt", "1 0 0 -1\n-1 0 0 -1\n");
  const std::string empty = scratch.write("empty.txt", "0 0 0 -1\n2 0 0 -1\n-3 0 0 6\n");
  for (const std::string& query : {"overlap " + cube + " ", "overlap " + flat + " ",
                                   "false-positives " + cube + " ", std::string("rays ")}) {
    const std::string rays =
        query == "rays " ? " " + scratch.write("rays.txt", "0 0 0 1 0 0\n") : "";
    for (const std::string& shape : {flat, open, empty}) {
      CHECK(error_of_query(query + shape + rays, 4).contains("proof"));
    }
  }
  // The rows of a proof are those of the file, as typed.
  const json proof = error_of_query("overlap " + cube + " " + empty, 4)["proof"];
  CHECK(proof["kind"] == "empty");
  CHECK(proof["farkas"].size() == 2);
  for (const json& entry : proof["farkas"]) CHECK(entry["halfspace"] > 0);
  for (const std::string& arguments : std::initializer_list<std::string>{
           "overlap", "overlap ", "shadow a b", "overlap --lines 3 " + cube + " " + cube,
           "overlap - -", "rays - -", "overlap " + cube + " " + cube + " " + cube,
           "false-positives --lines -1 " + cube + " " + cube,
           "false-positives --points 1e3 " + cube + " " + cube, "overlap --decimal far a b"}) {
    CAPTURE(arguments);
    CHECK(run_program("query " + arguments + " </dev/null").exit == 2);
  }
  CHECK(run_program("query").exit == 2);
  for (const char* words : {"", "overlap", "rays", "false-positives"}) {
    const Ran help = run_program("query " + std::string(words) + " --help");
    CHECK(help.exit == 0);
    CHECK(help.out.find("  convexact query " + std::string(words)) != std::string::npos);
    CHECK(help.out.find("Example") != std::string::npos);
  }
}
