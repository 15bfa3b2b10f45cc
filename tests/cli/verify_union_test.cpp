// SPDX-License-Identifier: MIT
// convexact verify INPUT PARTS: how parts are named, exit codes, the text for people, the output of
// --json (docs/schema/verdict.schema.json), requests on --stdio, and the picture.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cells.hpp"
#include "json_schema.hpp"
#include "process.hpp"

using nlohmann::json;
using namespace support;

namespace {

std::string obj_of(const Mesh& mesh, std::size_t first = 1, const std::string& name = "") {
  std::ostringstream text;
  if (!name.empty()) text << "o " << name << "\n";
  for (const Point& p : mesh.points.doubles()) {
    text << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  for (const auto& polygon : mesh.polygons) {
    text << "f";
    for (const std::uint32_t corner : polygon) text << " " << corner + first;
    text << "\n";
  }
  return text.str();
}

std::string obj_of(const std::set<Cell>& cells) {
  std::string text;
  std::size_t first = 1;
  for (const Cell& cell : cells) {
    text += obj_of(box_mesh(box_of(cell)), first, "part_" + std::to_string(first / 8));
    first += 8;
  }
  return text;
}

struct LFiles {
  ScratchFolder scratch;
  std::string input = scratch.write("l.obj", obj_of(mesh_of_cells(l_cells())));
  std::string good = scratch.write("good.obj", obj_of(l_cells()));
  std::string bad = scratch.write("bad.obj", obj_of({{0, 0, 0}, {1, 0, 0}}));

  std::string arguments(const std::string& parts, const std::string& options) const {
    return "verify " + input + " " + parts + " " + options;
  }
};

struct JudgedUnion {
  int exit;
  json document;

  std::string status(const std::string& code) const {
    for (const json& claim : document["claims"]) {
      if (claim["code"] == code) return claim["status"];
    }
    return "?";
  }
};

JudgedUnion judge_union(const LFiles& files, const std::string& parts, const std::string& options) {
  const auto ran = run_program(files.arguments(parts, options) + " --json");
  const json document = json::parse(ran.out);
  CHECK(schema_complaint("verdict", document) == "");
  return {ran.exit, document};
}

}  // namespace

TEST_CASE("verify --union: an L in three cells, and without one of them") {
  const LFiles files;
  const JudgedUnion good = judge_union(files, files.good, "--union");
  CHECK(good.exit == 0);
  CHECK(good.document["verdict"] == "holds");
  CHECK(good.document["parts"].size() == 3);
  CHECK(good.document["parts"][1]["name"] == "part_1");
  CHECK(good.document["surface"]["closed"] == true);
  CHECK(good.status("covers-solid") == "not-asked");

  const JudgedUnion bad = judge_union(files, files.bad,
                                      "--union --claims covers-points,covers-solid "
                                      "--exact-volumes");
  CHECK(bad.exit == 1);
  CHECK(bad.status("covers-points") == "violated");
  CHECK(bad.status("covers-solid") == "violated");
  CHECK(bad.status("covers-surface") == "not-asked");
  CHECK(bad.document["outside"]["points"] == 4);
  CHECK(bad.document["measures"]["uncovered_volume"]["exact"] == "1");
  CHECK(bad.document["worst_part"] == 0);
}

TEST_CASE("verify: when a candidate is taken for a decomposition") {
  const LFiles files;
  CHECK(judge_union(files, files.good, "--claims covers-surface").document.contains("surface"));
  CHECK(judge_union(files, files.good, "--parts").document.contains("surface"));
  const std::string folder = files.scratch.file("folder");
  std::filesystem::create_directory(folder);
  std::filesystem::copy(files.good, folder + "/all.obj");
  CHECK(judge_union(files, folder, "").exit == 0);
  const std::string parts =
      files.scratch.write("parts.json", R"({"parts": [{"vertices": [[0,0,0],[2,0,0],[0,2,0],[2,2,0],
                                                [0,0,1],[2,0,1],[0,2,1],[2,2,1]]}]})");
  CHECK(judge_union(files, parts, "").exit == 0);
  // Otherwise it is one solid, with a note.
  const JudgedUnion one = judge_union(files, files.good, "");
  CHECK(one.exit == 1);
  CHECK(one.document.contains("candidate"));
  CHECK(one.document["notes"][0].get<std::string>().find("--union") != std::string::npos);
}

