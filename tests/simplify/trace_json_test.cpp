// SPDX-License-Identifier: MIT
// Traces as JSON: there and back, and against the schema that the documents promise.
#include "simplify/trace_json.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
#include "json_schema.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"

using namespace convexact;
using nlohmann::json;

namespace {

Run example() { return simplify_points(shapes::cut_cube(3, 0.25)); }

std::string complaint(const json& document) { return schema_complaint("trace", document); }

}  // namespace

TEST_CASE("trace_json: a trace comes back") {
  const Run trace = example();
  REQUIRE(trace.steps.size() == 3);
  const Run again = read_trace_json(write_trace_json(trace));
  CHECK(again.halfspaces == trace.halfspaces);
  REQUIRE(again.steps.size() == trace.steps.size());
  for (std::size_t s = 0; s < trace.steps.size(); ++s) {
    CHECK(again.steps[s].removed == trace.steps[s].removed);
    CHECK(again.steps[s].cost == trace.steps[s].cost);
    CHECK(again.steps[s].tie == trace.steps[s].tie);
    CHECK(again.steps[s].ring == trace.steps[s].ring);
    CHECK(again.steps[s].triangles == trace.steps[s].triangles);
    CHECK(again.steps[s].left == trace.steps[s].left);
  }
  for (const StopReason stop :
       {StopReason::Reached, StopReason::GrowthLimit, StopReason::AllUnbounded}) {
    CHECK(read_trace_json(write_trace_json({trace.halfspaces, trace.steps, stop})).stop == stop);
  }
}

TEST_CASE("trace_json: a trace that does not say why it ended has reached its end") {
  json document = json::parse(write_trace_json(example()));
  document.erase("stop");
  CHECK(complaint(document).empty());
  CHECK(read_trace_json(document.dump()).stop == StopReason::Reached);
  document["stop"] = "bored";
  CHECK_THROWS_AS((void)read_trace_json(document.dump()), Error);
  document["stop"] = 3;
  CHECK_THROWS_AS((void)read_trace_json(document.dump()), Error);
}

TEST_CASE("trace_json: the first step of three equal corners, written out") {
  const json document = json::parse(write_trace_json(example()));
  CHECK(document["halfspaces"].size() == 9);
  CHECK(document["halfspaces"][0][3].is_string());
  const json& step = document["steps"][0];
  CHECK(step["cost"]["exact"] == "1/384");  // (1/4)^3 / 6
  CHECK(step["cost"]["value"] == 1.0 / 384);
  CHECK(step["tie"].size() == 3);
  CHECK(step["tie"][0] == step["removed"]);
  CHECK(step["ring"].size() == 3);
  CHECK(step["left"] == 8);
}

TEST_CASE("trace_json: conforms to its schema, and a mutated document does not") {
  const json good = json::parse(write_trace_json(example()));
  CHECK(complaint(good).empty());
  const std::vector<std::function<void(json&)>> mutations = {
      [](json& d) { d.erase("steps"); },
      [](json& d) { d["extra"] = 1; },
      [](json& d) { d["stop"] = "bored"; },
      [](json& d) { d["halfspaces"][0][0] = 1; },
      [](json& d) { d["halfspaces"][0][0] = "01"; },
      [](json& d) { d["halfspaces"][0].push_back("1"); },
      [](json& d) { d["steps"][0].erase("left"); },
      [](json& d) { d["steps"][0]["removed"] = -1; },
      [](json& d) { d["steps"][0]["cost"] = 0.5; },
      [](json& d) { d["steps"][0]["cost"]["value"] = -1; },
      [](json& d) { d["steps"][0]["cost"]["exact"] = "0.5"; },
      [](json& d) { d["steps"][0]["tie"] = json::array(); },
      [](json& d) { d["steps"][0]["ring"].erase(0); },
      [](json& d) { d["steps"][0]["triangles"][0].push_back(0); }};
  for (std::size_t m = 0; m < mutations.size(); ++m) {
    CAPTURE(m);
    json bad = good;
    mutations[m](bad);
    CHECK_FALSE(complaint(bad).empty());
  }
}

TEST_CASE("trace_json: a cost beyond the largest double has no value") {
  std::vector<Point> points = shapes::lattice(20, 3, 1);
  for (Point& p : points) p *= 0x1p400;
  const json document = json::parse(write_trace_json(simplify_points(points)));
  REQUIRE_FALSE(document["steps"].empty());
  CHECK(document["steps"][0]["cost"]["value"].is_null());
  CHECK(complaint(document).empty());
}

TEST_CASE("trace_json: malformed text is refused with the place") {
  const json good = json::parse(write_trace_json(example()));
  const auto message = [](const std::string& text) {
    try {
      (void)read_trace_json(text);
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::Malformed);
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK(message("") == "line 1: expected JSON, found the end at byte 1");
  CHECK(message("{\n\n\"halfspaces\": [}") ==
        "line 3: expected JSON, found '\"halfspaces\": [}' at byte 19");
  CHECK(message("{}").find("halfspaces") != std::string::npos);
  CHECK(message("[1]").find("trace") == 0);
  CHECK(message(R"({"halfspaces": {"a": 1}, "steps": []})") == "trace: expected an array");
  const auto mutated = [&](const std::function<void(json&)>& mutate) {
    json bad = good;
    mutate(bad);
    return message(bad.dump());
  };
  CHECK(mutated([](json& d) { d["halfspaces"][2][1] = "1/2"; }) ==
        "halfspace 2: expected an integer as a string");
  CHECK(mutated([](json& d) {
          d["halfspaces"][2] = {"0", "0", "0", "1"};
        }) == "halfspace 2: expected a normal that is not zero");
  CHECK(mutated([](json& d) { d["steps"][1]["removed"] = 9; }) ==
        "step 2: expected the index of a halfspace, below 9");
  CHECK(mutated([](json& d) { d["steps"][1]["ring"][0] = -1; }).find("step 2") == 0);
  CHECK(mutated([](json& d) { d["steps"][1]["cost"]["exact"] = "abc"; }) != "accepted");
  CHECK(mutated([](json& d) {
          d["steps"][1]["triangles"][0] = {0, 1};
        }) == "step 2: expected triangles of three indices");
  CHECK(mutated([](json& d) { d["steps"][1]["left"] = 2.5; }).find("step 2") == 0);
}
