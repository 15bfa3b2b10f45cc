// SPDX-License-Identifier: MIT
// The smallest program that uses the installed library: the hull of a cube and its center.
#include <convexact/hull.hpp>
#include <iostream>

int main() {
  std::vector<convexact::Point> points{{0.5, 0.5, 0.5}};
  for (const double x : {0, 1}) {
    for (const double y : {0, 1}) {
      for (const double z : {0, 1}) points.push_back({x, y, z});
    }
  }
  const auto outcome = convexact::convex_hull(convexact::PointSet(points));
  const auto& hull = std::get<convexact::Hull>(outcome);
  std::cout << hull.vertices.size() << " vertices, " << hull.facets.size() << " facets\n";
}
