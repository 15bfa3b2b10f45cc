// SPDX-License-Identifier: MIT
// A surface laid over convex parts, and volumes of unions: parts of a mesh by a grid, against
// CGAL's n-ary union of Nef polyhedra; and random solids of which each overlaps some ten others,
// for the growth with their number.
#include <benchmark/benchmark.h>

#include <cmath>

#include "benches.hpp"
#include "convexact/overlay.hpp"
#include "grid_parts.hpp"
#include "number/random.hpp"
#ifdef CONVEXACT_HAVE_CGAL
#include "nef_union.hpp"
#endif

using namespace convexact;

namespace {

constexpr long kBits = 128;

void union_of(benchmark::State& state, const std::vector<ConvexPart>& parts) {
  for (auto _ : state) benchmark::DoNotOptimize(union_volume(parts, kBits, false));
  state.counters["parts"] = static_cast<double>(parts.size());
}

#ifdef CONVEXACT_HAVE_CGAL
// The solids are ready; their volume is not asked for.
void union_by_nef(benchmark::State& state, const std::vector<ConvexPart>& parts) {
  std::vector<NefPolyhedron> solids;
  for (const ConvexPart& part : parts) {
    if (part.solid) solids.push_back(to_nef(part));
  }
  for (auto _ : state) benchmark::DoNotOptimize(nef_union(solids));
}
#endif

void cover(benchmark::State& state, const Surface& surface, const std::vector<ConvexPart>& parts) {
  std::size_t pieces = 0;
  for (auto _ : state) pieces = find_uncovered(surface, parts).uncovered.size();
  state.counters["triangles"] = static_cast<double>(surface.triangles.size());
  state.counters["pieces"] = static_cast<double>(pieces);
}

void cover_solid(benchmark::State& state, const Surface& surface,
                 const std::vector<ConvexPart>& parts) {
  const Winding winding(surface);
  for (auto _ : state) {
    benchmark::DoNotOptimize(uncovered_volume(surface, winding, parts, kBits, false));
  }
}

// Hulls of 24 points in balls of radius 1 about random places in a cube with a volume of 3 for
// each: some ten others are within a distance of 2 of each.
std::vector<ConvexPart> overlapping_parts(std::size_t count) {
  Random random(17);
  const double side = std::cbrt(3.0 * static_cast<double>(count));
  std::vector<ConvexPart> parts;
  for (std::size_t i = 0; i < count; ++i) {
    Point place;
    for (double& x : place) x = side * uniform_unit(random);
    std::vector<Point> points = shapes::in_ball(24, i + 1);
    for (Point& p : points) p += place;
    parts.push_back(convex_part(PointSet(points)));
  }
  return parts;
}

}  // namespace

void register_overlay_bench(const std::vector<std::string>& meshes) {
  using benchmark::kMillisecond;
  using benchmark::RegisterBenchmark;
  for (const std::string& path : meshes) {
    const std::string file = path.substr(path.find_last_of('/') + 1);
    const std::string name = "overlay/" + file.substr(0, file.find('.'));
    const Mesh mesh = read_mesh(path);
    const Surface surface = make_surface(mesh);
    const std::vector<ConvexPart> parts = grid_parts(mesh, 3, 0);
    const auto add = [&](const char* what, auto run) {
      RegisterBenchmark((name + "/" + what).c_str(), run)->Unit(kMillisecond);
    };
    add("union", [=](benchmark::State& state) { union_of(state, parts); });
#ifdef CONVEXACT_HAVE_CGAL
    add("nef-union", [=](benchmark::State& state) { union_by_nef(state, parts); });
#endif
    const std::vector<ConvexPart> half(parts.begin(), parts.begin() + parts.size() / 2);
    add("surface", [=](benchmark::State& state) { cover(state, surface, parts); });
    add("surface-half", [=](benchmark::State& state) { cover(state, surface, half); });
    if (!surface.is_closed) continue;
    add("solid-half", [=](benchmark::State& state) { cover_solid(state, surface, half); });
  }
  for (const std::size_t count : {24u, 100u, 1000u}) {
    RegisterBenchmark(("overlay/union-growth/" + std::to_string(count)).c_str(),
                      [=](benchmark::State& state) { union_of(state, overlapping_parts(count)); })
        ->Unit(kMillisecond);
  }
}
