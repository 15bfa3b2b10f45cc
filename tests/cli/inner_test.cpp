// SPDX-License-Identifier: MIT
// simplify --inner and verify --inner: files, answers, refusals.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
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

// A cube with a point in its middle, and a second one of twice the size.
const std::string kTwoCubes =
    "o small\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
    "v 0.5 0.5 0.5\nf 1 2 4 3\nf 5 6 8 7\nf 1 2 9\n"
    "o large\nv 4 0 0\nv 6 0 0\nv 4 2 0\nv 6 2 0\nv 4 0 2\nv 6 0 2\nv 4 2 2\nv 6 2 2\n"
    "f 10 11 13 12\nf 14 15 17 16\n";

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("simplify --inner: the answer is as the schema says, and verify --inner agrees") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.file("in.obj"), planes = scratch.file("in.json"),
                    rows = scratch.file("in.txt"), ine = scratch.file("in.ine"),
                    trace = scratch.file("trace.json"), page = scratch.file("in.html");
  const json document = program_json("simplify " + data("spot.obj") + " --inner --vertices 32 -o " +
                                         mesh + " -o " + planes + " -o " + rows + " -o " + ine +
                                         " --trace " + trace + " --picture " + page,
                                     "inner");
  CHECK(document["output"]["vertices"] == 32);
  CHECK(document["volume"]["ratio"].get<double>() == doctest::Approx(0.95115).epsilon(1e-5));
  CHECK(document["input"]["points"] == 2930);
  const json steps = json::parse(bytes_of(trace));
  CHECK(schema_complaint("inner-trace", steps).empty());
  CHECK(steps["vertices"].size() - steps["steps"].size() == 32);
  CHECK(bytes_of(page).find("hull of the input") != std::string::npos);
  for (const std::string& candidate : {mesh, planes, rows, ine}) {
    CAPTURE(candidate);
    const auto verdict = run_program("verify --inner --json " + data("spot.obj") + " " + candidate);
    CHECK(verdict.exit == 0);
    const json found = json::parse(verdict.out);
    CHECK(schema_complaint("verdict", found).empty());
    CHECK(found["claims"].back()["code"] == "inside-input");
    CHECK(found["claims"].back()["status"] == "holds");
    // As an enclosure it must fail.
    CHECK(run_program("verify --json " + data("spot.obj") + " " + candidate).exit == 1);
  }
  // The hull of the input is inside of it, an enclosure is not.
  CHECK(run_program("verify --inner " + data("spot.obj") + " " + data("spot.obj") +
                    " --claims inside-input")
            .exit == 0);
  const std::string outer = scratch.file("outer.obj");
  REQUIRE(run_program("simplify " + data("spot.obj") + " --faces 18 -o " + outer).exit == 0);
  CHECK(run_program("verify --inner " + data("spot.obj") + " " + outer).exit == 1);
}

TEST_CASE("verify --inner: the witness is the vertex farthest outside") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write(
      "cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n");
  // Vertex 1 is 1/4 outside, beyond x <= 1; vertex 3 is 1/8 outside.
  const std::string out =
      scratch.write("out.obj",
                    "v 0 0 0\nv 1.25 0.5 0.5\nv 0 1 0\nv 0 0 1.125\nf 1 3 2\nf 1 2 4\n"
                    "f 1 4 3\nf 2 3 4\n");
  const json document = program_json("verify --inner " + cube + " " + out, "verdict", 1);
  const json& claim = document["claims"].back();
  CHECK(claim["code"] == "inside-input");
  CHECK(claim["status"] == "violated");
  CHECK(claim["witness"]["vertices"] == json::array({1}));
  CHECK(claim["witness"]["point"] == json::array({"5/4", "1/2", "1/2"}));
  CHECK(claim["witness"]["nearest"] == json::array({"1", "1/2", "1/2"}));
  CHECK(claim["witness"]["plane"] == json::array({"1", "0", "0", "-1"}));
  CHECK(claim["witness"]["distance"]["squared"] == "1/16");
  CHECK(run_program("verify --inner --tolerance 0.25 " + cube + " " + out).exit == 0);
  CHECK(run_program("verify --inner --tolerance 0.2499 " + cube + " " + out).exit == 1);
  // Halfspaces: unbounded is outside; a smaller box is inside.
  const std::string open = scratch.write("open.txt", "1 0 0 -1\n0 1 0 -1\n0 0 1 -1\n");
  CHECK(run_program("verify --inner " + cube + " " + open).exit == 1);
  const auto alone =
      run_program("verify --inner --claims inside-input --json " + cube + " " + open);
  CHECK(alone.exit == 1);
  CHECK(json::parse(alone.out)["claims"].back()["witness"].contains("direction"));
  const std::string box =
      scratch.write("box.txt", "2 0 0 -1\n-1 0 0 0\n0 1 0 -1\n0 -1 0 0\n0 0 1 -1\n0 0 -1 0\n");
  CHECK(run_program("verify --inner " + cube + " " + box).exit == 0);
  CHECK(run_program("verify --claims inside-input " + cube + " " + box).exit == 2);
  CHECK(run_program("verify --inner " + cube + " --trace " + box).exit == 2);
}

