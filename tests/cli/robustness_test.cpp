// SPDX-License-Identifier: MIT
// What may happen to a program: no memory, no room, a closed pipe, an interrupt. The expected
// behaviour is the documented exit code, one sentence, and no half-written file. Codes are those of
// docs/usage.md.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "process.hpp"

using support::run_interrupted;
using support::run_program;
using support::ScratchFolder;

namespace {

const std::string kSmallTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

std::string program() { return std::string("'") + std::getenv("CONVEXACT_PROGRAM") + "'"; }

// The exit code of a shell's command line, and what it said.
support::Ran run_commands(const std::string& commands) {
  return support::run_shell("(" + commands + ")");
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("--max-memory: whatever the limit, the run is complete or leaves nothing") {
  const std::string bunny = support::data("bunny.obj");
  bool is_enough = false;
  for (const char* limit : {"1B", "1KB", "30KB", "300KB", "1MB", "3MB", "6MB", "9MB", "1GB"}) {
    CAPTURE(limit);
    const ScratchFolder scratch;
    const auto ran = run_program("simplify " + bunny + " --faces 18 -o " + scratch.file("b.obj") +
                                 " --picture " + scratch.file("b.html") + " --max-memory " + limit);
    CAPTURE(ran.err);
    is_enough = ran.exit == 0;
    CHECK((is_enough || ran.exit == 6));
    CHECK(scratch.count() == (is_enough ? 2u : 0u));
    CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == (is_enough ? 0 : 1));
    CHECK(has(ran.err, is_enough ? "" : "--max-memory"));
  }
  CHECK(is_enough);
}

TEST_CASE("--max-memory: numbers of GMP count, and end the run as cleanly") {
  // Hundreds of thousands of digits: nearly all memory is taken inside of GMP.
  const ScratchFolder scratch;
  const std::string offset = std::string(200000, '7') + "/" + std::string(200000, '3');
  const std::string input =
      scratch.write("a.json", "[[1,0,0,\"-" + offset +
                                  "\"],[-1,0,0,-1],[0,1,0,-1],[0,-1,0,-1],[0,0,1,-1],[0,0,-1,-1]]");
  for (const char* limit : {"200KB", "400KB", "800KB", "1500KB"}) {
    CAPTURE(limit);
    const auto ran = run_program("simplify --json --decimal exact " + input + " --faces 6 -o " +
                                 scratch.file("b.json") + " --max-memory " + limit);
    CHECK(ran.exit == 6);
    CHECK(nlohmann::json::parse(ran.out)["error"]["code"] == "stopped");
    CHECK(scratch.count() == 1);
  }
}

// Of 24 limits that end the run at different places, some do so while a JSON value is made, whose
// destructor allocates.
TEST_CASE("--max-memory: JSON values that are half made end cleanly") {
  for (int k = 0; k < 24; ++k) {
    const std::string limit = std::to_string(2300 + 25 * k) + "KB";
    CAPTURE(limit);
    const auto ran = run_program("hull --json --measures none " + support::data("spot.obj") +
                                 " --max-memory " + limit);
    CHECK((ran.exit == 0 || ran.exit == 6));
    CHECK(nlohmann::json::parse(ran.out).contains("error") == (ran.exit == 6));
  }
}

TEST_CASE("--max-memory: temporary files go, too") {
  const ScratchFolder scratch;
  const auto ran = run_commands("TMPDIR=" + scratch.file("") + " " + program() + " shrink " +
                                support::data("spot.obj") + " -o " + scratch.file("s.obj") +
                                " --max-memory 1MB -- false {input}");
  CAPTURE(ran.err);
  CHECK(ran.exit == 6);
  CHECK(scratch.count() == 0);
}

TEST_CASE("a full disk: exit 5, and no part of a file") {
  const ScratchFolder scratch;
  // Files may grow to one block of 512 or 1024 bytes; the mesh is larger.
  const auto ran =
      run_commands("ulimit -f 1; exec " + program() + " simplify " + support::data("spot.obj") +
                   " --faces 100 -o " + scratch.file("b.obj"));
  CHECK(ran.exit == 5);
  CHECK(scratch.count() == 0);
  CHECK(run_program("simplify " + support::data("spot.obj") + " --faces 18 >/dev/full #").exit ==
        5);
}

TEST_CASE("a closed pipe: exit 6") {
  const ScratchFolder scratch;
  const std::string code = scratch.file("code");
  run_commands("(" + program() + " hull " + support::data("spot.obj") + " --json; echo $? >" +
               code + ") | true");
  CHECK(support::bytes_of(code) == "6\n");
}

TEST_CASE("an interrupt: exit 6, and nothing written") {
  const ScratchFolder scratch;
  const std::string input = scratch.file("a.xyz");
  REQUIRE(run_program("generate fibonacci-sphere --points 5000 -o " + input).exit == 0);
  for (const char* signal : {"INT", "TERM"}) {
    CAPTURE(signal);
    const auto ran = run_interrupted(
        "simplify " + input + " --engine exact --faces 18 -o " + scratch.file("b.obj"), signal,
        "1");
    CHECK(ran.exit == 6);
    CHECK(has(ran.err, "interrupted"));
    CHECK(scratch.count() == 1);
  }
}

// The search on 116 facets begins within a fraction of a second and is out of reach: it is what the
// first signal meets.
TEST_CASE("an interrupt of a search for the optimum ends the search, a second one the program") {
  const ScratchFolder scratch;
  const std::string small = scratch.file("a.xyz"), large = scratch.file("b.xyz");
  REQUIRE(run_program("generate random-sphere --points 60 -o " + small).exit == 0);
  REQUIRE(run_program("generate fibonacci-sphere --points 5000 -o " + large).exit == 0);
  const std::string search =
      " --faces 18 --search optimal --moves 0 --nodes 100000000000 -o " + scratch.file("c.obj");

  const auto settled = run_interrupted("simplify " + small + search, "INT", "2");
  CHECK(settled.exit == 0);
  CHECK(has(settled.out, "not proven"));
  CHECK(std::filesystem::remove(scratch.file("c.obj")));

  // Two interrupts that meet the same search. The program stands still while they are sent, or it
  // might be done before the second; and they are different ones, since the same signal twice is
  // delivered once.
  const auto at_once = run_interrupted("simplify " + small + search, "STOP", "2",
                                       "kill -INT $pid; kill -TERM $pid; kill -CONT $pid; ");
  CHECK(at_once.exit == 6);
  CHECK(has(at_once.err, "interrupted"));

  // Ctrl-C twice. The second one meets the work on the next object, which takes far longer.
  const auto later = run_interrupted("simplify " + small + " " + large + " --engine exact" + search,
                                     "INT", "2", "sleep 1; kill -INT $pid; ");
  CHECK(later.exit == 6);
  CHECK(has(later.err, "interrupted"));
  CHECK(scratch.count() == 2);
}

TEST_CASE("an interrupt of verify: exit 6 at once, whatever it is doing (#13)") {
  const ScratchFolder scratch;
  const std::string input = scratch.file("a.obj");
  REQUIRE(run_program("generate random-sphere --points 60000 --facets -o " + input).exit == 0);
  for (const char* after : {"0.5", "1", "1.5"}) {
    CAPTURE(after);
    const auto ran = run_interrupted("verify " + input + " " + input, "INT", after);
    CHECK(ran.exit == 6);
    CHECK(has(ran.err, "interrupted"));
  }
}

TEST_CASE("an output that is the input: refused, by whatever name, and the input stays") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("a.obj", kSmallTetrahedron);
  std::filesystem::create_symlink(input, scratch.file("b.obj"));
  for (const std::string& output : {input, scratch.file("./a.obj"), scratch.file("b.obj")}) {
    CAPTURE(output);
    for (const char* command : {"simplify --faces 4 ", "hull "}) {
      const auto ran = run_program(command + input + " -o " + output);
      CHECK(ran.exit == 2);
      CHECK(has(ran.err, "is an input"));
    }
  }
  CHECK(support::bytes_of(input) == kSmallTetrahedron);
  CHECK(run_program("simplify --faces 4 " + input + " -o " + scratch.file("c.obj")).exit == 0);
}

TEST_CASE("progress: on a terminal only, with an estimate") {
  if (std::system("script --version >/dev/null 2>&1") != 0) {
    MESSAGE("skipped: no `script` (Debian's bsdutils) to make a terminal");
    return;
  }
  const ScratchFolder scratch;
  const std::string input = scratch.file("a.xyz"), typescript = scratch.file("typescript");
  REQUIRE(run_program("generate fibonacci-sphere --points 3000 -o " + input).exit == 0);
  // Ended once the estimate has been shown, however long that takes on a busy machine.
  run_commands("script -qefc \"" + program() + " simplify " + input +
               " --engine exact --faces 4\" " + typescript +
               " & for i in $(seq 900); do grep -q ' left' " + typescript +
               " && break; sleep 0.1; done; kill $!");
  const std::string shown = support::bytes_of(typescript);
  CHECK(has(shown, "\r\033[K"));
  CHECK(has(shown, "simplify: "));
  CHECK(has(shown, " left"));
  const auto quiet = run_commands("timeout --foreground -s INT 2 " + program() + " simplify " +
                                  input + " --engine exact --faces 4");
  CHECK_FALSE(has(quiet.err, "simplify: "));
}
