// SPDX-License-Identifier: MIT
// Several parts with one budget: the best of all splits for the summed volume, the first removals
// of each part's own run, ties between parts, the end and the growth limit. Expected are closed
// forms of cut cubes, and what brute force over all beginnings of the parts' own runs finds.
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "convexact/measure.hpp"
#include "convexact/simplify.hpp"
#include "expect_error.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

constexpr Engine kEngines[] = {Engine::Exact, Engine::Filtered, Engine::Float};
constexpr CostMeasure kMeasures[] = {CostMeasure::Volume, CostMeasure::Area,
                                     CostMeasure::MeanWidth};

SceneRequest total_request(std::size_t total, Engine engine = Engine::Filtered,
                           CostMeasure cost = CostMeasure::Volume) {
  SceneRequest request;
  request.each.engine = engine;
  request.each.cost = cost;
  request.each.exact_volumes = true;
  request.total_faces = total;
  return request;
}

SceneResult run(const std::vector<Shape>& parts, const SceneRequest& request) {
  SceneOutcome outcome = simplify_scene(parts, request);
  REQUIRE(std::holds_alternative<SceneResult>(outcome));
  return std::get<SceneResult>(std::move(outcome));
}

SimplifyResult run_alone(const Shape& part, std::size_t faces, Engine engine,
                         CostMeasure cost = CostMeasure::Volume, bool trace = false) {
  SimplifyRequest request;
  request.faces = faces;
  request.engine = engine;
  request.cost = cost;
  request.exact_volumes = true;
  request.trace = trace;
  return std::get<SimplifyResult>(simplify(part, request));
}

// To the end, with exact costs.
Run own_run(const Shape& part, CostMeasure cost = CostMeasure::Volume) {
  return *run_alone(part, 4, Engine::Exact, cost).run;
}

std::size_t halfspaces_of(const std::vector<Run>& runs) {
  std::size_t sum = 0;
  for (const Run& each : runs) sum += each.halfspaces.size();
  return sum;
}

std::size_t steps_of(const std::vector<Run>& runs) {
  std::size_t sum = 0;
  for (const Run& each : runs) sum += each.steps.size();
  return sum;
}

// Points of the same lattice solid elsewhere: the coordinates stay integers, so it is congruent.
std::vector<Point> moved(std::vector<Point> points, double by) {
  for (Point& point : points) point.x() += by;
  return points;
}

std::vector<Point> scaled(std::vector<Point> points, double by) {
  for (Point& point : points) point *= by;
  return points;
}

// What the definition asks for: at each step the cheapest next removal, on a tie of the first part.
struct Merged {
  std::vector<std::size_t> made;     // of each part
  std::vector<std::uint32_t> order;  // of all removals
  std::size_t ties = 0;              // of next removals of several parts, in `order`
};

// @param made  Removals that were made before.
Merged merge(const std::vector<Run>& runs, std::size_t total, std::vector<std::size_t> made) {
  Merged merged{std::move(made), {}, 0};
  std::size_t left = halfspaces_of(runs);
  for (const std::size_t count : merged.made) left -= count;
  const auto cost = [&](std::size_t part) -> const Cost& {
    return *runs[part].steps[merged.made[part]].cost;
  };
  for (; left > total; --left) {
    std::optional<std::uint32_t> best;
    bool is_tie = false;
    for (std::uint32_t part = 0; part < runs.size(); ++part) {
      if (merged.made[part] == runs[part].steps.size()) continue;
      const Order order = best ? compare(cost(part), cost(*best)).order : Order::Less;
      if (order == Order::Less) best = part;
      is_tie = order == Order::Equal || (is_tie && order != Order::Less);
    }
    if (!best) break;
    ++merged.made[*best];
    merged.order.push_back(*best);
    merged.ties += is_tie;
  }
  return merged;
}

Merged merge(const std::vector<Run>& runs, std::size_t total) {
  return merge(runs, total, std::vector<std::size_t>(runs.size(), 0));
}

