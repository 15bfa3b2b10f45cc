// SPDX-License-Identifier: MIT
// convexact verify INPUT CANDIDATE: exit codes, the text for people, and the output of --json
// (docs/schema/verdict.schema.json, validated by valijson).
#include <doctest/doctest.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "json_schema.hpp"
#include "process.hpp"

using nlohmann::json;
using support::data;
using support::run_program;
using support::ScratchFolder;

namespace {

const std::string kBigTetrahedron = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\n";
const std::string kFaces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

struct Judged {
  int exit;
  json document;

  std::string status(const std::string& code) const {
    for (const json& claim : document["claims"]) {
      if (claim["code"] == code) return claim["status"];
    }
    return "?";
  }
  json witness(const std::string& code) const {
    for (const json& claim : document["claims"]) {
      if (claim["code"] == code) return claim["witness"];
    }
    return {};
  }
};

Judged judge(const std::string& bytes, const std::string& name, const std::string& options = "") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("in.obj", kBigTetrahedron);
  const auto ran =
      run_program("verify " + input + " " + scratch.write(name, bytes) + " --json " + options);
  const json document = json::parse(ran.out);
  CHECK(schema_complaint("verdict", document) == "");
  return {ran.exit, document};
}

}  // namespace

TEST_CASE("verify: the input's own hull, in every format") {
  CHECK(judge(kBigTetrahedron + kFaces, "c.obj").exit == 0);
  CHECK(
      judge("OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", "c.off")
          .exit == 0);
  CHECK(judge("[[-1,0,0,0],[0,-1,0,0],[0,0,-1,0],[1,1,1,-4]]", "c.json").exit == 0);
  CHECK(judge("begin\n4 4 integer\n0 1 0 0\n0 0 1 0\n0 0 0 1\n4 -1 -1 -1\nend\n", "c.ine").exit ==
        0);
  CHECK(judge("-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n1 1 1 -4\n", "c.txt").exit == 0);
  CHECK(judge("-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n1 1 1 -4\n", "by-content").exit == 0);
}

TEST_CASE("verify: a violation is exit code 1, with the distance as a fraction") {
  const Judged judged = judge("-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n1 1 1 -3\n", "c.txt");
  CHECK(judged.exit == 1);
  CHECK(judged.document["verdict"] == "violated");
  CHECK(judged.document["outside"]["points"] == 3);
  // From (4, 0, 0) to the corner (3, 0, 0), while the plane x + y + z = 3 is at 1 / sqrt(3) only;
  // the diameter is sqrt(48).
  const json witness = judged.witness("contains-input");
  CHECK(witness["input_point"] == 1);
  CHECK(witness["rows"] == json::array({3}));
  CHECK(witness["plane"] == json::array({"1", "1", "1", "-3"}));
  CHECK(witness["nearest"] == json::array({"3", "0", "0"}));
  CHECK(witness["distance"]["squared"] == "1");
  CHECK(std::stod(witness["distance"]["decimal"].get<std::string>()) == 1);
  CHECK(std::stod(witness["distance"]["relative"].get<std::string>()) ==
        doctest::Approx(std::sqrt(1.0 / 48)));
  const auto exit_within = [](const std::string& tolerance) {
    return judge("-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n1 1 1 -3\n", "c.txt", "--tolerance " + tolerance)
        .exit;
  };
  CHECK(exit_within("1") == 0);
  CHECK(exit_within("0.1444d") == 0);
  CHECK(exit_within("0.1443d") == 1);
  CHECK(exit_within("0.6") == 1);
}

TEST_CASE("verify: a candidate of no known format is exit code 3, and says what to do") {
  for (const auto& [name, bytes, says] :
       {std::array<std::string, 3>{"c", std::string("\x00\xff\x7f", 3), "expected OBJ, OFF"},
        std::array<std::string, 3>{"c.obj", "version https://git-lfs.github.com/spec/v1",
                                   "git lfs pull"}}) {
    const ScratchFolder scratch;
    const auto ran = run_program("verify " + scratch.write("in.obj", kBigTetrahedron) + " " +
                                 scratch.write(name, bytes));
    CHECK(ran.exit == 3);
    CHECK(ran.err.find(says) != std::string::npos);
    CHECK(ran.out.empty());
  }
}

