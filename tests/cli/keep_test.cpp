// SPDX-License-Identifier: MIT
// --keep on the command line: selectors by id, plane, normal and group, in scenes, in traces, and
// what is refused.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "json_schema.hpp"
#include "process.hpp"
#include "program_json.hpp"

using nlohmann::json;
using support::bytes_of;
using support::data;
using support::program_json;
using support::run_program;
using support::ScratchFolder;

namespace {

// [0, 1]^3 without the corner cut off at x + y + z <= 5/2. The cut is facet 6; -x, -y, -z are 0, 1,
// 2, and z, y, x at 1 are 3, 4, 5. With the cut kept, one of these three goes at 25/48.
const std::string kGroupedCutCube =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv .5 1 1\nv 1 .5 1\nv 1 1 .5\n"
    "g cut\nf 8 9 10\ng bottom/left\nf 1 3 4 2\nf 1 5 3\n";

json simplified(const std::string& arguments) {
  return program_json("simplify " + arguments, "result");
}

std::string refusal(const std::string& arguments) {
  const auto ran = run_program(arguments);
  CHECK(ran.exit == 2);
  return ran.err;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("--keep: four ways to name one facet") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cut.obj", kGroupedCutCube);
  for (const std::string selector :
       {"id:6", "plane:2,2,2,-5", "plane:1/3,1/3,1/3,-5/6", "normal:1,1,1", "normal:2,2,2:0",
        "normal:3,3,4:10", "group:cut"}) {
    CAPTURE(selector);
    const json document = simplified(input + " --faces 6 --exact-values --keep " + selector);
    CHECK(document["kept"]["ids"] == json{6});
    CHECK(document["kept"]["planes"] == json{5});
    CHECK(document["output"]["planes"][5] == json{"2", "2", "2", "-5"});
    // 47/48 + 25/48
    CHECK(document["volume"]["output"]["exact"] == "3/2");
    CHECK(document["output"]["reached"] == true);
  }
  const json group = simplified(input + " --faces 6 --keep group:bottom/left --keep id:6");
  CHECK(group["kept"]["ids"] == json{0, 2, 6});
  CHECK_FALSE(simplified(input + " --faces 6").contains("kept"));
}

TEST_CASE("--keep: an end above K, with exit code 0") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cut.obj", kGroupedCutCube);
  const json document = simplified(input + " --faces 4 --keep id:3,4,5,6");
  CHECK(document["output"]["reached"] == false);
  CHECK(document["output"]["stop"] == "all-kept-or-unbounded");
  CHECK(document["output"]["halfspaces"] == 7);
  const auto summary = run_program("simplify " + input + " --faces 4 --keep id:3,4,5,6");
  CHECK(says(summary.out, "all others are kept, or leave the solid unbounded"));
}

TEST_CASE("--keep: what is refused, by name") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cut.obj", kGroupedCutCube);
  const std::string output = scratch.file("out.obj");
  const std::string run = "simplify " + input + " --faces 4 -o " + output + " --keep ";
  for (const auto& refused : std::vector<std::pair<std::string, std::string>>{
           {"id:7", "ids below 7"},
           {"id:-1", "whole number"},
           {"id:", "whole number"},
           {"id:1,,2", "whole number"},
           {"plane:1,2,3,4", "matches no facet"},
           {"plane:-2,-2,-2,5", "matches no facet"},
           {"plane:0,0,0,1", "zero"},
           {"plane:1,2,3", "expected 4 numbers"},
           {"normal:0,0,0", "zero"},
           {"normal:1,2,3:0", "matches no facet"},
           {"normal:1,1,1:181", "0 to 180 degrees"},
           {"normal:1,1,1:-1", "0 to 180 degrees"},
           {"normal:1,1,1:nan", "expected a number"},
           {"normal:1,1,1:", "expected a number"},
           {"normal:nan,0,1", "expected 3 numbers"},
           {"normal:1e999999,0,1", "expected 3 numbers"},
           {"group:cut2", "no group of that name"},
           {"6", "expected id:N"},
           {"''", "found an empty text"},
           {"id:0,1,2,3,4", "5 facets are to be kept"},
           {"lid/id:6", "expected id:N"},
       }) {
    const std::string said = refusal(run + refused.first);
    CHECK_MESSAGE(says(said, refused.second), refused.first << ": " << said);
    CHECK_MESSAGE((says(said, "--keep") || says(said, "to be kept")), said);
  }
  CHECK(scratch.count() == 1);
}

