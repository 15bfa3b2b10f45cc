// SPDX-License-Identifier: MIT
#include "report/stage_times.hpp"

#include <algorithm>
#include <map>

#include "convexact/measure.hpp"
#include "scene/solid.hpp"

namespace convexact {
namespace {

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
        list.push_back({stage.name, std::nullopt, stage.skipped});
      } else {
        list.push_back({stage.name, spread_of(seconds), {}});
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
  RunTimes times{run, {}, {}};
  times.seconds =
      time_repeatedly(effort, [&](Deadline& deadline) { collected.add(work(deadline)); });
  if (times.seconds) times.stages = collected.result();
  return times;
}

SimplifyRequest request_for(Engine engine, std::size_t faces, const Effort& effort,
                            Deadline& deadline) {
  SimplifyRequest request;
  request.faces = faces;
  request.engine = engine;
  request.seed = effort.seed;
  request.watch = deadline.watch();
  return request;
}

// The stages that simplify() skips for points, and the ones that it always skips, after it.
void run_the_rest(const Shape& shape, const SimplifyResult& result, const Effort& effort,
                  StageLog& log) {
  if (std::holds_alternative<PointSet>(shape)) {
    (void)make_polytope(result.record->solid.halfspaces, effort.seed, log);
  }
  log.run("area and mean width", [&] {
    (void)surface_area(result.solid.exact, kVolumeBits);
    (void)mean_width(result.solid.exact, kVolumeBits);
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

}  // namespace

std::vector<RunTimes> measure_stage_times(const Shape& shape, std::size_t faces,
                                          const Effort& effort) {
  std::vector<RunTimes> list;
  const std::pair<const char*, Engine> engines[] = {
      {"float", Engine::Float}, {"filtered", Engine::Filtered}, {"exact", Engine::Exact}};
  for (const auto& [name, engine] : engines) {
    list.push_back(measure(name, effort, [&, engine = engine](Deadline& deadline) {
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

}  // namespace convexact
