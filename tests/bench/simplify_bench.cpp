// SPDX-License-Identifier: MIT
// How the exact engine grows: random spheres of 500 to 8,000 halfspaces down to 18. The hull and
// its dual are not timed.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "benches.hpp"
#include "shapes/makers.hpp"
#include "simplify/exact_engine.hpp"

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

}  // namespace

void register_exact_growth() {
  benchmark::RegisterBenchmark("exact_growth", spheres)
      ->RangeMultiplier(2)
      ->Range(500, 8000)
      ->Unit(benchmark::kMillisecond)
      ->Complexity(benchmark::oNLogN);
}
