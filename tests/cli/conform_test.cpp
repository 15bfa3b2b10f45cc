// SPDX-License-Identifier: MIT
// convexact conform: our engines conform; a program that is wrong on purpose fails in each of the
// ways, which are told apart.
#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "json_schema.hpp"
#include "process.hpp"

using nlohmann::json;
using support::bytes_of;
using support::run_program;
using support::ScratchFolder;

namespace {

std::string vectors() {
  return std::string(" --vectors ") + std::getenv("CONVEXACT_VECTORS") + " ";
}

std::string ourselves() { return std::string("'") + std::getenv("CONVEXACT_PROGRAM") + "'"; }

// A mode of wrong_program.cpp, over some vectors: the JSON report, which fits the schema.
json conform_wrong(const std::string& mode, const std::string& options, int exit) {
  const auto ran = run_program("conform --json " + vectors() + options + " -- '" +
                               std::getenv("CONVEXACT_WRONG_PROGRAM") + "' " + mode +
                               " {input} {faces} {output}");
  CAPTURE(mode);
  CAPTURE(ran.err);
  CHECK(ran.exit == exit);
  const json report = json::parse(ran.out);
  CHECK(schema_complaint("conformance", report) == "");
  return report;
}

// The outcomes that occurred among vectors that ask to simplify, and among those that ask to
// refuse.
struct Outcomes {
  std::set<std::string> simplify, refuse;
};

Outcomes outcomes_of(const json& report) {
  Outcomes outcomes;
  for (const json& entry : report["vectors"]) {
    const std::string id = entry["id"].get<std::string>();
    const bool refuses = id.starts_with("flat-") || id.starts_with("malformed-");
    (refuses ? outcomes.refuse : outcomes.simplify).insert(entry["outcome"]);
  }
  return outcomes;
}

using Set = std::set<std::string>;

}  // namespace

TEST_CASE("conform: each engine of ours conforms, whatever it writes") {
  struct Case {
    const char* engine;
    const char* options;
  };
  // The exact engine takes seconds for a scan.
  for (const Case& c : {Case{"filtered", "--level 1"}, Case{"float", "--level 1"},
                        Case{"exact", "--level 2 --flag parallel-edges"}}) {
    for (const char* format : {"obj", "json"}) {
      CAPTURE(std::string(c.engine));
      CAPTURE(std::string(format));
      const auto ran =
          run_program(std::string("conform --json ") + c.options + vectors() + "--output-format " +
                      format + " -- " + ourselves() +
                      " simplify {input} --faces {faces} -o {output} --engine " + c.engine);
      CHECK(ran.exit == 0);
      const json report = json::parse(ran.out);
      CHECK(schema_complaint("conformance", report) == "");
      CHECK(report["conforms"] == true);
      CHECK(report["passed"] == report["total"]);
      CHECK(report["total"] > 30);
    }
  }
}

TEST_CASE("conform: halfspaces in, halfspaces out") {
  const auto ran =
      run_program("conform --json --input-format json --output-format ine" + vectors() + "-- " +
                  ourselves() + " simplify {input} --faces {faces} -o {output}");
  CHECK(ran.exit == 0);
  CHECK(json::parse(ran.out)["total"] >= 20);
}

TEST_CASE("conform: as tight as greedy where ties decide nothing") {
  const auto ran =
      run_program("conform --json --output-format json --level 1 --flag unbounded" + vectors() +
                  "-- " + ourselves() + " simplify {input} --faces {faces} -o {output}");
  const json report = json::parse(ran.out);
  std::size_t known = 0;
  for (const json& entry : report["vectors"]) {
    if (!entry.contains("tightness")) continue;
    ++known;
    CHECK(entry["tightness"].get<double>() == doctest::Approx(1));
  }
  CHECK(known > 5);
}

TEST_CASE("conform: every kind of failure is told apart") {
  struct Case {
    const char* mode;
    Set simplify, refuse;
  };
  const Case cases[] = {
      {"crash", {"crashed"}, {"crashed"}},
      {"exit", {"wrong-exit"}, {"passed"}},
      {"no-output", {"missing-output"}, {"accepted-unusable"}},
      {"empty-output", {"no-solid"}, {"accepted-unusable"}},
      {"noise", {"unreadable-output"}, {"accepted-unusable"}},
      {"nan", {"unreadable-output"}, {"accepted-unusable"}},
      {"cut-off", {"not-enclosing"}, {"passed"}},
      {"hole", {"broken-mesh"}, {"passed"}},
      {"inside-out", {"broken-mesh"}, {"passed"}},
  };
  for (const Case& c : cases) {
    CAPTURE(std::string(c.mode));
    const Outcomes solids = outcomes_of(conform_wrong(c.mode, "--level 1 --flag valence", 1));
    CHECK(solids.simplify == c.simplify);
    CHECK(solids.refuse.empty());
    const Outcomes flat = outcomes_of(
        conform_wrong(c.mode, "--level 1 --flag flat", c.refuse == Set{"passed"} ? 0 : 1));
    CHECK(flat.simplify.empty());
    CHECK(flat.refuse == c.refuse);
    const Outcomes outcomes = outcomes_of(
        conform_wrong(c.mode, "--level 1 --flag malformed", c.refuse == Set{"passed"} ? 0 : 1));
    CHECK(outcomes.simplify.empty());
    CHECK(outcomes.refuse == c.refuse);
  }
}

