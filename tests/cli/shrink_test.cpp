// SPDX-License-Identifier: MIT
// convexact shrink: programs that fail in a known way, so the minimal input is known in closed
// form. The programs are shell scripts around awk, run as any program would be.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "process.hpp"

using support::bytes_of;
using support::run_program;
using support::ScratchFolder;

namespace {

// Twelve points, faces among them.
const char* const kShape =
    "v 0.5 0.25 0\nv 3 1 2.5\nv -1 7 0.1\nv 2 2 2\nv 9 -4 1\nv 0.75 1 1\n"
    "v 1 1 8\nv 4.5 3 3\nv -6 0 0\nv 0 -5 0.3\nv 1e3 2 1\nv 5 6 7\n"
    "f 1 2 3\nf 3 2 4\nf 5 6 7\n";

struct ShrinkCase {
  ScratchFolder scratch;
  std::string input = scratch.write("shape.obj", kShape);
  std::string output = scratch.file("minimal.obj");

  // Shrinks for a script whose $1 is {input} and $2 {output}.
  support::Ran shrink(const std::string& script, const std::string& options = "") const {
    const std::string program = scratch.write("program", script);
    return run_program("shrink " + input + " -o " + output + " " + options + " -- /bin/sh " +
                       program + " {input} {output}");
  }
};

}  // namespace

TEST_CASE("shrink command: an exit code") {
  // Exits with 3 iff some x is above 2. The last such point has x = 5, whose half, 2, is not.
  const ShrinkCase test;
  const auto ran =
      test.shrink("awk '$1 == \"v\" && $2 > 2 {f = 3} END {exit f}' \"$1\"", "--allow-flat");
  REQUIRE_MESSAGE(ran.exit == 0, ran.err);
  CHECK(bytes_of(test.output) == "v 5 0 0\n");
  CHECK(ran.out.find("failure     exit code 3\n  points      1 of 12\n  bits        3 of ") !=
        std::string::npos);
}

TEST_CASE("shrink command: any predicate") {
  // Interesting: some x is above 2, as in the case above; and the file's name has blanks.
  const ShrinkCase test;
  const std::string folder = test.scratch.file("with 'a blank");
  std::filesystem::create_directory(folder);
  const std::string script = test.scratch.write(
      "predicate", "#!/bin/sh\nawk '$1 == \"v\" && $2 > 2 {f = 1} END {exit !f}' \"$1\"\n");
  for (const std::string& command :
       {"sh " + script, "sh " + script + " {input} | cat; sh " + script + " {input}"}) {
    const auto ran = support::run_shell(
        "TMPDIR=\"" + folder + "\" '" + std::getenv("CONVEXACT_PROGRAM") + "' shrink " +
        test.input + " -o " + test.output + " --allow-flat --interesting '" + command + "'");
    REQUIRE_MESSAGE(ran.exit == 0, ran.err);
    CHECK(bytes_of(test.output) == "v 5 0 0\n");
    CHECK(ran.out.find("failure     interesting\n  points      1 of 12\n") != std::string::npos);
  }
  const std::string base = "shrink " + test.input + " -o " + test.output + " --interesting ";
  const auto dull = run_program(base + "false");
  CHECK(dull.exit == 2);
  CHECK(dull.err.find("the command does not end with 0 on ") != std::string::npos);
  CHECK(run_program(base + "true -- cat {input}").exit == 2);
}

TEST_CASE("shrink command: the caps of a promise, and numbers in binary32") {
  // A program that copies: 11 corners, promised are 6. The fewest points that break the promise
  // are 7, and a third is no binary32 number.
  const ShrinkCase test;
  const std::string input = test.scratch.write("ball.obj", [] {
    std::string text;
    for (int k = 0; k < 11; ++k) {
      text += "v " + std::to_string(k) + " " + std::to_string(k * k) + " " +
              std::to_string(k * k * k + 1.0 / 3) + "\n";
    }
    return text;
  }());
  const auto ran = run_program("shrink " + input + " -o " + test.output +
                               " --numbers binary32 --max-vertices 6 --claims max-vertices -- cp "
                               "{input} {output}");
  REQUIRE_MESSAGE(ran.exit == 0, ran.err);
  CHECK(ran.out.find("violates max-vertices\n  points      7 of 11") != std::string::npos);
}

