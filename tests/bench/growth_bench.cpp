// SPDX-License-Identifier: MIT
// What could grow badly, each with a size n and with 4 n: ratios.py prints the exponent.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "benches.hpp"
#include "convexact/decompose.hpp"
#include "convexact/overlay.hpp"
#include "number/random.hpp"

using namespace convexact;

namespace {

using Faces = std::vector<std::vector<std::uint32_t>>;

// Meshes of many pieces.
class MeshMaker {
 public:
  void add(const std::vector<Point>& points, Faces faces) {
    const auto first = static_cast<std::uint32_t>(points_.size());
    points_.insert(points_.end(), points.begin(), points.end());
    for (std::vector<std::uint32_t>& face : faces) {
      for (std::uint32_t& corner : face) corner += first;
      mesh_.polygons.push_back(std::move(face));
    }
  }
  void add_box(const Point& low, const Point& high) {
    std::vector<Point> corners;
    for (unsigned k = 0; k < 8; ++k) {
      corners.emplace_back((k & 1u) != 0 ? high[0] : low[0], (k & 2u) != 0 ? high[1] : low[1],
                           (k & 4u) != 0 ? high[2] : low[2]);
    }
    add(corners,
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
  }
  Mesh take() {
    mesh_.points = PointSet(std::move(points_));
    return std::move(mesh_);
  }

 private:
  std::vector<Point> points_;
  Mesh mesh_;
};

// Boxes that all contain the origin.
Mesh overlapping_boxes(std::size_t count) {
  Random random(5);
  MeshMaker maker;
  for (std::size_t i = 0; i < count; ++i) {
    Point low, high;
    for (int k = 0; k < 3; ++k) {
      low[k] = -uniform_unit(random);
      high[k] = 0.01 + uniform_unit(random);
    }
    maker.add_box(low, high);
  }
  return maker.take();
}

Mesh equal_cubes(std::size_t count) {
  MeshMaker maker;
  for (std::size_t i = 0; i < count; ++i) maker.add_box({0, 0, 0}, {1, 1, 1});
  return maker.take();
}

Mesh separate_cubes(std::size_t count) {
  MeshMaker maker;
  const auto side = static_cast<std::size_t>(std::cbrt(static_cast<double>(count))) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Point low(2.0 * static_cast<double>(i % side), 2.0 * static_cast<double>(i / side % side),
                    2.0 * static_cast<double>(i / side / side));
    maker.add_box(low, low + Point(1, 1, 1));
  }
  return maker.take();
}

Mesh nested_cubes(std::size_t count) {
  MeshMaker maker;
  for (std::size_t i = 1; i <= count; ++i) {
    const auto half = static_cast<double>(i);
    maker.add_box({-half, -half, -half}, {half, half, half});
  }
  return maker.take();
}

// A cylinder with one polygon for each cap.
Mesh cylinder(std::size_t sides) {
  std::vector<Point> points;
  Faces faces;
  std::vector<std::uint32_t> lower, upper;
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    for (const double z : {0.0, 100.0}) points.emplace_back(std::cos(angle), std::sin(angle), z);
    faces.push_back({2 * i, 2 * ((i + 1) % n), 2 * ((i + 1) % n) + 1, 2 * i + 1});
    lower.insert(lower.begin(), 2 * i);
    upper.push_back(2 * i + 1);
  }
  faces.push_back(lower);
  faces.push_back(upper);
  MeshMaker maker;
  maker.add(points, faces);
  return maker.take();
}

// One polygon: there along a spiral, and back beside it.
Mesh spiral(std::size_t corners) {
  std::vector<Point> points;
  std::vector<std::uint32_t> face;
  const auto at = [&](std::size_t i, double out) {
    const double angle = 0.1 * static_cast<double>(i), far = 1 + 0.2 * angle + out;
    face.push_back(static_cast<std::uint32_t>(points.size()));
    points.emplace_back(far * std::cos(angle), far * std::sin(angle), 0);
  };
  for (std::size_t i = 0; i < corners / 2; ++i) at(i, 0);
  for (std::size_t i = corners / 2; i-- > 0;) at(i, 0.5);
  MeshMaker maker;
  maker.add(points, {face});
  return maker.take();
}

void volume_of(benchmark::State& state, const Mesh& mesh) {
  const Surface surface = make_surface(mesh);
  for (auto _ : state) benchmark::DoNotOptimize(solid_volume(surface, 96, false));
}

void clusters_of(benchmark::State& state, const Mesh& mesh) {
  const Surface surface = make_surface(mesh);
  for (auto _ : state) benchmark::DoNotOptimize(cluster(surface, {.every_merge = false}));
}

void surface_of(benchmark::State& state, const Mesh& mesh) {
  for (auto _ : state) benchmark::DoNotOptimize(make_surface(mesh));
}

void distance_of(benchmark::State& state, const Mesh& mesh) {
  const Surface surface = make_surface(mesh, {.orient = Orient::Keep});
  const Winding winding(surface);
  std::vector<ConvexPart> parts;
  for (std::uint32_t i = 0; i < mesh.points.size(); i += 8) {
    std::vector<PointId> corners;
    for (std::uint32_t k = 0; k < 8; ++k) corners.emplace_back(i + k);
    parts.push_back(convex_part(subset(mesh.points, corners)));
  }
  const Rational diameter = bounding_box(mesh.points).squared_diameter();
  for (auto _ : state) {
    benchmark::DoNotOptimize(union_to_surface(parts, surface, &winding, diameter));
  }
}

}  // namespace

void register_growth_bench() {
  struct Growth {
    const char* what;
    Mesh (*mesh)(std::size_t size);
    void (*run)(benchmark::State& state, const Mesh& mesh);
    std::size_t size;
  };
  for (const Growth& g : {Growth{"volume-overlapping-boxes", overlapping_boxes, volume_of, 10},
                          Growth{"volume-equal-cubes", equal_cubes, volume_of, 75},
                          Growth{"volume-separate-cubes", separate_cubes, volume_of, 500},
                          Growth{"clusters-cylinder", cylinder, clusters_of, 256},
                          Growth{"surface-spiral-polygon", spiral, surface_of, 1000},
                          Growth{"distance-nested-cubes", nested_cubes, distance_of, 6}}) {
    for (const std::size_t size : {g.size, 4 * g.size}) {
      const std::string name = std::string("growth/") + g.what + "/" + std::to_string(size);
      benchmark::RegisterBenchmark(name.c_str(), [g, size](benchmark::State& state) {
        g.run(state, g.mesh(size));
      })->Unit(benchmark::kMillisecond);
    }
  }
}
