// SPDX-License-Identifier: MIT
// convexact compare: what it prints is as the schema says and true of the solids in it; wrong usage
// and inputs without volume are refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "json_schema.hpp"
#include "process.hpp"
#include "program_json.hpp"

using nlohmann::json;
using support::bytes_of;
using support::data;
using support::program_json;
using support::Ran;
using support::run_program;
using support::ScratchFolder;

namespace {

// [0, 1]^3 as an OBJ without faces, and the octahedron with vertices +-1.
constexpr const char* kUnitCube =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
constexpr const char* kUnitOctahedron = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n";

json comparison_of(const std::string& arguments, int exit = 0) {
  return program_json("compare " + arguments, "compare", exit);
}

std::string comparison_error(const std::string& arguments, int exit) {
  const json error = comparison_of(arguments, exit)["error"];
  CHECK(error["exit"] == exit);
  return error["message"];
}

bool has_text(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("compare: two solids with known ratios, and their medians") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("cube.obj", kUnitCube),
                    octahedron = scratch.write("octahedron.obj", kUnitOctahedron);
  const json answer =
      comparison_of(cube + " " + octahedron + " --faces 13 --methods greedy,aabb,kdop14");
  REQUIRE(answer["inputs"].size() == 2);
  // The box of the octahedron has 8 over 4/3 of the volume.
  const json& box = answer["inputs"][1]["methods"][1];
  CHECK(box["method"] == "aabb");
  CHECK(box["volume"]["decimal"] == "6");
  CHECK(box["planes"] == 6);
  CHECK(box["least"] == false);
  CHECK(box["halfspaces"].size() == 6);
  // Of several equally small ones the first is the least, and none of them beats greedy.
  for (const json& input : answer["inputs"]) {
    CHECK(input["methods"][0]["least"] == true);
    for (const json& method : input["methods"]) CHECK(method["beats_greedy"] == false);
  }
  const json& medians = answer["medians"];
  REQUIRE(medians.size() == 3);
  CHECK(medians[2]["method"] == "aabb");
  CHECK(medians[2]["volume"] == 3.5);
  CHECK(medians[2]["inputs"] == 2);
}

TEST_CASE("compare: the table names the least, what beats greedy, and what has too many planes") {
  const Ran ran = run_program("compare " + data("spot.obj") + " --faces 12 " +
                              "--methods greedy,search,kdop26,stl");
  CHECK(ran.exit == 0);
  CHECK(has_text(ran.out, "least volume"));
  CHECK(has_text(ran.out, "more than 12 planes, not ranked"));
  CHECK(has_text(ran.out, "596 facets"));
  CHECK_FALSE(has_text(ran.out, "medians"));
}

TEST_CASE("compare: the CSV has a row for each input and method") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("a,cube.obj", kUnitCube), csv = scratch.file("out.csv");
  CHECK(run_program("compare '" + cube + "' --methods aabb,obb --csv " + csv).exit == 0);
  const std::string bytes = bytes_of(csv);
  CHECK(std::count(bytes.begin(), bytes.end(), '\n') == 3);
  CHECK(has_text(bytes, "a,cube.obj\",aabb,18,6,1,1,1,0,"));
}

TEST_CASE("compare: of a cube inside, four corners keep a third") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("cube.obj", kUnitCube), csv = scratch.file("out.csv");
  const json answer = comparison_of(cube + " --inner --vertices 4 --csv " + csv);
  CHECK(answer["vertices"] == 4);
  CHECK_FALSE(answer.contains("faces"));
  const json& methods = answer["inputs"][0]["methods"];
  REQUIRE(methods.size() == 2);
  CHECK(methods[0]["method"] == "drop");
  CHECK(methods[0]["vertices"] == 4);
  CHECK(methods[0]["volume"]["value"].get<double>() == doctest::Approx(1 / 3.0));
  CHECK(methods[0]["most"] == true);
  CHECK(methods[1]["method"] == "qem-ends");
  CHECK(has_text(bytes_of(csv), "most vertices"));
  const json whole = comparison_of(cube + " --inner --vertices 8");
  for (const json& method : whole["inputs"][0]["methods"]) {
    CHECK(method["volume"]["decimal"] == "1");
    CHECK(method["beats_drop"] == false);
  }
  const Ran ran = run_program("compare " + data("spot.obj") + " --inner --vertices 12");
  CHECK(ran.exit == 0);
  CHECK(has_text(ran.out, "at most 12 vertices, inside"));
  CHECK(has_text(ran.out, "most volume"));
}

TEST_CASE("compare: options of solids around the inputs and inside do not mix") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("cube.obj", kUnitCube);
  CHECK(has_text(comparison_error(cube + " --inner --faces 6", 2), "--inner"));
  CHECK(has_text(comparison_error(cube + " --vertices 6", 2), "--inner"));
  CHECK(has_text(comparison_error(cube + " --methods drop", 2), "give --inner"));
  CHECK(has_text(comparison_error(cube + " --inner --methods drop,aabb", 2), "encloses the hull"));
  comparison_error(cube + " --inner --vertices 3", 2);
}

TEST_CASE("compare: the list has every method") {
  const json list = comparison_of("--list");
  std::vector<std::string> names;
  for (const json& method : list["methods"]) names.push_back(method["name"]);
  for (const char* name :
       {"greedy", "search", "mck", "stl", "aabb", "kdop26", "obb", "random", "drop", "qem-ends"}) {
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  }
  const Ran ran = run_program("compare --list");
  CHECK(ran.exit == 0);
  for (const std::string& name : names) CHECK(has_text(ran.out, name));
}

TEST_CASE("compare: wrong usage and inputs without volume are refused, and nothing is written") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("cube.obj", kUnitCube),
                    flat = scratch.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n");
  const std::string unknown = comparison_error(cube + " --methods greedy,qslim", 2);
  CHECK(has_text(unknown, "qslim"));
  CHECK(has_text(unknown, "mck"));
  CHECK(has_text(comparison_error("", 2), "INPUT"));
  comparison_error(cube + " --faces 3", 2);
  comparison_error(cube + " --methods ''", 2);
  comparison_error(cube + " --csv " + cube, 2);
  CHECK(bytes_of(cube) == kUnitCube);
  comparison_error(scratch.file("none.obj"), 3);
  const std::string csv = scratch.file("out.csv");
  comparison_error(cube + " " + flat + " --methods aabb --csv " + csv, 4);
  CHECK_FALSE(std::filesystem::exists(csv));
}

TEST_CASE("compare: the same seed prints the same solids") {
  const auto solids = [](const std::string& seed) {
    json methods = comparison_of(data("spot.obj") + " --faces 9 --methods stl,random --seed " +
                                 seed)["inputs"][0]["methods"];
    return std::vector<json>{methods[0]["halfspaces"], methods[1]["halfspaces"]};
  };
  CHECK(solids("3") == solids("3"));
  CHECK(solids("3") != solids("4"));
}