TEST_CASE("verify: --skip-bad holds for every question about INPUT") {
  const ScratchFolder scratch;
  std::string stl = "solid a\n";
  for (const char* c : {"0 0 0", "4 0 0", "0 4 0"}) {
    stl += std::string("facet normal 0 0 1\nouter loop\nvertex 0 0 4\nvertex nan 0 0\nvertex ") +
           c + "\nendloop\nendfacet\n";
  }
  const std::string input = scratch.write("in.stl", stl + "endsolid a\n");
  const std::string hull = scratch.write("c.obj", kBigTetrahedron + kFaces);
  const std::string order = scratch.write("order.txt", "");
  for (const std::string& question :
       {hull, hull + " --union", hull + " --parts", "--trace " + order}) {
    CAPTURE(question);
    const auto without = run_program("verify " + input + " " + question);
    CHECK(without.exit == 3);
    const auto with = run_program("verify --skip-bad " + input + " " + question);
    CHECK(with.err.find("3 facets were skipped") != std::string::npos);
    CHECK(with.exit != 3);
  }
}

TEST_CASE("verify: whatever is wrong with the candidate is exit code 1, with a code") {
  struct Case {
    const char* name;
    std::string bytes;
    const char* code;
  };
  for (const Case& c :
       {Case{"c.obj", "", "candidate-solid"}, Case{"c.obj", "v 1 2\n", "candidate-readable"},
        Case{"c.obj", kBigTetrahedron + "f 1 2 9\n", "candidate-readable"},
        Case{"c.obj", kBigTetrahedron + "v inf 0 0\n", "candidate-finite"},
        Case{"c.obj", kBigTetrahedron + "f 1 3 2\n", "mesh-closed"},
        Case{"c.off", "OFF\n9 9 9\n0 0 0\n", "candidate-readable"},
        Case{"c.ply", "ply\nformat binary_little_endian 1.0\n", "candidate-readable"},
        Case{"c.stl", std::string(83, 'x'), "candidate-readable"},
        Case{"c.json", "{\"halfspaces\": 3}", "candidate-readable"},
        Case{"c.json", "[[0,0,0,1]]", "candidate-solid"},
        Case{"c.json", "[[0,0,0,-1]]", "candidate-bounded"},
        Case{"c.json", "[]", "candidate-readable"},
        Case{"c.ine", "begin\n1 4 integer\n", "candidate-readable"},
        Case{"c.txt", "1 0 0 1e999\n", "candidate-finite"}, Case{"c.txt", "", "candidate-readable"},
        Case{"c.obj", kBigTetrahedron + "f 1 2\n", "candidate-readable"},
        Case{"c.obj", std::string("\x00\xff\x7f", 3), "candidate-readable"}}) {
    CAPTURE(c.name);
    CAPTURE(c.bytes);
    const Judged judged = judge(c.bytes, c.name);
    CHECK(judged.exit == 1);
    CHECK(judged.status(c.code) == "violated");
  }
}

TEST_CASE("verify: with --numbers binary32, %.9g is a lossless print (#13)") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("in.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.3 0\nv 0 0 0.7\n");
  // printf("%.9g") of 0.1f, 0.3f and 0.7f, of which the last is below 0.7.
  const std::string candidate =
      scratch.write("c.obj", "v 0 0 0\nv 0.100000001 0 0\nv 0 0.300000012 0\nv 0 0 0.699999988\n");
  const std::string both = "verify " + input + " " + candidate;
  CHECK(run_program(both).exit == 1);
  CHECK(run_program(both + " --numbers binary64").exit == 1);
  CHECK(run_program(both + " --numbers binary32").exit == 0);
  CHECK(run_program(both + " --numbers binary32 --decimal nearest").exit == 0);
  const auto refused = run_program(both + " --numbers binary32 --decimal exact");
  CHECK(refused.exit == 2);
  CHECK(refused.err.find("--decimal exact") != std::string::npos);
  CHECK(run_program(both + " --numbers binary16").exit == 2);
  const std::string large = scratch.write("large.obj", "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nv 0 0 1\n");
  CHECK(run_program("verify " + large + " " + candidate + " --numbers binary32").exit == 3);
  const auto beyond = run_program("verify " + input + " " + large +
                                  " --numbers binary32 --claims candidate-finite");
  CHECK(beyond.exit == 1);
}

TEST_CASE("verify: exit codes of what is not the candidate's fault") {
  const ScratchFolder scratch;
  const std::string good = scratch.write("good.obj", kBigTetrahedron + kFaces);
  const std::string flat = scratch.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n");
  const std::string broken = scratch.write("broken.obj", "v 0 0\n");
  CHECK(run_program("verify " + good + " " + scratch.file("none.obj")).exit == 3);
  CHECK(run_program("verify " + scratch.file("none.obj") + " " + good).exit == 3);
  CHECK(run_program("verify " + broken + " " + good).exit == 3);
  CHECK(run_program("verify " + flat + " " + good).exit == 4);
  CHECK(run_program("verify " + good).exit == 2);
  CHECK(run_program("verify - -").exit == 2);
  CHECK(run_program("verify " + good + " " + good + " --tolerance much").exit == 2);
  CHECK(run_program("verify " + good + " " + good + " --claims beauty").exit == 2);
  CHECK(run_program("verify - " + good + " < " + good).exit == 0);
  CHECK(run_program("verify " + good + " - < " + good).exit == 0);
}

