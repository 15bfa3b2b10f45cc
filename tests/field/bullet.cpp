// SPDX-License-Identifier: MIT
// Bullet as a program of ./dev field: bullet hull|shape INPUT.obj OUTPUT.obj
// hull is btConvexHullComputer, shape is btShapeHull (42 directions). Built once with binary32,
// once with binary64. The seconds of the library's own call go to OUTPUT.obj.json.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btShapeHull.h>
#include <LinearMath/btConvexHullComputer.h>

#include <chrono>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

std::vector<btVector3> read_points(const char* path) {
  std::vector<btVector3> points;
  std::ifstream in(path);
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream words(line);
    double x, y, z;
    if (words >> word && word == "v" && words >> x >> y >> z) {
      points.emplace_back(btScalar(x), btScalar(y), btScalar(z));
    }
  }
  return points;
}

void print_point(std::ofstream& out, const btVector3& point) {
  out << "v " << point.x() << ' ' << point.y() << ' ' << point.z() << '\n';
}

using Clock = std::chrono::steady_clock;
double seconds = 0;

void stop(Clock::time_point start) {
  seconds = std::chrono::duration<double>(Clock::now() - start).count();
}

bool write_hull(const std::vector<btVector3>& points, std::ofstream& out) {
  btConvexHullComputer hull;
  const auto start = Clock::now();
  hull.compute(&points[0].x(), sizeof(btVector3), int(points.size()), 0, 0);
  stop(start);
  for (int k = 0; k < hull.vertices.size(); ++k) print_point(out, hull.vertices[k]);
  for (int f = 0; f < hull.faces.size(); ++f) {
    const btConvexHullComputer::Edge* const first = &hull.edges[hull.faces[f]];
    const btConvexHullComputer::Edge* edge = first;
    out << 'f';
    do {
      out << ' ' << edge->getSourceVertex() + 1;
      edge = edge->getNextEdgeOfFace();
    } while (edge != first);
    out << '\n';
  }
  return hull.faces.size() > 0;
}

bool write_shape(const std::vector<btVector3>& points, std::ofstream& out) {
  btConvexHullShape shape(&points[0].x(), int(points.size()), sizeof(btVector3));
  shape.setMargin(0);
  btShapeHull hull(&shape);
  const auto start = Clock::now();
  if (!hull.buildHull(0)) return false;
  stop(start);
  for (int k = 0; k < hull.numVertices(); ++k) print_point(out, hull.getVertexPointer()[k]);
  const unsigned int* corner = hull.getIndexPointer();
  for (int t = 0; t < hull.numTriangles(); ++t, corner += 3) {
    out << "f " << corner[0] + 1 << ' ' << corner[1] + 1 << ' ' << corner[2] + 1 << '\n';
  }
  return hull.numTriangles() > 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  const std::vector<btVector3> points = read_points(arguments[2]);
  if (points.empty()) return 4;
  std::ofstream out(arguments[3]);
  out.precision(std::numeric_limits<btScalar>::max_digits10);
  const bool found =
      std::string(arguments[1]) == "hull" ? write_hull(points, out) : write_shape(points, out);
  std::ofstream(std::string(arguments[3]) + ".json") << "{\"seconds\": " << seconds << "}\n";
  return found ? 0 : 4;
}
