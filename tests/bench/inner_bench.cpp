// SPDX-License-Identifier: MIT
// Inner runs beside runs by volume on the same hull, both down to the end: an inner run has half as
// many things to remove, at costs without a division. Each with its steps proven again.
#include <benchmark/benchmark.h>

#include "benches.hpp"
#include "convexact/hull.hpp"
#include "convexact/run.hpp"
#include "fast/engines.hpp"
#include "fast/filtered_inner.hpp"

using namespace convexact;

namespace {

void inner(benchmark::State& state, const std::vector<Point>& points, bool costs) {
  const PointSet set(points);
  const VertexHull start = vertex_hull(std::get<Hull>(convex_hull(set)), set);
  InnerRun run;
  for (auto _ : state) {
    run = simplify_inner_filtered(start);
    verify_inner_run(start, run, VerifyLevel::Local);
    if (costs) run = with_costs(start, std::move(run));
  }
  state.counters["removals"] = static_cast<double>(run.steps.size());
}

void outer(benchmark::State& state, const std::vector<Point>& points) {
  const PointSet set(points);
  const Hull hull = std::get<Hull>(convex_hull(set));
  const FastDual dual = FastDual::of(hull, set);
  FastResult result;
  for (auto _ : state) result = simplify_filtered(dual, SimplifyOptions{});
  state.counters["removals"] = static_cast<double>(result.steps.size());
}

}  // namespace

void register_inner_bench(const std::vector<BenchInput>& inputs) {
  constexpr std::size_t kMostPoints = 50000;
  for (const BenchInput& input : inputs) {
    if (input.points.size() > kMostPoints) continue;
    const auto add = [&](const char* name, auto&& function, auto... arguments) {
      benchmark::RegisterBenchmark((input.name + name).c_str(), function, input.points,
                                   arguments...)
          ->Unit(benchmark::kMillisecond);
    };
    add("/inner", inner, false);
    add("/inner-costs", inner, true);
    add("/outer", outer);
  }
}
