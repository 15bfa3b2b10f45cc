// SPDX-License-Identifier: MIT
// What --json prints, against docs/schema/result.schema.json (validated by valijson), and against
// facts of a run that follow by arithmetic alone.
#include <doctest/doctest.h>

#include <chrono>
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

bool is_valid(const json& document) { return schema_complaint("result", document).empty(); }

}  // namespace

TEST_CASE("--json: a result is as the schema says") {
  const auto ran =
      run_program("simplify " + data("spot.obj") + " --faces 100 --json --exact-values");
  REQUIRE(ran.exit == 0);
  json document = json::parse(ran.out);
  CHECK(is_valid(document));
  CHECK(document["output"]["halfspaces"] == 100);
  CHECK(document["output"]["planes"].size() == 100);
  CHECK(document["output"]["reached"] == true);
  CHECK(document["input"]["points"] == 2930);
  document["output"].erase("reached");
  CHECK_FALSE(is_valid(document));
}

TEST_CASE("--json: runs by area and by mean width, their measure and their ties") {
  for (const char* measure : {"area", "mean-width"}) {
    CAPTURE(measure);
    const ScratchFolder scratch;
    const json document =
        program_json("simplify " + data("spot.obj") + " --faces 580 --cost " +
                         std::string(measure) + " --proof " + scratch.file("proof"),
                     "result");
    CHECK(document["cost"] == measure);
    CHECK(document["proof"] ==
          (std::string(measure) == "area" ? "greedy-area" : "costs-not-shown"));
    CHECK(document[std::string(measure) == "area" ? "area" : "mean_width"]["ratio"] > 1.0);
    CHECK(document["ties"]["congruent"] > 0);  // the cow is its own mirror image
  }
}

TEST_CASE("--json: a cube cannot lose a side, and that is said") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write(
      "cube.json",
      "[[1,0,0,-1],[-1,0,0,-1],[0,1,0,-1],[0,-1,0,-1],[0,0,1,-1],[0,0,-1,-1],[1,0,0,-2]]");
  const json document = program_json("simplify " + cube + " --faces 5 --exact-values", "result");
  CHECK(document["output"]["reached"] == false);
  CHECK(document["output"]["halfspaces"] == 6);
  CHECK(document["input"]["redundant"] == json{6});
  CHECK(document["volume"]["output"]["exact"] == "8");
  CHECK(document["output"]["stop"] == "all-unbounded");
  // The float engine says what it can prove.
  const auto doubles = run_program("simplify " + cube + " --faces 5 --json --engine float");
  REQUIRE(doubles.exit == 0);
  CHECK(is_valid(json::parse(doubles.out)));
  CHECK(json::parse(doubles.out)["output"]["stop"] == "all-unbounded");
  CHECK(json::parse(doubles.out)["float_bound"]["vouched"] == true);
  // Facets that are plane but for rounding: it cannot tell which of them is the cheapest.
  const std::string rounded = scratch.write("rounded.xyz", "");
  REQUIRE(run_program("generate rounded-box -o " + rounded).exit == 0);
  const auto words = run_program("simplify " + rounded + " --faces 5 --engine float");
  CHECK((words.out + words.err).find("--engine filtered decides") != std::string::npos);
}

TEST_CASE("--json: failures and several objects are as the schema says") {
  const ScratchFolder scratch;
  const std::string flat = scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  const auto failed = run_program("simplify --json --faces 4 " + flat);
  CHECK(failed.exit == 4);
  const json error = json::parse(failed.out);
  CHECK(is_valid(error));
  CHECK(error["error"]["proof"]["equations"].size() == 1);

  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string two = scratch.write("two.obj", tetrahedron + "o first\nf 1 2 3\nf 1 2 4\n" +
                                                       "v 5 5 5\nv 6 5 5\nv 5 6 5\nv 5 5 6\n" +
                                                       "o second\nf 5 6 7\nf 5 6 8\n");
  const json document = program_json(
      "simplify --parts --faces 4 " + two + " -o " + scratch.file("proxies.obj"), "result");
  CHECK(document["objects"].size() == 2);
  CHECK(document["objects"][1]["output"]["halfspaces"] == 4);
}

TEST_CASE("--json: the stages tell nearly all of the run's time, or why they were left out") {
  const ScratchFolder scratch;
  const auto start = std::chrono::steady_clock::now();
  const auto ran = run_program("simplify " + data("spot.obj") + " --faces 18 --json");
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  REQUIRE(ran.exit == 0);
  double seconds = 0;
  bool dual_is_explained = false;
  const json document = json::parse(ran.out);
  for (const json& stage : document["stages"]) {
    if (stage.contains("seconds")) seconds += stage["seconds"].get<double>();
    if (stage["name"] == "hull of dual points") dual_is_explained = stage.contains("skipped");
  }
  CHECK(dual_is_explained);
  CHECK(seconds <= spent.count());
}
