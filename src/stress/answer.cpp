// SPDX-License-Identifier: MIT
#include "stress/answer.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "fast/filtered_engine.hpp"
#include "fast/float_engine.hpp"
#include "scene/solid.hpp"

namespace convexact {
namespace {

// Processor time of this process, not wall time: other load must not count.
double processor_time() {
  timespec now{};
  (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Range range_of(const Measured& measured) { return {measured.bounds.low(), measured.bounds.high()}; }

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

std::size_t faces_for(const Question& question, const Polytope& polytope) {
  const std::size_t size = polytope.planes.size();
  if (question.most_steps >= size) return question.faces;
  constexpr std::size_t kShort = 140;  // what takes as long with rings of any ordinary length
  if (size * (largest_valence(polytope) + kShort) <= question.most_work) return question.faces;
  return std::max(question.faces, size - question.most_steps);
}

void take_trace(const Trace& trace, EngineAnswer& answer) {
  for (const Step& step : trace.steps) {
    answer.removed.push_back(step.removed);
    answer.costs.push_back(step.cost);
    answer.ties.push_back(step.tie);
  }
}

// The pipeline as users run it; the only part whose time is taken.
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
  answer.input_volume = range_of(result->input_volume);
  answer.output_volume = range_of(result->output_volume);
  answer.left = result->solid.exact.planes;
  if (const auto& bound = result->float_bound) {
    answer.claim = {bound->cost, bound->regret, bound->doubtful, bound->is_end_proven,
                    bound->is_vouched()};
  }
  if (result->trace) take_trace(*result->trace, answer);
  return std::move(result->solid.exact);
}

// The steps of the run that keeps no record: the same computation as the pipeline's.
void take_lean_run(const FastDual& dual, const Question& question, std::size_t faces,
                   EngineAnswer& answer) {
  SimplifyOptions options;
  options.faces = faces;
  options.seed = question.seed;
  const FastResult result = question.engine == Engine::Float ? simplify_float(dual, options)
                                                             : simplify_filtered(dual, options);
  for (const FastStep& step : result.steps) {
    answer.lean_removed.push_back(canonical_id(answer.halfspaces, dual.exact(step.removed)));
    answer.lean_tied.push_back(step.tied);
    const auto exact = [&](double x) {  // an infinite end encloses nothing: any number will do
      return std::isfinite(x) ? scale_by_power_of_two(to_rational(x), dual.volume_exponent())
                              : Rational(-1);
    };
    answer.lean_costs.push_back({exact(step.cost_lower), exact(step.cost_upper)});
  }
}

void take_lean_run(const Shape& shape, const Solid& solid, const Question& question,
                   std::size_t faces, EngineAnswer& answer) {
  const auto* points = std::get_if<PointSet>(&shape);
  if (points == nullptr) {
    return take_lean_run(FastDual::of(solid.dual, interior_point_of(solid)), question, faces,
                         answer);
  }
  const HullOutcome outcome = convex_hull(*points, {.seed = question.seed});
  take_lean_run(FastDual::of(std::get<Hull>(outcome), *points), question, faces, answer);
}

// One form and precision. Refusing is an answer.
void store_one(const Polytope& result, const Solid& solid, StoredBytes stored,
               EngineAnswer& answer) {
  StageLog log;
  StoreRequest request;
  const bool planes = stored.form == StressStored::Form::Planes;
  (planes ? request.planes : request.mesh) = stored.precision;
  try {
    const StoredSolid kept = store(result, solid.points, solid.extreme, request, log);
    stored.bytes =
        planes ? write_halfspaces(kept.planes->planes, HalfspaceFormat::Json)
               : write_mesh(kept.mesh->mesh, MeshFormat::Obj, {.precision = stored.precision});
    const Growth& growth = planes ? kept.planes->growth : kept.mesh->growth;
    stored.push = growth.push;
    stored.volume_ratio = growth.volume_ratio;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Unrepresentable) throw;
    stored.refused = true;
    stored.why = error.what();
  }
  answer.stored.push_back(std::move(stored));
}

void store_all(const Polytope& result, const Solid& solid, bool whole, EngineAnswer& answer) {
  for (const auto form : {StressStored::Form::Planes, StressStored::Form::Mesh}) {
    for (const Precision precision : {Precision::Binary64, Precision::Binary32}) {
      store_one(result, solid, {form, precision, whole, false, {}, {}, 0, 1}, answer);
    }
  }
}

void answer_for(const Shape& shape, const Question& question, EngineAnswer& answer) {
  StageLog log;
  const SolidOutcome outcome = make_solid(shape, question.seed, true, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
    answer.end = StressEnd::NoVolume;
    answer.why = describe(*reason);
    return;
  }
  const Solid& solid = std::get<Solid>(outcome);
  answer.halfspaces = solid.dual.halfspaces;
  SimplifyRequest request;
  const std::size_t faces = faces_for(question, solid.polytope);
  request.faces = faces;
  request.engine = question.engine;
  request.seed = question.seed;
  request.trace = question.engine == Engine::Exact;
  const Polytope result = run_pipeline(shape, request, answer);
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
  if (question.engine == Engine::Float) answer.removed = answer.lean_removed;
  if (result.planes.size() <= question.most_stored) store_all(result, solid, false, answer);
  if (question.engine == Engine::Filtered && solid.polytope.planes.size() <= question.most_stored) {
    store_all(solid.polytope, solid, true, answer);
  }
}

}  // namespace

EngineAnswer answer_of(const Shape& shape, const Question& question) {
  EngineAnswer answer;
  answer.engine = question.engine;
  try {
    answer_for(shape, question, answer);
  } catch (const Error& error) {
    answer.end = StressEnd::Failed;
    answer.why = error.what();
  }
  return answer;
}

}  // namespace convexact
