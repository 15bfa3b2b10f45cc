// SPDX-License-Identifier: MIT
// convexact verify --trace: verdicts, exit codes, and what --json prints
// (docs/schema/trace_verdict.schema.json, validated by valijson).
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "json_schema.hpp"
#include "process.hpp"

using nlohmann::json;
using support::data;
using support::run_program;
using support::ScratchFolder;

namespace {

// [0, 4]^3 with two opposite corners of a side cut off at depths 3 and 2, of which the costs are
// depth^3 / 6: 9/2 and 4/3. Facet ids are positions here.
const char* const kCutCubeRows =
    "1 0 0 -4\n-1 0 0 0\n0 1 0 -4\n0 -1 0 0\n0 0 1 -4\n0 0 -1 0\n"
    "-1 -1 -1 3\n1 1 -1 -6\n";

struct JudgedOrder {
  int exit;
  json document;
};

// Judges the order with the input as its own facet list.
JudgedOrder judge_order(const std::string& order, const std::string& options = "--facets") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cut.txt", kCutCubeRows);
  const std::string list = options == "--facets" ? "--facets " + input : options;
  const auto ran = run_program("verify " + input + " --trace " + scratch.write("order", order) +
                               " " + list + " --json");
  const json document = json::parse(ran.out);
  CHECK(schema_complaint("trace_verdict", document) == "");
  return {ran.exit, document};
}

std::vector<std::string> violated(const json& document) {
  std::vector<std::string> codes;
  for (const json& claim : document["claims"]) {
    if (claim["status"] == "violated") codes.push_back(claim["code"]);
  }
  return codes;
}

using Codes = std::vector<std::string>;

}  // namespace

TEST_CASE("verify --trace: ids in a list of one's own, the cheapest first") {
  const JudgedOrder good = judge_order("7\n6\n");
  CHECK(good.exit == 0);
  CHECK(good.document["rating"] == "greedy");
  CHECK(good.document["steps"][0]["cost"]["exact"] == "4/3");
  CHECK(good.document["steps"][1]["minimum"]["exact"] == "9/2");
  CHECK(good.document["steps"][1]["regret"]["exact"] == "0");
}

TEST_CASE("verify --trace: too dear, and how much dearer may be allowed") {
  const JudgedOrder bad = judge_order("6\n7\n");
  CHECK(bad.exit == 1);
  CHECK(bad.document["verdict"] == "not greedy from step 0");
  CHECK(bad.document["worst"]["regret"]["exact"] == "19/8");  // 27/8 - 1
  CHECK(violated(bad.document) == Codes{"trace-greedy"});
  const ScratchFolder scratch;
  const std::string arguments = "verify " + scratch.write("cut.txt", kCutCubeRows) + " --facets " +
                                scratch.file("cut.txt") + " --trace " +
                                scratch.write("order", "6\n7\n");
  const auto allowed = run_program(arguments + " --max-regret 19/8");
  CHECK(allowed.exit == 0);
  CHECK(allowed.out.find("greedy up to regret 2.38 (step 0)") != std::string::npos);
  CHECK(run_program(arguments + " --max-regret 237.5%").exit == 0);
  CHECK(run_program(arguments + " --max-regret 2.374").exit == 1);
  CHECK(run_program(arguments + " --max-regret=-1").exit == 2);
  CHECK(run_program(arguments + " --max-regret much").exit == 2);
  const auto table = run_program(arguments);
  CHECK(table.out.find("not greedy from step 0") != std::string::npos);
  CHECK(table.out.find("2.38") != std::string::npos);  // the regret
}

TEST_CASE("verify --trace: what is wrong with the trace is a verdict, never a failure") {
  CHECK(violated(judge_order("").document) == Codes{"trace-readable"});
  CHECK(violated(judge_order("7\nnext\n").document) == Codes{"trace-readable"});
  CHECK(violated(judge_order("7\n8\n").document) == Codes{"trace-id-out-of-range"});
  CHECK(violated(judge_order("7\n7\n").document) == Codes{"trace-removed-twice"});
  CHECK(violated(judge_order("4\n").document) == Codes{"trace-bounded"});
  CHECK(violated(judge_order("1 1 -1 -6.000000001\n", "").document) ==
        Codes{"trace-plane-unknown"});
  CHECK(judge_order("\xff\xfe\0{", "").exit == 1);
  const JudgedOrder binary = judge_order(std::string(1000, '\0'));
  CHECK(binary.exit == 1);
  CHECK(binary.document["rating"] == "meaningless");
}

TEST_CASE("verify --trace: planes, exact or as doubles that are exact") {
  CHECK(judge_order("1 1 -1 -6\n-2 -2 -2 6\n", "").exit == 0);
  CHECK(judge_order("0.5 0.5 -0.5 -3.0\n", "").exit == 0);
}

