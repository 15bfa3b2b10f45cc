// SPDX-License-Identifier: MIT
// Bad, flat and extreme input on the command line: the documented exit code, one clear sentence, no
// file left behind. Expected codes are those of docs/usage.md.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "process.hpp"

using support::run_program;
using support::ScratchFolder;

namespace {

struct Case {
  const char* what;
  const char* file;  // its name, so that the extension counts
  std::string bytes;
  int exit;
  const char* says;  // a part of the sentence
};

const std::string kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

const std::vector<Case> kCases = {
    {"empty file", "a.obj", "", 4, "no points"},
    {"one point", "a.obj", "v 1 2 3\n", 4, "same point"},
    {"all equal", "a.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nv 1 2 3\n", 4, "same point"},
    {"collinear", "a.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 5 5 5\n", 4, "one line"},
    {"coplanar", "a.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 7 9 1\n", 4, "one plane"},
    {"one ulp from coplanar", "a.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1.0000000000000002\n", 0,
     ""},
    {"NaN", "a.obj", kTetrahedron + "v nan 0 0\n", 3, "a.obj:5"},
    {"infinity", "a.obj", kTetrahedron + "v 0 inf 0\n", 3, "a.obj:5"},
    {"beyond doubles", "a.obj", kTetrahedron + "v 0 0 1e400\n", 3, "a.obj:5"},
    {"subnormal", "a.obj", "v 0 0 0\nv 5e-324 0 0\nv 0 5e-324 0\nv 0 0 5e-324\n", 0, ""},
    {"1e300", "a.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1e300 0\nv 0 0 1e300\n", 0, ""},
    {"a word for a number", "a.obj", "v 0 0 x\n", 3, "a.obj:1"},
    {"a face index out of range", "a.obj", kTetrahedron + "f 1 2 9\n", 3, "a.obj:5"},
    {"truncated OFF", "a.off", "OFF\n4 4 6\n0 0 0\n1 0 0\n", 3, "a.off"},
    {"truncated PLY", "a.ply", "ply\nformat ascii 1.0\nelement vertex 4\n", 3, "a.ply"},
    {"truncated STL", "a.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", 3,
     "a.stl"},
    {"broken JSON", "a.json", "{\"halfspaces\": [[1, 0", 3, "a.json"},
    {"truncated .ine", "a.ine", "H-representation\nbegin\n4 4 integer\n1 0 0 1\n", 3, "a.ine"},
    {"JSON without a row", "a.json", "{\"halfspaces\": []}", 3, "found none"},
    {".ine without a row", "a.ine", "begin\n0 4 integer\nend\n", 3, "found none"},
    {"rows without a row", "a.txt", "", 3, "found none"},
    {"empty intersection", "a.json", "[[1,0,0,1],[-1,0,0,1]]", 4, "no point"},
    {"flat intersection", "a.json",
     "[[1,0,0,0],[-1,0,0,0],[0,1,0,-1],[0,-1,0,-1],[0,0,1,-1],[0,0,-1,-1]]", 4, "no interior"},
    {"unbounded intersection", "a.json", "[[1,0,0,-1],[-1,0,0,-1],[0,1,0,-1],[0,-1,0,-1]]", 4,
     "infinity"},
    {"zero normal, false", "a.json", "[[1,0,0,-1],[0,0,0,1]]", 4, "zero normal"},
};

}  // namespace

TEST_CASE("simplify: every kind of bad input has its exit code and its sentence") {
  for (const Case& c : kCases) {
    CAPTURE(c.what);
    const ScratchFolder scratch;
    const std::string input = scratch.write(c.file, c.bytes), output = scratch.file("proxy.obj");
    const auto ran = run_program("simplify " + input + " --faces 4 -o " + output);
    CAPTURE(ran.err);
    CHECK(ran.exit == c.exit);
    CHECK(ran.err.find(c.says) != std::string::npos);
    CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == (c.exit == 0 ? 0 : 1));
    CHECK(scratch.count() == (c.exit == 0 ? 2u : 1u));
  }
}

TEST_CASE("simplify --json: failure is one object on standard output too") {
  const ScratchFolder scratch;
  const auto ran = run_program("simplify --json --faces 4 " + scratch.write("a.obj", "v 1 2\n"));
  CHECK(ran.exit == 3);
  CHECK(ran.out.find("\"error\"") != std::string::npos);
  CHECK(ran.out.find("\"line\": 1") != std::string::npos);
}

TEST_CASE("simplify: files that cannot be read or written") {
  const ScratchFolder scratch;
  const std::string good = scratch.write("a.obj", kTetrahedron);
  CHECK(run_program("simplify --faces 4 " + scratch.file("missing.obj")).exit == 3);
  CHECK(run_program("simplify --faces 4 " + scratch.file("")).exit == 3);
  CHECK(run_program("simplify --faces 4 " + good + " -o " + scratch.file("no/such/b.obj")).exit ==
        5);
  CHECK(run_program("simplify --faces 4 " + good + " -o /proc/b.obj").exit == 5);
  CHECK(scratch.count() == 1);
  // Two outputs, one of them impossible: neither appears.
  CHECK(run_program("simplify --faces 4 " + good + " -o " + scratch.file("b.obj") + " -o " +
                    scratch.file("no/b.json"))
            .exit == 5);
  CHECK(scratch.count() == 1);
}

TEST_CASE("simplify: wrong usage") {
  const ScratchFolder scratch;
  const std::string good = scratch.write("a.obj", kTetrahedron);
  for (const char* arguments : {"simplify", "simplify --faces 4", "simplify --faces 3 a.obj",
                                "simplify --faces -7 a.obj", "simplify --faces x a.obj", "",
                                "no-such-command", "simplify a.obj --verify maybe --faces 4"}) {
    CAPTURE(arguments);
    CHECK(run_program(arguments).exit == 2);
  }
  for (const char* arguments :
       {"", "--max-growth -1", "--max-growth five", "--faces 4 --center 1,2",
        "--faces 4 --center 9,9,9", "--faces 4 -o b.abc", "--faces 4 -o b.stl --precision 64",
        "--faces 4 --parts", "--faces 4 --cost weight",
        "--faces 4 --cost mean-width --tie-bits 127", "--faces 4 --tie-bits x"}) {
    CAPTURE(arguments);
    CHECK(run_program("simplify " + good + " " + arguments).exit == 2);
  }
  CHECK(run_program("--help").exit == 0);
  CHECK(run_program("simplify --help").exit == 0);
  CHECK(run_program("hull --help").exit == 0);
}

TEST_CASE("simplify: what binary32 cannot hold is refused with exit 5") {
  const ScratchFolder scratch;
  const std::string huge =
      scratch.write("a.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1e300 0\nv 0 0 1e300\n");
  for (const char* name : {"b.stl", "b.obj --precision 32", "b.json --precision 32"}) {
    CAPTURE(name);
    const auto ran = run_program("simplify " + huge + " --faces 4 -o " + scratch.file(name));
    CHECK(ran.exit == 5);
    CHECK(scratch.count() == 1);
  }
}

TEST_CASE("simplify: standard input, and a full standard output") {
  const ScratchFolder scratch;
  const std::string good = scratch.write("a.obj", kTetrahedron);
  CHECK(run_program("simplify - --faces 4 <" + good).exit == 0);
  CHECK(run_program("simplify " + good + " --faces 4 --json >/dev/full #").exit == 5);
}
