// SPDX-License-Identifier: MIT
// convexact-bench: everything in one run, so that ratios are meaningful.
#include <benchmark/benchmark.h>

#include "benches.hpp"

int main(int argc, char** argv) {
  const std::vector<BenchInput> inputs = bench_inputs();
  register_hull_bench(inputs);
  register_pipeline_bench(inputs);
  register_loops_by_cost(inputs);
  register_query_bench(inputs);
  register_inner_bench(inputs);
  register_box_bench(inputs);
  register_exact_growth();
  register_scene_bench(inputs);
  register_overlay_bench(bench_meshes());
  register_cluster_bench(bench_meshes());
  register_split_bench(bench_meshes());
  register_growth_bench();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
