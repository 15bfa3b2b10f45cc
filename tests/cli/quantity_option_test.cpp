// SPDX-License-Identifier: MIT
// Counts, sizes and durations on the command line: text that is no such number, or a number outside
// of its range, is wrong usage and the message names the option; no number wraps, saturates or is
// octal.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "process.hpp"
#include "sweep.hpp"

using support::run_program;
using support::ScratchFolder;

namespace {

bool says(const support::Ran& ran, const std::string& part) {
  return ran.err.find(part) != std::string::npos;
}

struct CountOption {
  const char* command;  // with %INPUT% for a file that is there
  const char* option;
  const char* range;
  const char* outside;  // a count beyond the range; nullptr: none is but overflow
};

const std::vector<CountOption> kCounts = {
    {"simplify %INPUT%", "--faces", "4 to 4294967296", "3"},
    {"diff %INPUT%", "--faces", "4 to 4294967296", "4294967297"},
    {"hull %INPUT%", "--digits", "1 to 10000", "10001"},
    {"hull %INPUT%", "--seed", "0 to 18446744073709551615", nullptr},
    {"verify %INPUT% %INPUT%", "--max-facets", "0 to 18446744073709551615", nullptr},
    {"verify %INPUT% %INPUT%", "--max-vertices", "0 to 18446744073709551615", nullptr},
    {"verify %INPUT% %INPUT%", "--max-facet-vertices", "0 to 18446744073709551615", nullptr},
    {"compare %INPUT%", "--faces", "4 to 4294967296", "3"},
    {"report %INPUT%", "--faces", "4 to 4294967296", "0"},
    {"report %INPUT%", "--repetitions", "1 to 1000", "0"},
    {"conform", "--level", "1 to 3", "4"},
    {"shrink %INPUT% -o a.obj", "--faces", "4 to 4294967296", "3"},
    {"stress", "--size", "1 to 10000000", "0"},
    {"stress", "--seeds", "1 to 1000000000", "0"},
    {"stress", "--faces", "4 to 4294967296", "3"},
    {"stress", "--jobs", "1 to 256", "257"},
    {"generate prism", "--k", "3 to 1000000", "2"},
    {"generate needle", "--points", "1 to 10000000", "0"},
};

std::string with_input(std::string command, const std::string& input) {
  for (std::size_t at; (at = command.find("%INPUT%")) != command.npos;) {
    command.replace(at, 7, input);
  }
  return command;
}

}  // namespace

TEST_CASE("counts: everything but a count in range is wrong usage, told by its option (#13)" *
          sweep) {
  const ScratchFolder scratch;
  const std::string input = scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  for (const CountOption& c : kCounts) {
    const std::string command = with_input(c.command, input) + " " + c.option + "=";
    std::vector<std::string> bad = {"-1", "1e1", "99999999999999999999"};
    if (&c == &kCounts.front()) {  // one reader for all: what it refuses is asked once
      bad.insert(bad.end(), {"+4", "' 4'", "'4 '", "4.0", "4.5", "4e0", "0x10", "4,", "4_0", "four",
                             "18446744073709551620"});
    }
    if (c.outside != nullptr) bad.push_back(c.outside);
    for (const std::string& value : bad) {
      const std::string arguments = command + value;
      CAPTURE(arguments);
      const auto ran = run_program(arguments);
      CHECK(ran.exit == 2);
      CHECK(ran.out.empty());
      CHECK_MESSAGE(says(ran, std::string(c.option) + ": expected a whole number from " + c.range),
                    ran.err);
    }
  }
}

TEST_CASE("counts: 010 is ten (#13)") {
  const ScratchFolder scratch;
  CHECK(run_program("generate scaled-ball --points 010 -o " + scratch.file("a.xyz")).exit == 0);
  CHECK(run_program("generate scaled-ball --points 10 -o " + scratch.file("b.xyz")).exit == 0);
  const std::string ten = support::bytes_of(scratch.file("a.xyz"));
  CHECK(std::count(ten.begin(), ten.end(), '\n') == 10);
  CHECK(ten == support::bytes_of(scratch.file("b.xyz")));
  // The hull of a prism over a hexagon has eight facets: fewer than ten and as many as eight.
  const std::string prism = scratch.file("prism.off");
  REQUIRE(run_program("generate prism --k 006 --facets -o " + prism).exit == 0);
  CHECK(run_program("verify " + prism + " " + prism + " --max-facets 010").exit == 0);
  CHECK(
      run_program("verify " + prism + " " + prism + " --claims max-facets --max-facets 07").exit ==
      1);
  // The largest count there is, where it is in range.
  CHECK(run_program("verify " + prism + " " + prism +
                    " --max-facets 18446744073709551615 --seed "
                    "18446744073709551615")
            .exit == 0);
}

