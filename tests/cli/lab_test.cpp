// SPDX-License-Identifier: MIT
// The subcommands of convexact-lab: listed and started by convexact, and named where it is missing.
#include <doctest/doctest.h>

#include <filesystem>

#include "process.hpp"

using namespace support;

TEST_CASE("lab: --help lists its subcommands among all others") {
  const Ran help = run_program("--help");
  CHECK(help.exit == 0);
  std::size_t after = 0;
  for (const char* name :
       {"hull", "simplify", "decompose", "bvh", "verify", "diff", "report", "conform", "generate",
        "shrink", "stress", "query", "compare", "teach"}) {
    CAPTURE(name);
    const std::size_t at = help.out.find(std::string("\n  ") + name + " ", after);
    REQUIRE(at != std::string::npos);
    after = at;
  }
}

TEST_CASE("lab: convexact starts it, with all arguments and its exit code") {
  for (const char* name : {"diff", "report", "stress", "compare"}) {
    CAPTURE(name);
    const Ran help = run_program(std::string(name) + " --help");
    CHECK(help.exit == 0);
    CHECK(help.out.find(std::string("convexact ") + name) != std::string::npos);
  }
  CHECK(run_program("diff '" + data("none.obj") + "' --faces 4").exit == 3);
  CHECK(run_program("stress --list").exit == 0);
}

TEST_CASE("lab: where it is missing, one sentence says how to get it") {
  const ScratchFolder folder;
  // In a folder of its own, as the lab is looked for beside that, too.
  std::filesystem::create_directory(folder.file("bin"));
  const std::string alone = folder.file("bin/convexact");
  std::filesystem::copy_file(std::getenv("CONVEXACT_PROGRAM"), alone);
  const std::string out = folder.file("out"), err = folder.file("err");
  const auto run = [&](const std::string& words) {
    const std::string command =
        "PATH=/usr/bin:/bin '" + alone + "' " + words + " >" + out + " 2>" + err;
    return WEXITSTATUS(std::system(command.c_str()));
  };
  CHECK(run("report x.obj") == 2);
  CHECK(bytes_of(out).empty());
  CHECK(bytes_of(err).find("report is a subcommand of convexact-lab") != std::string::npos);
  CHECK(run("report x.obj --json") == 2);
  CHECK(bytes_of(out).find("\"exit\": 2") != std::string::npos);
  // All others work without it.
  CHECK(run("hull '" + data("spot.obj") + "'") == 0);
}