TEST_CASE("verify: people read the verdict, the witness and what was not asked") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("in.obj", kBigTetrahedron);
  const std::string planes = scratch.write("c.txt", "-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n1 1 1 -3\n");
  const auto ran = run_program("verify " + input + " " + planes + " --max-facets 3");
  CHECK(ran.exit == 1);
  for (const char* part : {"3 points outside, of 4 tested; point 1 is worst, 1 (0.144 of the "
                           "diameter) from the candidate, beyond row 3",
                           "the square of the distance is 1\n", "facets: 4, at most 3 allowed",
                           "not asked", "2 claims are violated"}) {
    CAPTURE(part);
    CHECK(ran.out.find(part) != std::string::npos);
  }
}

TEST_CASE("verify: what simplify writes passes, in every format and precision") {
  const ScratchFolder scratch;
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.json", "a.ine", "a.txt", "b.stl"}) {
    CAPTURE(name);
    const std::string file = scratch.file(name);
    const std::string precision = name[0] == 'b' ? " --precision 32" : " --precision 64";
    REQUIRE(
        run_program("simplify " + data("spot.obj") + " --faces 30 -o " + file + precision).exit ==
        0);
    CHECK(run_program("verify " + data("spot.obj") + " " + file + " --max-facets 30").exit == 0);
  }
}

TEST_CASE(
    "verify: a mesh of as many facets as simplify kept passes, exactly counted it does not (#13)") {
  const ScratchFolder scratch;
  for (const char* mesh : {"teapot.obj", "bunny.obj"}) {
    for (const char* precision : {"64", "32"}) {
      CAPTURE(mesh);
      CAPTURE(precision);
      const std::string file = scratch.file("c.off");
      REQUIRE(run_program("simplify " + data(mesh) + " --faces 18 --precision " + precision +
                          " -o " + file)
                  .exit == 0);
      const std::string verify = "verify " + data(mesh) + " " + file + " --no-tightness";
      CHECK(run_program(verify + " --max-facets 18").exit == 0);
      CHECK(run_program(verify + " --max-facets 17").exit == 1);
      CHECK(run_program(verify + " --max-facets 18 --exact-facets").exit == 1);
    }
  }
}

TEST_CASE("verify: polygons bent by rounding, and the tolerance that allows them (#13)") {
  // The faces of a rotated box, each corner rounded to doubles: no two quads are quite plane.
  const ScratchFolder scratch;
  std::string points;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        char line[200];
        std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n",
                      0.1 + 0.36 * x - 0.8 * y + 0.48 * z, 0.2 + 0.48 * x + 0.6 * y + 0.64 * z,
                      0.3 - 0.8 * x + 0.6 * z);
        points += line;
      }
    }
  }
  const std::string box = scratch.write(
      "box.obj", points + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n");
  const auto strict = run_program("verify " + box + " " + box + " --json --max-facets 6");
  CHECK(strict.exit == 1);
  const json verdict = json::parse(strict.out);
  CHECK(schema_complaint("verdict", verdict) == "");
  REQUIRE(verdict.contains("smallest_tolerance"));
  CHECK(verdict["smallest_tolerance"]["rounding"] == true);
  const std::string tolerance = verdict["smallest_tolerance"]["value"];
  CHECK(
      run_program("verify " + box + " " + box + " --max-facets 6 --tolerance " + tolerance).exit ==
      0);
}

TEST_CASE(
    "verify: what was named and does not apply is exit 1, what asks nothing is exit 2 (#13)") {
  CHECK(judge(kBigTetrahedron, "c.obj").exit == 0);
  const Judged closed = judge(kBigTetrahedron, "c.obj", "--claims mesh-closed");
  CHECK(closed.exit == 1);
  CHECK(closed.document["verdict"] == "undecided");
  CHECK(judge(kBigTetrahedron + "f 1 3 2\n", "c.obj", "--claims mesh-oriented").exit == 1);
  CHECK(judge("-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n", "c.txt", "--claims contains-input").exit == 0);
  CHECK(judge("-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n", "c.txt", "--claims contains-input --max-facets 3")
            .exit == 1);
  CHECK(judge(kBigTetrahedron, "c.obj", "--claims max-facets").exit == 2);
  CHECK(judge(kBigTetrahedron, "c.obj", "--claims ''").exit == 2);
  CHECK(judge(kBigTetrahedron, "c.obj", "--claims contains-input,").exit == 2);
  CHECK(judge(kBigTetrahedron, "c.obj", "--exact-facets").exit == 2);
}
