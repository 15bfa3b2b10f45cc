// SPDX-License-Identifier: MIT
// convexact generate: the written points are those that the family's header promises, to the bit,
// in every format; malformed files end the program with exit 3.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "affine_dimension.hpp"
#include "cli/time_left.hpp"
#include "convexact/io.hpp"
#include "convexact/shapes.hpp"
#include "process.hpp"
#include "sweep.hpp"
using namespace convexact;
using nlohmann::json;
using support::bytes_of;
using support::run_program;
using support::ScratchFolder;

namespace {

std::vector<Point> points_of(const std::string& path) {
  const Mesh mesh = read_mesh(path);
  REQUIRE(mesh.points.is_binary());
  return {mesh.points.doubles().begin(), mesh.points.doubles().end()};
}

std::vector<Point> without_repeats(const std::vector<Point>& points) {
  std::vector<Point> kept;
  for (const Point& p : points) {
    if (std::find(kept.begin(), kept.end(), p) == kept.end()) kept.push_back(p);
  }
  return kept;
}

}  // namespace

TEST_CASE("generate: each family, from its usual values, has its dimension and its doubles") {
  const ScratchFolder scratch;
  for (const shapes::Family& f : shapes::families()) {
    CAPTURE(f.name);
    const std::string name(f.name), path = scratch.file(name + ".obj");
    REQUIRE(run_program("generate " + name + " -o " + path).exit == 0);
    const std::vector<Point> points = points_of(path);
    CHECK(points == shapes::generate(f, shapes::usual_values(f)));
    CHECK(affine_dimension(points) == f.dimension);
  }
}

TEST_CASE("generate: any family, as the command that it names makes it again") {
  const ScratchFolder scratch;
  std::set<std::string> families;
  for (int seed = 1; seed <= 24; ++seed) {
    const std::string any = scratch.file("any.obj"), again = scratch.file("again.obj");
    const auto ran = run_program("generate --any --seed " + std::to_string(seed) + " -o " + any);
    REQUIRE_MESSAGE(ran.exit == 0, ran.err);
    const std::string start = "convexact generate ";
    REQUIRE(ran.err.find(start) == 0);
    const std::string command = ran.err.substr(start.size(), ran.err.find('\n') - start.size());
    families.insert(command.substr(0, command.find(' ')));
    REQUIRE(run_program("generate " + command + " -o " + again).exit == 0);
    CHECK(bytes_of(any) == bytes_of(again));
  }
  CHECK(families.size() > 10);
}

TEST_CASE("generate: the input of a vector") {
  const ScratchFolder scratch;
  const std::string vectors = std::string(" --vectors ") + std::getenv("CONVEXACT_VECTORS") + " ";
  const std::string out = scratch.file("cube.obj");
  REQUIRE(run_program("generate --vector cube-hull -o " + out + vectors).exit == 0);
  CHECK(points_of(out).size() == 8);
  CHECK(bytes_of(out).find("\nf ") != std::string::npos);
  const auto nan = run_program("generate --vector malformed-obj-nan" + vectors);
  CHECK(nan.exit == 0);
  CHECK(nan.out.find("NaN") != std::string::npos);
  CHECK(run_program("generate --vector malformed-obj-nan -o " + scratch.file("a.off") + vectors)
            .exit == 2);
  const auto mistyped = run_program("generate --vector cube-hul" + vectors);
  CHECK(mistyped.exit == 2);
  CHECK(mistyped.err.find("did you mean 'cube-hull'?") != std::string::npos);
  CHECK(run_program("generate --any cube").exit == 2);
}

TEST_CASE("command line: words that are spelt nearly so are named") {
  struct Case {
    const char* words;
    const char* meant;
  };
  for (const Case& c :
       {Case{"simplfy a.obj", "'simplify'"}, Case{"simplify a.obj --fcaes 3", "'--faces'"},
        Case{"generate cospherial", "'cospherical'"},
        Case{"generate needle --pionts 3", "'--points'"}}) {
    CAPTURE(c.words);
    const auto ran = run_program(c.words);
    CHECK(ran.exit == 2);
    CHECK(ran.err.find("; did you mean " + std::string(c.meant) + "?") != std::string::npos);
  }
  CHECK(run_program("frobnicate").err.find("did you mean") == std::string::npos);
}

TEST_CASE("progress: the time left never grows while the share stands still") {
  cli::TimeLeft left;
  CHECK(left.text(0.1, 1, 4) == "");
  CHECK(left.text(10, 1, 4) == "");  // the share has not changed since it was too soon to say
  CHECK(left.text(20, 2, 4) == "about 20 s left");
  CHECK(left.text(25, 2, 4) == "about 15 s left");
  CHECK(left.text(39.5, 2, 4) == "about 1 s left");
  CHECK(left.text(41, 2, 4) == "");
  CHECK(left.text(60, 3, 4) == "about 20 s left");
  CHECK(cli::TimeLeft().text(600, 1, 11) == "about 100 min left");
}