TEST_CASE("verify --union: the text for people") {
  const LFiles files;
  const auto ran = run_program(files.arguments(files.bad, "--union"));
  CHECK(ran.exit == 1);
  for (const char* text :
       {"as parts of", "covers-points       violated", "4 of 16 points in no part",
        "not asked           covers-solid, within-solid, parts-disjoint, parts-needed",
        "closed: it bounds a solid", "volume 1.000 of 3 (33.3%)", "left out",
        "the surface from the union", "2 claims are violated"}) {
    CAPTURE(text);
    CHECK(ran.out.find(text) != std::string::npos);
  }
  CHECK(ran.out.find("overlap by") == std::string::npos);
  const auto all = run_program(files.arguments(files.bad, "--union --measures all"));
  CHECK(all.out.find("parts overlap by") != std::string::npos);
  CHECK(all.out.find("the union from the solid") != std::string::npos);
  CHECK(all.out.find("left out") == std::string::npos);
  // JSON measures everything, unless it is told not to.
  const auto measures = [&](const std::string& options) {
    return judge_union(files, files.bad, "--union " + options).document.value("measures", json());
  };
  CHECK(measures("").contains("union_to_input"));
  CHECK(measures("--measures uncovered").contains("surface_to_union"));
  CHECK_FALSE(measures("--measures uncovered").contains("union_to_input"));
  CHECK(measures("--measures none").is_null());
}

TEST_CASE("verify --union: usage, and files that are not there") {
  const LFiles files;
  const auto exit_of = [&](const std::string& parts, const std::string& options) {
    const auto ran = run_program(files.arguments(parts, options));
    CAPTURE(options);
    if (ran.exit != 0) CHECK(ran.out == "");
    return ran.exit;
  };
  CHECK(exit_of(files.good, "--union --inner") == 2);
  CHECK(exit_of(files.good, "--union --parts") == 2);
  CHECK(exit_of(files.good, "--max-parts 3") == 2);
  CHECK(exit_of(files.good, "--parts --picture x.html") == 2);
  CHECK(exit_of(files.good, "--union --claims covers-everything") == 2);
  CHECK(exit_of(files.good, "--union --claims covers-surface,contains-input") == 2);
  CHECK(exit_of(files.good, "--union --claims covers-solid --tolerance 1") == 2);
  CHECK(exit_of(files.good, "--union --claims max-parts") == 2);
  CHECK(exit_of(files.good, "--union --picture x.obj") == 2);
  CHECK(exit_of(files.scratch.file("none.obj"), "--union") == 3);
  std::filesystem::create_directory(files.scratch.file("empty"));
  CHECK(exit_of(files.scratch.file("empty"), "") == 3);
  CHECK(exit_of(files.good, "--union --max-parts 3 --max-facets 6") == 0);
  for (const char* profile : {"physx", "jolt", "vhacd"}) {
    CHECK(exit_of(files.good, std::string("--union --profile ") + profile) == 0);
  }
  CHECK(run_program(files.arguments(files.good, "--union --profile physx --max-vertices 7")).exit ==
        1);
}

TEST_CASE("verify: options about measures that contradict each other") {
  const LFiles files;
  for (const char* options :
       {"--union --no-tightness --measures all", "--union --no-tightness --exact-volumes",
        "--union --measures none --exact-volumes", "--union --measures some"}) {
    CAPTURE(std::string(options));
    CHECK(run_program(files.arguments(files.good, options)).exit == 2);
  }
}

TEST_CASE("verify --union: an input without points, and a flat one") {
  const ScratchFolder scratch;
  const std::string empty = scratch.write("empty.obj", "");
  const std::string flat = scratch.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string cube = scratch.write("cube.obj", obj_of(box_mesh(box_of({0, 0, 0}))));
  CHECK(run_program("verify " + empty + " " + cube + " --union").exit == 4);
  CHECK(run_program("verify " + flat + " " + cube + " --union").exit == 0);
  const auto solid = run_program("verify " + flat + " " + cube + " --claims covers-solid");
  CHECK(solid.exit == 1);
  CHECK(solid.out.find("not-applicable") != std::string::npos);
}

