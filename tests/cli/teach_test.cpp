// SPDX-License-Identifier: MIT
// convexact teach: files, standard output, exit codes, and names of inputs that mean harm.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "json_schema.hpp"
#include "process.hpp"
#include "sweep.hpp"

using nlohmann::json;
using support::bytes_of;
using support::data;
using support::Ran;
using support::run_program;
using support::ScratchFolder;

namespace {

// The corners of a cube without one, which leaves seven facets.
constexpr const char* kLessonCube =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 0\nv 1 0 1\nv 0 1 1\nv 1 .5 1\nv 1 1 .5\nv .5 1 1\n";

json lesson_in(const std::string& text) {
  json document = json::parse(text);
  CHECK(schema_complaint("lesson", document) == "");
  return document;
}

}  // namespace

TEST_CASE("teach: a page, its data, and the same on standard output") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("cube.obj", kLessonCube);
  const std::string page = scratch.file("lesson.html"), file = scratch.file("lesson.json");
  const Ran ran = run_program("teach " + cube + " -o " + page + " -o " + file);
  REQUIRE_MESSAGE(ran.exit == 0, ran.err);
  CHECK(ran.out.find("removals    1") != std::string::npos);
  CHECK(ran.out.find("written     " + page) != std::string::npos);
  CHECK(bytes_of(page).find("<title>") != std::string::npos);
  const json lesson = lesson_in(bytes_of(file));
  CHECK(lesson["name"] == "cube.obj");
  CHECK(lesson["removals"][0]["volume_after"] == "1");
  const Ran printed = run_program("teach " + cube + " --json");
  REQUIRE(printed.exit == 0);
  CHECK(lesson_in(printed.out) == lesson);
  const Ran through = run_program("teach - --json < " + cube);
  REQUIRE(through.exit == 0);
  CHECK(lesson_in(through.out)["removals"] == lesson["removals"]);
}

TEST_CASE("teach: the removals are those of simplify --engine exact" * sweep) {
  const ScratchFolder scratch;
  const std::string spot = data("spot.obj"), trace = scratch.file("trace.json");
  for (const std::string options : {"--seed 1", "--seed 9", "--cost area"}) {
    CAPTURE(options);
    const std::string common = " " + spot + " --faces 150 " + options;
    REQUIRE(run_program("simplify" + common + " --engine exact --trace " + trace).exit == 0);
    const Ran ran = run_program("teach" + common + " --json");
    REQUIRE_MESSAGE(ran.exit == 0, ran.err);
    const json lesson = lesson_in(ran.out), run = json::parse(bytes_of(trace));
    const std::size_t skipped = lesson["topology"]["step"].get<std::size_t>();
    REQUIRE(lesson["removals"].size() + skipped == run["steps"].size());
    for (std::size_t s = 0; s < lesson["removals"].size(); ++s) {
      const json &removal = lesson["removals"][s], &step = run["steps"][skipped + s];
      CHECK(removal["step"] == skipped + s + 1);
      for (const char* key : {"removed", "cost", "tie", "ring", "left"}) {
        CHECK(removal[key] == step[key]);
      }
      for (std::size_t t = 0; t < step["triangles"].size(); ++t) {
        CHECK(removal["triangles"][t]["corners"] == step["triangles"][t]);
      }
    }
    for (std::size_t i = 0; i < run["halfspaces"].size(); ++i) {
      CHECK(lesson["halfspaces"][i]["plane"] == run["halfspaces"][i]);
    }
  }
}

TEST_CASE("teach: what it does not take") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("cube.obj", kLessonCube);
  const Ran nowhere = run_program("teach " + cube);
  CHECK(nowhere.exit == 2);
  CHECK(nowhere.err.find("-o lesson.html") != std::string::npos);
  CHECK(run_program("teach " + cube + " -o lesson.txt").exit == 2);
  CHECK(run_program("teach " + cube + " --faces 3 --json").exit == 2);
  CHECK(run_program("teach " + cube + " --measures height --json").exit == 2);
  CHECK(run_program("teach " + cube + " --center 1,2 --json").exit == 2);
  CHECK(run_program("teach " + cube + " --center 2,2,2 --json").exit == 2);
  CHECK(run_program("teach " + cube + " " + cube + " --json").exit == 2);
  CHECK(run_program("teach " + scratch.file("none.obj") + " --json").exit == 3);
  CHECK(run_program("teach " + cube + " -o " + scratch.file("none/lesson.json")).exit == 5);
  const std::string input = scratch.write("input.json", "[[1,0,0,-1],[-1,0,0,-1]]");
  CHECK(run_program("teach " + input + " -o " + input).exit == 2);
  CHECK(bytes_of(input) == "[[1,0,0,-1],[-1,0,0,-1]]");
  // Unbounded, flat, empty: with the proof. NaN is no number.
  const Ran open = run_program("teach " + input + " --json");
  CHECK(open.exit == 4);
  CHECK(json::parse(open.out)["error"].contains("proof"));
  const std::string flat = scratch.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n");
  const Ran plane = run_program("teach " + flat + " -o " + scratch.file("flat.html"));
  CHECK(plane.exit == 4);
  CHECK(plane.err.find("teach --plane") != std::string::npos);
  CHECK(bytes_of(scratch.file("flat.html")).empty());
  const std::string nan = scratch.write("nan.obj", "v 0 0 nan\n");
  CHECK(run_program("teach " + nan + " --json").exit == 3);
}

TEST_CASE("teach: names of inputs are text, whatever they spell") {
  const ScratchFolder scratch;
  for (const std::string name :
       {"<!--<script>alert(1)<|script>.obj", "\xff\xfe.obj", "a b&\".obj"}) {
    const std::string cube = scratch.write(name, kLessonCube);
    const std::string page = scratch.file("lesson.html"), file = scratch.file("lesson.json");
    const Ran ran = run_program("teach '" + cube + "' -o " + page + " -o " + file);
    REQUIRE_MESSAGE(ran.exit == 0, ran.err);
    const json lesson = lesson_in(bytes_of(file));  // refuses what is no UTF-8
    CHECK_NOTHROW((void)json(bytes_of(page)).dump());
    CHECK(bytes_of(page).find("<script>alert") == std::string::npos);
    CHECK(bytes_of(page).find("<!--<") == std::string::npos);
    if (name[0] == 'a') CHECK(lesson["name"] == name);
  }
}
