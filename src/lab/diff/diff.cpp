// SPDX-License-Identifier: MIT
#include "lab/diff/diff.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "fast/dual.hpp"
#include "fast/engines.hpp"
#include "lab/diff/divergence.hpp"
#include "number/precision.hpp"
#include "simplify/exact_engine.hpp"
#include "simplify/run_names.hpp"
#include "solid/solid.hpp"

namespace convexact {
namespace {

void require_sensible(const DiffRequest& request) {
  std::vector<Engine> engines = request.engines;
  std::sort(engines.begin(), engines.end());
  if (engines.size() < 2 || std::unique(engines.begin(), engines.end()) != engines.end()) {
    throw Error(ErrorCode::InvalidArgument, "name two or three different engines");
  }
  if (request.faces < 4) {
    throw Error(ErrorCode::InvalidArgument, "no bounded solid has fewer than 4 faces");
  }
}

std::string stage_name(Engine engine) { return std::string(name_of(engine)) + " engine"; }

// The solid that all engines receive, and the questions about it.
struct DiffCase {
  const DualHull& dual;
  RationalPoint center;
  const DiffRequest& request;
  StageLog& log;
  std::vector<HalfspaceId> keep;
};

std::vector<Run> run_engines(const DiffCase& c) {
  const auto& engines = c.request.engines;
  const bool record = std::find(engines.begin(), engines.end(), Engine::Exact) != engines.end();
  std::vector<Run> runs;
  for (const Engine engine : engines) {
    SimplifyOptions options;
    options.faces = c.request.faces;
    options.keep = c.keep;
    options.cost = c.request.cost;
    options.compare = c.request.compare;
    options.seed = c.request.seed;
    options.verify = VerifyLevel::None;
    options.watch = c.request.watch.of(stage_name(engine));
    runs.push_back(c.log.run(
        stage_name(engine), [&] { return run_engine(engine, c.dual, c.center, options, record); }));
  }
  return runs;
}

DivergenceOptions options_of(const DiffRequest& request) {
  return {.compare = request.compare, .watch = request.watch.stop};
}

// Sets the ratios of the results of two runs.
void compare_ends(const DiffCase& c, const Run& reference, const Run& other, Comparison& result) {
  const auto before = left_after(reference, reference.steps.size());
  const auto after = left_after(other, other.steps.size());
  const bool is_metric = c.request.cost != CostMeasure::Volume;
  if (before == after) {
    result.volume_ratio = Enclosure(Rational(1), kMeasureBits);
    if (is_metric) result.measure_ratio = result.volume_ratio;
    return;
  }
  const auto first = intersect(before, c.center), second = intersect(after, c.center);
  if (!first || !second) return;
  const auto ratio = [&](CostMeasure measure) {
    const Watch watch(c.request.watch.stop);
    return enclose_measure(*second, measure, kMeasureBits, watch) /
           enclose_measure(*first, measure, kMeasureBits, watch);
  };
  result.volume_ratio = ratio(CostMeasure::Volume);
  if (is_metric) result.measure_ratio = ratio(c.request.cost);
}

// The steps at which a float run is not greedy after step `first`, where it first differs from
// another run.
// @param is_reference  Whether the comparison has the float run first.
std::vector<Divergence> later_divergences(const DiffCase& c, const Run& run, std::size_t first,
                                          bool is_reference) {
  std::vector<Divergence> found = check_greedy(c.dual, c.center, run, options_of(c.request));
  std::erase_if(found, [&](const Divergence& divergence) { return divergence.step <= first; });
  if (!is_reference) return found;
  for (Divergence& divergence : found) {
    std::swap(divergence.reference, divergence.other);
    divergence.reference_at_fault = !divergence.reference_at_fault;
  }
  return found;
}

// The first run against the k-th.
Comparison compare(const DiffCase& c, const std::vector<Run>& runs, std::size_t k) {
  const Run &reference = runs[0], &other = runs[k];
  Comparison result{c.request.engines[0], c.request.engines[k]};
  result.judged = other.steps.size();
  result.with_records = have_records(reference, other);
  const std::optional<Divergence> first = c.log.run("costs by definition", [&] {
    return find_divergence(c.center, reference, other, options_of(c.request));
  });
  std::vector<Divergence>& found = result.divergences;
  if (first) {
    found.push_back(*first);
    result.judged = first->step + 1;
  }
  const bool is_reference = result.reference == Engine::Float;
  if (first && (is_reference || result.other == Engine::Float)) {
    const Run& followed = is_reference ? reference : other;
    c.log.run("every step of float", [&] {
      const auto later = later_divergences(c, followed, first->step, is_reference);
      found.insert(found.end(), later.begin(), later.end());
    });
    if (found.back().kind != DivergenceKind::WrongBoundedness) {
      result.judged = followed.steps.size();
    }
  }
  result.explained = std::all_of(found.begin(), found.end(), [&](const Divergence& divergence) {
    return is_explained(divergence, result.reference, result.other);
  });
  c.log.run("final volumes", [&] { compare_ends(c, reference, other, result); });
  return result;
}

}  // namespace

Run run_engine(Engine engine, const DualHull& dual, const RationalPoint& center,
               const SimplifyOptions& options, bool record) {
  if (engine == Engine::Exact) return simplify_exact(dual, center, options);
  if (engine == Engine::Filtered && record) return simplify_filtered(dual, center, options);
  const FastDual fast = FastDual::of(dual, center);
  Run run = run_of(
      engine == Engine::Float ? simplify_float(fast, options) : simplify_filtered(fast, options),
      dual.halfspaces);
  run.measure = options.cost;
  run.kept = options.keep;
  return run;
}

bool DiffReport::holds() const {
  return std::all_of(comparisons.begin(), comparisons.end(),
                     [](const Comparison& comparison) { return comparison.explained; });
}

DiffOutcome diff_engines(const Shape& shape, const DiffRequest& request) {
  require_sensible(request);
  StageLog log(request.watch);
  SolidOutcome outcome = make_solid(shape, {.seed = request.seed}, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  auto& solid = std::get<Solid>(outcome);
  log.skip("Chebyshev center", "any interior point serves, and all engines get the same");
  const RationalPoint center = log.run("center", [&] { return interior_point_of(solid); });
  const auto* points = std::get_if<PointSet>(&shape);
  const std::vector<HalfspaceId> keep = select_facets(
      solid.dual.halfspaces, points != nullptr ? *points : PointSet(), request.keep, request.faces);
  const DiffCase diff{solid.dual, center, request, log, keep};

  DiffReport report;
  report.kept = keep;
  report.cost = request.cost;
  report.engines = request.engines;
  report.runs = run_engines(diff);
  for (std::size_t k = 1; k < report.runs.size(); ++k) {
    report.comparisons.push_back(compare(diff, report.runs, k));
  }
  report.halfspaces = std::move(solid.dual.halfspaces);
  report.stages = log.stages();
  return report;
}

}  // namespace convexact
