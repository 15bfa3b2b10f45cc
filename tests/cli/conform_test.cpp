// SPDX-License-Identifier: MIT
// convexact conform: our engines conform; a program that is wrong on purpose fails in each of the
// ways, and the outcomes distinguish them.
#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "json_schema.hpp"
#include "process.hpp"
#include "program_json.hpp"
#include "sweep.hpp"

using nlohmann::json;
using support::bytes_of;
using support::program_json;
using support::run_program;
using support::ScratchFolder;

namespace {

std::string vectors() {
  return std::string(" --vectors ") + std::getenv("CONVEXACT_VECTORS") + " ";
}

std::string ourselves() { return std::string("'") + std::getenv("CONVEXACT_PROGRAM") + "'"; }

// A mode of wrong_program.cpp, over some vectors: the JSON report, which fits the schema.
json conform_wrong(const std::string& mode, const std::string& options, int exit) {
  return program_json("conform " + vectors() + options + " -- '" +
                          std::getenv("CONVEXACT_WRONG_PROGRAM") + "' " + mode +
                          " {input} {faces} {output}",
                      "conformance", exit);
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

TEST_CASE("conform: each engine of ours conforms, whatever it writes" * sweep) {
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
    CHECK(std::stod(entry["tightness"].get<std::string>()) == doctest::Approx(1));
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
      {"half", {"not-enclosing"}, {"passed"}},
      {"hole", {"broken-mesh"}, {"passed"}},
      {"inside-out", {"broken-mesh"}, {"passed"}},
  };
  for (const Case& c : cases) {
    CAPTURE(std::string(c.mode));
    const Outcomes solids = outcomes_of(conform_wrong(c.mode, "--level 1 --flag valence", 1));
    CHECK(solids.simplify == c.simplify);
    CHECK(solids.refuse.empty());
    // Of refusals alone, even those that it passes, nothing follows.
    const Outcomes flat = outcomes_of(conform_wrong(c.mode, "--level 1 --flag flat", 1));
    CHECK(flat.simplify.empty());
    CHECK(flat.refuse == c.refuse);
    const Outcomes outcomes = outcomes_of(conform_wrong(c.mode, "--level 1 --flag malformed", 1));
    CHECK(outcomes.simplify.empty());
    CHECK(outcomes.refuse == c.refuse);
  }
}

TEST_CASE("conform: a leak by a rounding is the last of the failures, and told apart (#13)") {
  const json report = conform_wrong("cut-off", "--level 1 --flag valence", 1);
  for (const json& entry : report["vectors"]) {
    CAPTURE(entry.dump());
    const json& last = entry["failures"].back();
    CHECK(last["outcome"] == "not-enclosing");
    CHECK(last["rounding"] == true);
    CHECK(entry["excess"]["points"] > 0);
  }
}

TEST_CASE("conform: nonsense that holds the points does not conform (#13)") {
  for (const auto& [mode, outcome] :
       {std::pair("inner-faces", "not-convex"), std::pair("huge", "too-loose")}) {
    const json report = conform_wrong(mode, "--level 1 --flag valence", 1);
    CHECK(outcomes_of(report).simplify == Set{outcome});
    CHECK(report["conforms"] == false);
  }
}

TEST_CASE("conform: a program that reads points only need not refuse malformed faces (#13)") {
  const json report = conform_wrong("points-only", "--level 1 --flag malformed", 1);
  for (const json& entry : report["vectors"]) {
    const std::string id = entry["id"];
    if (id.starts_with("malformed-obj-index")) CHECK(entry["outcome"] == "passed");
    if (id == "malformed-obj-two-coordinates") CHECK(entry["outcome"] == "accepted-unusable");
  }
}

TEST_CASE("conform: an empty output is no solid in every format (#13)") {
  for (const char* format : {"obj", "off", "ply", "stl", "json", "ine", "txt"}) {
    CAPTURE(std::string(format));
    const json report = conform_wrong(
        "empty-output", "--level 1 --flag valence --output-format " + std::string(format), 1);
    CHECK(outcomes_of(report).simplify == Set{"no-solid"});
  }
}

TEST_CASE("conform: the report is the same for any number of jobs (#13)") {
  const auto report_of = [](const char* jobs) {
    json report = conform_wrong("hull", "--level 1 --flag ties --jobs " + std::string(jobs), 1);
    for (json& entry : report["vectors"]) entry.erase("seconds");
    return report;
  };
  CHECK(report_of("1") == report_of("3"));
}

TEST_CASE("conform: hulls are asked of programs that are no simplifiers (#13)" * sweep) {
  const std::string program = std::string("'") + std::getenv("CONVEXACT_WRONG_PROGRAM") + "' ";
  const std::string hull = program + "hull {input} 0 {output}";
  const auto run = [&](const std::string& options, const std::string& words) {
    const auto ran =
        run_program("conform --json --jobs 2 --level 1 " + options + vectors() + "-- " + words);
    const json report = json::parse(ran.out);
    CHECK(schema_complaint("conformance", report) == "");
    CHECK(ran.exit == (report["conforms"].get<bool>() ? 0 : 1));
    return report;
  };
  for (const char* options : {"--asks hull", "--asks inner --flag ties", "--flag ties"}) {
    CAPTURE(std::string(options));
    const json report = run(options, hull);
    CHECK(report["conforms"] == true);
    CHECK(report["total"] > 25);
  }
  CHECK(run("--flag duplicates", hull)["promise"]["asks"] == "enclosure");
  CHECK(run("--asks hull --flag valence", program + "huge {input} 0 {output}")["passed"] == 0);
  CHECK(run("--asks hull --flag valence", program + "cut-off {input} 0 {output}")["passed"] == 0);
  CHECK(run("--asks inner --flag valence", program + "cut-off {input} 0 {output}")["conforms"] ==
        true);
}

TEST_CASE("conform: nine digits are the binary32 number that was meant (#13)") {
  const std::string words = std::string("-- '") + std::getenv("CONVEXACT_WRONG_PROGRAM") +
                            "' nine-digits {input} 0 {output}";
  const std::string base = "conform --json --level 1 --flag ties --asks hull" + vectors();
  const json as_float = json::parse(run_program(base + "--numbers binary32 " + words).out);
  CHECK(as_float["conforms"] == true);
  CHECK(as_float["promise"]["numbers"] == "binary32");
  CHECK(run_program(base + words).exit == 1);  // read as doubles, they are others
}

TEST_CASE("conform: the shipped profiles fit their schema (#13)") {
  const std::string path =
      std::string(std::getenv("CONVEXACT_VECTORS")) + "/../../share/convexact/profiles.json";
  CHECK(schema_complaint("profiles", json::parse(bytes_of(path))) == "");
}

TEST_CASE("conform: profiles, overridden by options, and named if unknown (#13)") {
  const std::string words =
      std::string("-- '") + std::getenv("CONVEXACT_WRONG_PROGRAM") + "' hull {input} 0 {output}";
  const auto promise_of = [&](const std::string& options) {
    const auto ran =
        run_program("conform --json --level 1 --flag duplicates " + options + vectors() + words);
    CHECK(ran.exit == 0);
    return json::parse(ran.out)["promise"];
  };
  const json jolt = promise_of("--profile jolt");
  CHECK(jolt["profile"] == "jolt");
  CHECK(jolt["asks"] == "hull");
  CHECK(jolt["numbers"] == "binary32");
  CHECK(jolt["allow_flat"] == true);
  CHECK(jolt["max_vertices"] == 256);
  // Godot hands its shapes to Jolt, in floats, with Jolt's default tolerance.
  const json godot = promise_of("--profile godot");
  for (const char* key : {"numbers", "tolerance", "max_vertices"}) CHECK(godot[key] == jolt[key]);
  const json mine = promise_of("--profile jolt --numbers binary64 --tolerance 0 --max-vertices 99");
  CHECK(mine["numbers"] == "binary64");
  CHECK(mine["tolerance"] == "0");
  CHECK(mine["max_vertices"] == 99);
  const auto unknown = run_program("conform --profile jolly" + vectors() + words);
  CHECK(unknown.exit == 2);
  CHECK(unknown.err.find("bullet, godot, jacobson, jolt, manifold, mujoco, physx") !=
        std::string::npos);
}

TEST_CASE("verify: a profile stands for numbers, tolerance and caps (#13)") {
  const ScratchFolder scratch;
  const auto box = [&](const std::string& name, const std::string& height) {
    std::string text;
    for (const char* z : {"-1", height.c_str()}) {
      for (const char* xy : {"-1 -1", "1 -1", "-1 1", "1 1"}) {
        text += std::string("v ") + xy + " " + z + "\n";
      }
    }
    return scratch.write(
        name, text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  };
  const std::string files = "verify " + box("in.obj", "1") + " " + box("out.obj", "0.9995") + " ";
  CHECK(run_program(files).exit == 1);
  CHECK(run_program(files + "--profile jolt").exit == 0);
  CHECK(run_program(files + "--profile jolt --tolerance 0").exit == 1);
  CHECK(run_program(files + "--profile jolt --max-vertices 7").exit == 1);
  CHECK(run_program(files + "--profile jolt --decimal exact").exit == 2);
  CHECK(run_program(files + "--profile jolt --numbers binary64 --decimal exact").exit == 0);
  CHECK(run_program(files + "--profile vhacd").exit == 2);
  const auto unknown = run_program(files + "--profile jolly");
  CHECK(unknown.exit == 2);
  CHECK(unknown.err.find("jolt, manifold") != std::string::npos);
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
  CHECK(ran.out.find("times (") != std::string::npos);  // the vector of the largest volume
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

TEST_CASE("conform: what is left without the vectors of a flag" * sweep) {
  const json all = conform_wrong("cut-off", "--level 1", 1);
  const json left = conform_wrong("cut-off", "--level 1 --skip-flag ties --skip-flag valence", 1);
  std::size_t expected = 0;
  for (const json& entry : all["vectors"]) {
    const auto flags = entry["flags"].get<Set>();
    expected += flags.contains("ties") || flags.contains("valence") ? 0 : 1;
  }
  CHECK(left["total"] == expected);
  CHECK(expected < all["total"].get<std::size_t>());
}

TEST_CASE("conform: a failure is kept, and its command makes a minimal input") {
  const ScratchFolder scratch;
  const std::string kept = scratch.file("failing");
  const std::string program = std::string(" -- '") + std::getenv("CONVEXACT_WRONG_PROGRAM") +
                              "' cut-off {input} {faces} {output}";
  const std::string base = "conform --level 1 --flag ties" + vectors() + "--keep-failing " + kept;
  const auto ran = run_program(base + program);
  CHECK(ran.exit == 1);
  CHECK(ran.out.find("Kept: " + kept) != std::string::npos);
  const std::string place = kept + "/icosahedron-simplify/";
  const json verdict = json::parse(bytes_of(place + "verdict.json"));
  CHECK(verdict["outcome"] == "too-many-facets");
  CHECK(bytes_of(place + "input.obj").find("v ") == 0);
  CHECK(bytes_of(place + "output.obj").find("v ") == 0);
  const auto shrunk = support::run_shell("sh " + place + "shrink.sh");
  REQUIRE_MESSAGE(shrunk.exit == 0, shrunk.err);
  CHECK(shrunk.out.find("failure     violates max-facets") != std::string::npos);
  // Fewer than the twelve points of the icosahedron.
  const std::string minimal = bytes_of(place + "minimal.obj");
  CHECK(std::count(minimal.begin(), minimal.end(), 'v') < 12);
  const auto again = run_program(base + program);
  CHECK(again.exit == 2);
  CHECK(again.err.find("not empty") != std::string::npos);
}

TEST_CASE("conform: known failures may fail, others not, and those that pass are named") {
  const ScratchFolder scratch;
  const std::string program = std::string(" -- '") + std::getenv("CONVEXACT_WRONG_PROGRAM") +
                              "' cut-off {input} {faces} {output}";
  const std::string base = "conform --level 1 --flag ties" + vectors(),
                    list = scratch.file("known.txt");
  CHECK(run_program(base + "-o " + list + program).exit == 1);
  const std::string ids = bytes_of(list);
  const auto known = run_program(base + "--json --known-failures " + list + program);
  CHECK(known.exit == 0);
  const json report = json::parse(known.out);
  CHECK(schema_complaint("conformance", report) == "");
  CHECK(report["conforms"] == true);
  CHECK(report["known_failures"]["failed"].size() == report["total"]);
  CHECK(report["known_failures"]["passed"].empty());

  // One that is not in the list; the others with a comment.
  const std::size_t end = ids.find('\n');
  const std::string fewer =
      scratch.write("fewer.txt", "# all but " + ids.substr(0, end) + "\n" + ids.substr(end + 1));
  const auto other = run_program(base + "--known-failures " + fewer + program);
  CHECK(other.exit == 1);
  CHECK(other.out.find("not in the list of known failures") != std::string::npos);

  // A program that is right passes them.
  const auto right = run_program(base + "--known-failures " + list + " -- " + ourselves() +
                                 " simplify {input} --faces {faces} -o {output}");
  CHECK(right.exit == 0);
  CHECK(right.out.find(" pass now and can leave the list: ") != std::string::npos);

  const std::string wrong = scratch.write("wrong.txt", "\nicosahedron-simplfy\n");
  const auto refused = run_program(base + "--known-failures " + wrong + program);
  CHECK(refused.exit == 2);
  CHECK(refused.err.find("line 2: there is no vector 'icosahedron-simplfy'; did you mean "
                         "'icosahedron-simplify'?") != std::string::npos);
}

TEST_CASE("conform: JUnit, and the last line that a program printed") {
  const ScratchFolder scratch;
  const std::string script = scratch.write(
      "program", "#!/bin/sh\necho starting\necho 'Error: <no module> & no \"path\"' >&2\nexit 1\n");
  const std::string xml = scratch.file("result.xml"), list = scratch.file("known.txt");
  const std::string program = " -- sh " + script + " {input} {faces} {output}";
  const std::string base = "conform --level 1 --flag ties" + vectors() + "-o " + xml;
  const auto ran = run_program(base + " -o " + list + program);
  CHECK(ran.exit == 1);
  const std::string line = "it printed: Error: <no module> & no \"path\"";
  const std::size_t first = ran.out.find(line);
  REQUIRE(first != std::string::npos);
  CHECK(ran.out.find(line, first + 1) == std::string::npos);  // once for each kind
  const std::string text = bytes_of(xml);
  const auto count = [&text](const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
  };
  CHECK(text.find("<?xml version=\"1.0\"") == 0);
  CHECK(count("<testcase ") == 29);
  CHECK(count("<failure type=\"wrong-exit\"") == 29);
  CHECK(count("failures=\"29\" errors=\"0\" skipped=\"0\"") == 1);
  CHECK(count("Error: &lt;no module&gt; &amp; no &quot;path&quot;") == 29);
  CHECK(run_program(base + " --known-failures " + list + program).exit == 0);
  const std::string known = bytes_of(xml);
  CHECK(known.find("failures=\"0\" errors=\"0\" skipped=\"29\"") != std::string::npos);
  CHECK(known.find("<skipped message=\"known failure: ") != std::string::npos);
}

TEST_CASE("conform: wrong usage") {
  const ScratchFolder scratch;
  for (const std::string arguments :
       {"conform", "conform --asks simplify -- false {input} {output}",
        "conform --asks nothing -- false {input} {output}",
        "conform --numbers binary16 -- false {input} {output}", "conform -- false {input} {faces}",
        "conform --jobs 0 -- false {input} {faces} {output}",
        "conform -- /no/such {input} {faces} {output}",
        "conform --level 4 -- false {input} {faces} {output}",
        "conform --time-limit 0 -- false {input} {faces} {output}",
        "conform --flag no-such-flag -- false {input} {faces} {output}",
        "conform --flag tise -- false {input} {faces} {output}",
        "conform --skip-flag tise -- false {input} {faces} {output}",
        "conform -o report.csv -- false {input} {faces} {output}"}) {
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

TEST_CASE("conform: an output that cannot be read is called {output}, not a file that is gone") {
  const auto ran =
      run_program("conform --level 1 --flag malformed --asks hull -- cp {input} {output}");
  CHECK(ran.exit == 1);
  CHECK(ran.out.find("candidate-readable: {output}:5: expected") != std::string::npos);
  CHECK(ran.out.find("output.obj") == std::string::npos);
}
