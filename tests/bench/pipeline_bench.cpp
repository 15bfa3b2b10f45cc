// SPDX-License-Identifier: MIT
// The whole pipeline, from points in memory to 18 proven planes: every stage but reading and
// writing, `local` verification included. Counters give the seconds of each stage in the last
// round, and the peak of memory per hull facet, the points not counted.
#include <benchmark/benchmark.h>

#include "benches.hpp"
#include "convexact/simplify.hpp"
#include "peak_memory.hpp"
#include "solid/stage_log.hpp"

using namespace convexact;

namespace {

void pipeline(benchmark::State& state, const std::vector<Point>& points, Engine engine) {
  const Shape shape = PointSet(points);
  SimplifyRequest request;
  request.faces = 18;
  request.engine = engine;
  StageLog log;
  const PeakMemory memory;
  double facets = 1;
  for (auto _ : state) {
    log = StageLog();
    const SimplifyOutcome outcome = simplify(shape, request);
    const auto& result = std::get<SimplifyResult>(outcome);
    state.counters["planes"] = static_cast<double>(result.solid.exact.planes.size());
    facets = static_cast<double>(result.input_halfspaces);
  }
  state.counters["bytes_per_facet"] = memory.bytes() / facets;
  for (const Stage& stage : log.stages()) {
    if (stage.skipped.empty()) state.counters[stage.name] = stage.seconds;
  }
}

}  // namespace

void register_pipeline_bench(const std::vector<BenchInput>& inputs) {
  for (const BenchInput& input : inputs) {
    const auto add = [&](const char* what, Engine engine) {
      benchmark::RegisterBenchmark((input.name + "/" + what).c_str(), pipeline, input.points,
                                   engine)
          ->Unit(benchmark::kMillisecond);
    };
    add("filtered", Engine::Filtered);
    add("float", Engine::Float);
    if (input.exact_too) add("exact", Engine::Exact);
  }
}
