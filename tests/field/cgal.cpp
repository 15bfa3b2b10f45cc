// SPDX-License-Identifier: MIT
// CGAL's convex_hull_3 and oriented_bounding_box as programs of ./dev field:
// cgal doubles|exact-predicates|box INPUT.obj OUTPUT.obj
// The seconds of the library's own call go to OUTPUT.obj.json.
#define CGAL_EIGEN3_ENABLED
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/optimal_bounding_box.h>

#include <array>
#include <chrono>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

template <class Point>
std::vector<Point> read_points(const char* input) {
  std::vector<Point> points;
  std::ifstream in(input);
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream words(line);
    double x, y, z;
    if (words >> word && word == "v" && words >> x >> y >> z) points.emplace_back(x, y, z);
  }
  return points;
}

// Makes a surface of the points by `call`, and writes it; 4 if it has no volume.
template <class Point, class Call>
int run(const char* input, const char* output, Call call) {
  const std::vector<Point> points = read_points<Point>(input);
  CGAL::Surface_mesh<Point> surface;
  const auto start = std::chrono::steady_clock::now();
  call(points, surface);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  std::ofstream(std::string(output) + ".json") << "{\"seconds\": " << passed.count() << "}\n";
  std::ofstream out(output);
  out.precision(17);
  for (const auto vertex : surface.vertices()) out << "v " << surface.point(vertex) << '\n';
  for (const auto face : surface.faces()) {
    out << 'f';
    for (const auto vertex : vertices_around_face(surface.halfedge(face), surface))
      out << ' ' << vertex.idx() + 1;
    out << '\n';
  }
  return surface.number_of_faces() > 3 ? 0 : 4;
}

const auto hull = [](const auto& points, auto& surface) {
  CGAL::convex_hull_3(points.begin(), points.end(), surface);
};

const auto box = [](const auto& points, auto& surface) {
  std::array<typename std::decay_t<decltype(points)>::value_type, 8> corners;
  CGAL::oriented_bounding_box(points, corners);
  CGAL::make_hexahedron(corners[0], corners[1], corners[2], corners[3], corners[4], corners[5],
                        corners[6], corners[7], surface);
};

}  // namespace

int main(int count, char** arguments) {
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  if (count != 4) return 2;
  const std::string mode = arguments[1];
  if (mode == "box") return run<Exact>(arguments[2], arguments[3], box);
  return mode == "doubles"
             ? run<CGAL::Simple_cartesian<double>::Point_3>(arguments[2], arguments[3], hull)
             : run<Exact>(arguments[2], arguments[3], hull);
}
