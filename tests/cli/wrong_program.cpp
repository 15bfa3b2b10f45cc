// SPDX-License-Identifier: MIT
// A program that is wrong on purpose: wrong_program MODE INPUT FACES OUTPUT. Unless its mode says
// otherwise it writes the hull of the input, and refuses inputs without volume.
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>

#include "convexact/error.hpp"
#include "convexact/hull/hull.hpp"
#include "convexact/io/read_mesh.hpp"
#include "convexact/io/write_mesh.hpp"
#include "convexact/shapes/boxes.hpp"

using namespace convexact;

namespace {

// Vertices and facets of the hull; nothing for points without volume.
std::optional<Mesh> hull_of(const PointSet& points) {
  const HullOutcome outcome = convex_hull(points);
  const auto* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return std::nullopt;
  Mesh mesh;
  mesh.points = points;
  for (std::size_t f = 0; f < hull->facets.size(); ++f) {
    auto& polygon = mesh.polygons.emplace_back();
    for (const PointId corner : hull->facets[f]) polygon.push_back(corner.value);
  }
  return mesh;
}

// The hull with each copy of its highest vertex one ulp lower.
void lower_the_top(Mesh& mesh) {
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  double top = -std::numeric_limits<double>::infinity();
  for (const Point& p : points) top = std::max(top, p.z());
  for (Point& p : points) {
    if (p.z() == top) p.z() = std::nextafter(top, -std::numeric_limits<double>::infinity());
  }
  mesh.points = PointSet(points);
}

void use_all_memory() {
  for (std::size_t total = 0;; total += 1 << 24) {
    char* block = new char[1 << 24];
    std::memset(block, 1, 1 << 24);
    if (block[total % 100] == 2) std::cout << "never";  // so that the blocks are not left out
  }
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

int run(const std::string& mode, const std::string& input, const std::string& output) {
  if (mode == "crash") std::raise(SIGSEGV);
  if (mode == "hang") pause();
  if (mode == "memory") use_all_memory();
  if (mode == "exit") return 9;
  if (mode == "no-output") return 0;
  if (mode == "empty-output") return write(output, ""), 0;
  if (mode == "noise") return write(output, "solid \x01\x02 no mesh\n"), 0;
  if (mode == "nan") return write(output, "v nan 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"), 0;
  std::optional<Mesh> mesh;
  try {
    mesh = hull_of(read_mesh(input).points);
  } catch (const Error&) {
    if (mode != "accept") return 3;
  }
  if (!mesh && mode == "accept") mesh = hull_of(PointSet(shapes::box({1, 1, 1})));
  if (!mesh) return 4;
  if (mode == "cut-off") lower_the_top(*mesh);
  if (mode == "hole") mesh->polygons.pop_back();
  if (mode == "inside-out") {
    for (auto& polygon : mesh->polygons) std::reverse(polygon.begin(), polygon.end());
  }
  write(output, write_mesh(*mesh, MeshFormat::Obj));
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) return 2;
  return run(words[1], words[2], words[4]);
}
