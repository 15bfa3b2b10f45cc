// SPDX-License-Identifier: MIT
#include "lab/report/run_times.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"
#include "number/precision.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"
#include "simplify/run_names.hpp"
#include "solid/solid.hpp"

namespace convexact {
namespace {

constexpr std::array kQuickestFirst = {Engine::Float, Engine::Filtered, Engine::Exact};

SimplifyRequest request_for(Engine engine, std::size_t faces, const Effort& effort,
                            Deadline& deadline) {
  SimplifyRequest request;
  request.faces = faces;
  request.engine = engine;
  request.seed = effort.seed;
  request.jobs = 1;  // as all other methods, whose times stand beside it
  request.watch = deadline.watch();
  return request;
}

// The stages of repeated runs, in the order of the first one.
class Collected {
 public:
  void add(const std::vector<Stage>& stages) {
    for (const Stage& stage : stages) {
      if (times_.find(stage.name) == times_.end()) order_.push_back(stage);
      std::vector<double>& times = times_[stage.name];
      if (stage.skipped.empty()) times.push_back(stage.seconds);
    }
  }
  std::vector<StageTime> result() const {
    std::vector<StageTime> list;
    for (const Stage& stage : order_) {
      const std::vector<double>& seconds = times_.at(stage.name);
      if (seconds.empty()) {
        list.push_back({.name = stage.name, .seconds = {}, .skipped = stage.skipped});
      } else {
        list.push_back({.name = stage.name, .seconds = spread_of(seconds), .skipped = {}});
      }
    }
    return list;
  }

 private:
  std::vector<Stage> order_;
  std::map<std::string, std::vector<double>> times_;
};

// Times one kind of run; `work` runs it and returns its stages.
template <class Work>
RunTimes measure(const std::string& run, const Effort& effort, Work&& work) {
  if (effort.progress) effort.progress("stages of " + run);
  Collected collected;
  RunTimes times;
  times.run = run;
  times.seconds =
      time_repeatedly(effort, [&](Deadline& deadline) { collected.add(work(deadline)); });
  if (times.seconds) times.stages = collected.result();
  return times;
}

// The stages that simplify() skips for points, and the ones that it always skips, after it.
void run_the_rest(const Shape& shape, const SimplifyResult& result, const Effort& effort,
                  StageLog& log) {
  if (std::holds_alternative<PointSet>(shape)) {
    (void)make_polytope(result.start->dual.halfspaces, effort.seed, log);
  }
  log.run("Chebyshev center", [&] {
    (void)chebyshev_center(result.start->dual.halfspaces, LpOptions{.seed = effort.seed});
  });
  log.run("area and mean width", [&] {
    (void)surface_area(result.solid.exact, kMeasureBits);
    (void)mean_width(result.solid.exact, kMeasureBits);
  });
}

std::vector<Stage> run_everything(const Shape& shape, SimplifyRequest request,
                                  const Effort& effort) {
  request.trace = request.record = request.exact_volumes = true;
  request.store = {Precision::Binary64, Precision::Binary64};
  const SimplifyOutcome outcome = simplify(shape, request);
  StageLog log;
  if (const auto* result = std::get_if<SimplifyResult>(&outcome)) {
    log.add(result->stages);
    run_the_rest(shape, *result, effort, log);
  }
  return log.stages();
}

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

// None if the set is flat or the time ran out.
std::optional<Sample> sample(const PointSet& points, Engine engine, const Effort& effort) {
  std::vector<double> hull, removals;
  Sample result;
  const auto whole = time_repeatedly(effort, [&](Deadline& deadline) {
    const SimplifyOutcome outcome = simplify(points, request_for(engine, 4, effort, deadline));
    const auto* solid = std::get_if<SimplifyResult>(&outcome);
    if (solid == nullptr) return;
    result.halfspaces = solid->input_halfspaces;
    hull.push_back(seconds_of(solid->stages, stage::kHull));
    removals.push_back(seconds_of(solid->stages, stage::kSimplify));
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

std::vector<RunTimes> measure_stage_times(const Shape& shape, std::size_t faces,
                                          const Effort& effort) {
  std::vector<RunTimes> list;
  for (const Engine engine : kQuickestFirst) {
    list.push_back(measure(name_of(engine), effort, [&](Deadline& deadline) {
      const auto outcome = simplify(shape, request_for(engine, faces, effort, deadline));
      const auto* result = std::get_if<SimplifyResult>(&outcome);
      return result == nullptr ? std::vector<Stage>() : result->stages;
    }));
  }
  list.push_back(measure("everything", effort, [&](Deadline& deadline) {
    return run_everything(shape, request_for(Engine::Filtered, faces, effort, deadline), effort);
  }));
  return list;
}

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
  std::vector<ScalingSeries> list{
      {.stage = stage::kHull, .run = "hull", .counts = "points", .points = {}, .law = {}}};
  for (const Engine engine : kQuickestFirst) {
    ScalingSeries series{.stage = stage::kSimplify,
                         .run = name_of(engine),
                         .counts = "halfspaces",
                         .points = {},
                         .law = {}};
    for (const PointSet& set : sets) {
      if (effort.progress) {
        effort.progress("size " + std::to_string(set.size()) + " by " + name_of(engine));
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
