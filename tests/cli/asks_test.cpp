// SPDX-License-Identifier: MIT
// --asks: what a candidate was to be. Expected values are closed forms of boxes, and that no two of
// the shipped meshes have one hull.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "process.hpp"
#include "program_json.hpp"

using nlohmann::json;
using support::data;
using support::program_json;
using support::Ran;
using support::run_program;
using support::ScratchFolder;

namespace {

std::string box(const std::string& top) {
  std::string text;
  for (const char* corner : {"0 0 ", "1 0 ", "0 1 ", "1 1 "}) {
    text += std::string("v ") + corner + "0\nv " + corner + top + "\n";
  }
  return text;
}

bool prints(const Ran& ran, const std::string& text) { return ran.out.find(text) != ran.out.npos; }

}  // namespace

TEST_CASE(
    "asks: the hull of another model is an enclosure, and the summary says what was not asked") {
  const ScratchFolder scratch;
  const std::string hull = scratch.file("spot_hull.obj");
  REQUIRE(run_program("hull " + data("spot.obj") + " -o " + hull).exit == 0);
  const std::string files = "verify " + data("bunny.obj") + " " + hull;
  const Ran enclosure = run_program(files);
  CHECK(enclosure.exit == 0);
  CHECK(prints(enclosure, "times the hull: --asks hull asks whether it is the hull"));
  const Ran asked = run_program(files + " --asks hull");
  CHECK(asked.exit == 1);
  CHECK(prints(asked, "is-hull             violated"));
  CHECK_FALSE(prints(asked, "--asks"));
  CHECK(run_program("verify " + data("spot.obj") + " " + hull + " --asks hull").exit == 0);
  CHECK(run_program("verify " + data("spot.obj") + " " + hull + " --parts --asks hull").exit == 0);
}

TEST_CASE("asks: profiles of programs that write hulls imply the hull") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("cube.obj", box("1")),
                    high = scratch.write("high.obj", box("1.25"));
  CHECK(run_program("verify " + cube + " " + high).exit == 0);
  for (const char* profile : {"physx", "jolt", "bullet", "qhull"}) {
    CAPTURE(profile);
    CHECK(run_program("verify " + cube + " " + high + " --profile " + profile).exit == 1);
    CHECK(run_program("verify " + cube + " " + cube + " --profile " + profile).exit == 0);
    CHECK(run_program("verify " + cube + " " + high + " --asks enclosure --profile " + profile)
              .exit == 0);
  }
  const json found =
      program_json("verify " + cube + " " + high + " --asks hull --tolerance 0.25", "verdict");
  CHECK(found["verdict"] == "holds");
  CHECK(found["claims"].back()["code"] == "is-hull");
  CHECK(found["claims"].back()["witness"]["distance"]["squared"] == "1/16");
}

TEST_CASE("asks: a simplification needs its number, and one candidate needs one question") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("cube.obj", box("1"));
  const std::string files = "verify " + cube + " " + cube + " ";
  CHECK(run_program(files + "--asks simplify").exit == 2);
  CHECK(run_program(files + "--asks simplify --max-facets 6").exit == 0);
  CHECK(run_program(files + "--asks simplify --max-facets 5").exit == 1);
  CHECK(run_program(files + "--asks inner").exit == 0);
  CHECK(run_program(files + "--inner --asks hull").exit == 2);
  CHECK(run_program(files + "--union --asks hull").exit == 2);
  CHECK(run_program(files + "--claims is-hull").exit == 2);
  CHECK(run_program(files + "--claims is-hull --asks hull").exit == 0);
  CHECK(run_program("verify " + cube + " --trace " + cube + " --asks hull").exit == 2);
}

TEST_CASE("asks: what conform finds, shrink finds, too") {
  const ScratchFolder scratch;
  const std::string cube = scratch.write("cube.obj", box("1")),
                    high = scratch.write("high.obj", box("2"));
  const std::string shrink = "shrink " + cube + " -o " + scratch.file("least.obj");
  const std::string program = " -- /bin/cp " + high + " {output} {input}";
  // The program is wrong, whatever its input: cp wants a folder after three names.
  CHECK(prints(run_program(shrink + " --asks hull" + program), "exit code 1"));
  const std::string copies = " -- /bin/sh -c 'cp \"$1\" \"$2\"' sh " + high + " {output} {input}";
  const Ran hull = run_program(shrink + " --asks hull" + copies);
  CHECK(hull.exit == 0);
  CHECK(prints(hull, "violates is-hull"));
  CHECK(run_program(shrink + copies).exit == 2);  // an enclosure it is
  CHECK(run_program(shrink + " --asks simplify" + copies).exit == 2);
}

TEST_CASE("conform: who refuses everything was asked nothing") {
  const Ran refusals =
      run_program("conform --level 1 --flag malformed -- /bin/false {input} {output}");
  CHECK(refusals.exit == 1);
  CHECK(prints(refusals, "nothing was asked"));
  CHECK(prints(refusals, "refuse malformed"));
  CHECK(run_program("conform --asks hull --max-vertices 3 -- /bin/false {input} {output}").exit ==
        1);
}