TEST_CASE("simplify --inner: parts, triangles, loss") {
  const ScratchFolder scratch;
  const std::string cubes = scratch.write("cubes.obj", kTwoCubes), out = scratch.file("out.obj");
  const auto parts =
      run_program("simplify --inner --parts --vertices 5 --json " + cubes + " -o " + out);
  CAPTURE(parts.err);
  REQUIRE(parts.exit == 0);
  const json document = json::parse(parts.out);
  CHECK(schema_complaint("inner", document).empty());
  REQUIRE(document["objects"].size() == 2);
  // Three corners of 1/6 are lost, in the larger cube of 8/6.
  CHECK(
      document["objects"][0]["volume"]["output"]["decimal"].get<std::string>().starts_with("0.5"));
  CHECK(document["objects"][1]["volume"]["output"]["decimal"].get<std::string>().starts_with("4"));
  CHECK(count(bytes_of(out), "\nv ") + (bytes_of(out).starts_with("v ") ? 1 : 0) == 10);
  CHECK(count(bytes_of(out), "o small\n") == 1);
  CHECK(count(bytes_of(out), "o large\n") == 1);
  const auto by_triangles = [&](const std::string& faces) {
    const auto ran =
        run_program("simplify --inner --faces " + faces + " --json " + data("spot.obj"));
    return json::parse(ran.out)["output"]["triangles"].get<int>();
  };
  CHECK(by_triangles("20") == 20);
  CHECK(by_triangles("21") == 20);
  CHECK(by_triangles("4") == 4);
  const auto loss =
      run_program("simplify --inner --max-loss 10% --json --exact-values " + data("spot.obj"));
  const json limited = json::parse(loss.out);
  CHECK(schema_complaint("inner", limited).empty());
  CHECK(limited["output"]["stop"] == "loss-limit");
  CHECK(limited["volume"]["ratio"] >= 0.9);
  CHECK(limited["volume"]["input"].contains("exact"));
}

TEST_CASE("simplify --inner: what is refused, by name") {
  const ScratchFolder scratch;
  const std::string cubes = scratch.write("cubes.obj", kTwoCubes);
  const std::string tenths =
      scratch.write("tenths.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nv 0.1 0.1 0.1\n");
  const std::string flat = scratch.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n");
  const std::string planes =
      scratch.write("planes.txt", "1 0 0 -1\n-1 0 0 0\n0 1 0 -1\n0 -1 0 0\n0 0 1 -1\n0 0 -1 0\n");
  const std::vector<std::pair<std::string, int>> refused{
      {"--inner --vertices 3 " + cubes, 2},
      {"--vertices 5 " + cubes, 2},
      {"--max-loss 5% " + cubes, 2},
      {"--inner " + cubes, 2},
      {"--inner --vertices 5 --faces 6 " + cubes, 2},
      {"--inner --vertices 5 --cost area " + cubes, 2},
      {"--inner --vertices 5 --max-growth 5% " + cubes, 2},
      {"--inner --vertices 5 --keep id:0 " + cubes, 2},
      {"--inner --vertices 5 --center 1,1,1 " + cubes, 2},
      {"--inner --vertices 5 --engine float " + cubes, 2},
      {"--inner --vertices 5 --precision 32 -o " + scratch.file("x.obj") + " " + cubes, 2},
      {"--inner --vertices 5 -o " + scratch.file("x.stl") + " " + cubes, 2},
      {"--inner --vertices 5 --proof " + scratch.file("x.proof") + " " + cubes, 2},
      {"--inner --vertices 5 --precision 64 -o " + scratch.file("x.json") + " " + cubes, 5},
      {"--inner --vertices 4 --decimal exact -o " + scratch.file("x.obj") + " " + tenths, 5},
      {"--inner --vertices 4 " + flat, 4},
      {"--inner --vertices 5 " + planes, 2}};
  const std::size_t files = scratch.count();
  for (const auto& each : refused) {
    CAPTURE(each.first);
    const auto ran = run_program("simplify " + each.first);
    CAPTURE(ran.err);
    CHECK(ran.exit == each.second);
    CHECK(scratch.count() == files);
  }
  // Exact planes of the same tenths are fine.
  CHECK(run_program("simplify --inner --vertices 4 --decimal exact -o " + scratch.file("y.json") +
                    " " + tenths)
            .exit == 0);
}

TEST_CASE("simplify --inner: an option of other runs may say what is so anyway") {
  const auto code_with = [](const std::string& option) {
    return run_program("simplify " + data("spot.obj") + " --inner --vertices 8 " + option).exit;
  };
  CHECK(code_with("--cost volume") == 0);
  CHECK(code_with("--center chebyshev") == 0);
  CHECK(code_with("--search none") == 0);
  CHECK(code_with("--cost area") == 2);
  CHECK(code_with("--center 0,0,0") == 2);
  CHECK(code_with("--search walk") == 2);
  CHECK(code_with("--max-growth 0") == 2);
  CHECK(code_with("--engine float") == 2);
}