// By volume the order after each part has made the removals that it makes whatever the others cost,
// because these keep 4 halfspaces each. Only volumes never fall.
Merged merge_in_the_end(const std::vector<Run>& runs, std::size_t total) {
  if (runs[0].measure != CostMeasure::Volume) return merge(runs, total);
  const std::size_t most = total - 4 * (runs.size() - 1);
  std::vector<std::size_t> made;
  for (const Run& each : runs) {
    const std::size_t all = each.halfspaces.size();
    made.push_back(all > most ? std::min(all - most, each.steps.size()) : 0);
  }
  return merge(runs, total, made);
}

// The least sum of costs of so many removals, over all beginnings of the parts' own runs; nothing
// if there are not so many.
std::optional<Rational> least_sum(const std::vector<Run>& runs, std::size_t part,
                                  std::size_t removals) {
  if (part == runs.size()) return removals == 0 ? std::optional(Rational(0)) : std::nullopt;
  std::optional<Rational> least;
  Rational spent = 0;
  for (std::size_t count = 0; count <= std::min(removals, runs[part].steps.size()); ++count) {
    if (count > 0) spent += runs[part].steps[count - 1].cost->rational();
    const std::optional<Rational> others = least_sum(runs, part + 1, removals - count);
    if (others && (!least || spent + *others < *least)) least = spent + *others;
  }
  return least;
}

// Of each part the planes that are left are those of the beginning of its own run.
void check_beginnings(const SceneResult& scene, const std::vector<Run>& runs) {
  std::size_t steps = 0;
  for (std::size_t part = 0; part < runs.size(); ++part) {
    CAPTURE(part);
    const std::size_t count = scene.parts[part].steps;
    steps += count;
    CHECK(scene.parts[part].solid.exact.planes == left_after(runs[part], count));
  }
  CHECK(scene.steps == steps);
}

std::vector<std::size_t> steps_of_parts(const SceneResult& scene) {
  std::vector<std::size_t> steps;
  for (const SimplifyResult& part : scene.parts) steps.push_back(part.steps);
  return steps;
}

std::vector<Shape> random_parts(std::uint64_t seed) {
  std::vector<Shape> parts;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto points = shapes::in_ball(8 + k, 3 * seed + k);
    parts.push_back(PointSet(k == 2 ? scaled(points, 0.5) : points));
  }
  return parts;
}

std::vector<Run> own_runs(const std::vector<Shape>& parts, CostMeasure cost = CostMeasure::Volume) {
  std::vector<Run> runs;
  for (const Shape& part : parts) runs.push_back(own_run(part, cost));
  return runs;
}

// Which part each removal was made in, as text.
std::string order_text(const SceneResult& scene) {
  std::string text;
  for (const std::uint32_t part : scene.order) text += static_cast<char>('0' + part);
  return text;
}

}  // namespace

TEST_CASE("simplify_scene: the least sum of volumes of all splits of a budget") {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    CAPTURE(seed);
    const std::vector<Shape> parts = random_parts(seed);
    const std::vector<Run> runs = own_runs(parts);
    const std::size_t all = halfspaces_of(runs);
    for (std::size_t total = all; total >= 12; total -= 2) {
      CAPTURE(total);
      const SceneResult scene = run(parts, total_request(total));
      const std::optional<Rational> least = least_sum(runs, 0, all - total);
      CHECK((scene.stop == StopReason::Reached) == least.has_value());
      CHECK(scene.input_halfspaces == all);
      if (!least) {
        CHECK(scene.stop == StopReason::AllUnbounded);
        CHECK(scene.output_halfspaces == all - steps_of(runs));
        continue;
      }
      CHECK(scene.output_halfspaces == total);
      CHECK(Rational(*scene.output_volume.exact - *scene.input_volume.exact) == *least);
      check_beginnings(scene, runs);
    }
  }
}

TEST_CASE("simplify_scene: every engine and measure takes the cheapest removal of all parts") {
  for (const std::uint64_t seed : {5, 6}) {
    const std::vector<Shape> parts = random_parts(seed);
    for (const CostMeasure cost : kMeasures) {
      CAPTURE(static_cast<int>(cost));
      const std::vector<Run> runs = own_runs(parts, cost);
      for (const std::size_t total :
           {std::size_t(12), std::size_t(17), std::size_t(22), halfspaces_of(runs) - 7}) {
        const Merged expected = merge(runs, total), end = merge_in_the_end(runs, total);
        CHECK(expected.made == end.made);
        for (const Engine engine : kEngines) {
          CAPTURE(static_cast<int>(engine));
          const SceneResult scene = run(parts, total_request(total, engine, cost));
          CHECK(steps_of_parts(scene) == expected.made);
          CHECK(scene.order == end.order);
          CHECK(scene.measure.has_value() == (cost != CostMeasure::Volume));
          check_beginnings(scene, runs);
        }
      }
    }
  }
}

