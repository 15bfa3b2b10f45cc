// SPDX-License-Identifier: MIT
// Running a program: every way to end is distinguished, and no process of it remains. The programs
// are the system's own, so their behaviour is known.
#include <doctest/doctest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "convexact/conform.hpp"
#include "convexact/error.hpp"
#include "process.hpp"

using namespace convexact;

namespace {

ProgramRun shell(const std::string& script, const ProgramLimits& limits = {}) {
  return run_program({"/bin/sh", "-c", script}, limits);
}

}  // namespace

TEST_CASE("run_program: exit codes") {
  CHECK(run_program({"true"}, {}).succeeded());
  const ProgramRun failed = shell("exit 42");
  CHECK(failed.end == ProgramEnd::Exited);
  CHECK(failed.exit_code == 42);
  CHECK_FALSE(failed.succeeded());
  CHECK(describe(failed) == "exit code 42");
}

TEST_CASE("run_program: crashes") {
  const ProgramRun crashed = shell("kill -SEGV $$");
  CHECK(crashed.end == ProgramEnd::Crashed);
  CHECK(crashed.signal == SIGSEGV);
  CHECK(describe(crashed) == "killed by signal 11");
}

TEST_CASE("run_program: one that hangs is killed, and what it started too") {
  const support::ScratchFolder scratch;
  const std::string late = scratch.file("late");
  const ProgramRun hung =
      shell("(sleep 1; touch '" + late + "') & sleep 60", {.seconds = 0.2, .memory = 0});
  CHECK(hung.end == ProgramEnd::TimedOut);
  CHECK(describe(hung) == "no end within 0.2 s");
  usleep(1300000);
  CHECK_FALSE(std::filesystem::exists(late));
}

TEST_CASE("run_program: one that closes its output, or leaves it to another, is waited for") {
  CHECK(shell("exec >/dev/null 2>&1; sleep 0.1; exit 3").exit_code == 3);
  const ProgramRun run = shell("sleep 60 & exit 4");
  CHECK(run.exit_code == 4);
  CHECK(run.seconds < 10);
}

TEST_CASE("run_program: no such program, and one that is a folder") {
  CHECK(run_program({"/no/such/program"}, {}).end == ProgramEnd::NotStarted);
  CHECK(run_program({"/"}, {}).end == ProgramEnd::NotStarted);
  CHECK(describe(run_program({"no-such-program-anywhere"}, {})) == "cannot be started");
}

TEST_CASE("run_program: the last of what it prints is kept") {
  CHECK(shell("echo one; echo two >&2").printed == "one\ntwo\n");
  const ProgramRun long_one = shell("i=0; while [ $i -lt 3000 ]; do echo $i; i=$((i+1)); done");
  CHECK(long_one.succeeded());
  CHECK(long_one.printed.size() <= 4096);
  CHECK(long_one.printed.ends_with("2998\n2999\n"));
}

TEST_CASE("run_program: standard input is empty, and a word is one argument") {
  CHECK(run_program({"cat"}, {}).succeeded());
  CHECK(run_program({"printf", "%s|", "a b", "$HOME", ""}, {}).printed == "a b|$HOME||");
}

TEST_CASE("run_program: memory is limited") {
  // The shell's own variable grows beyond it.
  const ProgramRun run =
      shell("x=0123456789abcdef; while :; do x=$x$x; done", {.seconds = 20, .memory = 1 << 28});
  CHECK(run.end != ProgramEnd::TimedOut);
  CHECK_FALSE(run.succeeded());
}

TEST_CASE("run_program: an interrupt ends it") {
  const std::atomic<bool> stop = true;
  CHECK_THROWS_AS((void)run_program({"sleep", "60"}, {}, &stop), Error);
  CHECK_THROWS_AS((void)run_program({}, {}), Error);
  CHECK_THROWS_AS((void)run_program({"true"}, {.seconds = 0, .memory = 0}), Error);
}

TEST_CASE("fill_in: placeholders anywhere in a word, other braces as they are") {
  const std::map<std::string, std::string> values = {{"input", "a b.obj"}, {"faces", "18"}};
  CHECK(fill_in({"prog", "{input}", "-k{faces}", "{{faces}}", "{other}", "{", ""}, values) ==
        std::vector<std::string>{"prog", "a b.obj", "-k18", "{18}", "{other}", "{", ""});
}