TEST_CASE("shrink command: a crash that needs two points, and fails otherwise with fewer") {
  // With fewer than two points it fails in another way, which is not the one to keep.
  const ShrinkCase test;
  const auto ran = test.shrink(
      "n=$(grep -c '^v' \"$1\"); [ \"$n\" -lt 2 ] && exit 9\n"
      "grep -q '^v.* 7$' \"$1\" && kill -SEGV $$\nexit 0\n",
      "--allow-flat --json");
  REQUIRE_MESSAGE(ran.exit == 0, ran.err);
  const auto document = nlohmann::json::parse(ran.out);
  CHECK(document["failure"] == "killed by signal 11");
  CHECK(document["points"]["before"] == 12);
  CHECK(document["points"]["after"] == 2);
  CHECK(document["bits"]["after"] == 3);
  CHECK(bytes_of(test.output) == "v 0 0 0\nv 0 0 7\n");
}

TEST_CASE("shrink command: no end in time") {
  // Few runs that hang, and long enough a time for those that do not, on a busy machine too.
  const ShrinkCase test;
  (void)test.scratch.write("shape.obj", "v 1 1 1\nv -6 0 0\n");
  const auto ran = test.shrink("grep -q '^v -6' \"$1\" && sleep 60\nexit 0\n", "--time-limit 2");
  REQUIRE_MESSAGE(ran.exit == 0, ran.err);
  CHECK(ran.out.find("no end within 2 s") != std::string::npos);
  CHECK(bytes_of(test.output) == "v -6 0 0\n");
}

TEST_CASE("shrink command: a verdict, and faces that keep all their corners") {
  // Its output is its input without the last point. An input with a volume has four points, and a
  // triangle misses the fourth.
  const ShrinkCase test;
  const auto ran = test.shrink("grep '^v' \"$1\" | sed '$d' > \"$2\"",
                               "--fails-if verdict --claims contains-input");
  REQUIRE_MESSAGE(ran.exit == 0, ran.err);
  CHECK(ran.out.find("violates contains-input") != std::string::npos);
  const std::string minimal = bytes_of(test.output);
  CHECK(std::count(minimal.begin(), minimal.end(), 'v') == 4);
  CHECK(minimal.find_first_not_of("vf 0123456789-\n") == minimal.npos);
}

TEST_CASE("shrink command: output that is missing, while another failure is not looked at") {
  const ShrinkCase test;
  const auto ran = test.shrink("exit 0", "--fails-if verdict --allow-flat");
  REQUIRE_MESSAGE(ran.exit == 0, ran.err);
  CHECK(ran.out.find("no output") != std::string::npos);
  CHECK(bytes_of(test.output).empty());
  CHECK(test.shrink("exit 1", "--fails-if verdict").exit == 2);
  CHECK(test.shrink("exit 0", "--fails-if exit").exit == 2);
}

TEST_CASE("shrink command: the same again, whenever it is asked") {
  const ShrinkCase one, two;
  const char* const script = "awk '$1 == \"v\" {s += $2 * $3} END {exit s > 17.3 ? 1 : 0}' \"$1\"";
  REQUIRE(one.shrink(script).exit == 0);
  REQUIRE(two.shrink(script).exit == 0);
  CHECK(bytes_of(one.output) == bytes_of(two.output));
}

