// SPDX-License-Identifier: MIT
// simplify --total-faces: what it refuses, what it prints and writes, and that everything is
// written or nothing. Expected numbers are closed forms: a corner cut off a unit cube at the depth
// d has the volume d^3 / 6.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>
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

// A unit cube of which the corner at the origin is cut off at depth d, beside others by x.
std::string cut_cube(const std::string& name, double x, double d, int first) {
  std::ostringstream text;
  text << "o " << name << "\n";
  const double corners[10][3] = {{d, 0, 0}, {0, d, 0}, {0, 0, d}, {1, 0, 0}, {0, 1, 0},
                                 {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  for (const auto& c : corners) text << "v " << x + c[0] << " " << c[1] << " " << c[2] << "\n";
  const std::vector<std::vector<int>> faces = {{1, 3, 2},      {4, 7, 10, 8},   {5, 9, 10, 7},
                                               {6, 8, 10, 9},  {1, 4, 8, 6, 3}, {1, 2, 5, 7, 4},
                                               {2, 3, 6, 9, 5}};
  for (const auto& face : faces) {
    text << "f";
    for (const int corner : face) text << " " << corner + first - 1;
    text << "\n";
  }
  return text.str();
}

std::string two_cubes() { return cut_cube("deep", 0, 0.5, 1) + cut_cube("shallow", 4, 0.25, 11); }

// The refusal names the option.
void check_refused(const std::string& arguments, int exit = 2) {
  CAPTURE(arguments);
  const auto ran = run_program("simplify " + arguments);
  CHECK(ran.exit == exit);
  if (exit == 2) CHECK(ran.err.find("--total-faces") != std::string::npos);
}

}  // namespace

TEST_CASE("scene: one budget, in JSON and as a mesh with the names of the parts") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("room.obj", two_cubes());
  const std::string mesh = scratch.file("proxy.obj"), page = scratch.file("proxy.html");
  const json document = program_json("simplify " + input + " --parts --total-faces 13 -o " + mesh +
                                         " --picture " + page + " --exact-values",
                                     "result");
  CHECK(document["total"]["input"]["halfspaces"] == 14);
  CHECK(document["total"]["output"]["halfspaces"] == 13);
  CHECK(document["total"]["output"]["reached"] == true);
  CHECK(document["total"]["output"]["stop"] == "reached");
  CHECK(document["total"]["volume"]["input"]["exact"] == "253/128");
  CHECK(document["total"]["volume"]["output"]["exact"] == "95/48");
  CHECK(document["total"]["gaps"] ==
        json{{"faces", 14}, {"out_of_own_part", 0}, {"in_no_part", 0}});
  CHECK(document["objects"][0]["output"]["halfspaces"] == 7);
  CHECK(document["objects"][1]["output"]["halfspaces"] == 6);
  CHECK(document["objects"][1]["volume"]["output"]["exact"] == "1");
  const std::string bytes = bytes_of(mesh);
  CHECK(bytes.find("o deep\n") != std::string::npos);
  CHECK(bytes.find("o shallow\n") != std::string::npos);
  CHECK_FALSE(bytes_of(page).empty());
  const auto words = run_program("simplify " + input + " --parts --total-faces 12");
  CHECK(words.out.find("all parts together") != std::string::npos);
  CHECK(words.out.find("12 halfspaces of 14") != std::string::npos);
  CHECK(words.out.find("0 of 14 faces are outside the solid of their part: proven") !=
        std::string::npos);
}

TEST_CASE("scene: every measure, stuck parts, and several files") {
  const ScratchFolder scratch;
  const std::string deep = scratch.write("deep.obj", cut_cube("a", 0, 0.5, 1));
  const std::string shallow = scratch.write("shallow.obj", cut_cube("b", 0, 0.25, 1));
  for (const std::string cost : {"volume", "area", "mean-width"}) {
    for (const std::string engine : {"exact", "filtered", "float"}) {
      const json document = program_json("simplify " + deep + " " + shallow + " --total-faces 8" +
                                             " --cost " + cost + " --engine " + engine,
                                         "result");
      CHECK(document["total"]["cost"] == cost);
      CHECK(document["total"]["output"]["halfspaces"] == 12);
      CHECK(document["total"]["output"]["reached"] == false);
      CHECK(document["total"]["output"]["stop"] == "all-unbounded");
      CHECK(document["total"].contains("ties") == (engine != "float"));
      CHECK(document["total"].contains("area") == (cost == "area"));
    }
  }
  const auto limited = run_program("simplify " + deep + " " + shallow +
                                   " --total-faces 8 --max-growth 1% --growth-of area --json");
  REQUIRE(limited.exit == 0);
  const json document = json::parse(limited.out);
  CHECK(schema_complaint("result", document).empty());
  CHECK(document["total"]["output"]["stop"] == "growth-limit");
  CHECK(document["total"]["output"]["halfspaces"] == 13);
  CHECK(document["total"]["growth_of"] == "area");
}

