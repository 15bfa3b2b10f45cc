// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/simplify.hpp"
#include "number/precision.hpp"
#include "scene/each_object.hpp"
#include "scene/part_runs.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

void require_sensible_scene(std::size_t parts, const SceneRequest& request) {
  if (parts == 0) reject_argument("a scene needs a part");
  if (request.each.faces || request.each.center || !request.each.keep.empty()) {
    reject_argument("the parts of a scene have no faces, center or kept facets in common");
  }
  if (request.each.search.kind != SearchKind::None) {
    reject_argument(
        "a scene distributes its halfspaces by removals; a search is for a run with faces of its "
        "own");
  }
  if (!request.keep.empty() && request.keep.size() != parts) {
    reject_argument("kept facets are not given for each part");
  }
  if (request.total_faces / 4 < parts) {
    reject_argument(fmt::format("{} parts need at least {} faces, 4 for each; {} are too few",
                                parts, 4 * parts, request.total_faces));
  }
}

// The request for one part of the scene.
SimplifyRequest part_request(const SceneRequest& request, std::size_t part) {
  SimplifyRequest own = request.each;
  if (!request.keep.empty()) own.keep = request.keep[part];
  return own;
}

struct PreparedPart {
  SimplifyRequest request;
  StageLog log;
  std::unique_ptr<RunInput> input;
  std::optional<InputMeasures> before;
};

std::variant<std::vector<PreparedPart>, NotSolidPart> prepare_parts(std::span<const Shape> shapes,
                                                                    const SceneRequest& request) {
  using Prepared = std::variant<PreparedPart, NotSolid>;
  const auto prepare = [&](std::size_t k, const StageWatch& watch, std::size_t jobs) -> Prepared {
    PreparedPart part{part_request(request, k), StageLog(watch), nullptr, {}};
    part.request.jobs = jobs;
    auto prepared = prepare_run(shapes[k], part.request, part.log);
    if (auto* reason = std::get_if<NotSolid>(&prepared)) return std::move(*reason);
    part.input = std::get<std::unique_ptr<RunInput>>(std::move(prepared));
    part.before = measure_input(*part.input, part.request, part.log);
    return part;
  };
  return on_each<PreparedPart>(shapes.size(), request.each.jobs, request.each.watch, prepare);
}

SharedOptions options_of(const SceneRequest& request, const std::vector<PreparedPart>& parts) {
  const SimplifyRequest& each = request.each;
  SharedOptions options{.total_faces = request.total_faces,
                        .compare = each.compare,
                        .max_growth = each.max_growth,
                        .costs_never_fall = each.cost == CostMeasure::Volume,
                        .jobs = jobs_of(each),
                        .watch = each.watch.of(stage::kSimplify)};
  if (each.max_growth) {
    options.measure = Enclosure(kMeasureBits);
    for (const PreparedPart& part : parts) {
      *options.measure += part.before->of(each.growth_of.value_or(each.cost), each.cost);
    }
  }
  const bool keeps_any = std::any_of(parts.begin(), parts.end(), [](const PreparedPart& part) {
    return !part.input->keep.empty();
  });
  if (keeps_any) options.when_stuck = StopReason::AllKeptOrUnbounded;
  return options;
}

// In order, so that the sums are the same everywhere.
Measured sum_of_volumes(std::span<const SimplifyResult> parts, Measured SimplifyResult::*volume) {
  Measured sum{Enclosure(kMeasureBits), Rational(0)};
  for (const SimplifyResult& part : parts) {
    const Measured& term = part.*volume;
    sum.bounds += term.bounds;
    if (term.exact && sum.exact) {
      *sum.exact += *term.exact;
    } else {
      sum.exact.reset();
    }
  }
  return sum;
}

std::optional<std::array<Enclosure, 2>> sum_of_measures(
    std::span<const SimplifyResult> parts,
    std::optional<std::array<Enclosure, 2>> SimplifyResult::*measure) {
  if (!(parts[0].*measure)) return {};
  std::array<Enclosure, 2> sum{Enclosure(kMeasureBits), Enclosure(kMeasureBits)};
  for (const SimplifyResult& part : parts) {
    for (std::size_t k = 0; k < 2; ++k) sum[k] += (*(part.*measure))[k];
  }
  return sum;
}