TEST_CASE("conform: the hull itself has too many facets") {
  const json report = conform_wrong("hull", "--level 1 --flag ties", 1);
  const Outcomes outcomes = outcomes_of(report);
  CHECK(outcomes.simplify.count("too-many-facets") == 1);
  for (const json& entry : report["vectors"]) {
    if (entry["id"] == "icosahedron-simplify") CHECK(entry["outcome"] == "too-many-facets");
    if (entry["id"] == "octahedron-simplify") CHECK(entry["outcome"] == "too-many-facets");
  }
}

TEST_CASE("conform: a program that hangs is killed, one that takes all memory is stopped") {
  const std::string few = "--level 1 --flag duplicates ";
  CHECK(outcomes_of(conform_wrong("hang", few + "--time-limit 0.1", 1)).simplify ==
        Set{"timed-out"});
  CHECK(outcomes_of(conform_wrong("memory", few + "--memory-limit 200MB", 1)).simplify ==
        Set{"out-of-memory"});
}

TEST_CASE("conform: flat points and malformed files must not be accepted") {
  const Outcomes flat = outcomes_of(conform_wrong("accept", "--level 1 --flag flat", 1));
  CHECK(flat.refuse == Set{"accepted-unusable"});
  const Outcomes malformed = outcomes_of(conform_wrong("accept", "--level 1 --flag malformed", 1));
  CHECK(malformed.refuse == Set{"accepted-unusable"});
}

TEST_CASE("conform: the reports agree with each other") {
  const ScratchFolder scratch;
  const std::string base = scratch.file("r");
  const auto ran =
      run_program("conform --level 1 --flag ties" + vectors() + "-o " + base + ".json -o " + base +
                  ".md -o " + base + ".svg -- '" + std::getenv("CONVEXACT_WRONG_PROGRAM") +
                  "' hull {input} {faces} {output}");
  CHECK(ran.exit == 1);
  const json report = json::parse(bytes_of(base + ".json"));
  CHECK(schema_complaint("conformance", report) == "");
  const std::string score = std::to_string(report["passed"].get<int>()) + "/" +
                            std::to_string(report["total"].get<int>());
  CHECK(report["flags"]["ties"]["all"]["passed"] == report["passed"]);
  std::map<std::string, int> outcomes;
  for (const json& entry : report["vectors"]) ++outcomes[entry["outcome"]];
  for (const auto& [name, count] : outcomes) CHECK(report["outcomes"][name] == count);
  const std::string markdown = bytes_of(base + ".md"), badge = bytes_of(base + ".svg");
  CHECK(ran.out.find(score) != std::string::npos);
  CHECK(markdown.find("| " + score + " |") != std::string::npos);
  CHECK(markdown.find("does not conform") != std::string::npos);
  CHECK(badge.starts_with("<svg "));
  CHECK(badge.find(">" + score + "<") != std::string::npos);
}

TEST_CASE("conform: the shipped vectors are found without being named") {
  const auto ran =
      run_program("conform --level 1 --flag subnormal -- false {input} {faces} {output}");
  CHECK(ran.exit == 2);  // found, but none is that easy
  CHECK(run_program("conform --level 1 --flag ties -- false {input} {faces} {output}").exit == 1);
}

TEST_CASE("conform: wrong usage") {
  const ScratchFolder scratch;
  for (const std::string arguments :
       {"conform", "conform -- false {input} {output}",
        "conform -- /no/such {input} {faces} {output}",
        "conform --level 4 -- false {input} {faces} {output}",
        "conform --time-limit 0 -- false {input} {faces} {output}",
        "conform --flag no-such-flag -- false {input} {faces} {output}",
        "conform -o report.txt -- false {input} {faces} {output}"}) {
    CAPTURE(arguments);
    CHECK(run_program(arguments).exit == 2);
  }
  CHECK(
      run_program("conform --vectors " + scratch.file("no") + " -- false {input} {faces} {output}")
          .exit == 3);
  const std::string broken = scratch.write("a.json", "{\"vectors\": [{\"id\": 3}]}");
  CHECK(run_program("conform --vectors " + scratch.file("") + " -- false {input} {faces} {output}")
            .exit == 3);
}
