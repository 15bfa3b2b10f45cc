// SPDX-License-Identifier: MIT
#include "report/scaling.hpp"

#include <algorithm>
#include <numeric>

#include "number/random.hpp"
#include "shapes/random_points.hpp"

namespace convexact {
namespace {

// The times of repeated runs on one input.
struct Sample {
  std::size_t points = 0, halfspaces = 0;
  Spread hull, simplify;
};

double seconds_of(const std::vector<Stage>& stages, const std::string& name) {
  for (const Stage& stage : stages) {
    if (stage.name == name && stage.skipped.empty()) return stage.seconds;
  }
  return 0;
}

// None if the set is flat or the time was up.
std::optional<Sample> sample(const PointSet& points, Engine engine, const Effort& effort) {
  std::vector<double> hull, removals;
  Sample result;
  const auto whole = time_repeatedly(effort, [&](Deadline& deadline) {
    SimplifyRequest request;
    request.faces = 4;
    request.engine = engine;
    request.seed = effort.seed;
    request.watch = deadline.watch();
    const SimplifyOutcome outcome = simplify(points, request);
    const auto* solid = std::get_if<SimplifyResult>(&outcome);
    if (solid == nullptr) return;
    result.halfspaces = solid->input_halfspaces;
    hull.push_back(seconds_of(solid->stages, "hull"));
    removals.push_back(seconds_of(solid->stages, "simplify"));
  });
  if (!whole || hull.empty()) return std::nullopt;
  result.points = points.size();
  result.hull = spread_of(hull);
  result.simplify = spread_of(removals);
  return result;
}

// Through the least times, since other work of the machine can only add to them.
void fit(ScalingSeries& series) {
  std::vector<std::pair<double, double>> points;
  for (const auto& [size, seconds] : series.points) {
    if (seconds.least > 0) points.push_back({static_cast<double>(size), seconds.least});
  }
  series.law = fit_power_law(points);
}

}  // namespace

std::vector<PointSet> nested_subsets(const PointSet& points, std::size_t least,
                                     std::uint64_t seed) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random(seed);
  shuffle(std::span<std::size_t>(order), random);
  std::vector<PointSet> sets;
  for (std::size_t n = points.size(); n >= std::max<std::size_t>(least, 4); n /= 2) {
    std::vector<RationalPoint> subset;
    for (std::size_t i = 0; i < n; ++i) subset.push_back(points[PointId(order[i])]);
    sets.emplace_back(std::move(subset));
  }
  std::reverse(sets.begin(), sets.end());
  return sets;
}

std::vector<PointSet> growing_spheres(std::size_t least, std::size_t most, std::uint64_t seed) {
  std::vector<PointSet> sets;
  for (std::size_t n = least; n <= most; n *= 2) {
    sets.emplace_back(shapes::on_sphere(static_cast<std::uint32_t>(n), seed));
  }
  return sets;
}

std::vector<ScalingSeries> measure_scaling(const std::vector<PointSet>& sets,
                                           const Effort& effort) {
  std::vector<ScalingSeries> list{{"hull", "hull", "points", {}, {}}};
  const std::pair<const char*, Engine> engines[] = {
      {"float", Engine::Float}, {"filtered", Engine::Filtered}, {"exact", Engine::Exact}};
  for (const auto& [name, engine] : engines) {
    ScalingSeries series{"simplify", name, "halfspaces", {}, {}};
    for (const PointSet& set : sets) {
      if (effort.progress) {
        effort.progress("size " + std::to_string(set.size()) + " by " + name);
      }
      const std::optional<Sample> found = sample(set, engine, effort);
      if (!found) continue;
      series.points.push_back({found->halfspaces, found->simplify});
      // Every engine begins with the same hull, so the hull of one of them is timed.
      if (engine == Engine::Filtered) list.front().points.push_back({found->points, found->hull});
      if (found->simplify.median > effort.budget / 10) break;
    }
    fit(series);
    list.push_back(std::move(series));
  }
  fit(list.front());
  return list;
}

}  // namespace convexact
