// SPDX-License-Identifier: MIT
// The exact and the filtered engine agree on every shipped mesh, costs and ties included; the float
// engine differs from them in ties and by less than rounding.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "process.hpp"
#include "sweep.hpp"

using nlohmann::json;

TEST_CASE("diff: the engines agree on every shipped mesh at 18 faces" * sweep) {
  const std::string data = std::getenv("CONVEXACT_TEST_DATA");
  const auto ran = support::run_program("diff --json --engines exact,filtered --faces 18 " + data +
                                        "/spot.obj " + data + "/teapot.obj " + data + "/bunny.obj");
  CHECK(ran.exit == 0);
  const json document = json::parse(ran.out);
  REQUIRE(document["objects"].size() == 3);
  for (const json& object : document["objects"]) {
    CAPTURE(object["name"].get<std::string>());
    CHECK(object["comparisons"][0]["other"] == "filtered");
    CHECK(object["comparisons"][0]["same"] == true);
    CHECK(object["engines"][0]["steps"] == object["halfspaces"].get<int>() - 18);
  }
}

TEST_CASE("diff: every step of the float engine is explained on every shipped mesh at 4 faces" *
          sweep) {
  const std::string data = std::getenv("CONVEXACT_TEST_DATA");
  const auto ran = support::run_program("diff --json --engines filtered,float --faces 4 " + data +
                                        "/spot.obj " + data + "/teapot.obj " + data + "/bunny.obj");
  CHECK(ran.exit == 0);
  const json document = json::parse(ran.out);
  REQUIRE(document["objects"].size() == 3);
  for (const json& object : document["objects"]) {
    CAPTURE(object["name"].get<std::string>());
    const json& comparison = object["comparisons"][0];
    CHECK(comparison["explained"] == true);
    CHECK(comparison["judged"] == object["halfspaces"].get<int>() - 4);
    for (const json& found : comparison["divergences"]) {
      CHECK((found["class"] == "tie" || found["class"] == "gap-below-rounding"));
    }
  }
  // A scan has no ties: there the runs are the same to the end.
  CHECK(document["objects"][2]["comparisons"][0]["same"] == true);
}
