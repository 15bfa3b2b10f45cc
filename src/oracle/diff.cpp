// SPDX-License-Identifier: MIT
#include "oracle/diff.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "number/precision.hpp"
#include "oracle/engine_run.hpp"
#include "oracle/greedy_check.hpp"
#include "scene/result_json.hpp"
#include "scene/solid.hpp"

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

std::vector<Run> run_engines(const DualHull& dual, const RationalPoint& center,
                             const DiffRequest& request, StageLog& log) {
  const auto& engines = request.engines;
  const bool record = std::find(engines.begin(), engines.end(), Engine::Exact) != engines.end();
  std::vector<Run> runs;
  for (const Engine engine : engines) {
    SimplifyOptions options;
    options.faces = request.faces;
    options.seed = request.seed;
    options.verify = VerifyLevel::None;
    options.stop = request.watch.stop;
    if (request.watch.progress) {
      options.progress = [&, engine](std::size_t left) {
        const std::size_t at_start = dual.halfspaces.size();
        request.watch.progress(stage_name(engine), at_start - left, at_start - request.faces);
      };
    }
    runs.push_back(log.run(stage_name(engine),
                           [&] { return run_engine(engine, dual, center, options, record); }));
  }
  return runs;
}

std::optional<Enclosure> volume_ratio(const RationalPoint& center, const Run& reference,
                                      const Run& other) {
  const auto before = left_after(reference, reference.steps.size());
  const auto after = left_after(other, other.steps.size());
  if (before == after) return Enclosure(Rational(1), kMeasureBits);
  const auto first = intersect(before, center), second = intersect(after, center);
  if (!first || !second) return std::nullopt;
  return enclose_volume(*second, kMeasureBits) / enclose_volume(*first, kMeasureBits);
}

// Divergences as seen from the run, in a comparison that has the run first.
void swap_sides(std::vector<Divergence>& divergences) {
  for (Divergence& divergence : divergences) {
    std::swap(divergence.reference, divergence.other);
    divergence.reference_at_fault = !divergence.reference_at_fault;
  }
}

// Where the run is not greedy after step `first`, the one at which it differs from another run.
std::vector<Divergence> later_divergences(const DualHull& dual, const RationalPoint& center,
                                          const Run& run, std::size_t first,
                                          const DiffRequest& request) {
  std::vector<Divergence> found = check_greedy(dual, center, run, request.watch.stop);
  std::erase_if(found, [&](const Divergence& divergence) { return divergence.step <= first; });
  return found;
}

// The first run against the k-th.
Comparison compare(const DualHull& dual, const RationalPoint& center, const std::vector<Run>& runs,
                   std::size_t k, const DiffRequest& request, StageLog& log) {
  const Run &reference = runs[0], &other = runs[k];
  Comparison result{request.engines[0],
                    request.engines[k],
                    {},
                    true,
                    other.steps.size(),
                    have_records(reference, other),
                    {}};
  const std::optional<Divergence> first =
      log.run("costs by definition", [&] { return find_divergence(center, reference, other); });
  std::vector<Divergence>& found = result.divergences;
  if (first) {
    found.push_back(*first);
    result.judged = first->step + 1;
  }
  const bool is_reference = result.reference == Engine::Float;
  if (first && (is_reference || result.other == Engine::Float)) {
    const Run& followed = is_reference ? reference : other;
    log.run("every step of float", [&] {
      std::vector<Divergence> later =
          later_divergences(dual, center, followed, first->step, request);
      if (is_reference) swap_sides(later);
      found.insert(found.end(), later.begin(), later.end());
    });
    if (found.back().kind != DivergenceKind::WrongBoundedness) {
      result.judged = followed.steps.size();
    }
  }
  result.explained = std::all_of(found.begin(), found.end(), [&](const Divergence& divergence) {
    return is_explained(divergence, result.reference, result.other);
  });
  result.volume_ratio =
      log.run("final volumes", [&] { return volume_ratio(center, reference, other); });
  return result;
}

}  // namespace

bool DiffReport::holds() const {
  return std::all_of(comparisons.begin(), comparisons.end(),
                     [](const Comparison& comparison) { return comparison.explained; });
}

DiffOutcome diff_engines(const Shape& shape, const DiffRequest& request) {
  require_sensible(request);
  StageLog log(request.watch);
  SolidOutcome outcome = make_solid(shape, request.seed, true, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  auto& solid = std::get<Solid>(outcome);
  log.skip("Chebyshev center", "any interior point serves, and all engines get the same");
  const RationalPoint center = log.run("center", [&] { return interior_point_of(solid); });

  DiffReport report;
  report.engines = request.engines;
  report.runs = run_engines(solid.dual, center, request, log);
  for (std::size_t k = 1; k < report.runs.size(); ++k) {
    report.comparisons.push_back(compare(solid.dual, center, report.runs, k, request, log));
  }
  report.halfspaces = std::move(solid.dual.halfspaces);
  report.stages = log.stages();
  return report;
}

}  // namespace convexact
