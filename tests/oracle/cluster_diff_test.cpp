// SPDX-License-Identifier: MIT
// Engines of a decomposition compared: the exact and the filtered one agree; the float engine
// differs at ties, which are known by construction, and elsewhere not at all.
#include "diff/cluster_diff.hpp"

#include <doctest/doctest.h>

#include "expect_error.hpp"
#include "small_surfaces.hpp"

using namespace convexact;
using namespace support;

TEST_CASE("the exact and the filtered engine make the same merges; a float engine may break ties") {
  std::mt19937 random(17);
  std::size_t divergences = 0;
  for (int round = 0; round < 12; ++round) {
    // Cells of one size: many pairs of triangles are congruent, so their costs are equal.
    const Surface surface = make_surface(mesh_of_cells(random_cells(3, random)));
    const ClusterDiff diff =
        diff_clusters(surface, {}, {Engine::Exact, Engine::Filtered, Engine::Float});
    REQUIRE(diff.comparisons.size() == 2);
    CHECK_FALSE(diff.comparisons[0].divergence);
    CHECK(diff.holds());
    if (const auto& found = diff.comparisons[1].divergence) {
      ++divergences;
      CHECK(found->kind == MergeDifference::Tie);
      const Merge& exact = diff.runs[0].merges[found->step];
      CHECK(exact.kept == found->reference->kept);
      CHECK(exact.ties > 0);
    }
    const auto json = cluster_diff_json(diff);
    CHECK(json["runs"].size() == 3);
    CHECK(json["comparisons"][0]["divergence"].is_null());
    CHECK(cluster_diff_text(diff).find("the same merges") != std::string::npos);
  }
  MESSAGE(divergences << " of 12 float runs differ");
}

TEST_CASE("engines to compare are two or three, and different") {
  const Surface surface = make_surface(mesh_of_cells({{0, 0, 0}}));
  for (const auto& engines :
       std::vector<std::vector<Engine>>{{}, {Engine::Exact}, {Engine::Float, Engine::Float}}) {
    CHECK(error_of([&] { return diff_clusters(surface, {}, engines); }).code() ==
          ErrorCode::InvalidArgument);
  }
}
