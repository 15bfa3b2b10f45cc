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
#include "sweep.hpp"

using namespace convexact;

namespace {

SearchOptions optimal(Engine engine = Engine::Filtered, std::size_t kicks = 3) {
  return {.request = {SearchKind::Optimal, kicks}, .engine = engine};
}

// A few random points and what a reflection, or turns, make of them: up to 12 facets.
std::vector<std::vector<Point>> symmetric_points() {
  using Image = Point (*)(const Point&);
  constexpr Image kMirror = [](const Point& p) -> Point { return {-p[0], p[1], p[2]}; };
  constexpr Image kCenter = [](const Point& p) -> Point { return -p; };
  constexpr Image kHalfTurn = [](const Point& p) -> Point { return {-p[0], -p[1], p[2]}; };
  constexpr Image kQuarterTurn = [](const Point& p) -> Point { return {-p[1], p[0], p[2]}; };
  std::vector<std::vector<Point>> list;
  const auto add = [&](std::uint32_t count, std::vector<Image> images) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      std::vector<Point> points = shapes::lattice(count, 20, seed);
      for (const Image image : images) {
        const std::vector<Point> before = points;
        for (const Point& p : before) points.push_back(image(p));
      }
      if (Greedy(points, 4, CostMeasure::Volume).dual.halfspaces.size() <= 12) {
        list.push_back(std::move(points));
      }
    }
  };
  add(4, {kMirror});
  add(4, {kCenter});
  add(4, {kHalfTurn});
  add(2, {kHalfTurn, kMirror});
  add(2, {kQuarterTurn, kHalfTurn});
  return list;
}

}  // namespace

TEST_CASE("optimal: no choice of the definition is smaller, in both engines" * sweep) {
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
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    const Greedy greedy(shapes::in_ball(8, seed), 6, CostMeasure::Volume);
    const definition::HalfspaceArrangement arrangement(greedy.dual.halfspaces);
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

TEST_CASE("optimal: with mirrors, turns and a center no choice of the definition is smaller" *
          sweep) {
  std::size_t cases = 0;
  for (const std::vector<Point>& points : symmetric_points()) {
    const std::size_t most = Greedy(points, 4, CostMeasure::Volume).dual.halfspaces.size();
    for (std::size_t faces = 4; faces < most; ++faces) {
      CAPTURE(faces);
      const Greedy greedy(points, faces, CostMeasure::Volume);
      const definition::HalfspaceArrangement arrangement(greedy.dual.halfspaces);
      // Without kicks, as above; with a plane to be kept, which few symmetries do.
      for (const bool keeps : {false, true}) {
        SearchOptions options = optimal(Engine::Filtered, 0);
        if (keeps) options.keep = {greedy.left[faces / 2]};
        CHECK(find_optimum(greedy, options).optimality->lower_bound ==
              definition::least_volume(arrangement, greedy.left.size(),
                                       definition::subset_of(options.keep))
                  .volume);
        ++cases;
      }
    }
  }
  CHECK(cases > 100);
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
  std::size_t kicks = 0;
  options.watch = {nullptr, [&](std::size_t made, std::size_t) { kicks = made; }};
  const SearchRun settled = find_optimum(greedy, options);
  CHECK_FALSE(settled.optimality->is_proven);
  CHECK(kicks == 0);
  options.request.kind = SearchKind::Local;
  CHECK(same_moves(settled, greedy.search(options)));
  options.watch = &now;
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
