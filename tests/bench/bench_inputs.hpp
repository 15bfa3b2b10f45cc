// SPDX-License-Identifier: MIT
// bench_inputs.hpp - the point sets that benchmarks run on.
#pragma once
#include <cstdlib>
#include <string>
#include <vector>

#include "convexact/io.hpp"
#include "shapes/makers.hpp"

struct BenchInput {
  std::string name;
  std::vector<convexact::Point> points;
  bool exact_too;  ///< Small enough for the exact engine.
};

/// The shipped meshes in the folder $CONVEXACT_TEST_DATA, and further files named in
/// $CONVEXACT_BENCH_MESHES (separated by colons).
inline std::vector<std::string> bench_meshes() {
  std::vector<std::string> paths;
  if (const char* folder = std::getenv("CONVEXACT_TEST_DATA")) {
    for (const char* mesh : {"bunny.obj", "spot.obj", "teapot.obj"}) {
      paths.push_back(std::string(folder) + "/" + mesh);
    }
  }
  if (const char* files = std::getenv("CONVEXACT_BENCH_MESHES")) {
    const std::string list(files);
    for (std::size_t begin = 0; begin < list.size();) {
      const std::size_t end = std::min(list.find(':', begin), list.size());
      paths.push_back(list.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  return paths;
}

/// The points of bench_meshes(); then spheres, a rounded box and a cylinder.
inline std::vector<BenchInput> bench_inputs() {
  std::vector<BenchInput> inputs;
  const auto add_mesh = [&](const std::string& path) {
    const convexact::Mesh mesh = convexact::read_mesh(path);
    const auto points = mesh.points.doubles();
    const std::string file = path.substr(path.find_last_of('/') + 1);
    inputs.push_back({file.substr(0, file.find('.')), {points.begin(), points.end()}, true});
  };
  for (const std::string& path : bench_meshes()) add_mesh(path);
  for (const std::uint32_t n : {1'000u, 10'000u, 50'000u, 100'000u, 200'000u}) {
    inputs.push_back(
        {"sphere" + std::to_string(n), convexact::shapes::fibonacci_sphere(n), n <= 1000});
  }
  inputs.push_back({"rounded_box", convexact::shapes::rounded_box({3, 2, 1}, 0.5, 16), true});
  inputs.push_back({"cylinder1000", convexact::shapes::cylinder(1000, 3), true});
  return inputs;
}
