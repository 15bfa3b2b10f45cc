// SPDX-License-Identifier: MIT
#include "lab/stress/answer.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "fast/engines.hpp"
#include "solid/solid.hpp"

namespace convexact {
namespace {

constexpr std::size_t kMostStored = 4000;   // solids of more halfspaces are not stored
constexpr std::size_t kMostSearched = 100;  // no search starts from more halfspaces

// Processor time of this process, not wall time: other load must not count.
double processor_time() {
  timespec now{};
  (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

ReportedVolume reported(const Enclosure& bounds) { return {bounds.low(), bounds.high()}; }
ReportedVolume reported(const Measured& measured) { return reported(measured.bounds); }

HalfspaceId canonical_id(const std::vector<Halfspace>& halfspaces, const Halfspace& plane) {
  const auto found = std::lower_bound(halfspaces.begin(), halfspaces.end(), plane);
  if (found == halfspaces.end() || *found != plane) {
    throw Error(ErrorCode::Internal, "a removed halfspace is none of the solid's");
  }
  return HalfspaceId(static_cast<std::size_t>(found - halfspaces.begin()));
}

// Corners of a facet, or facets around a vertex.
std::size_t largest_valence(const Polytope& polytope) {
  std::vector<std::size_t> around(polytope.vertices.size(), 0);
  std::size_t largest = 0;
  for (const auto& facet : polytope.facets) {
    largest = std::max<std::size_t>(largest, facet.size());
    for (const std::uint32_t corner : facet) largest = std::max(largest, ++around[corner]);
  }
  return largest;
}

// The exact engine evaluates long rings again and again, which takes about 10 microseconds times
// the number of halfspaces and (the largest valence + kShort). Above kMostWork it makes only
// kMostSteps removals, which are compared with the filtered engine's.
std::size_t faces_for(const Question& question, const Polytope& polytope) {
  constexpr std::size_t kShort = 140, kMostWork = 3000000, kMostSteps = 20;
  const std::size_t size = polytope.planes.size();
  if (question.engine != Engine::Exact || size <= kMostSteps) return question.faces;
  if (size * (largest_valence(polytope) + kShort) <= kMostWork) return question.faces;
  return std::max(question.faces, size - kMostSteps);
}

// The pipeline as users run it; the only part that is timed.
Polytope run_pipeline(const Shape& shape, const SimplifyRequest& request, EngineAnswer& answer) {
  const double start = processor_time();
  SimplifyOutcome outcome = simplify(shape, request);
  answer.seconds = processor_time() - start;
  auto* result = std::get_if<SimplifyResult>(&outcome);
  if (result == nullptr) {
    throw Error(ErrorCode::Internal, "the pipeline finds no volume where its first stage does");
  }
  answer.end =
      result->stop == StopReason::AllUnbounded ? StressEnd::AllUnbounded : StressEnd::Reached;
  answer.input_volume = reported(result->input_volume);
  answer.output_volume = reported(result->output_volume);
  if (const auto& measure = result->measure) {
    answer.measure = {reported((*measure)[0]), reported((*measure)[1])};
  }
  answer.left = result->solid.exact.planes;
  if (const auto& bound = result->float_bound) {
    answer.claim = {bound->cost, bound->regret, bound->doubtful, bound->is_end_proven,
                    bound->is_vouched()};
  }
  if (result->run) answer.run.steps = std::move(result->run->steps);
  return std::move(result->solid.exact);
}

// The steps of the run that keeps no record, which is the same computation as the pipeline's.
void take_lean_run(const FastDual& dual, const Question& question, std::size_t faces,
                   EngineAnswer& answer) {
  SimplifyOptions options;
  options.faces = faces;
  options.seed = question.seed;
  options.cost = question.cost;
  const FastResult result = question.engine == Engine::Float ? simplify_float(dual, options)
                                                             : simplify_filtered(dual, options);
  if (const auto& bound = result.bound) {
    const auto& claim = answer.claim.value();
    if (bound->cost != claim.cost || bound->regret != claim.regret) {
      throw Error(ErrorCode::Internal, "the run without a record is not the pipeline's");
    }
  }
  const auto exact = [&](double x) -> std::optional<Rational> {
    if (!std::isfinite(x) || x < 0) return std::nullopt;  // no cost is negative
    return scale_by_power_of_two(to_rational(x), dual.cost_exponent(question.cost));
  };
  for (const FastStep& step : result.steps) {
    answer.lean.push_back({.removed = canonical_id(answer.run.halfspaces, dual.exact(step.removed)),
                           .cost = {exact(step.cost_lower), exact(step.cost_upper)},
                           .tied = step.tied});
  }
}

void take_lean_run(const Shape& shape, const Solid& solid, const Question& question,
                   std::size_t faces, EngineAnswer& answer) {
  // From the dual that the pipeline uses: bounds depend on its center. Points need no exact planes.
  const auto* points = std::get_if<PointSet>(&shape);
  if (points == nullptr) {
    return take_lean_run(FastDual::of(solid.dual, interior_point_of(solid)), question, faces,
                         answer);
  }
  const HullOutcome outcome = convex_hull(*points, {.seed = question.seed});
  take_lean_run(FastDual::of(std::get<Hull>(outcome), *points), question, faces, answer);
}

// The result in one form and precision. A refusal is an answer, too.
StoredBytes store_as(StressStored::Form form, Precision precision, bool whole,
                     const Polytope& result, const Solid& solid) {
  StoredBytes kept;
  kept.stored.form = form;
  kept.stored.precision = precision;
  kept.stored.whole = whole;
  StageLog log;
  StoreRequest request;
  const bool planes = form == StressStored::Form::Planes;
  (planes ? request.planes : request.mesh) = precision;
  try {
    const Stored made = store(result, solid.points, solid.extreme, request, log);
    kept.bytes = planes ? write_halfspaces(made.planes->planes, HalfspaceFormat::Json)
                        : write_mesh(made.mesh->mesh, MeshFormat::Obj, {.precision = precision});
    const Growth& growth = planes ? made.planes->growth : made.mesh->growth;
    kept.stored.outcome = StressStored::Outcome::Holds;
    kept.stored.push = growth.push;
    kept.stored.volume_ratio = growth.volume_ratio;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Unrepresentable) throw;
    kept.stored.outcome = StressStored::Outcome::Refused;
    kept.stored.why = error.what();
  }
  return kept;
}

void store_all(const Polytope& result, const Solid& solid, bool whole, EngineAnswer& answer) {
  for (const auto form : {StressStored::Form::Planes, StressStored::Form::Mesh}) {
    for (const Precision precision : {Precision::Binary64, Precision::Binary32}) {
      answer.stored.push_back(store_as(form, precision, whole, result, solid));
    }
  }
}

// The engine's removals again, then the search from their end.
Polytope take_search(const Shape& shape, SimplifyRequest request, const SearchRequest& search,
                     EngineAnswer& answer) {
  request.trace = true;
  request.search = search;
  SimplifyOutcome outcome = simplify(shape, request);
  auto& result = std::get<SimplifyResult>(outcome);
  answer.search.emplace(
      SearchAnswer{std::move(result.run.value().moves), result.solid.exact.planes});
  return std::move(result.solid.exact);
}

void answer_for(const Shape& shape, const Question& question, EngineAnswer& answer) {
  StageLog log;
  const SolidOutcome outcome = make_solid(shape, {.seed = question.seed}, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
    answer.end = StressEnd::NoVolume;
    answer.why = describe(*reason);
    return;
  }
  const Solid& solid = std::get<Solid>(outcome);
  answer.run.halfspaces = solid.dual.halfspaces;
  SimplifyRequest request;
  const std::size_t faces = faces_for(question, solid.polytope);
  request.faces = faces;
  request.engine = question.engine;
  request.cost = question.cost;
  request.seed = question.seed;
  request.jobs = 1;  // threads reserve addresses, of which the process has a limit
  request.trace = question.engine == Engine::Exact;
  Polytope result = run_pipeline(shape, request, answer);
  if (question.engine != Engine::Exact) take_lean_run(shape, solid, question, faces, answer);
  if (question.engine == Engine::Filtered) {
    request.trace = true;
    const std::vector<Halfspace> left = answer.left;
    const double seconds = answer.seconds;
    (void)run_pipeline(shape, request, answer);
    answer.seconds = seconds;
    if (answer.left != left) {
      throw Error(ErrorCode::Internal, "with a record the filtered engine ends elsewhere");
    }
  }
  if (question.engine == Engine::Float) {
    for (const LeanStep& step : answer.lean) answer.run.steps.emplace_back().removed = step.removed;
  }
  if (question.search.kind != SearchKind::None && question.engine != Engine::Float &&
      result.planes.size() <= kMostSearched) {
    result = take_search(shape, request, question.search, answer);
  }
  if (result.planes.size() <= kMostStored) store_all(result, solid, false, answer);
  if (question.engine == Engine::Filtered && solid.polytope.planes.size() <= kMostStored) {
    store_all(solid.polytope, solid, true, answer);
  }
}

}  // namespace

EngineAnswer answer_of(const Shape& shape, const Question& question) {
  EngineAnswer answer;
  answer.engine = question.engine;
  answer.run.measure = question.cost;
  try {
    answer_for(shape, question, answer);
  } catch (const Error& error) {
    answer.end = StressEnd::Failed;
    answer.why = error.what();
  }
  return answer;
}

}  // namespace convexact