// Of the bipyramid one removal is dear and the next ones cheap, so that its run does not get as far
// as the frustum's lets it: what a part could do at most, it need not do.
TEST_CASE("simplify_scene: costs that fall are spent in order, with a growth limit or without" *
          sweep) {
  std::vector<Point> frustum;
  for (const double size : {9.590644312935588, 19.181288625871176}) {
    for (int axis = 0; axis < 3; ++axis) frustum.push_back(size * Point::Unit(axis));
  }
  const std::vector<Shape> parts{PointSet(shapes::bipyramid(8)), PointSet(frustum)};
  for (const CostMeasure cost : kMeasures) {
    CAPTURE(static_cast<int>(cost));
    const std::vector<Run> runs = own_runs(parts, cost);
    for (std::size_t total = 8; total < halfspaces_of(runs); ++total) {
      const Merged expected = merge(runs, total);
      for (const Engine engine : kEngines) {
        SceneRequest request = total_request(total, engine, cost);
        CHECK(steps_of_parts(run(parts, request)) == expected.made);
        request.each.max_growth = Rational(100000);
        CHECK(steps_of_parts(run(parts, request)) == expected.made);
      }
    }
  }
}

TEST_CASE("simplify_scene: one part alone is the plain run, removal by removal" * sweep) {
  const Shape ball = PointSet(shapes::in_ball(40, 7));
  for (const Engine engine : kEngines) {
    for (const CostMeasure cost : kMeasures) {
      CAPTURE(static_cast<int>(engine));
      CAPTURE(static_cast<int>(cost));
      for (const bool records : {false, true}) {
        if (records && engine == Engine::Float) continue;
        for (const bool limits_growth : {false, true}) {
          SceneRequest request = total_request(11, engine, cost);
          request.each.trace = records;
          if (limits_growth) request.each.max_growth = Rational(1, 50);
          SimplifyRequest plain = request.each;
          plain.faces = 11;
          const SceneResult scene = run({ball}, request);
          const auto alone = std::get<SimplifyResult>(simplify(ball, plain));
          const SimplifyResult& part = scene.parts[0];
          CHECK(part.steps == alone.steps);
          CHECK(scene.steps == alone.steps);
          const bool has_order = limits_growth || cost != CostMeasure::Volume;
          CHECK(scene.order.size() == (has_order ? alone.steps : 0));
          CHECK(part.stop == alone.stop);
          CHECK(scene.stop == alone.stop);
          CHECK((alone.stop == StopReason::GrowthLimit) == limits_growth);
          CHECK(part.solid.exact.planes == alone.solid.exact.planes);
          CHECK(part.ties.steps == alone.ties.steps);
          CHECK(part.run.has_value() == alone.run.has_value());
          if (alone.float_bound) {
            CHECK(part.float_bound->cost == alone.float_bound->cost);
            CHECK(part.float_bound->regret == alone.float_bound->regret);
            CHECK(part.float_bound->is_end_proven == alone.float_bound->is_end_proven);
          }
          if (!alone.run) continue;
          for (std::size_t s = 0; s < alone.steps; ++s) {
            CHECK(part.run->steps[s].removed == alone.run->steps[s].removed);
            CHECK(part.run->steps[s].tie == alone.run->steps[s].tie);
            CHECK(compare(*part.run->steps[s].cost, *alone.run->steps[s].cost).order ==
                  Order::Equal);
          }
        }
      }
    }
  }
}

