// SPDX-License-Identifier: MIT
// convexact diff: exit codes, what --json prints (docs/schema/diff.schema.json, validated by
// valijson), and that the engines agree on the shipped meshes.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "json_schema.hpp"
#include "process.hpp"
#include "program_json.hpp"

using nlohmann::json;
using support::data;
using support::program_json;
using support::run_program;
using support::ScratchFolder;

namespace {

std::string complaint(const json& document) { return schema_complaint("diff", document); }

// [0, 4]^3 with two opposite corners of a side cut off at depths of which the costs are
// depth^3 / 6: 9/2 and 4/3.
const char* const kCutCube =
    "[[1,0,0,-4],[-1,0,0,0],[0,1,0,-4],[0,-1,0,0],[0,0,1,-4],[0,0,-1,0],"
    "[-1,-1,-1,3],[1,1,-1,-6]]";

}  // namespace

TEST_CASE("diff --json: engines that agree are exit 0, as the schema says") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cut.json", kCutCube);
  const json document = program_json("diff " + input, "diff");
  CHECK(document["explained"] == true);
  const json& object = document["objects"][0];
  CHECK(object["halfspaces"] == 8);
  CHECK(object["engines"][0] == json{{"engine", "exact"}, {"steps", 2}, {"stop", "all-unbounded"}});
  REQUIRE(object["comparisons"].size() == 2);
  CHECK(object["comparisons"][0]["compared"] == json{"removals", "costs", "ties"});
  CHECK(object["comparisons"][1]["compared"] == json{"removals"});
  for (const json& comparison : object["comparisons"]) {
    CHECK(comparison["same"] == true);
    CHECK(comparison["judged"] == 2);
    CHECK(comparison["divergences"].empty());
    CHECK(comparison["volume_ratio"]["decimal"] == "1");
  }
}

TEST_CASE("diff --json: exact ties end in the float engine as in the others (#13)") {
  // The mirror images of the shipped cow tie exactly.
  const json document = program_json("diff " + data("spot.obj") + " --faces 560", "diff");
  for (const json& comparison : document["objects"][0]["comparisons"]) {
    CHECK(comparison["same"] == true);
  }
}

TEST_CASE("diff --json: a choice of the float engine among costs equal to doubles is explained") {
  // Points of a spiral lie nearly symmetrically: exact numbers tell their costs apart.
  const ScratchFolder scratch;
  const std::string sphere = scratch.file("sphere.obj");
  REQUIRE(run_program("generate fibonacci-sphere --points 40 -o " + sphere).exit == 0);
  json document = program_json("diff " + sphere + " --faces 8", "diff");
  const json& comparisons = document["objects"][0]["comparisons"];
  CHECK(comparisons[0]["same"] == true);
  CHECK(comparisons[0]["other"] == "filtered");
  REQUIRE(comparisons[1]["same"] == false);
  const json& found = comparisons[1]["divergence"];
  CHECK(found["class"] == "gap-below-rounding");
  CHECK(found["at_fault"] == "float");
  CHECK(found["reference"]["cost"]["exact"] != found["other"]["cost"]["exact"]);
  // Every one of the 68 steps was judged, and nothing worse than rounding found.
  CHECK(comparisons[1]["judged"] == 68);
  REQUIRE(comparisons[1]["divergences"].size() > 1);
  CHECK(comparisons[1]["divergences"][0]["step"] == found["step"]);
  for (const json& each : comparisons[1]["divergences"]) {
    CHECK((each["class"] == "tie" || each["class"] == "gap-below-rounding"));
    CHECK(each["at_fault"] == "float");
  }
  CHECK(comparisons[1]["worst"]["regret"]["value"] >= 0);
  document["objects"][0]["comparisons"][1]["divergence"]["class"] = "bad luck";
  CHECK(complaint(document) != "");
}

TEST_CASE("diff: several files make a table of a row per comparison") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cut.json", kCutCube);
  const auto ran = run_program("diff " + input + " " + input + " --engines filtered,float");
  CHECK(ran.exit == 0);
  std::size_t rows = 0;
  for (std::size_t at = ran.out.find("filtered float "); at != std::string::npos;
       at = ran.out.find("filtered float ", at + 1)) {
    ++rows;
  }
  CHECK(rows == 2);
}

TEST_CASE("diff: bad input and wrong usage have the exit codes of the manual") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cut.json", kCutCube);
  for (const char* arguments : {"--faces 3", "--engines exact", "--engines exact,exact",
                                "--engines exact,slow", "--engines ,"}) {
    CAPTURE(arguments);
    CHECK(run_program("diff " + input + " " + arguments).exit == 2);
  }
  CHECK(run_program("diff").exit == 2);
  CHECK(run_program("diff --help").exit == 0);
  CHECK(run_program("diff " + scratch.file("missing.obj")).exit == 3);
  const auto flat = run_program("diff --json " + scratch.write("flat.obj", "v 0 0 0\nv 1 0 0\n"));
  CHECK(flat.exit == 4);
  CHECK(complaint(json::parse(flat.out)) == "");
}

TEST_CASE("diff --cost: the engines agree by area and by mean width, as the schema says") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cut.json", kCutCube);
  for (const std::string cost : {"area", "mean-width"}) {
    CAPTURE(cost);
    const std::string arguments = "diff " + input + " --engines exact,filtered --cost " + cost;
    const json document = program_json(arguments, "diff");
    const json& object = document["objects"][0];
    CHECK(object["cost"] == cost);
    CHECK(object["comparisons"][0]["same"] == true);
    CHECK(object["comparisons"][0]["compared"] == json{"removals", "costs", "ties"});
    CHECK(object["comparisons"][0]["measure_ratio"]["decimal"] == "1");
    const auto table = run_program(arguments);
    CHECK(table.out.find(cost == "area" ? "final area" : "final width") != std::string::npos);
  }
  CHECK(run_program("diff " + input + " --cost weight").exit == 2);
}
