// SPDX-License-Identifier: MIT
// convexact decompose with the method cut, which is the default for solids: what is said first,
// files, budgets, profiles. Shapes of unit cells, whose parts can be counted.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cells.hpp"
#include "json_schema.hpp"
#include "process.hpp"
#include "program_json.hpp"
#include "sweep.hpp"

using nlohmann::json;
using support::bytes_of;
using support::program_json;
using support::run_program;
using support::ScratchFolder;

namespace {

std::string cells_obj(const std::set<support::Cell>& cells, std::size_t left_out = 0) {
  const support::Mesh mesh = support::mesh_of_cells(cells);
  std::ostringstream text;
  for (const support::Point& p : mesh.points.doubles()) {
    text << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  for (std::size_t f = left_out; f < mesh.polygons.size(); ++f) {
    text << "f";
    for (const std::uint32_t corner : mesh.polygons[f]) text << " " << corner + 1;
    text << "\n";
  }
  return text.str();
}

const std::set<support::Cell> kU = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {2, 0, 1}};

}  // namespace

TEST_CASE("decompose cut: solids are cut, and the first line says what is proven") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("u.obj", cells_obj(kU)),
                    parts = scratch.file("parts.obj");
  const auto ran = run_program("decompose " + input + " -o " + parts);
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.find("  result      3 parts hold the solid; no point of them is farther than 3% of "
                     "the diameter") == ran.out.find('\n') + 1);
  CHECK(ran.out.find("hollow      nothing: the parts hold the solid") != std::string::npos);
  CHECK(run_program("verify " + input + " " + parts + " --distance 3%").exit == 0);
  // Its own hull fills the notch: 1/2 deep at least, of a diameter of 3.7.
  CHECK(run_program("verify " + input + " " + input + " --distance 3%").exit == 1);
}

TEST_CASE("decompose cut: an open surface, or an option of clusters, takes hacd and says so") {
  const ScratchFolder scratch;
  const std::string open = scratch.write("open.obj", cells_obj(kU, 6)),
                    input = scratch.write("u.obj", cells_obj(kU));
  const auto shell = run_program("decompose --points used --close never " + open);
  CHECK(shell.exit == 0);
  CHECK(shell.err.find("the surface is open: hacd") != std::string::npos);
  CHECK(shell.out.find("from the surface, proven") != std::string::npos);
  const auto clusters = run_program("decompose --concavity 5% " + input);
  CHECK(clusters.exit == 0);
  CHECK(clusters.err.find("--method cut holds solids") != std::string::npos);
}

TEST_CASE("decompose cut: JSON, trace, picture, tree and proof of one run") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("u.obj", cells_obj(kU)), list = scratch.file("u.json"),
                    trace = scratch.file("trace.json"), proof = scratch.file("u.proof");
  const json answer = program_json(
      "decompose " + input + " -o " + list + " --trace " + trace + " --proof " + proof +
          " --picture " + scratch.file("u.html") + " --tree " + scratch.file("tree.json"),
      "decompose");
  CHECK(answer["method"] == "cut");
  CHECK(answer["covers"] == "solid");
  CHECK(answer["eps_holds"] == true);
  CHECK(answer["stop"] == "distance");
  CHECK(answer["reach"]["holds"] == true);
  CHECK(answer["excess"]["high"].get<double>() < 1e-30);
  CHECK_FALSE(answer.contains("concavity"));
  const json document = json::parse(bytes_of(list));
  CHECK(schema_complaint("decompose", document) == "");
  std::size_t held = 0;
  for (const json& node : document["tree"]) {
    CHECK(node.contains("plane") == node.contains("children"));
    held += node["part"].is_null() ? 0 : 1;
  }
  CHECK(held == answer["cuts"]["leaves"].get<std::size_t>());
  const json cuts = json::parse(bytes_of(trace));
  CHECK(schema_complaint("decompose-cut-trace", cuts) == "");
  CHECK(cuts["leaves"].size() == held);
  CHECK(cuts["parts"].size() == 3);
  CHECK(bytes_of(proof).starts_with("convexact-proof 6 partition\n"));
  CHECK(bytes_of(scratch.file("u.html")).find("part 2") != std::string::npos);
  CHECK(run_program("verify " + input + " " + scratch.file("tree.json") + " --union").exit == 0);
}

TEST_CASE("decompose cut: any number of threads makes the same bytes" * sweep) {
  const ScratchFolder scratch;
  const std::string list = scratch.file("parts.json"), mesh = scratch.file("parts.obj"),
                    trace = scratch.file("trace.json"), proof = scratch.file("parts.proof");
  const auto made_by = [&](int jobs) {
    json answer =
        program_json("decompose " + support::data("spot.obj") +
                         " --method cut --distance 10% --jobs " + std::to_string(jobs) + " -o " +
                         mesh + " -o " + list + " --trace " + trace + " --proof " + proof,
                     "decompose");
    for (json& stage : answer["stages"]) stage.erase("seconds");
    return std::vector{answer.dump(), bytes_of(mesh), bytes_of(list), bytes_of(trace),
                       bytes_of(proof)};
  };
  const std::vector<std::string> alone = made_by(1);
  for (const std::string& bytes : alone) CHECK(bytes.size() > 1000);
  for (const int jobs : {2, 3, 8}) {
    CAPTURE(jobs);
    const bool is_same = made_by(jobs) == alone;  // a CHECK of megabytes would print them
    CHECK(is_same);
  }
}

