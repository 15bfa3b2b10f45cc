// SPDX-License-Identifier: MIT
// Several parts with one budget against the parts' own runs to the same ends. What is before and
// after the removals is the same for both, and is timed as well. The time of the removals alone is
// a counter.
#include <benchmark/benchmark.h>

#include "benches.hpp"
#include "convexact/simplify.hpp"

using namespace convexact;

namespace {

constexpr std::size_t kFacesEach = 18;

double seconds_of(const std::vector<Stage>& stages) {
  double seconds = 0;
  for (const Stage& stage : stages) {
    if (stage.name == stage::kSimplify) seconds += stage.seconds;
  }
  return seconds;
}

SceneRequest scene_request(std::size_t parts) {
  SceneRequest request;
  request.each.verify = VerifyLevel::None;
  request.total_faces = kFacesEach * parts;
  return request;
}

void shared(benchmark::State& state, const std::vector<Shape>& parts) {
  double least = 1e9;
  for (auto _ : state) {
    const SceneOutcome outcome = simplify_scene(parts, scene_request(parts.size()));
    least = std::min(least, seconds_of(std::get<SceneResult>(outcome).stages));
  }
  state.counters["least_loop_ms"] = 1000 * least;
}

void own(benchmark::State& state, const std::vector<Shape>& parts) {
  const auto scene = std::get<SceneResult>(simplify_scene(parts, scene_request(parts.size())));
  SimplifyRequest request = scene_request(parts.size()).each;
  double least = 1e9;
  for (auto _ : state) {
    double seconds = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      request.faces = scene.parts[k].solid.exact.planes.size();
      seconds += seconds_of(std::get<SimplifyResult>(simplify(parts[k], request)).stages);
    }
    least = std::min(least, seconds);
  }
  state.counters["least_loop_ms"] = 1000 * least;
}

}  // namespace

void register_scene_bench(const std::vector<BenchInput>& inputs) {
  constexpr std::size_t kMostPoints = 50000;
  std::vector<Shape> parts;
  for (const BenchInput& input : inputs) {
    if (input.points.size() <= kMostPoints) parts.push_back(PointSet(input.points));
  }
  benchmark::RegisterBenchmark("scene/shared", shared, parts)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("scene/own", own, parts)->Unit(benchmark::kMillisecond);
}