TEST_CASE("generate: every format keeps the doubles, also the smallest and the largest") {
  const ScratchFolder scratch;
  for (const char* family : {"subnormal", "huge", "needle --aspect 1e300", "all-equal",
                             "scaled-ball --exponent -1000", "scaled-ball --exponent 1000"}) {
    CAPTURE(family);
    const std::string call = std::string("generate ") + family + " --seed 5 -o ";
    const std::string obj = scratch.file("a.obj");
    REQUIRE(run_program(call + obj).exit == 0);
    const std::vector<Point> points = points_of(obj);
    for (const char* name : {"a.off", "a.ply"}) {
      REQUIRE(run_program(call + scratch.file(name)).exit == 0);
      CHECK(points_of(scratch.file(name)) == points);
    }
    // STL merges equal points.
    REQUIRE(run_program(call + scratch.file("a.stl")).exit == 0);
    CHECK(points_of(scratch.file("a.stl")) == without_repeats(points));
    const auto printed = run_program(std::string("generate ") + family + " --seed 5");
    CHECK(printed.out == bytes_of(obj));
  }
}

TEST_CASE("generate --json: the same doubles, with the values that made them") {
  const ScratchFolder scratch;
  const auto ran = run_program("generate lattice --points 9 --range 7 --seed 3 --json");
  REQUIRE(ran.exit == 0);
  const json document = json::parse(ran.out);
  CHECK(document["family"] == "lattice");
  CHECK(document["seed"] == 3);
  CHECK(document["parameters"] == json{{"points", 9}, {"range", 7}});
  const auto points = shapes::generate(shapes::family("lattice"), std::vector<double>{9, 7}, 3);
  REQUIRE(document["points"].size() == 9);
  for (std::size_t i = 0; i < 9; ++i) {
    for (int k = 0; k < 3; ++k) CHECK(document["points"][i][k] == points[i][k]);
  }
}

TEST_CASE("generate --facets: the closed hull; refused where there is none") {
  const ScratchFolder scratch;
  const std::string path = scratch.file("a.off");
  REQUIRE(run_program("generate prism --k 7 --facets -o " + path).exit == 0);
  const Mesh mesh = read_mesh(path);
  CHECK(mesh.points.size() == 14);
  CHECK(mesh.polygons.size() == 9);
  const auto corners = [&](std::size_t n) {
    return std::count_if(mesh.polygons.begin(), mesh.polygons.end(),
                         [&](const auto& polygon) { return polygon.size() == n; });
  };
  CHECK(corners(7) == 2);
  CHECK(corners(4) == 7);
  CHECK(run_program("generate coplanar --facets").exit == 4);
}

TEST_CASE("generate: malformed files come byte by byte and end any run with exit 3" * sweep) {
  const ScratchFolder scratch;
  for (const shapes::MalformedFile& file : shapes::malformed_files()) {
    CAPTURE(file.name);
    const std::string path = scratch.file("a." + std::string(file.extension()));
    REQUIRE(run_program("generate " + file.name + " -o " + path).exit == 0);
    CHECK(bytes_of(path) == file.bytes);
    CHECK(run_program("hull " + path).exit == 3);
  }
}

TEST_CASE("generate --list: every family, parameter and malformed file") {
  const auto text = run_program("generate --list");
  const auto ran = run_program("generate --list --json");
  REQUIRE(text.exit == 0);
  REQUIRE(ran.exit == 0);
  const json document = json::parse(ran.out);
  REQUIRE(document["families"].size() == shapes::families().size());
  for (std::size_t i = 0; i < shapes::families().size(); ++i) {
    const shapes::Family& f = shapes::families()[i];
    const json& listed = document["families"][i];
    CHECK(listed["name"] == f.name);
    CHECK(listed["dimension"] == f.dimension);
    REQUIRE(listed["parameters"].size() == f.parameters.size());
    for (std::size_t p = 0; p < f.parameters.size(); ++p) {
      CHECK(listed["parameters"][p]["name"] == f.parameters[p].name);
      CHECK(listed["parameters"][p]["default"] == f.parameters[p].usual);
    }
    CHECK(text.out.find("  " + std::string(f.name) + " ") != std::string::npos);
  }
  CHECK(document["malformed"].size() == shapes::malformed_files().size());
}

TEST_CASE("generate: wrong usage is exit 2 with one sentence, and writes nothing") {
  const ScratchFolder scratch;
  struct Case {
    const char* arguments;
    const char* says;
  };
  const Case cases[] = {
      {"", "expected a family"},
      {"sphere-of-cheese", "sphere-of-cheese"},
      {"needle --aspect 0.5", "aspect is a number from 1"},
      {"needle --aspect nan", "aspect"},
      {"needle --points 3.5", "--points: expected a whole number from 1 to"},
      {"needle --points many", "points"},
      {"needle --thickness 3", "--thickness"},
      {"cospherical --squared-radius 7", "squared radius 7"},
      {"cube -o a.abc", ".abc"},
      {"malformed-off-nan -o a.obj", ".off"},
      {"malformed-off-nan --facets", "--facets"},
      {"cube octahedron", "octahedron"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.arguments);
    const auto ran = run_program("generate " + std::string(c.arguments));
    CHECK(ran.exit == 2);
    CHECK(ran.out.empty());
    CHECK(ran.err.find(c.says) != std::string::npos);
  }
}
