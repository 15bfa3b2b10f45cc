// SPDX-License-Identifier: MIT
#include "lab/compare/compare.hpp"

#include <algorithm>

#include "lab/report/timing.hpp"

namespace convexact {
namespace {

// The result of `work`, and its seconds.
template <class Work>
auto timed(double& seconds, Work&& work) {
  const Stopwatch watch;
  auto made = work();
  seconds = watch.seconds();
  return made;
}

MethodResult run_method(const Method& method, const HullToFit& hull, const HullMeasures& measures,
                        const CompareRequest& request) {
  double seconds = 0, refit_seconds = 0;
  if (method.is_inner()) {
    const HullCorners corners =
        timed(seconds, [&] { return method.select(hull, request.size, request.seed); });
    RefitOutcome outcome = timed(
        refit_seconds, [&] { return hull_of_corners(hull, measures, corners, request.seed); });
    return {&method, seconds, refit_seconds, std::move(outcome)};
  }
  const Normals proposal =
      timed(seconds, [&] { return method.propose(hull, request.size, request.seed); });
  RefitOutcome outcome =
      timed(refit_seconds, [&] { return refit(hull, measures, proposal, request.seed); });
  return {&method, seconds, refit_seconds, std::move(outcome)};
}

}  // namespace

const MethodResult* MethodComparison::tightest() const {
  const MethodResult* best = nullptr;
  for (const MethodResult& result : results) {
    if (result.fits(size) && (best == nullptr || result.is_tighter(*best))) best = &result;
  }
  return best;
}

bool MethodComparison::beats_own(const MethodResult& result) const {
  const auto own = std::find_if(results.begin(), results.end(),
                                [](const MethodResult& other) { return other.method->is_own; });
  return own != results.end() && own->solid() != nullptr && result.fits(size) &&
         result.is_tighter(*own);
}

std::variant<MethodComparison, NotSolid> compare_methods(const std::string& name,
                                                         const Shape& shape,
                                                         const CompareRequest& request) {
  StageLog log(request.watch);
  SolidOutcome outcome = make_solid(shape, {.seed = request.seed}, log);
  if (auto* reason = std::get_if<NotSolid>(&outcome)) return std::move(*reason);
  const auto& solid = std::get<Solid>(outcome);
  const HullMeasures measures = log.run(
      "measures of the hull", [&] { return measures_of(solid.polytope, log.watch("hull")); });
  MethodComparison comparison{.name = name,
                              .points = solid.input_points,
                              .vertices = solid.polytope.vertices.size(),
                              .facets = solid.polytope.facets.size(),
                              .size = request.size,
                              .inner = request.inner,
                              .results = {}};
  for (const Method* method : request.methods) {
    const std::string stage(method->name);
    comparison.results.push_back(log.run(stage, [&] {
      return run_method(*method, hull_to_fit(solid, log.watch(stage)), measures, request);
    }));
  }
  return comparison;
}

std::vector<MethodMedian> medians(const std::vector<MethodComparison>& comparisons) {
  std::vector<MethodMedian> list;
  if (comparisons.empty()) return list;
  for (const MethodResult& first : comparisons.front().results) {
    std::vector<double> volume, area, mean_width, distance, seconds;
    for (const MethodComparison& comparison : comparisons) {
      for (const MethodResult& result : comparison.results) {
        if (result.method != first.method || !result.fits(comparison.size)) continue;
        const Ratios ratios = ratios_of(*result.solid());
        volume.push_back(ratios.volume);
        area.push_back(ratios.area);
        mean_width.push_back(ratios.mean_width);
        distance.push_back(ratios.distance);
        seconds.push_back(result.seconds);
      }
    }
    if (volume.empty()) continue;
    list.push_back({.method = first.method,
                    .inputs = volume.size(),
                    .volume = median(volume),
                    .area = median(area),
                    .mean_width = median(mean_width),
                    .distance = median(distance),
                    .seconds = median(seconds)});
  }
  std::stable_sort(list.begin(), list.end(), [](const MethodMedian& a, const MethodMedian& b) {
    return a.method->is_inner() ? a.volume > b.volume : a.volume < b.volume;
  });
  return list;
}

}  // namespace convexact