TEST_CASE("scene: one part alone is the plain run") {
  const ScratchFolder scratch;
  const auto planes_of = [](const support::Ran& ran, bool is_scene) {
    REQUIRE(ran.exit == 0);
    const json document = json::parse(ran.out);
    CHECK(schema_complaint("result", document).empty());
    return is_scene ? document["objects"][0]["output"] : document["output"];
  };
  const std::string trace = scratch.file("scene.json"), plain = scratch.file("plain.json");
  const std::string end = " --json --parts --trace ";
  CHECK(
      planes_of(run_program("simplify " + data("spot.obj") + " --total-faces 560" + end + trace),
                true) ==
      planes_of(run_program("simplify " + data("spot.obj") + " --faces 560" + end + plain), false));
  CHECK(bytes_of(trace) == bytes_of(plain));
}

TEST_CASE("scene: refusals are named") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("room.obj", two_cubes());
  check_refused(input + " --total-faces 12");
  check_refused(input + " --parts --total-faces 7");
  check_refused(input + " --parts --total-faces 3");
  check_refused(input + " --parts --total-faces 12x");
  check_refused(input + " --parts --total-faces 12 --faces 6");
  check_refused(input + " --parts --total-faces 12 --center 0.5,0.5,0.5");
  check_refused(input + " " + data("spot.obj") + " --total-faces 7");
  const auto trace = run_program("simplify " + input + " --parts --total-faces 12 --trace " +
                                 scratch.file("trace.json"));
  CHECK(trace.exit == 2);
  CHECK(scratch.count() == 1);
}

TEST_CASE("scene: everything is written or nothing") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("room.obj", two_cubes());
  const std::string flat =
      scratch.write("flat.obj", two_cubes() + "o flat\nv 0 0 9\nv 1 0 9\nv 0 1 9\nf 21 22 23\n");
  const std::string mesh = scratch.file("a.obj");
  const std::string outputs = " -o " + mesh + " --picture ";
  CHECK(run_program("simplify " + input + " --parts --total-faces 12" + outputs +
                    scratch.file("missing/a.html"))
            .exit == 5);
  const auto ran = run_program("simplify " + flat + " --parts --total-faces 14 --json" + outputs +
                               scratch.file("a.html"));
  CHECK(ran.exit == 4);
  CHECK(schema_complaint("result", json::parse(ran.out)).empty());
  CHECK(ran.out.find("flat.obj: flat") != std::string::npos);
  CHECK(run_program("simplify " + input + " --parts --total-faces 12" + outputs +
                    scratch.file("a.html") + " >/dev/full #")
            .exit == 5);
  CHECK(scratch.count() == 2);
}

TEST_CASE("scene: verify --parts judges each part, and the gaps") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("room.obj", two_cubes());
  const std::string whole = cut_cube("deep", 0, 0.125, 1), narrow = cut_cube("shallow", 4, 0.5, 11);
  const auto judged = [&](const std::string& candidate, const std::string& options, int exit) {
    const std::string file = scratch.write("candidate.obj", candidate);
    return program_json("verify --parts " + input + " " + file + options, "verdict", exit);
  };
  // Itself; other names in the same order; the same names in another order.
  for (const std::string& candidate :
       {two_cubes(), cut_cube("a", 0, 0.5, 1) + cut_cube("b", 4, 0.25, 11),
        cut_cube("shallow", 4, 0.25, 1) + cut_cube("deep", 0, 0.5, 11)}) {
    const json document = judged(candidate, "", 0);
    CHECK(document["verdict"] == "holds");
    CHECK(document["parts"].size() == 2);
    CHECK(document["parts"][0]["part"] == "deep");
    CHECK(document["gaps"]["status"] == "holds");
    CHECK(document["gaps"]["faces"] == 14);
    CHECK_FALSE(document["gaps"].contains("witness"));
  }
  // The second part is cut deeper than its input: the four faces at that corner stick out.
  const json cut = judged(whole + narrow, "", 1);
  CHECK(cut["verdict"] == "violated");
  CHECK(cut["parts"][0]["verdict"] == "holds");
  CHECK(cut["parts"][1]["verdict"] == "violated");
  CHECK(cut["gaps"]["status"] == "violated");
  CHECK(cut["gaps"]["out_of_own_part"] == 4);
  CHECK(cut["gaps"]["in_no_part"] == 4);
  CHECK(cut["gaps"]["witness"]["part"] == "shallow");
  CHECK(cut["gaps"]["witness"]["face"] == 0);
  CHECK(cut["gaps"]["witness"]["plane"] == json{"-2", "-2", "-2", "9"});  // x + y + z >= 9/2
  const json alone = judged(whole + narrow, " --claims no-gaps", 1);
  CHECK(alone["parts"].empty());
  CHECK(alone["gaps"] == cut["gaps"]);
  CHECK_FALSE(judged(whole + narrow, " --claims mesh-closed", 0).contains("gaps"));
  // Exchanged candidates: each cube is in the other part only.
  const json exchanged = judged(cut_cube("shallow", 0, 0.125, 1) + cut_cube("deep", 4, 0.125, 11),
                                " --claims no-gaps", 1);
  CHECK(exchanged["gaps"]["out_of_own_part"] == 14);
  CHECK(exchanged["gaps"]["in_no_part"] == 0);
  // A flat part encloses nothing, and a file that cannot be read is no enclosure of any part.
  const json flat = judged(whole + "o shallow\nv 4 0 0\nv 5 0 0\nv 4 1 0\nf 11 12 13\n", "", 1);
  CHECK(flat["gaps"]["out_of_own_part"] == 7);
  CHECK_FALSE(flat["gaps"]["witness"].contains("plane"));
  const json unreadable = judged("v 0 0 x\n", " --claims no-gaps", 1);
  CHECK_FALSE(unreadable.contains("gaps"));
  CHECK(unreadable["parts"].size() == 2);
}

