// SPDX-License-Identifier: MIT
// The oriented box of `convexact compare` against CGAL's, of the same hulls in one run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "benches.hpp"
#include "lab/compare/method.hpp"
#ifdef CONVEXACT_HAVE_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/optimal_bounding_box.h>
#endif

using namespace convexact;

namespace {

Solid solid_of_points(const std::vector<Point>& points) {
  StageLog log;
  return std::get<Solid>(make_solid(PointSet(points), {}, log));
}

// Of the box with these three orthogonal directions around the vertices, in their unit.
double box_volume(const std::array<Point, 3>& directions, const std::vector<Point>& vertices) {
  double volume = 1;
  for (const Point& direction : directions) {
    double low = vertices.front().dot(direction), high = low;
    for (const Point& vertex : vertices) {
      low = std::min(low, vertex.dot(direction));
      high = std::max(high, vertex.dot(direction));
    }
    volume *= (high - low) / direction.norm();
  }
  return volume;
}

void oriented_box(benchmark::State& state, const std::vector<Point>& points) {
  const Solid solid = solid_of_points(points);
  const HullToFit hull = hull_to_fit(solid);
  Normals normals;
  for (auto _ : state) normals = propose_obb(hull, 6, 1);
  // Each direction and its opposite.
  std::vector<Point> axes;
  for (const RationalVector3& normal : normals) {
    const Point axis = normal.cast<double>();
    const auto is_axis = [&](const Point& other) {
      return std::abs(axis.dot(other)) > 0.5 * axis.norm() * other.norm();
    };
    if (std::none_of(axes.begin(), axes.end(), is_axis)) axes.push_back(axis);
  }
  state.counters["volume"] = box_volume({axes.at(0), axes.at(1), axes.at(2)}, hull.vertices);
}

#ifdef CONVEXACT_HAVE_CGAL
void cgal_oriented_box(benchmark::State& state, const std::vector<Point>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const Solid solid = solid_of_points(points);
  const HullToFit hull = hull_to_fit(solid);
  std::vector<Kernel::Point_3> list;
  for (const Point& p : hull.vertices) list.emplace_back(p.x(), p.y(), p.z());
  std::array<Kernel::Point_3, 8> corners;
  for (auto _ : state) {
    CGAL::oriented_bounding_box(list, corners, CGAL::parameters::use_convex_hull(false));
  }
  // Corners 1, 3 and 5 are next to corner 0.
  const auto edge = [&](std::size_t k) {
    const auto vector = corners[k] - corners[0];
    return Point(vector.x(), vector.y(), vector.z());
  };
  state.counters["volume"] = box_volume({edge(1), edge(3), edge(5)}, hull.vertices);
}
#endif

}  // namespace

void register_box_bench(const std::vector<BenchInput>& inputs) {
  for (const BenchInput& input : inputs) {
    if (!input.exact_too) continue;
    benchmark::RegisterBenchmark((input.name + "/obb").c_str(), oriented_box, input.points)
        ->Unit(benchmark::kMillisecond);
#ifdef CONVEXACT_HAVE_CGAL
    benchmark::RegisterBenchmark((input.name + "/cgal-obb").c_str(), cgal_oriented_box,
                                 input.points)
        ->Unit(benchmark::kMillisecond);
#endif
  }
}