TEST_CASE("sizes: fractions are exact, anything else says what is expected (#13)" * sweep) {
  const ScratchFolder scratch;
  const std::string hull = "hull " + scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  for (const std::string size : {"1.5GB", "1.5gb", "1.5GiB", "1610612736", "1610612736B",
                                 "1572864K", "01.50G", "0", "16777215TB"}) {
    CAPTURE(size);
    CHECK(run_program(hull + " --max-memory " + size).exit == 0);
  }
  for (const std::string size :
       {"-1", "-1GB", "+1GB", "'1 GB'", "' 1GB'", "1.GB", ".5GB", "1e9", "1,5GB", "1.5.5GB", "GB",
        "1XB", "1Gi", "1BB", "0x10", "16777216TB", "99999999999999999999", "1/2GB"}) {
    CAPTURE(size);
    for (const std::string option : {"--max-memory", "--memory-limit"}) {
      const auto ran = run_program("stress " + option + "=" + size);
      CHECK(ran.exit == 2);
      CHECK_MESSAGE(says(ran, option + ": expected a size such as 512MB or 1.5GB"), ran.err);
    }
  }
  // 1.5 KB are 1536 bytes, no more and no less.
  const auto stopped = run_program(hull + " --max-memory 1.5KB");
  CHECK(stopped.exit == 6);
  CHECK(says(stopped, "--max-memory allows 1536 bytes"));
}

TEST_CASE("durations: more than 0, finite, decimal (#13)") {
  for (const std::string seconds : {"0", "-1", "nan", "inf", "1e7", "0x10", "' 1'", "1s"}) {
    CAPTURE(seconds);
    const auto ran = run_program("stress --time-limit=" + seconds);
    CHECK(ran.exit == 2);
    CHECK_MESSAGE(says(ran, "--time-limit: expected seconds, more than 0"), ran.err);
  }
}

TEST_CASE("generate: a negative exponent, and numbers that are none (#13)") {
  CHECK(run_program("generate scaled-ball --exponent -7 --points 3").exit == 0);
  CHECK(run_program("generate scaled-ball --exponent=-7.5").exit == 2);
  for (const std::string number : {"nan", "inf", "0x10", "' 1'", "one"}) {
    CAPTURE(number);
    const auto ran = run_program("generate needle --aspect=" + number);
    CHECK(ran.exit == 2);
    CHECK_MESSAGE(says(ran, "--aspect: expected a number"), ran.err);
  }
}

TEST_CASE("command line: an unknown option is named, also before -- (#13)") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("a.obj", "v 0 0 0\n");
  const std::string output = scratch.file("b.obj");
  for (const std::string& command :
       {"shrink " + input + " --frobnicate -o " + output + " -- cat {input}",
        "shrink " + input + " -o " + output + " --frobnicate=7 -- cat {input}",
        "shrink --frobnicate 7 " + input + " -o " + output + " -- cat {input} --json",
        std::string("conform --frobnicate -- cat {input} {faces} {output}"),
        "simplify " + input + " --frobnicate", std::string("stress --frobnicate"),
        std::string("--frobnicate hull ") + input}) {
    CAPTURE(command);
    const auto ran = run_program(command);
    CHECK(ran.exit == 2);
    CHECK(ran.out.empty());
    CHECK_MESSAGE(says(ran, "there is no option '--frobnicate'"), ran.err);
  }
  // What the program behind -- is called with is its own.
  CHECK(run_program("shrink " + input + " -o " + output + " -- false {input} --frobnicate").exit ==
        0);
}

TEST_CASE("command line: with --json wrong usage is one object, too (#13)") {
  for (const char* arguments :
       {"simplify --json", "stress --json --jobs 0", "verify --json --no"}) {
    CAPTURE(arguments);
    const auto ran = run_program(arguments);
    CHECK(ran.exit == 2);
    CHECK(nlohmann::json::parse(ran.out)["error"]["exit"] == 2);
  }
}

TEST_CASE("command line: a word that is no subcommand is named") {
  for (const char* arguments : {"frobnicate", "frobnicate --json", "frobnicate --faces 4"}) {
    CAPTURE(arguments);
    const auto ran = run_program(arguments);
    CHECK(ran.exit == 2);
    CHECK((ran.out + ran.err).find("there is no subcommand 'frobnicate'") != std::string::npos);
  }
}

TEST_CASE("command line: a help that cannot be printed is not a success") {
  for (const char* arguments : {"--help", "--version", "simplify --help"}) {
    CAPTURE(arguments);
    CHECK(run_program(arguments).exit == 0);
    CHECK(run_program(std::string(arguments) + " >/dev/full #").exit == 5);
  }
}

TEST_CASE("command line: a word out of a list is told with the list (#13)" * sweep) {
  const ScratchFolder scratch;
  const std::string input = scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  const std::vector<std::pair<std::string, std::string>> lists = {
      {"--decimal", "exact, nearest"},
      {"--precision", "32, 64"},
      {"--engine", "exact, filtered, float"},
      {"--verify", "full, local, none"}};
  for (const auto& choice : lists) {  // Clang 14 captures no bindings
    const std::string &option = choice.first, &list = choice.second;
    CAPTURE(option);
    // Neither the number of a word in the list nor an octal one stands for the word.
    for (const std::string word : {"0", "1", "064", "0x40", "near", "exactly"}) {
      CAPTURE(word);
      const auto ran = run_program("simplify " + input + " --faces 4 " + option + " " + word);
      CHECK(ran.exit == 2);
      CHECK(ran.err ==
            "convexact: " + option + ": expected one of " + list + ", found '" + word + "'\n");
    }
  }
  CHECK(run_program("simplify " + input + " --faces 4 --decimal EXACT --precision 64").exit == 0);
}
