// SPDX-License-Identifier: MIT
// The exact engine down to 18 halfspaces: the meshes with and without verification, and its growth
// from 500 to 8,000 halfspaces on random spheres. The hull and its dual are not timed.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "bench_inputs.hpp"
#include "convexact/simplify/exact_engine.hpp"

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
    for (const Step& step : simplify_exact(solid, center, options).trace.steps) {
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
BENCHMARK(spheres)
    ->Arg(500)
    ->Arg(1000)
    ->Arg(2000)
    ->Arg(4000)
    ->Arg(8000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);

}  // namespace

int main(int argc, char** argv) {
  const std::vector<BenchInput> inputs = bench_inputs();
  for (const BenchInput& input : inputs) {
    if (input.name.find("sphere") == 0) continue;
    for (const auto& [level, name] : {std::pair(VerifyLevel::None, "/verify none"),
                                      std::pair(VerifyLevel::Local, "/verify local")}) {
      benchmark::RegisterBenchmark((input.name + name).c_str(), [&, level = level](auto& state) {
        simplify(state, input.points, level);
      })->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
