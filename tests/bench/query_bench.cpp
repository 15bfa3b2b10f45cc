// SPDX-License-Identifier: MIT
// Queries against solids of few and of many halfspaces: what a proxy of k planes saves. Pairs,
// rays and lines are the same for every k.
#include <benchmark/benchmark.h>

#include <cmath>

#include "benches.hpp"
#include "convexact/measure.hpp"
#include "convexact/query.hpp"
#include "convexact/simplify.hpp"
#include "number/random.hpp"
#include "query/probed_solid.hpp"

using namespace convexact;

namespace {

constexpr std::size_t kPairs = 16, kRays = 256;

// The hull of an input, or its proxy of k halfspaces; the box of the hull.
struct QuerySolid {
  Polytope solid;
  BoundingBox box;
};

QuerySolid solid_for_queries(const PointSet& points, std::size_t faces) {
  SimplifyRequest request;
  request.faces = faces;
  const SimplifyOutcome outcome = simplify(Shape(points), request);
  return {std::get<SimplifyResult>(outcome).solid.exact, bounding_box(points)};
}

Point direction(Random& random) {
  while (true) {
    const Point u(2 * uniform_unit(random) - 1, 2 * uniform_unit(random) - 1,
                  2 * uniform_unit(random) - 1);
    const double length = u.norm();
    if (length > 0.1 && length <= 1) return u / length;
  }
}

Polytope moved_by(const Polytope& solid, const RationalVector3& by) {
  Polytope moved = solid;
  for (RationalPoint& v : moved.vertices) v += by;
  for (Halfspace& plane : moved.planes) {
    const RationalVector3 normal = plane.normal().cast<Rational>();
    plane = Halfspace(normal, Rational(Rational(plane.offset()) - normal.dot(by)));
  }
  return moved;
}

double size_of(const BoundingBox& box) {
  return std::sqrt(to_double(box.squared_diameter(), Rounding::Nearest));
}

// Each iteration asks all of a list. The counter "query" is the processor time of one of them,
// "yes" the share of those that hit or overlap.
template <class Query, class Ask>
void ask_all(benchmark::State& state, const Polytope& solid, const std::vector<Query>& queries,
             Ask&& ask) {
  std::size_t yes = 0;
  for (auto _ : state) {
    yes = 0;
    for (const Query& query : queries) yes += ask(query);
  }
  const auto count = static_cast<double>(queries.size());
  state.counters["halfspaces"] = static_cast<double>(solid.planes.size());
  state.counters["yes"] = static_cast<double>(yes) / count;
  state.counters["query"] = benchmark::Counter(
      count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// The solid against copies of it, moved by 0.3 to 0.8 of the diameter of the hull's box.
void overlaps(benchmark::State& state, const PointSet& points, std::size_t faces) {
  const QuerySolid made = solid_for_queries(points, faces);
  Random random(1);
  std::vector<Polytope> others;
  for (std::size_t i = 0; i < kPairs; ++i) {
    const double away = size_of(made.box) * (0.3 + 0.5 * uniform_unit(random));
    others.push_back(moved_by(made.solid, to_rational(Point(away * direction(random)))));
  }
  ask_all(state, made.solid, others, [&](const Polytope& other) {
    return std::holds_alternative<CommonPoint>(find_overlap(made.solid, other));
  });
}

// Lines through two points of a sphere around the box of the hull.
std::vector<ProbeLine> lines_around(const BoundingBox& box) {
  const RationalPoint middle = (box.low + box.high) / Rational(2);
  Point center;
  for (int k = 0; k < 3; ++k) center[k] = to_double(middle[k], Rounding::Nearest);
  Random random(2);
  std::vector<ProbeLine> lines;
  for (std::size_t i = 0; i < kRays; ++i) {
    const Point first = center + size_of(box) / 2 * direction(random);
    lines.push_back({first, center + size_of(box) / 2 * direction(random)});
  }
  return lines;
}

// Entry, exit and facets of rays as fractions.
void rays(benchmark::State& state, const PointSet& points, std::size_t faces) {
  const QuerySolid made = solid_for_queries(points, faces);
  std::vector<Ray> list;
  for (const ProbeLine& line : lines_around(made.box)) {
    list.push_back({to_rational(line.first), to_rational(Point(line.second - line.first))});
  }
  ask_all(state, made.solid, list,
          [&](const Ray& ray) { return cast_ray(made.solid, ray).is_hit(); });
}

// Whether lines hit, in doubles first.
void lines(benchmark::State& state, const PointSet& points, std::size_t faces) {
  const QuerySolid made = solid_for_queries(points, faces);
  const ProbeFrame frame = probe_frame(made.solid, made.solid);
  const ProbedSolid probed(made.solid, frame);
  Random random(2);
  std::vector<ProbeLine> list;
  for (std::size_t i = 0; i < kRays; ++i) {
    const Point first = frame.radius * direction(random);
    list.push_back({first, frame.radius * direction(random)});
  }
  ask_all(state, made.solid, list, [&](const ProbeLine& line) { return probed.is_hit(line); });
}

}  // namespace

void register_query_bench(const std::vector<BenchInput>& inputs) {
  constexpr std::size_t kAll = std::size_t(1) << 32;
  using Query = void (*)(benchmark::State&, const PointSet&, std::size_t);
  const std::pair<const char*, Query> queries[] = {
      {"overlap", overlaps}, {"ray", rays}, {"line", lines}};
  for (const BenchInput& input : inputs) {
    if (!input.exact_too) continue;
    const PointSet points(input.points);
    for (const auto& query : queries) {
      for (const std::size_t faces :
           {std::size_t(6), std::size_t(12), std::size_t(18), std::size_t(32), kAll}) {
        const std::string name = input.name + "/query-" + query.first + "/" +
                                 (faces == kAll ? "hull" : std::to_string(faces));
        benchmark::RegisterBenchmark(name.c_str(), query.second, points, faces)
            ->Unit(benchmark::kMicrosecond);
      }
    }
  }
}