// A corner cut off at the depth d costs d^3 / 6; volumes of a cube are 1 without cuts.
TEST_CASE("simplify_scene: the part with the shallow cuts pays first") {
  const std::vector<Shape> parts{PointSet(shapes::cut_cube(2, 0.5)),
                                 PointSet(shapes::cut_cube(2, 0.25))};
  for (const Engine engine : kEngines) {
    CAPTURE(static_cast<int>(engine));
    const SceneResult fourteen = run(parts, total_request(14, engine));
    CHECK(order_text(fourteen) == "11");
    CHECK(fourteen.parts[0].solid.exact.planes.size() == 8);
    CHECK(fourteen.parts[1].solid.exact.planes.size() == 6);
    CHECK(*fourteen.input_volume.exact == Rational(2 - Rational(2, 48) - Rational(2, 384)));
    CHECK(*fourteen.output_volume.exact == Rational(2 - Rational(2, 48)));
    CHECK(order_text(run(parts, total_request(13, engine))) == "110");
    // Each on its own to seven: the sum is larger.
    Rational uniform = 0;
    for (const Shape& part : parts) uniform += *run_alone(part, 7, engine).output_volume.exact;
    CHECK(*fourteen.output_volume.exact < uniform);
  }
}

TEST_CASE("simplify_scene: shared is never worse than uniform, by volume") {
  for (const std::uint64_t seed : {11, 12, 13}) {
    std::vector<Shape> parts;
    for (std::uint32_t k = 0; k < 4; ++k) {
      parts.push_back(PointSet(shapes::in_ball(30 + 10 * k, seed + 100 * k)));
    }
    for (const std::size_t each : {8, 12, 16}) {
      Rational uniform = 0;
      std::size_t total = 0;
      for (const Shape& part : parts) {
        const SimplifyResult alone = run_alone(part, each, Engine::Filtered);
        uniform += *alone.output_volume.exact;
        total += alone.solid.exact.planes.size();
      }
      CHECK(*run(parts, total_request(total)).output_volume.exact <= uniform);
    }
  }
}

TEST_CASE("simplify_scene: of equal costs the first part goes on, however the parts are scaled") {
  const std::vector<Point> solid = shapes::lattice(9, 50, 3);
  const std::vector<Shape> parts{PointSet(solid), PointSet(moved(solid, 1024)),
                                 PointSet(moved(solid, -4096))};
  for (const CostMeasure cost : kMeasures) {
    CAPTURE(static_cast<int>(cost));
    const std::vector<Run> runs = own_runs(parts, cost);
    // Budgets with which the queue makes every removal, and only the last ones.
    for (const std::size_t total : {runs[0].halfspaces.size() + 8, std::size_t(15)}) {
      const Merged expected = merge_in_the_end(runs, total);
      for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
        const SceneResult scene = run(parts, total_request(total, engine, cost));
        CHECK(scene.order == expected.order);
        CHECK(steps_of_parts(scene) == merge(runs, total).made);
        const auto& tied = scene.ties.steps;
        CHECK(tied[static_cast<std::size_t>(cost == CostMeasure::Volume ? TieProof::EqualRationals
                                            : cost == CostMeasure::Area ? TieProof::SquareClasses
                                                                        : TieProof::NormalForm)] ==
              expected.ties);
        CHECK(std::accumulate(tied.begin(), tied.end(), std::size_t(0)) == expected.ties);
      }
    }
    CHECK(merge_in_the_end(runs, runs[0].halfspaces.size() + 8).ties > 4);
  }
}

// Both corners of the first cube cost as much as those of the second.
TEST_CASE("simplify_scene: ties within a part go before those of the next one") {
  const std::vector<Point> cube = shapes::cut_cube(2, 0.5);
  const std::vector<Shape> parts{PointSet(cube), PointSet(moved(cube, 8)),
                                 PointSet(shapes::cut_cube(1, 0.25))};
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    const SceneResult scene = run(parts, total_request(18, engine));
    CHECK(order_text(scene) == "20011");
    CHECK(scene.ties.steps[static_cast<std::size_t>(TieProof::EqualRationals)] == 2);
    for (const SimplifyResult& part : scene.parts) CHECK(part.stop == StopReason::Reached);
  }
}

