// SPDX-License-Identifier: MIT
// CGAL's convex_hull_3 as a program of ./dev field: cgal doubles|exact-predicates INPUT.obj
// OUTPUT.obj
// The seconds of the library's own call go to OUTPUT.obj.json.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

template <class Kernel>
int run(const char* input, const char* output) {
  using Point = typename Kernel::Point_3;
  std::vector<Point> points;
  std::ifstream in(input);
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream words(line);
    double x, y, z;
    if (words >> word && word == "v" && words >> x >> y >> z) points.emplace_back(x, y, z);
  }
  CGAL::Surface_mesh<Point> hull;
  const auto start = std::chrono::steady_clock::now();
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  std::ofstream(std::string(output) + ".json") << "{\"seconds\": " << passed.count() << "}\n";
  std::ofstream out(output);
  out.precision(17);
  for (const auto vertex : hull.vertices()) out << "v " << hull.point(vertex) << '\n';
  for (const auto face : hull.faces()) {
    out << 'f';
    for (const auto vertex : vertices_around_face(hull.halfedge(face), hull))
      out << ' ' << vertex.idx() + 1;
    out << '\n';
  }
  return hull.number_of_faces() > 3 ? 0 : 4;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  return std::string(arguments[1]) == "doubles"
             ? run<CGAL::Simple_cartesian<double>>(arguments[2], arguments[3])
             : run<CGAL::Exact_predicates_inexact_constructions_kernel>(arguments[2], arguments[3]);
}
