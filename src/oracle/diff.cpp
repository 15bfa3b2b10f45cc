// SPDX-License-Identifier: MIT
#include "oracle/diff.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "oracle/greedy_check.hpp"
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

const char* stage_name(Engine engine) {
  switch (engine) {
    case Engine::Exact:
      return "exact engine";
    case Engine::Filtered:
      return "filtered engine";
    case Engine::Float:
      break;
  }
  return "float engine";
}

std::vector<EngineRun> run_engines(const DualHull& solid, const RationalPoint& center,
                                   const DiffRequest& request, StageLog& log) {
  const auto& engines = request.engines;
  const bool record = std::find(engines.begin(), engines.end(), Engine::Exact) != engines.end();
  std::vector<EngineRun> runs;
  for (const Engine engine : engines) {
    SimplifyOptions options;
    options.faces = request.faces;
    options.seed = request.seed;
    options.verify = VerifyLevel::None;
    options.stop = request.watch.stop;
    if (request.watch.progress) {
      options.progress = [&, engine](std::size_t left) {
        const std::size_t at_start = solid.halfspaces.size();
        request.watch.progress(stage_name(engine), at_start - left, at_start - request.faces);
      };
    }
    runs.push_back(log.run(stage_name(engine),
                           [&] { return run_engine(engine, solid, center, options, record); }));
  }
  return runs;
}

std::optional<Enclosure> volume_ratio(std::span<const Halfspace> halfspaces,
                                      const RationalPoint& center, const EngineRun& reference,
                                      const EngineRun& other) {
  const auto before = left_after(halfspaces, reference, reference.removed.size());
  const auto after = left_after(halfspaces, other, other.removed.size());
  if (before == after) return Enclosure(Rational(1), kVolumeBits);
  const auto first = intersect(before, center), second = intersect(after, center);
  if (!first || !second) return std::nullopt;
  return enclose_volume(*second, kVolumeBits) / enclose_volume(*first, kVolumeBits);
}

// Divergences as seen from the run, in a comparison that has the run first.
void swap_sides(std::vector<Divergence>& divergences) {
  for (Divergence& divergence : divergences) {
    std::swap(divergence.reference, divergence.other);
    divergence.reference_at_fault = !divergence.reference_at_fault;
  }
}

// Where the run is not greedy after step `first`, the one at which it differs from another run.
std::vector<Divergence> later_divergences(const DualHull& solid, const RationalPoint& center,
                                          const EngineRun& run, std::size_t first,
                                          const DiffRequest& request) {
  std::vector<Divergence> found = check_greedy(solid, center, run, request.watch.stop);
  std::erase_if(found, [&](const Divergence& divergence) { return divergence.step <= first; });
  return found;
}

Comparison compare(const DualHull& solid, const RationalPoint& center, const EngineRun& reference,
                   const EngineRun& other, const DiffRequest& request, StageLog& log) {
  Comparison result{reference.engine, other.engine, {}, true, other.removed.size(), false, {}};
  result.with_records = have_records(reference, other);
  const std::optional<Divergence> first = log.run("costs by definition", [&] {
    return find_divergence(solid.halfspaces, center, reference, other);
  });
  std::vector<Divergence>& found = result.divergences;
  if (first) {
    found.push_back(*first);
    result.judged = first->step + 1;
  }
  const bool is_reference = reference.engine == Engine::Float;
  if (first && (is_reference || other.engine == Engine::Float)) {
    const EngineRun& followed = is_reference ? reference : other;
    log.run("every step of float", [&] {
      std::vector<Divergence> later =
          later_divergences(solid, center, followed, first->step, request);
      if (is_reference) swap_sides(later);
      found.insert(found.end(), later.begin(), later.end());
    });
    if (found.back().kind != DivergenceKind::WrongBoundedness) {
      result.judged = followed.removed.size();
    }
  }
  result.explained = std::all_of(found.begin(), found.end(), [&](const Divergence& divergence) {
    return is_explained(divergence, reference.engine, other.engine);
  });
  result.volume_ratio = log.run(
      "final volumes", [&] { return volume_ratio(solid.halfspaces, center, reference, other); });
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
  report.runs = run_engines(solid.dual, center, request, log);
  for (std::size_t k = 1; k < report.runs.size(); ++k) {
    report.comparisons.push_back(
        compare(solid.dual, center, report.runs[0], report.runs[k], request, log));
  }
  report.halfspaces = std::move(solid.dual.halfspaces);
  report.stages = log.stages();
  return report;
}

}  // namespace convexact
