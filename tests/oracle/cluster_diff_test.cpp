// SPDX-License-Identifier: MIT
// Engines of a decomposition compared: the exact and the filtered one agree; the float engine
// differs at ties, which are known by construction, and elsewhere not at all.
#include "lab/diff/cluster_diff.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

#include "expect_error.hpp"
#include "small_surfaces.hpp"
#include "surface/flat_polygon.hpp"

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

namespace {

// Two rectangles of two triangles each: 1 x 2, and 1 x (2 + more), which is less round.
Surface two_rectangles(double more) {
  const double b = 2 + more;
  return make_surface(
      {PointSet(std::vector<Point>{
           {0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}, {4, 0, 0}, {5, 0, 0}, {5, b, 0}, {4, b, 0}}),
       {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}},
       {}});
}

MergeDifference kind_of(const Surface& surface, const ClusterOptions& options,
                        const Clustering& reference, const Clustering& other, Engine engine,
                        bool explained) {
  const ClusterComparison found =
      compare_runs(surface, options, {Engine::Exact, reference}, {engine, other});
  REQUIRE(found.divergence);
  CHECK(found.explained == explained);
  return found.divergence->kind;
}

}  // namespace

TEST_CASE("the judge of merges alone: ties, other counts, dearer pairs") {
  const Surface cube = make_surface(mesh_of_cells({{0, 0, 0}}));
  ClusterOptions options;
  options.engine = Engine::Exact;
  const Clustering reference = cluster(cube, options);
  REQUIRE(reference.merges[0].ties > 0);
  // The second merge is of two triangles like the first ones, so that it cost the same before.
  Clustering other = reference;
  std::swap(other.merges[0], other.merges[1]);
  CHECK(kind_of(cube, options, reference, other, Engine::Float, true) == MergeDifference::Tie);
  CHECK(kind_of(cube, options, reference, other, Engine::Filtered, false) == MergeDifference::Tie);
  // Another number of ties is a wrong record, but the float engine counts none.
  other = reference;
  ++other.merges[0].ties;
  CHECK(kind_of(cube, options, reference, other, Engine::Filtered, false) ==
        MergeDifference::WrongRecord);
  CHECK_FALSE(
      compare_runs(cube, options, {Engine::Exact, reference}, {Engine::Float, other}).divergence);
  // Two triangles over an edge of the cube are less round, and bent.
  const auto bent = [&](const std::pair<TriangleId, TriangleId>& pair) {
    return cube.face[pair.first.index()] != cube.face[pair.second.index()] &&
           area_vector(cube.points, cube.triangles[pair.first.index()])
                   .dot(area_vector(cube.points, cube.triangles[pair.second.index()])) == 0;
  };
  const auto pairs = neighbours(cube, Connect::Edge);
  const auto found = std::find_if(pairs.begin(), pairs.end(), bent);
  REQUIRE(found != pairs.end());
  other = reference;
  other.merges[0] = {.kept = found->first, .gone = found->second};
  CHECK(kind_of(cube, options, reference, other, Engine::Float, false) ==
        MergeDifference::WrongMerge);
}

TEST_CASE("the judge of merges alone: what rounding explains, and what it does not") {
  ClusterOptions options;
  options.engine = Engine::Exact;
  // perimeter^2 / area grows by a sixth of the share: 2^-29 or so of it, or 2^-19.
  for (const auto& [more, kind] : {std::pair(0x1p-26, MergeDifference::CostRounding),
                                   std::pair(0x1p-16, MergeDifference::WrongMerge)}) {
    const Surface rectangles = two_rectangles(more);
    const Clustering reference = cluster(rectangles, options);
    REQUIRE(reference.merges.size() == 2);
    Clustering other = reference;
    std::swap(other.merges[0], other.merges[1]);
    const bool explained = kind == MergeDifference::CostRounding;
    CHECK(kind_of(rectangles, options, reference, other, Engine::Float, explained) == kind);
    CHECK(kind_of(rectangles, options, reference, other, Engine::Filtered, false) == kind);
  }
  // The whole L is 1 below its hull: at a limit of 1, its last merge is allowed by nothing to
  // spare.
  const Surface l = make_surface(mesh_of_cells(l_cells()));
  for (const auto& [limit, kind] : {std::pair(Rational(1), MergeDifference::LimitRounding),
                                    std::pair(Rational(2), MergeDifference::WrongMerge)}) {
    options.limit = {limit, false};
    const Clustering reference = cluster(l, options);
    REQUIRE(reference.clusters.size() == 1);
    Clustering other = reference;
    other.merges.pop_back();
    const bool explained = kind == MergeDifference::LimitRounding;
    CHECK(kind_of(l, options, reference, other, Engine::Float, explained) == kind);
    CHECK(kind_of(l, options, other, reference, Engine::Float, explained) == kind);
  }
}

TEST_CASE("engines to compare are two or three, and different") {
  const Surface surface = make_surface(mesh_of_cells({{0, 0, 0}}));
  for (const auto& engines :
       std::vector<std::vector<Engine>>{{}, {Engine::Exact}, {Engine::Float, Engine::Float}}) {
    CHECK(error_of([&] { return diff_clusters(surface, {}, engines); }).code() ==
          ErrorCode::InvalidArgument);
  }
}
