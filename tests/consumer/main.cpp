// SPDX-License-Identifier: MIT
// The smallest program that uses the installed library: the hull of a cube and its center point.
#include <convexact/hull/hull.hpp>
#include <iostream>

int main() {
  std::vector<convexact::Point> points{{0.5, 0.5, 0.5}};
  for (int corner = 0; corner < 8; ++corner) points.push_back({corner & 1, corner >> 1 & 1, corner >> 2});
  const auto outcome = convexact::convex_hull(convexact::PointSet(points));
  const auto& hull = std::get<convexact::Hull>(outcome);
  std::cout << hull.vertices.size() << " vertices, " << hull.facets.size() << " facets\n";
}
