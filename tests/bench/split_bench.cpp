// SPDX-License-Identifier: MIT
// A mesh's triangles split at notches until 3% of the diameter, beside the clusters of the same
// limit; and the searches for shortest paths of the same run alone.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>

#include "benches.hpp"
#include "convexact/cluster.hpp"
#include "decompose/bridges.hpp"

using namespace convexact;

namespace {

void split_mesh(benchmark::State& state, const Surface& surface) {
  SplitTree made;
  for (auto _ : state) made = split(surface);
  const auto count = [&](LeafStatus status) {
    return std::count_if(made.leaves.begin(), made.leaves.end(),
                         [&](const SplitLeaf& leaf) { return leaf.status == status; });
  };
  state.counters["triangles"] = static_cast<double>(surface.triangles.size());
  state.counters["parts"] = static_cast<double>(made.leaves.size());
  state.counters["splits"] = static_cast<double>(made.splits.size());
  state.counters["unsplittable"] = static_cast<double>(count(LeafStatus::Unsplittable));
}

// What split() searches for a node: from and to are numbers of points of the patch.
struct Searches {
  std::unique_ptr<Patch> patch;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
};

// By node: the triangles of the leaves below it.
std::vector<std::vector<TriangleId>> triangles_of(const SplitTree& tree) {
  std::vector<std::vector<TriangleId>> found(tree.nodes.size());
  for (const SplitLeaf& leaf : tree.leaves) {
    for (std::optional<std::uint32_t> n = leaf.node; n; n = tree.nodes[*n].parent) {
      found[*n].insert(found[*n].end(), leaf.triangles.begin(), leaf.triangles.end());
    }
  }
  for (auto& triangles : found) std::sort(triangles.begin(), triangles.end());
  return found;
}

std::vector<Searches> searches_of(const Surface& surface, const NearSurface& near) {
  SplitOptions options;
  options.associations = true;
  const SplitTree tree = split(surface, options);
  const auto triangles = triangles_of(tree);
  const EdgeLengths lengths(surface.points, near);
  std::vector<Searches> found;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    Searches& searches = found.emplace_back();
    searches.patch = std::make_unique<Patch>(surface, triangles[n], lengths);
    for (const BridgePath& path : tree.nodes[n].association->paths) {
      const std::uint32_t from = searches.patch->number_of(path.points.front());
      const std::uint32_t to = searches.patch->number_of(path.points.back());
      if (path.spans_hole || searches.patch->is_edge(from, to)) continue;
      searches.ends.emplace_back(from, to);
    }
  }
  return found;
}

void search_paths(benchmark::State& state, const Surface& surface) {
  const NearSurface near(surface);
  const std::vector<Searches> all = searches_of(surface, near);
  std::size_t count = 0;
  for (auto _ : state) {
    count = 0;
    for (const Searches& searches : all) {
      ShortestPaths paths(*searches.patch, near.points);
      for (const auto& [from, to] : searches.ends) benchmark::DoNotOptimize(paths(from, to));
      count += searches.ends.size();
    }
  }
  state.counters["paths"] = static_cast<double>(count);
}

}  // namespace

void register_split_bench(const std::vector<std::string>& meshes) {
  for (const std::string& path : meshes) {
    const std::string file = path.substr(path.find_last_of('/') + 1);
    // So named that tests/bench/ratios.py divides them by the clusters of the same mesh.
    const std::string name = "clusters-of-" + file.substr(0, file.find('.'));
    const Surface surface = make_surface(read_mesh(path));
    const auto add = [&](const std::string& what, auto run) {
      benchmark::RegisterBenchmark((name + what).c_str(), run)->Unit(benchmark::kMillisecond);
    };
    add("/acd", [=](benchmark::State& state) { split_mesh(state, surface); });
    add("/acd-paths", [=](benchmark::State& state) { search_paths(state, surface); });
  }
}
