// SPDX-License-Identifier: MIT
// Facet normals in clusters: k-means, and the mean normal of each cluster.
#include <algorithm>
#include <cmath>

#include "lab/compare/method.hpp"
#include "near/near_plane.hpp"
#include "number/random.hpp"

namespace convexact {
namespace {

double squared_distance(const Point& a, const Point& b) {
  const double x = a.x() - b.x(), y = a.y() - b.y(), z = a.z() - b.z();
  return x * x + y * y + z * z;
}

// The unit normals of the facets. They have the same weight, whatever the areas of the facets.
std::vector<Point> unit_normals(const Polytope& hull) {
  std::vector<Point> normals;
  for (const Halfspace& plane : hull.planes) {
    const Point direction = scaled_direction(plane.normal());
    normals.push_back(direction / std::sqrt(squared_distance(direction, Point(0, 0, 0))));
  }
  return normals;
}

// k-means++: each further center is drawn with a chance that grows with the squared distance to
// the centers before it. Fewer than `count` if all normals are centers.
std::vector<Point> first_centers(const std::vector<Point>& normals, std::size_t count,
                                 Random& random) {
  std::vector<Point> centers{normals[uniform_below(random, normals.size())]};
  std::vector<double> distance(normals.size(), INFINITY);
  while (centers.size() < count) {
    double total = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      distance[i] = std::min(distance[i], squared_distance(normals[i], centers.back()));
      total += distance[i];
    }
    if (total == 0) break;
    double left = uniform_unit(random) * total;
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < normals.size() && left >= 0; ++i) {
      if (distance[i] > 0) drawn = i;  // so that rounding never draws a center again
      left -= distance[i];
    }
    centers.push_back(normals[drawn]);
  }
  return centers;
}

std::size_t nearest(const std::vector<Point>& centers, const Point& normal) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < centers.size(); ++k) {
    if (squared_distance(centers[k], normal) < squared_distance(centers[best], normal)) best = k;
  }
  return best;
}

}  // namespace

Normals propose_stl(const HullToFit& hull, std::size_t faces, std::uint64_t seed) {
  constexpr int kRounds = 100;
  const std::vector<Point> normals = unit_normals(hull.polytope());
  Random random(seed);
  std::vector<Point> centers = first_centers(normals, faces, random);
  for (int round = 0; round < kRounds; ++round) {
    hull.watch.ask();
    std::vector<Point> sums(centers.size(), Point(0, 0, 0));
    std::vector<double> sizes(centers.size(), 0);
    for (const Point& normal : normals) {
      const std::size_t k = nearest(centers, normal);
      sums[k] += normal;
      sizes[k] += 1;
    }
    bool has_moved = false;
    for (std::size_t k = 0; k < centers.size(); ++k) {
      if (sizes[k] == 0) continue;  // an empty cluster keeps its center
      const Point mean = sums[k] / sizes[k];
      has_moved = has_moved || mean != centers[k];
      centers[k] = mean;
    }
    if (!has_moved) break;
  }
  Normals directions;
  for (const Point& center : centers) {
    if (!center.isZero(0)) directions.push_back(to_rational(center));
  }
  return directions;
}

}  // namespace convexact