TEST_CASE("verify --trace: a facet that is never removed is named once, and --left-out (#13)") {
  const JudgedOrder bad = judge_order("6\n");  // 9/2; 7 would cost 4/3
  CHECK(bad.exit == 1);
  CHECK(bad.document["verdict"] == "not greedy from step 0");
  CHECK(bad.document["left_out"].empty());
  REQUIRE(bad.document["notes"].size() == 1);
  const json note = bad.document["notes"][0];
  CHECK(note["code"] == "left-out");
  CHECK(note["facets"].size() == 1);
  CHECK(note["steps"] == 1);
  CHECK(note["verdict"] == "greedy");
  const std::string id = std::to_string(note["facets"][0].get<std::size_t>());
  const ScratchFolder scratch;
  const std::string arguments = "verify " + scratch.write("cut.txt", kCutCubeRows) + " --trace " +
                                scratch.write("order", "6\n") + " --facets " +
                                scratch.file("cut.txt");
  const auto text = run_program(arguments);
  CHECK(text.exit == 1);
  CHECK(text.out.find("  note                   facet " + id +
                      " is the cheapest in every step and never removed: was it left out on "
                      "purpose? Without it the order is greedy; --left-out " +
                      id + " makes that the verdict.\n") != std::string::npos);
  const auto good = run_program(arguments + " --json --left-out " + id);
  CHECK(good.exit == 0);
  const json document = json::parse(good.out);
  CHECK(schema_complaint("trace_verdict", document) == "");
  CHECK(document["verdict"] == "greedy without facet " + id);
  CHECK(document["left_out"] == json::array({note["facets"][0]}));
  CHECK(document["notes"].empty());
  CHECK(document["steps"][0]["minimum"]["exact"] == "9/2");
  // The facet that the order removes, one that does not exist, and no ids.
  const std::string removed =
      std::to_string(bad.document["steps"][0]["removed"].get<std::size_t>());
  for (const std::string& ids :
       {removed, std::string("8"), std::string("x"), std::string("-1"), id + ",", std::string("''"),
        std::string("99999999999999999999")}) {
    CAPTURE(ids);
    CHECK(run_program(arguments + " --left-out=" + ids).exit == 2);
  }
  CHECK(run_program("verify " + scratch.file("cut.txt") + " " + scratch.file("cut.txt") +
                    " --left-out 1")
            .exit == 2);
}

TEST_CASE(
    "verify --trace: a facet list in doubles is matched, and blamed where it is wrong (#13)") {
  const ScratchFolder scratch;
  const std::string third = "0.57735026918962573",
                    two = "3.464101615137755";  // 1/sqrt 3; 6/sqrt 3 and an ulp
  const std::string list = "1 0 0 -4\n" + third + " " + third + " -" + third + " -" + two + "\n";
  const JudgedOrder good = judge_order("1\n", "--facets " + scratch.write("list.txt", list));
  CHECK(good.exit == 0);
  REQUIRE(good.document["notes"].size() == 1);
  CHECK(good.document["notes"][0]["code"] == "facet-list");
  CHECK(good.document["notes"][0]["rounded"] == 1);
  const std::string off = "1 0 0 -4\n1 1 -1 -6.000001\n";
  const JudgedOrder bad = judge_order("1\n", "--facets " + scratch.write("off.txt", off));
  CHECK(bad.exit == 1);
  CHECK(violated(bad.document) == Codes{"trace-plane-unknown"});
  for (const json& claim : bad.document["claims"]) {
    if (claim["code"] != "trace-plane-unknown") continue;
    const std::string found = claim["witness"]["found"], expected = claim["witness"]["expected"];
    CHECK(found.find("the id '1', in the facet list the plane") == 0);
    CHECK(expected.find("the nearest, of facet") != std::string::npos);
    CHECK(expected.find("5.77e-7 off it") != std::string::npos);  // 1e-6 / sqrt(3)
  }
}

TEST_CASE("verify --trace: our traces of the shipped cow hold; one with a wrong claim does not") {
  const ScratchFolder scratch;
  const std::string trace = scratch.file("steps.json");
  REQUIRE(run_program("simplify " + data("spot.obj") + " --faces 500 --trace " + trace).exit == 0);
  const std::string arguments = "verify " + data("spot.obj") + " --json --trace ";
  const auto good = run_program(arguments + trace);
  CHECK(good.exit == 0);
  json document = json::parse(good.out);
  CHECK(schema_complaint("trace_verdict", document) == "");
  CHECK(document["rating"] == "greedy");
  CHECK(document["notes"].empty());
  document["rating"] = "fine";
  CHECK(schema_complaint("trace_verdict", document) != "");

  json steps = json::parse(support::bytes_of(trace));
  steps["steps"][20]["cost"]["exact"] = "1/3";
  const auto bad = run_program(arguments + scratch.write("bad.json", steps.dump()));
  CHECK(bad.exit == 1);
  CHECK(violated(json::parse(bad.out)) == Codes{"trace-cost"});
}

