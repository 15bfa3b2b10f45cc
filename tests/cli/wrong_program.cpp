// SPDX-License-Identifier: MIT
// A program that is wrong on purpose: wrong_program MODE INPUT FACES OUTPUT. Unless its mode says
// otherwise it writes the hull of the input, and refuses inputs without volume.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "convexact/io.hpp"
#include "shapes/makers.hpp"

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

// The right points, but a single tetrahedron between the first ones that span a volume as faces.
void keep_one_tetrahedron(Mesh& mesh) {
  const HullOutcome outcome = convex_hull(mesh.points);
  const auto& s = std::get<Hull>(outcome).certificate.simplex;
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  const Point middle =
      (points[s[0].index()] + points[s[1].index()] + points[s[2].index()] + points[s[3].index()]) /
      4;
  const auto first = static_cast<std::uint32_t>(points.size());
  for (const PointId corner : s) points.push_back((points[corner.index()] + middle) / 2);
  const RationalPoint a = to_rational(points[first]), b = to_rational(points[first + 1]),
                      c = to_rational(points[first + 2]), d = to_rational(points[first + 3]);
  const RationalVector3 u = b - a, v = c - a, w = d - a;
  mesh.points = PointSet(points);
  mesh.polygons = {{first, first + 2, first + 1},
                   {first, first + 1, first + 3},
                   {first + 1, first + 2, first + 3},
                   {first + 2, first, first + 3}};
  if (u.cross(v).dot(w) > 0) return;
  for (auto& polygon : mesh.polygons) std::reverse(polygon.begin(), polygon.end());
}

// One tetrahedron around everything, with 100 times the size of the input to spare.
Mesh huge_tetrahedron(const PointSet& points) {
  Point low = points.doubles()[0], high = low;
  for (const Point& p : points.doubles()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = 100 * (high - low).maxCoeff();
  const Point corner = low - Point(size, size, size);
  Mesh mesh;
  mesh.points =
      PointSet(std::vector<Point>{corner, corner + Point(9 * size, 0, 0),
                                  corner + Point(0, 9 * size, 0), corner + Point(0, 0, 9 * size)});
  mesh.polygons = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

// The points of an OBJ, whatever its faces say.
PointSet points_of_obj(const std::string& path) {
  std::ifstream stream(path);
  std::vector<Point> points;
  for (std::string line; std::getline(stream, line);) {
    Point p;
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &p[0], &p[1], &p[2]) == 3) points.push_back(p);
  }
  return PointSet(points);
}

// The shortest text that gives the same binary32 number, nine digits: another double.
std::string in_nine_digits(const Mesh& mesh) {
  std::string text;
  char line[128];
  for (const Point& p : mesh.points.doubles()) {
    std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", p.x(), p.y(), p.z());
    text += line;
  }
  for (const auto& polygon : mesh.polygons) {
    text += "f";
    for (const std::uint32_t corner : polygon) text += " " + std::to_string(corner + 1);
    text += "\n";
  }
  return text;
}

// Half of the size, about the middle of two points.
void shrink_by_half(Mesh& mesh) {
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  const Point middle = (points.front() + points.back()) / 2;
  for (Point& p : points) p = (p + middle) / 2;
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
    mesh = hull_of(mode == "points-only" ? points_of_obj(input) : read_mesh(input).points);
  } catch (const Error&) {
    if (mode != "accept") return 3;
  }
  if (!mesh && mode == "accept") mesh = hull_of(PointSet(shapes::box({1, 1, 1})));
  if (!mesh) return 4;
  if (mode == "cut-off") lower_the_top(*mesh);
  if (mode == "inner-faces") keep_one_tetrahedron(*mesh);
  if (mode == "half") shrink_by_half(*mesh);
  if (mode == "huge") mesh = huge_tetrahedron(mesh->points);
  if (mode == "nine-digits") return write(output, in_nine_digits(*mesh)), 0;
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