TEST_CASE("decompose: options of parts, with any number of threads" * sweep) {
  const ScratchFolder scratch;
  const std::string list = scratch.file("parts.json"), mesh = scratch.file("parts.obj");
  for (const char* options :
       {"cases/cup.obj --method cut --distance 5% --disjoint",
        "cases/house.obj --method cut --effort high",
        "spot.obj --method cut --distance 10% --faces 20 --max-excess 30%",
        "spot.obj --method hacd --guard reach --merge reach --distance 5% --faces 20",
        "teapot.obj --method hacd --guard reach --merge reach --distance 5% --precision 32"}) {
    CAPTURE(options);
    const auto made_by = [&](int jobs) {
      json answer = program_json("decompose " + support::data("") + options + " --jobs " +
                                     std::to_string(jobs) + " -o " + mesh + " -o " + list,
                                 "decompose");
      for (json& stage : answer["stages"]) stage.erase("seconds");
      return std::vector{answer.dump(), bytes_of(mesh), bytes_of(list)};
    };
    const std::vector<std::string> alone = made_by(1);
    for (const int jobs : {2, 5}) {
      CAPTURE(jobs);
      const bool is_same = made_by(jobs) == alone;  // a CHECK of megabytes would print them
      CHECK(is_same);
    }
  }
}

TEST_CASE("decompose cut: disjoint parts") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("u.obj", cells_obj(kU)),
                    parts = scratch.file("parts.obj");
  const auto ran = run_program("decompose --disjoint " + input + " -o " + parts);
  CHECK(ran.exit == 0);
  CHECK(ran.out.find("disjoint    no two parts have a common interior point, proven") !=
        std::string::npos);
  const json answer = program_json("decompose --disjoint " + input, "decompose");
  CHECK(answer["disjoint"]["squared_push"] == "0");
  CHECK(answer["disjoint"]["planes"].size() == 3);
  const std::string asks = " --union --claims parts-disjoint";
  CHECK(run_program("verify " + input + " " + parts + asks).exit == 0);
  CHECK(run_program("decompose --method hacd --disjoint " + input).exit == 2);
  // Two bars that have a cell in common: half a cell beyond a plane in the middle of it.
  const std::string crossing = scratch.write(
      "crossing.json", R"({"parts": [{"vertices": [[0,0,0],[2,0,0],[2,1,0],[0,1,0],[0,0,1],)"
                       R"([2,0,1],[2,1,1],[0,1,1]]}, {"vertices": [[1,0,0],[3,0,0],[3,1,0],)"
                       R"([1,1,0],[1,0,1],[3,0,1],[3,1,1],[1,1,1]]}]})");
  CHECK(run_program("verify " + input + " " + crossing + asks).exit == 1);
  CHECK(run_program("verify " + input + " " + crossing + asks + " --tolerance 0.49").exit == 1);
  CHECK(run_program("verify " + input + " " + crossing + asks + " --tolerance 0.5").exit == 0);
}

TEST_CASE("decompose cut: a number of parts, and parts that fit a program") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("u.obj", cells_obj(kU));
  const json one = program_json("decompose " + input + " --max-parts 1", "decompose");
  CHECK(one["parts"].size() == 1);
  CHECK(one["eps_holds"] == false);
  CHECK(one["reach"]["farther"].size() == 1);
  CHECK(one["parts"][0]["status"] == "beyond-eps");
  const json fits = program_json("decompose " + input + " --profile physx-gpu", "decompose");
  CHECK(fits["precision"] == "binary32");
  for (const json& part : fits["parts"]) {
    CHECK(part["corners"] <= 64);
    CHECK(part["facets"] <= 64);
  }
  CHECK(fits["reach"]["holds"] == true);
  // Without the profile parts of this one have more than 500 corners.
  const std::string spot = support::data("spot.obj"), small = scratch.file("small.obj");
  const json less = program_json(
      "decompose " + spot + " --profile physx-gpu --distance 10% -o " + small, "decompose");
  CHECK(less["reach"]["holds"] == true);
  CHECK(run_program("verify " + spot + " " + small + " --profile physx-gpu --distance 10%").exit ==
        0);
  // The hull of a plus: a prism over an octagon. (A box keeps its corners: no face can go.)
  const std::string plus =
      scratch.write("plus.obj", cells_obj({{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}}));
  for (const auto& [option, corners] : {std::pair("", 16), {" --max-part-vertices 12", 12}}) {
    const json prism = program_json("decompose " + plus + " --distance 30%" + option, "decompose");
    REQUIRE(prism["parts"].size() == 1);
    CHECK(prism["parts"][0]["corners"] == corners);
  }
  CHECK(run_program("decompose " + input + " --max-part-vertices 3").exit == 2);
  CHECK(run_program("decompose " + input + " --max-part-vertices 9 --total-faces 40").exit == 2);
  CHECK(run_program("decompose " + input + " --profile physx --max-part-vertices 9").exit == 2);
  CHECK(run_program("decompose " + input + " --profile physx --faces 9").exit == 2);
  CHECK(run_program("decompose " + input + " --profile nobody").exit == 2);
}
