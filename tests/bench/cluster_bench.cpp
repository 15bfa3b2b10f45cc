// SPDX-License-Identifier: MIT
// Clusters of a mesh's triangles at 3% of the diameter: the engines, and the library of the
// method's author; the growth of time and memory with the number of triangles; and how long it
// takes to test that each triangle lies in the part that owns it.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "benches.hpp"
#include "convexact/cluster.hpp"
#include "convexact/stored.hpp"
#include "peak_memory.hpp"
#ifdef CONVEXACT_HAVE_HACD
#include <HACD/hacdHACD.h>
#endif

using namespace convexact;

namespace {

void cluster_by(benchmark::State& state, const Surface& surface, Engine engine) {
  ClusterOptions options;
  options.engine = engine;
  Clustering made;
  PeakMemory memory;
  for (auto _ : state) made = cluster(surface, options);
  const auto triangles = static_cast<double>(surface.triangles.size());
  state.counters["triangles"] = triangles;
  state.counters["parts"] = static_cast<double>(made.clusters.size());
  state.counters["evaluations_per_triangle"] = static_cast<double>(made.evaluations) / triangles;
  state.counters["exact_evaluations"] = static_cast<double>(made.exact_evaluations);
  state.counters["bytes_per_triangle"] = memory.bytes() / triangles;
}

// Each corner of each triangle against the hull of its cluster.
void cover_by_owners(benchmark::State& state, const Surface& surface) {
  std::vector<std::vector<Halfspace>> planes;
  std::vector<PointSet> points;
  for (const auto& triangles : cluster(surface).clusters) {
    points.push_back(subset(surface.points, points_of(surface, triangles)));
    planes.push_back(convex_part(points.back()).halfspaces);
  }
  for (auto _ : state) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      benchmark::DoNotOptimize(count_outside(planes[k], points[k]));
    }
  }
}

#ifdef CONVEXACT_HAVE_HACD
// Classical HACD grows with the square: the bunny's 69,451 triangles take it over four minutes.
constexpr std::size_t kMostForHacd = 20'000;

// The library scales its input so that the diagonal of the box is 2,000: 60 is 3%. The weight is
// that of Bullet's own example; no points are added.
void cluster_by_hacd(benchmark::State& state, const Surface& surface) {
  std::vector<HACD::Vec3<HACD::Real>> points;
  for (const Point& p : surface.points.doubles()) points.emplace_back(p[0], p[1], p[2]);
  std::vector<HACD::Vec3<long>> triangles;
  for (const auto& [a, b, c] : surface.triangles) triangles.emplace_back(a.value, b.value, c.value);
  std::size_t parts = 0;
  for (auto _ : state) {
    HACD::HACD hacd;
    hacd.SetPoints(points.data());
    hacd.SetNPoints(points.size());
    hacd.SetTriangles(triangles.data());
    hacd.SetNTriangles(triangles.size());
    hacd.SetNClusters(1);
    hacd.SetConcavity(60);
    hacd.SetCompacityWeight(0.1);
    hacd.SetVolumeWeight(0);
    hacd.SetAddExtraDistPoints(false);
    hacd.SetAddNeighboursDistPoints(false);
    hacd.SetAddFacesPoints(false);
    hacd.Compute(true);
    parts = hacd.GetNClusters();
  }
  state.counters["parts"] = static_cast<double>(parts);
}
#endif

// The first triangles in canonical order, for the engine that is slow.
Surface first_triangles(const Surface& surface, std::size_t count) {
  Mesh mesh;
  mesh.points = surface.points;
  for (std::size_t t = 0; t < std::min(count, surface.triangles.size()); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    mesh.polygons.push_back({a.value, b.value, c.value});
  }
  return make_surface(mesh, {Orient::Keep});
}

// A ball with bumps: the same shape for any number of triangles.
Surface bumpy_ball(std::size_t triangles) {
  const auto rings = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4.0));
  const std::uint32_t around = 2 * rings;
  std::vector<Point> points{{0, 0, 1}, {0, 0, -1}};
  for (std::uint32_t i = 1; i < rings; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const double latitude = std::numbers::pi * i / rings;
      const double longitude = 2 * std::numbers::pi * j / around;
      const double radius = 1 + 0.2 * std::sin(3 * latitude) * std::sin(4 * longitude);
      points.push_back(radius * Point(std::sin(latitude) * std::cos(longitude),
                                      std::sin(latitude) * std::sin(longitude),
                                      std::cos(latitude)));
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return 2 + (i - 1) * around + j % around;
  };
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t j = 0; j < around; ++j) {
    faces.push_back({0, at(1, j), at(1, j + 1)});
    faces.push_back({1, at(rings - 1, j + 1), at(rings - 1, j)});
    for (std::uint32_t i = 1; i + 1 < rings; ++i) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return make_surface({PointSet(std::move(points)), std::move(faces), {}});
}

}  // namespace

void register_cluster_bench(const std::vector<std::string>& meshes) {
  const auto add = [](const std::string& name, auto run) {
    benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
  };
  const auto add_engine = [&](const std::string& name, const Surface& surface, Engine engine) {
    add(name, [=](benchmark::State& state) { cluster_by(state, surface, engine); });
  };
  for (const std::string& path : meshes) {
    const std::string file = path.substr(path.find_last_of('/') + 1);
    const std::string name = "clusters-of-" + file.substr(0, file.find('.'));
    const Surface surface = make_surface(read_mesh(path));
    add_engine(name + "/filtered", surface, Engine::Filtered);
    add_engine(name + "/float", surface, Engine::Float);
    add(name + "/owners", [=](benchmark::State& state) { cover_by_owners(state, surface); });
#ifdef CONVEXACT_HAVE_HACD
    if (surface.triangles.size() <= kMostForHacd) {
      add(name + "/hacd", [=](benchmark::State& state) { cluster_by_hacd(state, surface); });
    }
#endif
    const Surface first = first_triangles(surface, 300);
    add_engine(name + "-300/filtered", first, Engine::Filtered);
    add_engine(name + "-300/exact", first, Engine::Exact);
  }
  for (const std::size_t triangles : {5'000u, 20'000u, 70'000u}) {
    add_engine("cluster-growth/" + std::to_string(triangles), bumpy_ball(triangles),
               Engine::Filtered);
  }
}