void add_up(SceneResult& scene) {
  for (const SimplifyResult& part : scene.parts) {
    scene.steps += part.steps;
    scene.input_halfspaces += part.input_halfspaces;
    scene.output_halfspaces += part.solid.exact.planes.size();
  }
  scene.input_volume = sum_of_volumes(scene.parts, &SimplifyResult::input_volume);
  scene.output_volume = sum_of_volumes(scene.parts, &SimplifyResult::output_volume);
  scene.measure = sum_of_measures(scene.parts, &SimplifyResult::measure);
  scene.limited = sum_of_measures(scene.parts, &SimplifyResult::limited);
  scene.growth_of = scene.parts[0].growth_of;
}

// The float engine compared the growth in doubles: every part records whether that is proven.
void vouch_for_growth(SceneResult& scene, const std::vector<PreparedPart>& parts,
                      const SimplifyRequest& request) {
  std::optional<Rational> least;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto next = least_next(*scene.parts[k].float_bound, *parts[k].input, request.cost);
    if (next && (!least || *next < *least)) least = next;
  }
  const auto measure =
      scene.measure.value_or(std::array{scene.input_volume.bounds, scene.output_volume.bounds});
  const bool is_proven =
      is_growth_proven(scene.steps, scene.stop, least, measure, *request.max_growth);
  for (SimplifyResult& part : scene.parts) part.float_bound->is_end_proven &= is_proven;
}

}  // namespace

SceneOutcome simplify_scene(std::span<const Shape> shapes, const SceneRequest& request) {
  require_sensible_scene(shapes.size(), request);
  SimplifyRequest whole = request.each;
  whole.faces = request.total_faces;
  require_sensible(whole);
  StageLog log(request.each.watch);
  auto prepared = prepare_parts(shapes, request);
  if (auto* flat = std::get_if<NotSolidPart>(&prepared)) return *flat;
  auto& parts = std::get<std::vector<PreparedPart>>(prepared);

  SceneResult scene;
  std::vector<std::unique_ptr<PartRun>> runs;
  std::vector<ScenePartRun*> ends;
  std::size_t kept = 0;
  for (const PreparedPart& part : parts) kept += part.input->keep.size();
  if (kept > request.total_faces) {
    reject_argument(
        fmt::format("{} faces are to be kept, but only {} in all", kept, request.total_faces));
  }
  SharedEnd end = log.run(stage::kSimplify, [&] {
    for (const PreparedPart& part : parts) {
      auto run = start_part(*part.input, part.request);
      ends.push_back(run.get());
      runs.push_back(std::move(run));
    }
    return run_shared(runs, options_of(request, parts));
  });
  const std::size_t jobs = jobs_of(request.each);
  const bool together = jobs > 1 && parts.size() > 1;  // otherwise the stages of each are told
  if (together && log.watch().begins) log.watch().begins("proofs");
  std::vector<std::optional<SimplifyResult>> results(parts.size());
  for_each_in_parallel(parts.size(), jobs, together ? log.watch("proofs") : log.watch().stop,
                       [&](std::size_t k, const Watch&) {
                         PreparedPart& part = parts[k];
                         RunEnd own = ends[k]->finish(end.stop, part.log);
                         own.growth_bits = end.growth_bits;
                         results[k] = finish_run(*part.input, std::move(*part.before),
                                                 std::move(own), part.request, part.log);
                       });
  for (std::optional<SimplifyResult>& result : results) scene.parts.push_back(std::move(*result));
  scene.order = std::move(end.order);
  scene.stop = end.stop;
  scene.growth_bits = end.growth_bits;
  scene.ties = end.ties;
  scene.cost = request.each.cost;
  scene.engine = request.each.engine;
  add_up(scene);
  if (request.each.engine == Engine::Float && request.each.max_growth) {
    vouch_for_growth(scene, parts, request.each);
  }
  scene.is_end_proven =
      std::all_of(scene.parts.begin(), scene.parts.end(), [](const SimplifyResult& part) {
        return !part.float_bound || part.float_bound->is_end_proven;
      });
  scene.stages = log.stages();
  return scene;
}

}  // namespace convexact