TEST_CASE("verify --union: malformed parts are a verdict") {
  const LFiles files;
  const JudgedUnion line =
      judge_union(files, files.scratch.write("x.obj", "v 0 0 0\nv 1\n"), "--union");
  CHECK(line.exit == 1);
  CHECK(line.status("parts-readable") == "violated");
  const JudgedUnion nan =
      judge_union(files, files.scratch.write("y.obj", "v 0 0 nan\n"), "--union");
  CHECK(nan.status("parts-finite") == "violated");
}

TEST_CASE("verify --union: a picture, written or not at all") {
  const LFiles files;
  const std::string page = files.scratch.file("parts.html");
  CHECK(run_program(files.arguments(files.bad, "--union --picture " + page)).exit == 1);
  const std::string html = bytes_of(page);
  CHECK(html.find("in no part") != std::string::npos);
  CHECK(html.find("part_1") != std::string::npos);
  CHECK(run_program(
            files.arguments(files.bad, "--union --picture " + files.scratch.file("no/p.html")))
            .exit == 5);
}

TEST_CASE("verify --stdio: candidates with parts") {
  const ScratchFolder scratch;
  const std::string box = "[[0,0,0],[1,0,0],[0,1,0],[0,0,1],[1,1,0],[1,0,1],[0,1,1],[1,1,1]]";
  const std::string requests =
      R"({"id": 1, "points": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]], "candidate": {"parts": [{"vertices": )" +
      box + "}]}}\n" +
      R"({"id": 2, "points": [[0,0,0],[2,0,0],[0,1,0]], "triangles": [[0,1,2]], "candidate": {"parts": [{"name": "b", "vertices": )" +
      box + R"(}]}, "max_parts": 1, "tightness": true})" + "\n" +
      R"({"id": 3, "points": [[0,0,0]], "triangles": [[0,0,0]], "candidate": {"vertices": [[0,0,0]]}})" +
      "\n" + R"({"id": 4, "points": [], "candidate": {"parts": []}})" + "\n" +
      R"({"id": 5, "points": [[0,0,0]], "candidate": {"parts": [{"faces": []}]}})" + "\n";
  const auto ran = run_program("verify --stdio <" + scratch.write("requests", requests));
  REQUIRE(ran.exit == 0);
  std::istringstream lines(ran.out);
  std::vector<json> answers;
  for (std::string line; std::getline(lines, line);) {
    answers.push_back(json::parse(line));
    CHECK(schema_complaint("stdio_request", answers.back()) == "");
  }
  REQUIRE(answers.size() == 5);
  CHECK(answers[0]["verdict"] == "holds");
  CHECK(answers[1]["verdict"] == "violated");
  CHECK(answers[1]["outside"]["points"] == 1);
  CHECK(answers[1].contains("measures"));
  CHECK(answers[2]["error"]["exit"] == 4);  // one point
  CHECK(answers[3]["error"]["exit"] == 4);
  CHECK(answers[4]["claims"][0]["code"] == "parts-readable");
  CHECK(answers[4]["claims"][0]["status"] == "violated");
}

TEST_CASE("verify --distance: both directions first, and the exit code of the verdict") {
  const LFiles files;
  const std::string box =
      files.scratch.write("box.obj", obj_of(box_mesh({{0, 0, 0}, {2, 2, 1}}), 1, "box"));
  const auto within = run_program(files.arguments(box, "--distance 1.1"));
  CHECK(within.exit == 0);
  // The first line after the names of the files.
  const std::string second = within.out.substr(within.out.find('\n') + 1);
  CHECK(second.find("  distance            the solid from the parts: 0, as they hold it; the parts "
                    "from the solid: ") == 0);
  CHECK(second.find("at most 1.1 allowed") != std::string::npos);
  const JudgedUnion beyond = judge_union(files, box, "--distance 30%");
  CHECK(beyond.exit == 1);
  CHECK(beyond.status("covers-solid") == "holds");
  CHECK(beyond.status("within-solid") == "violated");
  CHECK(beyond.document["measures"].contains("union_to_input"));
  for (const char* wrong : {"--distance x", "--claims within-solid", "--distance 3% --parts"}) {
    CHECK(run_program(files.arguments(box, wrong)).exit == 2);
  }
}