TEST_CASE("--keep: in a scene after the part's name") {
  const ScratchFolder scratch;
  std::string two = "o a/b\n" + kGroupedCutCube.substr(0, kGroupedCutCube.find("g cut")) +
                    "f 8 9 10\nf 1 3 4 2\n";
  two += "f 1 2 5\nf 3 7 4\no c\n";
  for (const char* v : {"5 0 0", "6 0 0", "5 1 0", "5 0 1"}) two += std::string("v ") + v + "\n";
  two += "f 11 13 12\nf 11 12 14\nf 11 14 13\nf 12 13 14\n";
  const std::string input = scratch.write("two.obj", two);
  // The first part has only the points that its faces use.
  const std::string run = input + " --parts --faces 4 --keep ";
  const json document = simplified(run + "c/id:0 --keep a/b/normal:1,1,1");
  CHECK(document["objects"][0]["kept"]["ids"].size() == 1);
  CHECK(document["objects"][1]["kept"]["ids"] == json{0});
  CHECK(says(refusal("simplify " + run + "id:0"), "PART/SELECTOR"));
  CHECK(says(refusal("simplify " + run + "d/id:0"), "the part one of 'a/b', 'c'"));
}

TEST_CASE("--keep: parts with the names of selectors, of files, and with the same name") {
  const ScratchFolder scratch;
  const std::string tetrahedron =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const std::string odd =
      scratch.write("odd.obj", "o id:0/q\n" + tetrahedron + "o b\nv 5 0 0\nf 5 1 3\nf 5 3 2\n");
  std::filesystem::create_directory(scratch.file("d"));
  const std::string one = scratch.write("box.obj", tetrahedron);
  const std::string two = scratch.write("d/box.obj", tetrahedron);
  const std::string output = scratch.file("out.obj");
  const std::string files = one + " " + two + " --faces 4 -o " + output;
  const json both = simplified(files + " --keep box/id:1 --keep box-2/id:2");
  CHECK(both["objects"][0]["kept"]["ids"] == json{1});
  CHECK(both["objects"][1]["kept"]["ids"] == json{2});
  const std::string written = bytes_of(output);
  CHECK(says(written, "o box\n"));
  CHECK(says(written, "o box-2\n"));
  CHECK(simplified(one + " " + two + " --total-faces 8 -o " + output)["objects"].size() == 2);
  CHECK(run_program("simplify --inner --vertices 4 " + one + " " + two + " -o " + output).exit ==
        0);
  CHECK(says(bytes_of(output), "o box-2\n"));
  const auto part = run_program("simplify --parts --faces 4 --json --keep id:0/q/id:0 " + odd);
  CHECK(part.exit == 4);  // the other part is flat: the selector was understood
}

TEST_CASE("--keep: halfspace input, and every place where a run is judged or replayed") {
  const ScratchFolder scratch;
  const std::string input = scratch.write(
      "cut.txt", "1 0 0 -1\n-1 0 0 0\n0 1 0 -1\n0 -1 0 0\n0 0 1 -1\n0 0 -1 0\n2 2 2 -5\n");
  const std::string trace = scratch.file("trace.json"), picture = scratch.file("page.html");
  for (const std::string measure : {"volume", "area", "mean-width"}) {
    CAPTURE(measure);
    const json document = simplified(input + " --faces 6 --keep normal:1,1,1 --cost " + measure +
                                     " --trace " + trace + " --picture " + picture);
    CHECK(document["kept"]["ids"] == json{6});
    const json written = json::parse(bytes_of(trace));
    CHECK(schema_complaint("trace", written) == "");
    CHECK(written["kept"] == json{6});
    CHECK(says(bytes_of(picture), "kept faces"));
    const auto judged =
        run_program("verify " + input + " --trace " + trace + " --keep plane:2,2,2,-5 --json");
    CHECK(judged.exit == 0);
    const json verdict = json::parse(judged.out);
    CHECK(schema_complaint("trace_verdict", verdict) == "");
    CHECK(verdict["kept"] == json{6});
    CHECK(run_program("verify " + input + " --trace " + trace).exit == 1);
    CHECK(run_program("verify " + input + " --trace " + trace + " --keep id:5").exit == 1);
    const auto compared = run_program("diff " + input + " --json --keep id:6 --cost " + measure);
    CHECK(compared.exit == 0);
    const json report = json::parse(compared.out);
    CHECK(schema_complaint("diff", report) == "");
    CHECK(report["objects"][0]["kept"] == json{6});
  }
  CHECK(says(refusal("simplify " + input + " --faces 6 --keep group:cut"), "no group"));
  CHECK(run_program("verify " + input + " " + input + " --keep id:6").exit == 2);
}

TEST_CASE("--keep: the floor of the bunny") {
  const json document = simplified(data("bunny.obj") + " --faces 18 --keep normal:0,-1,0");
  REQUIRE(document["kept"]["ids"].size() >= 1);
  for (const json& plane : document["kept"]["planes"]) {
    const json& n = document["output"]["planes"][plane.get<std::size_t>()];
    CHECK(n[1].get<std::string>().starts_with("-"));
  }
  CHECK(document["output"]["halfspaces"] == 18);
}