TEST_CASE("verify --trace: files that are not there, inputs without interior, wrong usage") {
  const ScratchFolder scratch;
  const std::string cut = scratch.write("cut.txt", kCutCubeRows);
  const std::string order = scratch.write("order", "7\n");
  CHECK(run_program("verify " + cut + " --trace " + scratch.file("none")).exit == 3);
  CHECK(run_program("verify " + cut + " --trace " + order + " --facets " + scratch.file("none"))
            .exit == 3);
  CHECK(run_program("verify " + scratch.file("none.obj") + " --trace " + order).exit == 3);
  CHECK(run_program("verify " + scratch.write("bad.obj", "v 0 0\n") + " --trace " + order).exit ==
        3);
  const auto flat = run_program("verify --json " + scratch.write("flat.obj", "v 0 0 0\nv 1 0 0\n") +
                                " --trace " + order);
  CHECK(flat.exit == 4);
  CHECK(schema_complaint("trace_verdict", json::parse(flat.out)) == "");
  CHECK(run_program("verify " + cut + " --trace " + scratch.write("planes", "1 1 -1 -6\n") +
                    " --facets " + cut)
            .exit == 2);
  // A facet list that cannot be read is the other program's content too.
  CHECK(run_program("verify " + cut + " --trace " + order + " --facets " +
                    scratch.write("list.json", "[[1]]"))
            .exit == 1);
}

// The cuts cost (3 - sqrt 3) depth^2 / 2 of area, depths 3 and 2, and a multiple of the depth of
// mean width.
TEST_CASE("verify --trace --cost: planes and ids are judged by the measure that is named") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cut.txt", kCutCubeRows);
  const std::string good = scratch.write("good", "1 1 -1 -6\n-1 -1 -1 3\n");
  const std::string bad = scratch.write("bad", "-1 -1 -1 3\n1 1 -1 -6\n");
  for (const bool is_area : {true, false}) {
    const std::string cost = is_area ? "area" : "mean-width";
    const std::string words = is_area ? "area" : "mean width", regret = is_area ? "5/4" : "1/2";
    CAPTURE(cost);
    const std::string options = std::string(" --cost ") + cost;
    const auto right = run_program("verify " + input + " --trace " + good + options + " --json");
    CHECK(right.exit == 0);
    const json verdict = json::parse(right.out);
    CHECK(schema_complaint("trace_verdict", verdict) == "");
    CHECK(verdict["verdict"] == std::string("greedy by ") + words);
    CHECK(verdict["measure"] == cost);
    CHECK(verdict["undecided"] == 0);
    const auto wrong = run_program("verify " + input + " --trace " + bad + options + " --json");
    CHECK(wrong.exit == 1);
    CHECK(schema_complaint("trace_verdict", json::parse(wrong.out)) == "");
    CHECK(violated(json::parse(wrong.out)) == Codes{"trace-greedy"});
    CHECK(run_program("verify " + input + " --trace " + bad + options + " --max-regret " + regret)
              .exit == 0);
    CHECK(run_program("verify " + input + " --trace " + bad + options +
                      " --max-regret 0.499999999999")
              .exit == 1);
    const auto table = run_program("verify " + input + " --trace " + good + options);
    CHECK(table.out.find(std::string(words) + " added") != std::string::npos);
  }
  const json area =
      json::parse(run_program("verify " + input + " --trace " + good + " --cost area --json").out);
  // 4 (3 - sqrt 3) / 2
  CHECK(area["steps"][0]["cost"]["roots"] == json::parse(R"([["6", "1"], ["-2", "3"]])"));
}

TEST_CASE("verify --trace --cost: a trace names its measure, and another one is wrong usage") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cut.txt", kCutCubeRows);
  for (const std::string cost : {"volume", "area", "mean-width"}) {
    const std::string trace = scratch.file(cost + ".json");
    REQUIRE(run_program("simplify " + input + " --faces 6 --cost " + cost + " --trace " + trace +
                        " -o " + scratch.file(cost + ".obj"))
                .exit == 0);
    for (const std::string other : {"volume", "area", "mean-width"}) {
      const auto ran = run_program("verify " + input + " --trace " + trace + " --cost " + other);
      CHECK(ran.exit == (cost == other ? 0 : 2));
      if (cost != other) CHECK(ran.err.find("the trace is by " + cost) != std::string::npos);
    }
    CHECK(run_program("verify " + input + " --trace " + trace).exit == 0);
  }
  const std::string order = scratch.write("order", "6\n");
  CHECK(run_program("verify " + input + " --trace " + order + " --cost weight").exit == 2);
  CHECK(run_program("verify " + input + " --trace " + order + " --tie-bits 1").exit == 2);
  CHECK(run_program("verify " + input + " " + input + " --cost area").exit == 2);
}