TEST_CASE("scene: verify --parts refuses parts that do not match") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("room.obj", two_cubes());
  const auto refused = [&](const std::string& candidate, const std::string& says,
                           const std::string& name = "c.obj") {
    const auto ran = run_program("verify --parts " + input + " " + scratch.write(name, candidate));
    CAPTURE(ran.err);
    CHECK(ran.exit == 2);
    CHECK(ran.err.find(says) != std::string::npos);
  };
  refused(cut_cube("deep", 0, 0.5, 1), "the input has 2 parts and the candidate has 1");
  refused(cut_cube("deep", 0, 0.5, 1) + cut_cube("other", 4, 0.25, 11),
          "the candidate has no part 'shallow'");
  refused(cut_cube("shallow", 0, 0.5, 1) + cut_cube("shallow", 4, 0.25, 11),
          "the input has 2 parts and the candidate has 1");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n", "the file has no faces, so no parts");
  refused("[[1,0,0,-1],[-1,0,0,-1],[0,1,0,-1],[0,-1,0,-1],[0,0,1,-1],[0,0,-1,-1]]",
          "the candidate is a list of halfspaces, which has no parts", "c.json");
  CHECK(run_program("verify --claims no-gaps " + input + " " + input).exit == 2);
  CHECK(run_program("verify --parts " + input + " --trace " + input).exit == 2);
  CHECK(run_program("verify --parts --stdio").exit == 2);
  const std::string flat =
      scratch.write("flat.obj", two_cubes() + "o flat\nv 0 0 9\nv 1 0 9\nv 0 1 9\nf 21 22 23\n");
  CHECK(run_program("verify --parts " + flat + " " + flat).exit == 4);
}

// Expected by the definition: the hull of the second object is far from that of the first, and the
// bar is longer than both boxes together.
TEST_CASE("scene: objects that are only points are objects") {
  const ScratchFolder scratch;
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n",
                    faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const std::string cloud = "v 100 100 100\nv 101 100 100\nv 100 101 100\nv 100 100 101\n";
  const std::string loose = scratch.write("loose.obj",
                                          "o a\n" + tetrahedron + faces + "o cloud\n" + cloud),
                    alone = scratch.write("alone.obj", "o a\n" + tetrahedron + faces),
                    out = scratch.file("out.obj");
  const auto ran = run_program("simplify --parts --faces 4 " + loose + " -o " + out);
  CHECK(ran.exit == 0);
  CHECK(bytes_of(out).find("o cloud") != std::string::npos);
  CHECK(run_program("verify --parts " + loose + " " + out).exit == 0);
  CHECK(run_program("verify --parts " + loose + " " + alone).exit == 2);  // cloud has no partner

  const auto box = [](const std::string& name, int from, int to) {
    std::string text = "o " + name + "\n";
    for (int k = 0; k < 8; ++k) {
      text += "v " + std::to_string(k & 1 ? to : from) + (k & 2 ? " 1" : " 0") +
              (k & 4 ? " 1\n" : " 0\n");
    }
    return text;
  };
  const std::string bar =
                        scratch.write("bar.obj", box("bar", 0, 10) +
                                                     "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\n"
                                                     "f 1 5 7 3\nf 2 4 8 6\n"),
                    ends = scratch.write("ends.obj", box("left", 0, 1) + box("right", 9, 10)),
                    halves = scratch.write("halves.obj", box("left", 0, 5) + box("right", 5, 10));
  CHECK(run_program("verify --union " + bar + " " + ends).exit == 1);
  CHECK(run_program("verify --union " + bar + " " + halves).exit == 0);
}

TEST_CASE("scene: a name that comes again later gets a number") {
  const ScratchFolder scratch;
  std::string text;
  for (const char* name : {"a", "b", "a"}) {
    text +=
        std::string("o ") + name +
        "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n";
  }
  const std::string scene = scratch.write("scene.obj", text), out = scratch.file("out.obj");
  CHECK(run_program("simplify --parts --faces 4 " + scene + " -o " + out).exit == 0);
  CHECK(bytes_of(out).find("o a-2") != std::string::npos);
  CHECK(run_program("verify --parts " + scene + " " + out).exit == 0);
}
