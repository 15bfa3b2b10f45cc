// SPDX-License-Identifier: MIT
// The loops of the engines to 18 halfspaces; the hull and its dual are not timed. Those by each
// cost run without verification. On random spheres of 500 to 8,000 halfspaces: how the exact engine
// grows.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "benches.hpp"
#include "fast/engines.hpp"
#include "shapes/makers.hpp"
#include "simplify/exact_engine.hpp"
#include "simplify/run_names.hpp"

using namespace convexact;

namespace {

constexpr std::size_t kFaces = 18;

RationalPoint mean(const std::vector<RationalPoint>& vertices) {
  RationalPoint sum = RationalPoint::Zero();
  for (const RationalPoint& v : vertices) sum += v;
  return sum / Rational(vertices.size());
}

void simplify(benchmark::State& state, const std::vector<Point>& points, VerifyLevel verify) {
  const PointSet set(points);
  const DualHull solid = dual_of(std::get<Hull>(convex_hull(set)), set);
  const RationalPoint center = mean(solid.vertices);
  SimplifyOptions options;
  options.faces = kFaces;
  options.verify = verify;
  std::size_t hash = 0;  // of what is removed: equal answers have equal hashes
  for (auto _ : state) {
    hash = 0;
    for (const Step& step : simplify_exact(solid, center, options).steps) {
      hash = (hash * 1000003 + step.removed.value) % 1000000007;
    }
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["halfspaces"] = static_cast<double>(solid.halfspaces.size());
  state.counters["hash"] = static_cast<double>(hash);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;  // so far
  state.SetComplexityN(static_cast<std::int64_t>(solid.halfspaces.size()));
}

void spheres(benchmark::State& state) {
  const auto halfspaces = static_cast<std::uint32_t>(state.range(0));
  simplify(state, shapes::on_sphere(halfspaces / 2 + 2, halfspaces), VerifyLevel::Local);
}

void loop_by_cost(benchmark::State& state, const std::vector<Point>& points, CostMeasure cost,
                  FastResult (*engine)(const FastDual&, const SimplifyOptions&)) {
  const PointSet set(points);
  const Hull hull = std::get<Hull>(convex_hull(set));
  const FastDual dual = FastDual::of(hull, set);
  SimplifyOptions options;
  options.faces = kFaces;
  options.verify = VerifyLevel::None;
  options.cost = cost;
  FastResult result;
  for (auto _ : state) result = engine(dual, options);
  const auto removals = static_cast<double>(result.steps.size());
  const double first = static_cast<double>(dual.size());
  state.counters["evaluations"] =
      (static_cast<double>(result.counts.evaluations) - first) / removals;
  state.counters["exact"] = static_cast<double>(result.counts.exact);
}

void exact_loop_by_cost(benchmark::State& state, const std::vector<Point>& points,
                        CostMeasure cost) {
  const PointSet set(points);
  const DualHull solid = dual_of(std::get<Hull>(convex_hull(set)), set);
  const RationalPoint center = mean(solid.vertices);
  SimplifyOptions options;
  options.faces = kFaces;
  options.verify = VerifyLevel::None;
  options.cost = cost;
  for (auto _ : state) benchmark::DoNotOptimize(simplify_exact(solid, center, options));
}

}  // namespace

void register_loops_by_cost(const std::vector<BenchInput>& inputs) {
  for (const BenchInput& input : inputs) {
    if (!input.exact_too) continue;
    for (const auto& [cost, name] : kCostMeasureNames) {
      const std::string loop = input.name + "/by-" + name;
      const auto filtered = [](const FastDual& dual, const SimplifyOptions& options) {
        return simplify_filtered(dual, options);
      };
      benchmark::RegisterBenchmark(loop.c_str(), loop_by_cost, input.points, cost, filtered)
          ->Unit(benchmark::kMillisecond);
      benchmark::RegisterBenchmark((loop + "-float").c_str(), loop_by_cost, input.points, cost,
                                   simplify_float)
          ->Unit(benchmark::kMillisecond);
      constexpr std::size_t kMostPoints = 4000;  // seconds per run
      if (input.points.size() > kMostPoints) continue;
      benchmark::RegisterBenchmark((loop + "-exact").c_str(), exact_loop_by_cost, input.points,
                                   cost)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

void register_exact_growth() {
  benchmark::RegisterBenchmark("exact_growth", spheres)
      ->RangeMultiplier(2)
      ->Range(500, 8000)
      ->Unit(benchmark::kMillisecond)
      ->Complexity(benchmark::oNLogN);
}
