// SPDX-License-Identifier: MIT
// --search on the command line: its report, its trace and the judgement of that, and what is
// refused.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "json_schema.hpp"
#include "process.hpp"
#include "program_json.hpp"
#include "sweep.hpp"

using nlohmann::json;
using support::bytes_of;
using support::data;
using support::program_json;
using support::run_program;
using support::ScratchFolder;

namespace {

json searched(const std::string& arguments) {
  return program_json("simplify " + arguments, "result");
}

std::string refused(const std::string& arguments) {
  const auto ran = run_program("simplify " + data("spot.obj") + " " + arguments);
  CHECK(ran.exit == 2);
  return ran.err;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string status_of(const json& verdict, const std::string& code) {
  for (const json& claim : verdict["claims"]) {
    if (claim["code"] == code) return claim["status"];
  }
  return "missing";
}

}  // namespace

TEST_CASE("--search: the report, by both engines the same" * sweep) {
  const std::string request = data("spot.obj") + " --faces 6 --search local --moves 40";
  const json filtered = searched(request), exact = searched(request + " --engine exact");
  const json& search = filtered["search"];
  CHECK(search["kind"] == "local");
  CHECK(search["kicks"] == 40);
  CHECK(search["accepted"] >= 1);
  CHECK(search["now"]["value"] < search["greedy"]["value"]);
  CHECK(search["now"]["decimal"] == filtered["volume"]["output"]["decimal"]);
  CHECK(search["best_move"]["after"]["value"] < search["best_move"]["before"]["value"]);
  CHECK(search == exact["search"]);
  CHECK(filtered["output"]["planes"] == exact["output"]["planes"]);
  const json greedy = searched(data("spot.obj") + " --faces 6");
  CHECK_FALSE(greedy.contains("search"));
  CHECK(greedy["volume"]["output"]["decimal"] == search["greedy"]["decimal"]);
  const auto text = run_program("simplify " + request);
  CHECK(contains(text.out, "walk and 40 kicks"));
  CHECK(contains(text.out, "of what the removals added"));
}

TEST_CASE("--search: its trace is judged move by move" * sweep) {
  const ScratchFolder scratch;
  for (const std::string cost : {"volume", "area", "mean-width"}) {
    CAPTURE(cost);
    const std::string path = scratch.file(cost + ".json");
    const json result = searched(data("spot.obj") + " --faces 6 --search local --moves 20 --cost " +
                                 cost + " --trace " + path);
    json trace = json::parse(bytes_of(path));
    CHECK(schema_complaint("trace", trace) == "");
    REQUIRE(trace["moves"].size() == result["search"]["accepted"]);
    const double last = trace["moves"].back()["measure"]["value"];
    CHECK(last == doctest::Approx(result["search"]["now"]["value"].get<double>()));
    const auto judged = [&](const json& order, int exit) {
      const std::string file = scratch.write("order.json", order.dump());
      return program_json("verify " + data("spot.obj") + " --trace " + file, "trace_verdict", exit);
    };
    CHECK(status_of(judged(trace, 0), "trace-moves") == "holds");
    const auto is_refuted = [&](const json& order) {
      return status_of(judged(order, 1), "trace-moves") == "violated";
    };
    json wrong = trace;  // the first move again: what it removes is gone
    wrong["moves"].push_back(trace["moves"][0]);
    CHECK(is_refuted(wrong));
    wrong = trace;  // back again: the measure rises
    wrong["moves"].push_back({{"removed", trace["moves"].back()["inserted"]},
                              {"inserted", trace["moves"].back()["removed"]}});
    CHECK(is_refuted(wrong));
    wrong = trace;  // another measure
    wrong["moves"][0]["measure"] = trace["steps"][0]["cost"];
    CHECK(is_refuted(wrong));
    wrong = trace;  // fewer go than come
    wrong["moves"][0]["removed"] = json::array();
    CHECK(is_refuted(wrong));
  }
}

TEST_CASE("--search: what it cannot be combined with, and what to do instead") {
  CHECK(contains(refused("--faces 6 --search walk --engine float"), "filtered"));
  CHECK(contains(refused("--max-growth 5% --search walk"), "number of faces"));
  CHECK(contains(refused("--faces 6 --search walk --proof p.txt"), "leave out"));
  CHECK(contains(refused("--inner --vertices 8 --search walk"), "--search"));
  CHECK(contains(refused(data("spot.obj") + " --total-faces 16 --search walk"), "--faces"));
  CHECK(contains(refused("--faces 6 --moves 3"), "--search local"));
  CHECK(contains(refused("--faces 6 --search walk --moves 3"), "--search local"));
  CHECK(contains(refused("--faces 6 --search best"), "local"));
  for (const std::string cost : {"area", "mean-width"}) {
    CHECK(contains(refused("--faces 6 --search optimal --cost " + cost), "only a volume"));
  }
  CHECK(contains(refused("--faces 6 --search local --nodes 3"), "--search optimal"));
  CHECK(contains(refused("--faces 6 --search optimal --nodes 0"), "--nodes"));
}

// The regular tetrahedron, as in tests/search/search_test.cpp.
TEST_CASE("--search optimal: a proof, its report, and its trace") {
  const ScratchFolder scratch;
  const std::string solid = scratch.file("icosahedron.obj"), trace = scratch.file("trace.json");
  REQUIRE(run_program("generate icosahedron -o " + solid).exit == 0);
  const std::string request = solid + " --faces 4 --search optimal --moves 0";
  const std::string proof = scratch.file("proof.txt");
  const json result = searched(request + " --exact-values --trace " + trace + " --proof " + proof);
  CHECK(result["proof"] == "optimal");
  CHECK(bytes_of(proof).starts_with("convexact-proof 5 optimal\n"));
  const json& search = result["search"];
  CHECK(search["kind"] == "optimal");
  CHECK(result["volume"]["ratio"].get<double>() == doctest::Approx(2.741640786));
  CHECK(search["optimum"]["proven"] == true);
  CHECK(search["optimum"]["gap"] == 0);
  CHECK(search["optimum"]["lower_bound"]["exact"] == result["volume"]["output"]["exact"]);
  const auto judged = run_program("verify " + solid + " --trace " + trace + " --json");
  CHECK(judged.exit == 0);
  CHECK(status_of(json::parse(judged.out), "trace-moves") == "holds");
  CHECK(contains(run_program("simplify " + request).out, "proven: no other facets"));
}

TEST_CASE("--search optimal: a limit of nodes is no failure, and no proof") {
  const std::string request = data("spot.obj") + " --faces 8 --search optimal --nodes 20";
  const json optimum = searched(request)["search"]["optimum"];
  CHECK(optimum["proven"] == false);
  CHECK(optimum["nodes"] <= 20);
  CHECK(optimum["node_limit"] == 20);
  CHECK(optimum["gap"] > 0);
  CHECK(optimum["gap"] < 1);
  CHECK(contains(run_program("simplify " + request).out, "not proven"));
}
