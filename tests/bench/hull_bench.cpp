// SPDX-License-Identifier: MIT
// The hull against CGAL (exact predicates, inexact constructions) and Qhull, in one run. Reading
// and converting the points is not timed; the time of our hull includes the certificate; checking
// it is timed separately.
#include <benchmark/benchmark.h>

#include "benches.hpp"
#include "convexact/hull.hpp"

#ifdef CONVEXACT_HAVE_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#endif
#ifdef CONVEXACT_HAVE_QHULL
extern "C" {
#include <libqhull_r/qhull_ra.h>
}
#endif

using namespace convexact;

namespace {

void hull(benchmark::State& state, const std::vector<Point>& points) {
  const PointSet set(points);
  std::size_t facets = 0;
  for (auto _ : state) facets = std::get<Hull>(convex_hull(set)).facets.size();
  state.counters["facets"] = static_cast<double>(facets);
}

void certificate(benchmark::State& state, const std::vector<Point>& points) {
  const PointSet set(points);
  const Hull hull = std::get<Hull>(convex_hull(set));
  for (auto _ : state) {
    if (!check_hull(hull, set)) state.SkipWithError("the hull is wrong");
  }
}

#ifdef CONVEXACT_HAVE_CGAL
void cgal(benchmark::State& state, const std::vector<Point>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> list;
  for (const Point& p : points) list.emplace_back(p.x(), p.y(), p.z());
  std::size_t facets = 0;
  for (auto _ : state) {
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    CGAL::convex_hull_3(list.begin(), list.end(), mesh);
    facets = mesh.number_of_faces();
  }
  state.counters["facets"] = static_cast<double>(facets);
}
#endif

#ifdef CONVEXACT_HAVE_QHULL
void qhull(benchmark::State& state, const std::vector<Point>& points) {
  std::vector<double> coordinates;
  for (const Point& p : points) coordinates.insert(coordinates.end(), p.data(), p.data() + 3);
  std::string command = "qhull";
  int facets = 0;
  for (auto _ : state) {
    qhT qh;
    QHULL_LIB_CHECK
    qh_zero(&qh, nullptr);
    if (qh_new_qhull(&qh, 3, static_cast<int>(points.size()), coordinates.data(), False,
                     command.data(), nullptr, nullptr) != 0) {
      state.SkipWithError("qhull failed");
    }
    facets = qh.num_facets;
    int still_used = 0, pieces = 0;
    qh_freeqhull(&qh, qh_ALL);
    qh_memfreeshort(&qh, &still_used, &pieces);
  }
  state.counters["facets"] = facets;
}
#endif

}  // namespace

void register_hull_bench(const std::vector<BenchInput>& inputs) {
  const auto add = [](const BenchInput& input, const char* what, auto* function) {
    benchmark::RegisterBenchmark((input.name + "/" + what).c_str(), function, input.points)
        ->Unit(benchmark::kMillisecond);
  };
  for (const BenchInput& input : inputs) {
    add(input, "hull", hull);
    add(input, "check", certificate);
#ifdef CONVEXACT_HAVE_CGAL
    add(input, "cgal", cgal);
#endif
#ifdef CONVEXACT_HAVE_QHULL
    add(input, "qhull", qhull);
#endif
  }
}
