// SPDX-License-Identifier: MIT
// The least volume: against every choice by the definition, known ends, and limits.
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <string>

#include "convexact/measure.hpp"
#include "convexact/search.hpp"
#include "convexact/simplify.hpp"
#include "expect_error.hpp"
#include "least_volume.hpp"
#include "searched.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

SearchOptions optimal(Engine engine = Engine::Filtered, std::size_t kicks = 3) {
  return {.request = {SearchKind::Optimal, kicks}, .engine = engine};
}

}  // namespace

TEST_CASE("optimal: no choice of the definition is smaller, in both engines") {
  std::size_t choices = 0, improved = 0;
  // In the last two, weights that are twice too high cut the least choice off.
  const std::vector<std::vector<Point>> list = {shapes::octahedron(),   shapes::cut_cube(3, 0.25),
                                                shapes::antiprism(4),   shapes::bipyramid(5),
                                                shapes::in_ball(7, 1),  shapes::lattice(9, 4, 2),
                                                shapes::in_ball(8, 18), shapes::lattice(10, 4, 14)};
  for (const std::vector<Point>& points : list) {
    const std::size_t most = Greedy(points, 4, CostMeasure::Volume).dual.halfspaces.size();
    CAPTURE(most);
    REQUIRE(most <= 12);
    for (std::size_t faces = 4; faces < most; ++faces) {
      CAPTURE(faces);
      const Greedy greedy(points, faces, CostMeasure::Volume);
      const definition::HalfspaceArrangement arrangement(greedy.dual.halfspaces);
      const definition::Least least = definition::least_volume(arrangement, greedy.left.size());
      choices += least.choices;
      for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
        // Without kicks, so that the branches have something to find.
        const SearchRun run = find_optimum(greedy, optimal(engine, 0));
        REQUIRE(run.optimality.has_value());
        CHECK(run.optimality->is_proven);
        CHECK(run.optimality->lower_bound == least.volume);
        CHECK(arrangement.volume(definition::left_by(run, greedy.left)) == least.volume);
        improved += run.moves.size() > 0 && run.changes.back() < 0;
      }
    }
  }
  CHECK(choices > 500);
  CHECK(improved > 10);
}

TEST_CASE("optimal: what is kept on request is kept, and the rest is the least") {
  // The last three have symmetries, which few keep what is to be kept.
  for (const std::vector<Point>& points :
       {shapes::in_ball(8, 1), shapes::in_ball(8, 2), shapes::in_ball(8, 3), shapes::octahedron(),
        shapes::dodecahedron(), shapes::cut_cube(3, 0.25)}) {
    const Greedy greedy(points, 6, CostMeasure::Volume);
    const definition::HalfspaceArrangement arrangement(greedy.dual.halfspaces);
    CAPTURE(greedy.dual.halfspaces.size());
    const std::vector<HalfspaceId> keep(greedy.left.begin(), greedy.left.begin() + 2);
    const definition::Subset kept = definition::subset_of(keep);
    SearchOptions options = optimal();
    options.keep = keep;
    const SearchRun run = find_optimum(greedy, options);
    CHECK((definition::left_by(run, greedy.left) & kept) == kept);
    CHECK(run.optimality->is_proven);
    CHECK(run.optimality->lower_bound == definition::least_volume(arrangement, 6, kept).volume);
    // With all of them kept there is nothing to choose.
    options.keep = greedy.left;
    CHECK(find_optimum(greedy, options).moves.empty());
  }
}

// As in search_test.cpp. Its doubles are not quite regular.
TEST_CASE("optimal: the regular tetrahedron around an icosahedron is the least") {
  SimplifyRequest request;
  request.faces = 4;
  request.search.kind = SearchKind::Optimal;
  request.verify = VerifyLevel::Full;
  const auto result =
      std::get<SimplifyResult>(simplify(Shape(PointSet(shapes::icosahedron())), request));
  const double ratio = (result.output_volume.bounds / result.input_volume.bounds).high_double();
  CHECK(ratio == doctest::Approx((7 + 3 * std::sqrt(5.0)) / 5));
  REQUIRE(result.search.has_value());
  CHECK(result.search->optimality.value().is_proven);
}

TEST_CASE("optimal: a limit of nodes leaves a true lower bound, and claims no proof") {
  const Greedy greedy(shapes::in_ball(20, 4), 6, CostMeasure::Volume);
  SearchOptions options = optimal();
  const SearchRun whole = find_optimum(greedy, options);
  REQUIRE(whole.optimality->is_proven);
  REQUIRE(whole.optimality->nodes > 100);
  const Rational& least = whole.optimality->lower_bound;
  const Rational input = exact_measure(greedy.input, CostMeasure::Volume).rational();
  bool is_any_above = false;
  for (std::size_t nodes = 1; nodes < whole.optimality->nodes; nodes = 2 * nodes + 1) {
    CAPTURE(nodes);
    options.request.nodes = nodes;
    const SearchRun cut = find_optimum(greedy, options);
    CHECK_FALSE(cut.optimality->is_proven);
    CHECK(cut.optimality->nodes <= nodes);
    CHECK(cut.optimality->lower_bound <= least);
    CHECK(cut.optimality->lower_bound >= input);
    is_any_above = is_any_above || cut.optimality->lower_bound > input;
  }
  CHECK(is_any_above);
  options.request.nodes = whole.optimality->nodes;
  CHECK(find_optimum(greedy, options).optimality->is_proven);
}

TEST_CASE("optimal: it settles for the best so far, or stops without a result") {
  const Greedy greedy(shapes::in_ball(20, 4), 6, CostMeasure::Volume);
  const std::atomic<bool> now = true;
  SearchOptions options = optimal();
  options.settle = &now;
  const SearchRun settled = find_optimum(greedy, options);
  CHECK_FALSE(settled.optimality->is_proven);
  options.request.kind = SearchKind::Local;
  CHECK(same_moves(settled, greedy.search(options)));
  options.stop = &now;
  CHECK(error_of([&] { return find_optimum(greedy, options); }).code() == ErrorCode::Stopped);
}

TEST_CASE("optimal: progress tells a gap that a proof closes") {
  const Greedy greedy(shapes::in_ball(30, 2), 7, CostMeasure::Volume);
  SearchOptions options = optimal();
  std::size_t calls = 0;
  options.bounded = [&](std::size_t nodes, double gap) {
    ++calls;
    CHECK(nodes % 1024 == 0);
    CHECK(gap >= 0);
    CHECK(gap < 1);
  };
  options.request.nodes = 5000;
  CHECK(find_optimum(greedy, options).optimality->nodes >= 1024);
  CHECK(calls >= 1);
}

TEST_CASE("optimal: costs that may fall are refused, and so is the float engine") {
  const Greedy greedy(shapes::cube(), 6, CostMeasure::Volume);
  for (const CostMeasure cost : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    SearchOptions options = optimal();
    options.cost = cost;
    const Error error = error_of([&] { return find_optimum(greedy, options); });
    CHECK(error.code() == ErrorCode::InvalidArgument);
    CHECK(std::string(error.what()).find("only a volume") != std::string::npos);
    SimplifyRequest request;
    request.faces = 6;
    request.cost = cost;
    request.search.kind = SearchKind::Optimal;
    CHECK(error_of([&] { return simplify(Shape(PointSet(shapes::cube())), request); }).code() ==
          ErrorCode::InvalidArgument);
  }
  CHECK(error_of([&] { return find_optimum(greedy, optimal(Engine::Float)); }).code() ==
        ErrorCode::InvalidArgument);
}