TEST_CASE("shrink command: what cannot be done") {
  const ShrinkCase test;
  const std::string start = "shrink " + test.input;
  const std::string to = " -o " + test.output;
  CHECK(run_program(start + to + " -- true {input}").exit == 2);      // does not fail
  CHECK(run_program(start + to + " -- false").exit == 2);             // no {input}
  CHECK(run_program(start + to).exit == 2);                           // no program
  CHECK(run_program(start + " -- false {input}").exit == 2);          // no result
  CHECK(run_program(start + to + " -- /no/such {input}").exit == 2);  // not started
  CHECK(run_program(start + to + " -- false {input} {faces}").exit == 2);
  CHECK(run_program(start + " -o a.stl -- false {input}").exit == 2);
  CHECK(run_program(start + to + " --fails-if verdict -- false {input}").exit == 2);
  CHECK(run_program("shrink " + test.scratch.file("absent") + to + " -- false {input}").exit == 3);
  CHECK(bytes_of(test.output).empty());
}

TEST_CASE("shrink command: an input with nothing to remove is refused as elsewhere") {
  // The program would fail on it, and is not run.
  const ScratchFolder scratch;
  const std::string ran = scratch.file("ran");
  const std::string program = scratch.write("program", "echo >>'" + ran + "'; exit 1\n");
  struct Case {
    const char* file;
    const char* bytes;
    const char* output;
    const char* says;
  };
  for (const Case& c : {Case{"a.obj", "", "b.obj", "there are no points"},
                        Case{"a.xyz", "# nothing\n", "b.xyz", "there are no points"},
                        Case{"a.off", "OFF\n0 0 0\n", "b.off", "there are no points"},
                        Case{"a.txt", "0 0 0 -1\n", "b.txt", "infinity"}}) {
    CAPTURE(c.file);
    const std::string input = scratch.write(c.file, c.bytes);
    for (const char* options : {"", "--allow-flat ", "--json "}) {
      CAPTURE(options);
      const auto refused =
          run_program("shrink " + std::string(options) + input + " -o " + scratch.file(c.output) +
                      " -- /bin/sh " + program + " {input}");
      const bool is_json = std::string(options) == "--json ";
      CHECK(refused.exit == 4);
      CHECK((is_json ? refused.out : refused.err).find(c.says) != std::string::npos);
    }
    CHECK(run_program("hull " + input).exit == 4);
    CHECK_FALSE(std::filesystem::exists(scratch.file(c.output)));
  }
  CHECK_FALSE(std::filesystem::exists(ran));
}

TEST_CASE("shrink command: an interrupt leaves the smallest input so far that fails") {
  // It ends as in the first case, and interrupts its parent once few points are left.
  const ShrinkCase test;
  const std::string fails = "awk '$1 == \"v\" && $2 > 2 {f = 3} END {exit f}' \"$1\"";
  const auto ran = test.shrink(
      "[ $(grep -c '^v' \"$1\") -lt 4 ] && kill -INT $PPID\n" + fails + "\n", "--allow-flat");
  CHECK(ran.exit == 6);
  CHECK(ran.err.find("not yet minimal") != std::string::npos);
  const std::string left = bytes_of(test.output);
  const auto points = std::count(left.begin(), left.end(), 'v');
  CHECK(points >= 1);
  CHECK(points < 12);
  const std::string check = test.scratch.write("check", fails);
  CHECK(WEXITSTATUS(std::system(("/bin/sh " + check + " " + test.output).c_str())) == 3);

  // Interrupted before anything smaller is known: nothing is written.
  const ShrinkCase early;
  const auto at_once = early.shrink("kill -INT $PPID; exit 3\n");
  CHECK(at_once.exit == 6);
  CHECK(at_once.err.find("nothing") != std::string::npos);
  CHECK(bytes_of(early.output).empty());
}

