// SPDX-License-Identifier: MIT
// convexact verify --trace on the shipped meshes, from their hulls to the last removal.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "process.hpp"
#include "sweep.hpp"

using nlohmann::json;
using support::run_program;
using support::ScratchFolder;

TEST_CASE("verify --trace: our whole runs on the shipped meshes are greedy, every claim holds" *
          sweep) {
  const ScratchFolder scratch;
  for (const char* name : {"bunny", "spot", "teapot"}) {
    CAPTURE(name);
    const std::string input = std::string(std::getenv("CONVEXACT_TEST_DATA")) + "/" + name + ".obj";
    const std::string trace = scratch.file("steps.json");
    REQUIRE(run_program("simplify " + input + " --faces 4 --trace " + trace).exit == 0);
    const auto ran = run_program("verify " + input + " --json --trace " + trace);
    CHECK(ran.exit == 0);
    const json verdict = json::parse(ran.out);
    CHECK(verdict["rating"] == "greedy");
    CHECK(verdict["judged"].get<std::size_t>() > 100);
    CHECK(verdict["judged"] == json::parse(support::bytes_of(trace))["steps"].size());

    // The same run by ids in canonical order, the first two removals swapped unless they tie.
    std::string ids;
    std::vector<std::size_t> order;
    for (const json& step : verdict["steps"]) order.push_back(step["removed"]);
    std::swap(order[0], order[1]);
    for (const std::size_t id : order) ids += std::to_string(id) + "\n";
    const auto swapped =
        run_program("verify " + input + " --json --trace " + scratch.write("ids.txt", ids));
    const json other = json::parse(swapped.out);
    CHECK(other["judged"] == verdict["judged"]);
    const bool ties = verdict["steps"][0]["cost"]["exact"] == verdict["steps"][1]["cost"]["exact"];
    CHECK(other["verdict"] == (ties ? "greedy" : "not greedy from step 0"));
  }
}
