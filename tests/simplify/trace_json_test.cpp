// SPDX-License-Identifier: MIT
// Traces as JSON: there and back, and against the schema that the documents promise.
#include "wire/trace_json.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "convexact/number.hpp"
#include "json_schema.hpp"
#include "shapes/makers.hpp"
#include "simplify/run_names.hpp"
#include "simplify_points.hpp"

using namespace convexact;
using nlohmann::json;

namespace {

Run example() { return simplify_points(shapes::cut_cube(3, 0.25)); }

std::string complaint(const json& document) { return schema_complaint("trace", document); }

}  // namespace

TEST_CASE("trace_json: every part of a run stands in its trace") {
  const Run run = example();
  REQUIRE(run.steps.size() == 3);
  const json document = json::parse(write_trace_json(run));
  REQUIRE(document["halfspaces"].size() == run.halfspaces.size());
  for (std::size_t i = 0; i < run.halfspaces.size(); ++i) {
    const Halfspace& plane = run.halfspaces[i];
    const json& row = document["halfspaces"][i];
    for (int k = 0; k < 3; ++k) CHECK(row[k] == to_string(plane.normal()[k]));
    CHECK(row[3] == to_string(plane.offset()));
  }
  const auto ids = [](const auto& list) {
    json numbers = json::array();
    for (const HalfspaceId id : list) numbers.push_back(id.value);
    return numbers;
  };
  REQUIRE(document["steps"].size() == run.steps.size());
  for (std::size_t s = 0; s < run.steps.size(); ++s) {
    const Step& step = run.steps[s];
    const json& written = document["steps"][s];
    CHECK(written["removed"] == step.removed.value);
    CHECK(parse_rational(written["cost"]["exact"].get<std::string>()) == step.cost->rational());
    CHECK(written["tie"] == ids(step.tie));
    CHECK(written["ring"] == ids(step.ring));
    REQUIRE(written["triangles"].size() == step.triangles.size());
    for (std::size_t t = 0; t < step.triangles.size(); ++t) {
      CHECK(written["triangles"][t] == ids(step.triangles[t]));
    }
    CHECK(written["left"] == step.left);
  }
  for (const StopReason stop :
       {StopReason::Reached, StopReason::GrowthLimit, StopReason::AllUnbounded}) {
    Run ended = run;
    ended.stop = stop;
    const std::string text = write_trace_json(ended);
    CHECK(json::parse(text)["stop"] == name_of(stop));
    CHECK(complaint(json::parse(text)).empty());
  }
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

TEST_CASE("trace_json: areas and mean widths, with the terms of their sums") {
  for (const CostMeasure measure : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    const Run run = simplify_points(shapes::cut_cube(3, 0.25), {.cost = measure});
    const json document = json::parse(write_trace_json(run));
    CHECK(complaint(document) == "");
    CHECK(document["version"] == 2);
    CHECK(document["measure"] == name_of(measure));
    const json& step = document["steps"][0];
    CHECK(step["tie_proof"].is_string());
    CHECK_FALSE(step["cost"].contains("exact"));
    if (measure == CostMeasure::Area) {
      // (3 - sqrt 3) / 32: three right triangles of legs 1/4, less the cut.
      CHECK(step["cost"]["roots"] == json::array({{"3/32", "1"}, {"-1/32", "3"}}));
      CHECK(step["cost"]["decimal"] == "0.039623412263472585");
    } else {
      CHECK_FALSE(step["cost"]["edges"].empty());
      CHECK(step["cost"]["decimal"] == "0.013116830775607213");  // half of legs 1/2
    }
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