TEST_CASE("shrink command: a solid stays one unless flat inputs are asked for (#13)") {
  // The first case above ends with one point if it may.
  const ShrinkCase test;
  const std::string fails = "awk '$1 == \"v\" && $2 > 2 {f = 3} END {exit f}' \"$1\"";
  REQUIRE(test.shrink(fails).exit == 0);
  const std::string minimal = bytes_of(test.output);
  CHECK(std::count(minimal.begin(), minimal.end(), 'v') == 4);
  CHECK(run_program("hull " + test.output).exit == 0);
  const std::string check = test.scratch.write("check", fails);
  CHECK(WEXITSTATUS(std::system(("/bin/sh " + check + " " + test.output).c_str())) == 3);

  // A flat input has no volume to keep.
  const ShrinkCase flat;
  (void)flat.scratch.write("shape.obj", "v 9 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 7 7 0\n");
  REQUIRE(flat.shrink(fails).exit == 0);
  const std::string one = bytes_of(flat.output);
  CHECK(std::count(one.begin(), one.end(), 'v') == 1);
}

TEST_CASE("shrink command: halfspaces lose rows, then bits of their numbers (#13)") {
  // Exits with 3 iff some second number is above 100.
  const std::string fails = "awk '$2 > 100 {f = 3} END {exit f}' \"$1\"";
  const std::string rows =
      "1 0 0 -1\n-1 0 0 -1\n0 1 0 -1\n0 -1 0 -1\n0 0 1 -1\n0 0 -1 -1\n"
      "1000003 1234567 999983 -3000017\n3 2 1 -5\n1 1 1 -2.5\n";
  for (const std::string flat : {"", "--allow-flat "}) {
    CAPTURE(flat);
    const ScratchFolder scratch;
    const std::string input = scratch.write("planes.txt", rows);
    const std::string output = scratch.file("minimal.txt");
    const std::string program = scratch.write("program", fails);
    const auto ran = run_program("shrink --json " + flat + input + " -o " + output +
                                 " -- /bin/sh " + program + " {input}");
    REQUIRE_MESSAGE(ran.exit == 0, ran.err);
    const auto document = nlohmann::json::parse(ran.out);
    CHECK(document["failure"] == "exit code 3");
    CHECK(document["halfspaces"]["before"] == 9);
    // Four rows at least bound a solid; one row is enough to fail.
    CHECK(document["halfspaces"]["after"] == (flat.empty() ? 4 : 1));
    CHECK(document["bits"]["after"] < (flat.empty() ? 24 : 12));
    CHECK(run_program("hull " + output).exit == (flat.empty() ? 0 : 4));
    CHECK(WEXITSTATUS(std::system(("/bin/sh " + program + " " + output).c_str())) == 3);
    CHECK(run_program("shrink " + input + " -o " + scratch.file("minimal.obj") + " -- /bin/sh " +
                      program + " {input}")
              .exit == 2);
  }
}

TEST_CASE("shrink command: a verdict with a tolerance (#13)") {
  // Its output is its input, a hundred millionth smaller.
  const ShrinkCase test;
  const std::string script =
      "awk '$1 == \"v\" {printf \"v %.17g %.17g %.17g\\n\", $2 * 0.99999999, $3 * 0.99999999, "
      "$4 * 0.99999999}' \"$1\" > \"$2\"";
  const std::string verdict = "--fails-if verdict --claims contains-input ";
  CHECK(test.shrink(script, verdict).exit == 0);
  const auto passes = test.shrink(script, verdict + "--tolerance 1e-6d");
  CHECK(passes.exit == 2);
  CHECK(passes.err.find("does not fail") != std::string::npos);
  CHECK(test.shrink(script, verdict + "--tolerance 1e-10").exit == 0);
  CHECK(test.shrink(script, verdict + "--tolerance x").exit == 2);
}

TEST_CASE("shrink command: limits and formats have the names that they have elsewhere (#13)") {
  const ShrinkCase test;
  CHECK(test.shrink("exit 3", "--time-limit 9 --memory-limit 2GB --output-format json").exit == 0);
  for (const std::string old : {"--time", "--memory", "--output-as"}) {
    const auto ran = test.shrink("exit 3", old + " 9");
    CHECK(ran.exit == 2);
    CHECK(ran.err.find("there is no option '" + old + "'") != std::string::npos);
  }
}
