// SPDX-License-Identifier: MIT
// Outputs of programs that are no files, and places where no output can be written. Expected are
// the exit codes of the manual, and that the work does not begin.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "process.hpp"
#include "program_json.hpp"

using nlohmann::json;
using support::bytes_of;
using support::data;
using support::program_json;
using support::Ran;
using support::run_program;
using support::ScratchFolder;

namespace {

// A program whose output is made by a line of shell, with the output's name in $1.
std::string program_of(const std::string& line) {
  return " -- /bin/sh -c '" + line + "' sh {output} {input}";
}

struct OddOutput {
  const char* name;
  const char* line;
};
const OddOutput kOddOutputs[] = {{"a FIFO", "mkfifo \"$1\""},
                                 {"a folder", "mkdir \"$1\""},
                                 {"a link to a device", "ln -s /dev/zero \"$1\""},
                                 {"200 GB of nothing", "truncate -s 200G \"$1\""}};

}  // namespace

TEST_CASE("odd outputs: conform calls them unreadable and goes on") {
  for (const OddOutput& odd : kOddOutputs) {
    CAPTURE(std::string(odd.name));
    const json report =
        program_json("conform --level 1 --flag valence --asks enclosure" + program_of(odd.line),
                     "conformance", 1);
    CHECK(report["vectors"].size() > 1);
    for (const json& entry : report["vectors"]) CHECK(entry["outcome"] == "unreadable-output");
  }
}

TEST_CASE("odd outputs: shrink sees them as a violation, and ends") {
  const ScratchFolder scratch;
  const std::string input =
      scratch.write("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 1 2 4\n");
  for (const OddOutput& odd : kOddOutputs) {
    CAPTURE(std::string(odd.name));
    const Ran ran =
        run_program("shrink " + input + " -o " + scratch.file("least.obj") + program_of(odd.line));
    CHECK(ran.exit == 0);
    CHECK(ran.out.find("violates candidate-readable") != ran.out.npos);
  }
}

TEST_CASE("odd outputs: an option sets the largest size that is read") {
  const std::string program = program_of("cp \"$2\" \"$1\"");
  const std::string conform = "conform --level 1 --flag valence --asks enclosure ";
  CHECK(program_json(conform + "--output-limit 10" + program, "conformance",
                     1)["outcomes"]["unreadable-output"] > 0);
  CHECK(program_json(conform + program, "conformance", 0)["outcomes"]["unreadable-output"] == 0);
}

TEST_CASE("odd outputs: a verdict that takes too long is undecided, which is no pass") {
  // One face, a comb of 60,001 corners: its verdict takes a second or more.
  const ScratchFolder scratch;
  std::string comb, face = "f";
  for (int k = 0; k < 60000; ++k) {
    comb += "v " + std::to_string(k) + (k % 2 == 0 ? " 0 0\n" : " 1000 0\n");
    face += " " + std::to_string(k + 1);
  }
  comb += "v 60000 2000 0\n";
  const std::string output = scratch.write("comb.obj", comb + face + " 60001\n");
  const json report =
      program_json("conform --level 1 --flag valence --asks enclosure --judge-time-limit 0.01 " +
                       program_of("cp " + output + " \"$1\""),
                   "conformance", 1);
  for (const json& entry : report["vectors"]) CHECK(entry["outcome"] == "undecided");
}

TEST_CASE("places of outputs: every command finds out before the work") {
  const ScratchFolder scratch;
  const std::string spot = data("spot.obj"), nowhere = scratch.file("nowhere") + "/file",
                    marker = scratch.file("started");
  const std::string program = " -- /bin/sh -c 'touch " + marker + "; exit 1' sh {input} {output}";
  for (const std::string& command :
       {"simplify " + spot + " --faces 18 -o " + nowhere + ".obj",
        "simplify " + spot + " --faces 18 --trace " + nowhere + ".json",
        "simplify " + spot + " --faces 18 --picture " + nowhere + ".html",
        "simplify " + spot + " --inner --vertices 8 -o " + nowhere + ".obj",
        "hull " + spot + " -o " + nowhere + ".obj", "teach " + spot + " -o " + nowhere + ".html",
        "decompose --method hacd " + spot + " -o " + nowhere + ".obj",
        "decompose --method hacd " + spot + " --trace " + nowhere + ".json",
        "bvh " + spot + " -o " + nowhere + ".json", "generate cube -o " + nowhere + ".obj",
        "verify " + spot + " " + spot + " --union --picture " + nowhere + ".html",
        "compare " + spot + " --faces 18 --csv " + nowhere + ".csv",
        "conform --level 1 -o " + nowhere + ".json" + program,
        "shrink " + spot + " -o " + nowhere + ".obj" + program}) {
    CAPTURE(command);
    const Ran ran = run_program(command);
    CHECK(ran.exit == 5);
    CHECK(ran.err.find("cannot be written") != ran.err.npos);
  }
  CHECK_FALSE(std::filesystem::exists(marker));
}

TEST_CASE("places of outputs: the longest name, and a link to itself") {
  const ScratchFolder scratch;
  const std::string longest = scratch.file(std::string(251, 'a') + ".obj");  // 255 bytes
  CHECK(run_program("generate cube -o " + longest).exit == 0);
  CHECK(run_program("generate cube -o " + longest).exit == 0);  // the old one is kept meanwhile
  CHECK(bytes_of(longest).starts_with("v "));
  const std::string loop = scratch.file("loop.obj");
  std::filesystem::create_symlink("loop.obj", loop);
  CHECK(run_program("generate cube -o " + loop).exit == 5);
  CHECK(std::filesystem::is_symlink(loop));
}

TEST_CASE("empty texts: a value that a script did not set is wrong usage") {
  const std::string spot = data("spot.obj");
  for (const char* option : {"--tolerance", "--claims", "--profile", "--asks", "--max-facets",
                             "--picture", "--decimal", "--numbers"}) {
    CAPTURE(std::string(option));
    CHECK(run_program("verify " + spot + " " + spot + " " + option + " ''").exit == 2);
  }
  for (const char* option : {"--faces", "-o", "--picture", "--keep", "--engine", "--max-memory"}) {
    CAPTURE(std::string(option));
    CHECK(run_program("simplify " + spot + " " + option + " ''").exit == 2);
  }
}
