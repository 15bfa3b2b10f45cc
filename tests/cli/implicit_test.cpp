// SPDX-License-Identifier: MIT
// simplify --implicit on the command line: the capsule, what it prints, and what is refused.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "json_schema.hpp"
#include "process.hpp"
#include "program_json.hpp"

using nlohmann::json;
using support::data;
using support::program_json;
using support::run_program;
using support::ScratchFolder;

namespace {

const std::string kBoxOption = " --box=-2,-2,-2,4 ";

std::string implicit_arguments(const std::string& file) { return "simplify --implicit " + file; }

std::string implicit_refused(int exit, const std::string& arguments) {
  const auto ran = run_program(arguments + " --faces 18");
  CAPTURE(arguments);
  CHECK(ran.exit == exit);
  CHECK(ran.out == "");
  return ran.err;
}

bool tells(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("simplify --implicit: the capsule, its cells and bounds, and a proof") {
  const ScratchFolder scratch;
  const std::string arguments = implicit_arguments(data("capsule.json")) + kBoxOption +
                                "--depth 5 --faces 18 --proof " + scratch.file("proof.txt") +
                                " -o " + scratch.file("proxy.obj");
  const json document = program_json(arguments, "result");
  // Of the specification, which had them from other code.
  const json& cells = document["implicit"];
  CHECK(cells["levels"].size() == 6);
  CHECK(cells["levels"][4]["kept"] == 240);
  CHECK(cells["levels"][5]["tested"] == 8 * 240);
  CHECK(cells["levels"][5]["kept"] == 992);
  CHECK(cells["lipschitz"] == "1");
  CHECK(cells["tightness"] == "1");
  CHECK(document["input"]["halfspaces"] == 74);
  CHECK(document["input"]["points"] == cells["corners"]);
  CHECK(document["output"]["halfspaces"] == 18);
  CHECK(document["volume"]["input"]["value"] <= cells["volume_bound"]);
  CHECK(scratch.count() == 2);
}

TEST_CASE("simplify --implicit: the summary, with and without a known tightness") {
  const ScratchFolder scratch;
  const auto known =
      run_program(implicit_arguments(data("capsule.json")) + kBoxOption + "--depth 4 --faces 18");
  CHECK(known.exit == 0);
  CHECK(tells(known.out, "tightness 1: no corner is farther than"));
  CHECK(tells(known.out, "Steiner"));
  const std::string file =
      scratch.write("cut.json", R"({"intersection": [{"sphere": {"center": [0, 0, 0], "radius": 1}},
                                       {"half-space": {"normal": [1, 1, 0], "offset": 0}}]})");
  const auto unknown = run_program(implicit_arguments(file) + kBoxOption + "--depth 4 --faces 8");
  CHECK(unknown.exit == 0);
  CHECK(tells(unknown.out, "tightness not known"));
  CHECK_FALSE(tells(unknown.out, "Steiner"));
}

TEST_CASE("simplify --implicit: options that do not go together are exit code 2") {
  const std::string capsule = implicit_arguments(data("capsule.json"));
  CHECK(tells(implicit_refused(2, "simplify"), "INPUT is required"));
  CHECK(tells(implicit_refused(2, "simplify " + data("spot.obj") + " --depth 3"), "--implicit"));
  CHECK(tells(implicit_refused(2, "simplify " + data("spot.obj") + kBoxOption), "--implicit"));
  CHECK(tells(implicit_refused(2, capsule + " --depth 3"), "--box"));
  CHECK(tells(implicit_refused(2, capsule + kBoxOption), "--depth"));
  const std::string all = capsule + kBoxOption + "--depth 3 ";
  CHECK(tells(implicit_refused(2, all + data("spot.obj")), "leave INPUT out"));
  CHECK(tells(implicit_refused(2, all + "--inner"), "--inner"));
  CHECK(tells(implicit_refused(2, all + "--parts"), "--parts"));
  CHECK(tells(implicit_refused(2, capsule + " --box=0,0,0 --depth 3"), "x0,y0,z0,edge"));
  CHECK(tells(implicit_refused(2, capsule + " --box=0,0,0,-1 --depth 3"), "above 0"));
  CHECK(tells(implicit_refused(2, capsule + kBoxOption + "--depth 21"), "0 to 20"));
}

TEST_CASE("simplify --implicit: shapes that are refused, and boxes that do not hold them") {
  const ScratchFolder scratch;
  const std::string capsule = implicit_arguments(data("capsule.json"));
  CHECK(tells(implicit_refused(4, capsule + " --box=-1,-1,-1,2 --depth 5"), "may leave the box"));
  CHECK(tells(implicit_refused(4, capsule + " --box=5,5,5,2 --depth 5"), "empty"));
  const std::string bad =
      scratch.write("bad.json", R"({"sphere": {"center": [0, 0, 0], "radius": -1}})");
  CHECK(tells(implicit_refused(3, implicit_arguments(bad) + kBoxOption + "--depth 3"),
              "bad.json: /sphere: expected a radius above 0, found -1"));
  CHECK(implicit_refused(
            3, implicit_arguments(scratch.file("missing.json")) + kBoxOption + "--depth 3") != "");
  // The shape is an input, which an output would overwrite.
  CHECK(
      tells(implicit_refused(2, implicit_arguments(bad) + kBoxOption + "--depth 3 --trace " + bad),
            "is an input"));
}