TEST_CASE("simplify_scene: parts that are stuck drop out, and a part with 4 facets at once") {
  const std::vector<Shape> parts{PointSet(shapes::tetrahedron()),
                                 PointSet(shapes::cut_cube(2, 0.5)),
                                 PointSet(shapes::box({1, 1, 1}))};
  for (const Engine engine : kEngines) {
    for (const CostMeasure cost : kMeasures) {
      const SceneResult reached = run(parts, total_request(17, engine, cost));
      CHECK(reached.stop == StopReason::Reached);
      CHECK(order_text(reached) == "1");
      const SceneResult stuck = run(parts, total_request(12, engine, cost));
      CHECK(stuck.stop == StopReason::AllUnbounded);
      CHECK(stuck.output_halfspaces == 16);
      CHECK(steps_of_parts(stuck) == std::vector<std::size_t>{0, 2, 0});
      for (const SimplifyResult& part : stuck.parts) CHECK(part.stop == stuck.stop);
      CHECK(run(parts, total_request(18, engine, cost)).steps == 0);
      CHECK(run(parts, total_request(1000, engine, cost)).steps == 0);
    }
  }
}

// Cubes with one corner cut at 1/2, so 47/48 each: a corner is 1/94 of the sum of two.
TEST_CASE("simplify_scene: growth is that of the sum, exactly") {
  const std::vector<Point> cube = shapes::cut_cube(1, 0.5);
  const std::vector<Shape> parts{PointSet(cube), PointSet(moved(cube, 16))};
  const Rational one(1, 94), tiny = scale_by_power_of_two(Rational(1), -200);
  struct Limit {
    Rational growth;
    std::size_t steps;
  };
  const Limit limits[] = {{0, 0}, {one - tiny, 0}, {one, 1}, {2 * one - tiny, 1}, {2 * one, 2}};
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    for (const CostMeasure cost : kMeasures) {
      for (const Limit& limit : limits) {
        SceneRequest request = total_request(8, engine, cost);
        request.each.max_growth = limit.growth;
        request.each.growth_of = CostMeasure::Volume;
        const SceneResult scene = run(parts, request);
        CHECK(scene.order.size() == limit.steps);
        CHECK(scene.stop ==
              (limit.steps == 2 ? StopReason::AllUnbounded : StopReason::GrowthLimit));
        CHECK(scene.growth_of == CostMeasure::Volume);
        CHECK(scene.growth_bits == 0);
      }
    }
  }
  // The float engine, where doubles can tell.
  SceneRequest request = total_request(8, Engine::Float);
  request.each.max_growth = Rational(3, 188);
  const SceneResult scene = run(parts, request);
  CHECK(scene.order.size() == 1);
  for (const SimplifyResult& part : scene.parts) CHECK(part.float_bound->is_vouched());
}

// Areas: a cube of edge 2 has 24, one of edge 1 with a corner cut at 1/2 has 6 - (3 - sqrt 3) / 8.
TEST_CASE("simplify_scene: growth of an area, of parts that differ in size by powers of two") {
  const double small = 0x1p-300;
  const std::vector<Shape> parts{PointSet(shapes::cut_cube(1, 0.5)),
                                 PointSet(scaled(shapes::cut_cube(1, 0.5), small))};
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    for (const CostMeasure cost : kMeasures) {
      SceneRequest request = total_request(13, engine, cost);
      CHECK(order_text(run(parts, request)) == "1");
      request = total_request(12, engine, cost);
      // The large corner is 2.7% of the area; the small one is nothing beside it.
      request.each.max_growth = Rational(2, 100);
      request.each.growth_of = CostMeasure::Area;
      CHECK(order_text(run(parts, request)) == "1");
      request.each.max_growth = Rational(3, 100);
      CHECK(order_text(run(parts, request)) == "10");
    }
  }
}

TEST_CASE("simplify_scene: kept facets stay, by part") {
  const std::vector<Shape> parts{PointSet(shapes::cut_cube(1, 0.5)),
                                 PointSet(shapes::cut_cube(1, 0.25))};
  for (const Engine engine : kEngines) {
    SceneRequest request = total_request(13, engine);
    CHECK(order_text(run(parts, request)) == "1");
    const auto cut = run(parts, total_request(14, engine)).parts[1].solid.exact;
    const auto normal = std::find_if(cut.planes.begin(), cut.planes.end(), [](const auto& plane) {
                          return plane.normal().x() != 0 && plane.normal().y() != 0;
                        })->normal();
    const KeepSelector kept{KeepNormal{RationalVector3(normal.x(), normal.y(), normal.z()), 0.0},
                            "the cut"};
    request.keep = {{}, {kept}};
    const SceneResult scene = run(parts, request);
    CHECK(order_text(scene) == "0");
    CHECK(scene.parts[1].kept.size() == 1);
    request.total_faces = 8;  // the first cube keeps its six sides
    CHECK(run(parts, request).stop == StopReason::AllKeptOrUnbounded);
    request.keep.pop_back();
    CHECK(error_of([&] { return simplify_scene(parts, request); }).code() ==
          ErrorCode::InvalidArgument);
  }
}

