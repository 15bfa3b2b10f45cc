// SPDX-License-Identifier: MIT
// --points and --loose: points that no face uses. Expected values are closed forms: the tetrahedron
// on the axes has the volume 1/6, with (2, 2, 2) its hull has the volume 1.
#include <doctest/doctest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "process.hpp"

using nlohmann::json;
using support::bytes_of;
using support::Ran;
using support::run_program;
using support::ScratchFolder;

namespace {

const std::string kAxisTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string kItsSides = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
// Of three loose points one is inside of the tetrahedron.
const std::string kWithLoose =
    kAxisTetrahedron + "v 0.5 0.5 0.1\nv 0.1 0.1 0.1\nv 2 2 2\n" + kItsSides;

bool prints(const std::string& text, const std::string& what) {
  return text.find(what) != text.npos;
}

json answer(const std::string& arguments) {
  const Ran ran = run_program(arguments + " --json");
  REQUIRE_MESSAGE(ran.exit == 0, ran.err);
  return json::parse(ran.out);
}

}  // namespace

TEST_CASE("points: simplify and hull leave out those that no face uses") {
  const ScratchFolder scratch;
  const std::string shape = scratch.write("shape.obj", kWithLoose),
                    cloud = scratch.write("cloud.obj", kAxisTetrahedron);
  const json all = answer("hull " + shape + " --exact-values"),
             used = answer("hull " + shape + " --points used --exact-values");
  CHECK(all["volume"]["exact"] == "1");
  CHECK(used["volume"]["exact"] == "1/6");
  // Without faces, a file is its points.
  CHECK(answer("hull " + cloud + " --points used --exact-values")["volume"]["exact"] == "1/6");
  const std::string output = scratch.file("simplified.obj");
  REQUIRE(run_program("simplify " + shape + " --faces 4 --points used -o " + output).exit == 0);
  CHECK(run_program("verify " + shape + " " + output + " --points used --asks hull").exit == 0);
  CHECK(run_program("verify " + shape + " " + output).exit == 1);
  CHECK(run_program("hull " + shape + " --points some").exit == 2);
}

TEST_CASE("points: verify says how many of the points outside no face uses, of parts too") {
  const ScratchFolder scratch;
  const std::string shape = scratch.write("shape.obj", "o a\n" + kWithLoose),
                    output =
                        scratch.write("tetrahedron.obj", "o a\n" + kAxisTetrahedron + kItsSides);
  const std::string verify = "verify " + shape + " " + output;
  for (const char* parts : {"", " --parts", " --union"}) {
    CAPTURE(parts);
    const Ran all = run_program(verify + parts);
    CHECK(all.exit == 1);
    CHECK(prints(all.out, "2 of the 2 points outside are used by no face; --points used asks"));
    CHECK(run_program(verify + parts + " --points used").exit == 0);
  }
}

TEST_CASE("points: what a program drops is no failure to shrink, if it is not asked about") {
  const ScratchFolder scratch;
  const std::string shape = scratch.write("shape.obj", kWithLoose), minimal = scratch.file("m.obj");
  // Writes the corners that faces use, as a reader of faces does.
  const std::string program = scratch.write(
      "program",
      "awk '$1 == \"v\" {v[++n] = $0} $1 == \"f\" {for (i = 2; i <= NF; ++i) u[$i] = 1} "
      "END {for (k in u) print v[k]}' \"$1\" >\"$2\"\n");
  const std::string shrink = "shrink " + shape + " -o " + minimal;
  const std::string words = " -- /bin/sh " + program + " {input} {output}";
  const Ran used = run_program(shrink + " --points used" + words);
  CHECK(used.exit == 2);
  CHECK(prints(used.err, "does not fail"));
  CHECK(run_program(shrink + words).exit == 0);
}

TEST_CASE("loose: decompose and bvh put them into the nearest part, or refuse them") {
  const ScratchFolder scratch;
  const std::string shape = scratch.write("shape.obj", kWithLoose),
                    parts = scratch.file("parts.obj"), tree = scratch.file("tree.json");
  const json made = answer("decompose --method hacd " + shape + " --exact-volumes -o " + parts);
  REQUIRE(made["parts"].size() == 1);
  CHECK(made["parts"][0]["loose_points"] == 3);
  CHECK(made["union"]["exact"] == "1");
  CHECK(run_program("verify " + shape + " " + parts + " --union").exit == 0);
  REQUIRE(run_program("bvh " + shape + " -o " + tree).exit == 0);
  CHECK(run_program("verify " + shape + " " + tree).exit == 0);
  for (const char* command : {"decompose --method hacd ", "bvh "}) {
    CAPTURE(command);
    const Ran refused = run_program(command + shape + " --loose refuse");
    CHECK(refused.exit == 2);
    CHECK(prints(refused.err, "3 points are used by no face"));
    CHECK(run_program(command + shape + " --loose refuse --points used").exit == 0);
  }
  // A proof is about triangles: of a part that such points widen, it has the corners.
  const std::string proof = scratch.file("p.proof");
  for (const char* points : {"", " --points used"}) {
    CAPTURE(points);
    REQUIRE(run_program("decompose --method hacd " + shape + points + " --proof " + proof).exit ==
            0);
    CHECK(prints(bytes_of(proof), "\npart stored") == (*points == '\0'));
    const std::string check = std::getenv("CONVEXACT_CHECK");
    CHECK(std::system(("'" + check + "' " + proof + " " + shape + " >/dev/null").c_str()) == 0);
  }
}

TEST_CASE("loose: an object that is only points is one part, its hull") {
  const ScratchFolder scratch;
  const std::string two = scratch.write(
      "two.obj", "o a\n" + kAxisTetrahedron + kItsSides +
                     "o cloud\nv 9 9 9\nv 10 9 9\nv 9 10 9\nv 9 9 10\nv 9.25 9.25 9.25\n");
  const std::string parts = scratch.file("parts.obj"), tree = scratch.file("tree.json");
  const json together = answer("decompose --method hacd " + two + " --exact-volumes -o " + parts);
  CHECK(together["parts"].size() == 2);
  CHECK(together["union"]["exact"] == "1/3");
  CHECK(run_program("verify " + two + " " + parts + " --union").exit == 0);
  const std::string each = scratch.file("each.obj");
  REQUIRE(run_program("decompose --method hacd " + two + " --parts -o " + each).exit == 0);
  CHECK(run_program("verify " + two + " " + each + " --union").exit == 0);
  REQUIRE(run_program("bvh " + two + " -o " + tree).exit == 0);
  CHECK(run_program("verify " + two + " " + tree).exit == 0);
  // A file without faces is such an object; one that lies in a plane is no solid.
  const std::string cloud = scratch.write("cloud.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n.1 .1 .1\n"),
                    flat = scratch.write("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n");
  CHECK(answer("decompose --method hacd " + cloud + " --exact-volumes")["union"]["exact"] == "1/6");
  CHECK(run_program("bvh " + cloud).exit == 0);
  CHECK(run_program("decompose --method hacd " + flat).exit == 4);
  CHECK(answer("decompose --method hacd " + flat + " --flat keep")["parts"][0]["dimension"] == 2);
}
