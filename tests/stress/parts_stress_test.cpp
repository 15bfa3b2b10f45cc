// SPDX-License-Identifier: MIT
// Solids that are hard to take apart: what is promised of parts is kept on every family, and what
// ends otherwise is reported.
#include "lab/stress/parts_stress.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "json_schema.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

// The first and the last value; `convexact stress --parts` has all.
void check_family(const PartsFamily& family) {
  CAPTURE(family.name);
  for (const double value : {family.values.front(), family.values.back()}) {
    CAPTURE(value);
    const PartsStressRun run = cut_and_judge(family.make(value));
    CHECK(run.end == StressEnd::Reached);
    CHECK(run.faults == std::vector<std::string>{});
    // Beyond 1e14, rounding a corner moves it by more than is allowed, and the result says so.
    CHECK(run.is_within == (family.name != "far" || value < 1e14));
  }
}

bool is_quick(const PartsFamily& family) {
  return family.name == "keyholes" || family.name == "crossing";
}

}  // namespace

TEST_CASE("stress of parts: crossing shells, and keyholes") {
  for (const PartsFamily& family : parts_families()) {
    if (is_quick(family)) check_family(family);
  }
}

TEST_CASE("stress of parts: every family keeps what is promised" * sweep) {
  for (const PartsFamily& family : parts_families()) {
    if (!is_quick(family)) check_family(family);
  }
}

TEST_CASE("stress of parts: other ends are faults, and the rest goes on") {
  PartsFamily family{"broken", "", "kind", {0, 1, 2, 3}, [](double kind) -> Mesh {
                       if (kind == 0) throw Error(ErrorCode::Internal, "something broke");
                       if (kind == 1) std::abort();
                       Mesh mesh;
                       mesh.points = PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
                       if (kind == 2) mesh.polygons = {{0, 1, 2}};
                       return mesh;
                     }};
  const std::vector<PartsStressRun> runs = stress_parts({&family, 1}, {}, {.seconds = 20});
  REQUIRE(runs.size() == 4);
  CHECK(runs[0].end == StressEnd::Failed);
  CHECK(runs[0].why.find("something broke") != std::string::npos);
  CHECK(runs[1].end == StressEnd::Crashed);
  CHECK(runs[2].end == StressEnd::NoVolume);
  CHECK(runs[2].faults.empty());
  CHECK(runs[3].end == StressEnd::Failed);  // without a face
  for (const std::size_t k : {0, 1, 3}) CHECK(runs[k].faults.size() == 1);
  const std::string table = parts_stress_table(runs);
  CHECK(table.find("something broke") != std::string::npos);
  CHECK(schema_complaint("stress-parts",
                         nlohmann::json::parse(write_json(parts_stress_json(runs)))) == "");
}