TEST_CASE("simplify_scene: what makes no sense is refused") {
  const std::vector<Shape> parts{PointSet(shapes::tetrahedron()), PointSet(shapes::cube())};
  const auto is_refused = [&](std::span<const Shape> given, const SceneRequest& request) {
    return error_of([&] { return simplify_scene(given, request); }).code() ==
           ErrorCode::InvalidArgument;
  };
  CHECK(is_refused({}, total_request(8)));
  CHECK(is_refused(parts, total_request(7)));
  CHECK(is_refused(parts, total_request(0)));
  SceneRequest request = total_request(8);
  request.each.faces = 4;
  CHECK(is_refused(parts, request));
  request = total_request(8);
  request.each.center = RationalPoint(0, 0, 0);
  CHECK(is_refused(parts, request));
  request = total_request(8);
  request.each.max_growth = Rational(-1);
  CHECK(is_refused(parts, request));
  request = total_request(8, Engine::Float);
  request.each.trace = true;
  CHECK(is_refused(parts, request));
}

TEST_CASE("simplify_scene: the first part without volume comes back with its proof") {
  const std::vector<Shape> parts{PointSet(shapes::cube()),
                                 PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
                                 PointSet()};
  const SceneOutcome outcome = simplify_scene(parts, total_request(100));
  REQUIRE(std::holds_alternative<NotSolidPart>(outcome));
  CHECK(std::get<NotSolidPart>(outcome).part == 1);
  CHECK(std::holds_alternative<FlatInput>(std::get<NotSolidPart>(outcome).reason));
}

TEST_CASE("simplify_scene: progress counts the removals of all parts, and it can be stopped") {
  const std::vector<Shape> parts{PointSet(shapes::cut_cube(2, 0.5)),
                                 PointSet(shapes::cut_cube(2, 0.25))};
  SceneRequest request = total_request(13);
  std::vector<std::size_t> seen;
  request.each.watch.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
    if (stage != stage::kSimplify) return;
    CHECK(total == 3);
    seen.push_back(done);
  };
  (void)run(parts, request);
  CHECK(seen == std::vector<std::size_t>{1, 2, 3});
  const std::atomic<bool> stop = true;
  request.each.watch.stop = &stop;
  CHECK(error_of([&] { return simplify_scene(parts, request); }).code() == ErrorCode::Stopped);
}

namespace {

// Two unit cubes side by side, each with its faces.
std::vector<SceneObject> two_cubes() {
  std::vector<SceneObject> parts;
  for (const double x : {0.0, 1.0}) {
    std::vector<Point> corners;
    for (int k = 0; k < 8; ++k) {
      corners.emplace_back(x + (k & 1), (k >> 1) & 1, (k >> 2) & 1);
    }
    parts.push_back(
        {.name = "cube",
         .part = "cube",
         .shape = PointSet(corners),
         .polygons = {
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}});
  }
  return parts;
}

std::vector<Halfspace> slab_box(int low, int high) {
  const auto plane = [](int a, int b, int c, int d) {
    return Halfspace(IntegerVector3(a, b, c), Integer(d));
  };
  return {plane(1, 0, 0, -high), plane(-1, 0, 0, low), plane(0, 1, 0, -1),
          plane(0, -1, 0, 0),    plane(0, 0, 1, -1),   plane(0, 0, -1, 0)};
}

}  // namespace

TEST_CASE("find_gaps: faces out of their own part, and in no part") {
  const std::vector<SceneObject> parts = two_cubes();
  // The boxes themselves: touching is inside.
  const Gaps none = find_gaps(parts, std::vector{slab_box(0, 1), slab_box(1, 2)});
  CHECK(none.faces == 12);
  CHECK(none.out_of_own.empty());
  CHECK(none.in_no_part.empty());
  // The first solid holds both cubes and the second is empty: all faces of the second cube are in
  // another part only.
  const Gaps other = find_gaps(parts, std::vector{slab_box(0, 2), std::vector<Halfspace>()});
  CHECK(other.out_of_own.size() == 6);
  CHECK(other.out_of_own[0] == PartFace{1, 0});
  CHECK(other.in_no_part.empty());
  // Exchanged: only the face in the plane between them is in both.
  const Gaps exchanged = find_gaps(parts, std::vector{slab_box(1, 2), slab_box(0, 1)});
  CHECK(exchanged.out_of_own.size() == 10);
  CHECK(exchanged.in_no_part.empty());
  // Half of the second cube is bare: its end, and the four faces that reach there.
  auto half = slab_box(1, 2);
  half[0] = Halfspace(IntegerVector3(2, 0, 0), Integer(-3));
  const Gaps bare = find_gaps(parts, std::vector{slab_box(0, 1), half});
  CHECK(bare.out_of_own == bare.in_no_part);
  CHECK(bare.out_of_own == std::vector<PartFace>{{1, 0}, {1, 1}, {1, 2}, {1, 3}, {1, 5}});
  CHECK(error_of([&] { return find_gaps(parts, {}); }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("find_gaps: what simplify_scene() makes has none, halfspaces and clouds have no faces") {
  std::vector<SceneObject> parts = two_cubes();
  std::vector<Shape> shapes_of_parts;
  for (const SceneObject& part : parts) shapes_of_parts.push_back(part.shape);
  const SceneResult scene = run(shapes_of_parts, total_request(8));
  std::vector<std::vector<Halfspace>> solids;
  for (const SimplifyResult& part : scene.parts) solids.push_back(part.solid.exact.planes);
  CHECK(find_gaps(parts, solids).out_of_own.empty());
  parts[0].polygons.clear();
  parts[1].shape = slab_box(1, 2);
  CHECK(find_gaps(parts, solids).faces == 0);
}

TEST_CASE("a scene is the same for any number of threads") {
  std::vector<Shape> parts;
  for (std::uint64_t seed = 1; seed <= 9; ++seed) {
    parts.emplace_back(PointSet(shapes::on_sphere(40 + 60 * std::uint32_t(seed % 3), seed / 2)));
  }
  for (const Engine engine : kEngines) {
    for (const CostMeasure cost : kMeasures) {
      if (engine == Engine::Exact && cost != CostMeasure::Volume) continue;  // takes long
      SceneRequest request = total_request(120, engine, cost);
      request.each.jobs = 1;
      const SceneResult alone = run(parts, request);
      for (const std::size_t jobs : {2u, 3u, 8u}) {
        CAPTURE(jobs);
        request.each.jobs = jobs;
        const SceneResult made = run(parts, request);
        CHECK(made.order == alone.order);
        CHECK(made.steps == alone.steps);
        CHECK(made.input_volume.exact == alone.input_volume.exact);
        CHECK(made.output_volume.exact == alone.output_volume.exact);
        for (std::size_t k = 0; k < parts.size(); ++k) {
          CHECK(made.parts[k].solid.exact.planes == alone.parts[k].solid.exact.planes);
        }
      }
    }
  }
}

TEST_CASE("a scene: the first part that is flat or refused is told of, by any number of threads") {
  std::vector<Shape> parts(20, Shape(PointSet(shapes::cut_cube(1, 0.25))));
  parts[4] = PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  parts[6] = std::vector<Halfspace>{};
  for (const std::size_t jobs : {1u, 2u, 8u}) {
    CAPTURE(jobs);
    SceneRequest request = total_request(100);
    request.each.jobs = jobs;
    const SceneOutcome outcome = simplify_scene(parts, request);
    REQUIRE(std::holds_alternative<NotSolidPart>(outcome));
    CHECK(std::get<NotSolidPart>(outcome).part == 4);
  }
  SceneRequest request = total_request(100);
  request.each.jobs = 0;
  CHECK(error_of([&] { return simplify_scene(parts, request); }).code() ==
        ErrorCode::InvalidArgument);
}
