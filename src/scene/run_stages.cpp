// SPDX-License-Identifier: MIT
#include "scene/run_stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/stored.hpp"
#include "fast/checks.hpp"
#include "hull/facet_order.hpp"
#include "number/precision.hpp"
#include "scene/search_stage.hpp"
#include "simplify/replay.hpp"
#include "simplify/step_verification.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

// Of CompareLimits. Fewer bits than the first enclosures have would have no effect; more take
// minutes.
constexpr long kLeastTieBits = 128, kMostTieBits = 1L << 20;

RationalPoint find_center(const Solid& solid, const SimplifyRequest& request, StageLog& log) {
  const std::vector<Halfspace>& halfspaces = solid.dual.halfspaces;
  if (request.center) return given_center(*request.center, halfspaces, log);
  if (request.engine != Engine::Exact) {
    log.skip("Chebyshev center", "any interior point serves this engine");
    return log.run("center", [&] { return interior_point_of(solid); });
  }
  return certified_center(halfspaces, {.seed = request.seed}, log).center;
}

// The exact planes of the survivors alone, and their solid.
Polytope polytope_of(const FastResult& result, const FastDual& dual, Engine engine) {
  std::vector<HalfspaceId> survivors = result.survivors;  // ids of a FastDual need not be canonical
  std::sort(survivors.begin(), survivors.end(),
            [&](HalfspaceId a, HalfspaceId b) { return dual.precedes(a, b); });
  std::vector<Halfspace> halfspaces;
  std::unordered_map<HalfspaceId, HalfspaceId> position;
  for (const HalfspaceId id : survivors) {
    position.emplace(id, HalfspaceId(halfspaces.size()));
    halfspaces.push_back(dual.exact(id));
  }
  if (engine == Engine::Float && !is_dual_hull(dual, result.triangles)) {
    // Doubles computed this topology wrongly: the solid comes from the planes alone.
    const DualHull exact = dual_of(halfspaces, dual.center()).dual;
    return to_polytope(exact.halfspaces, exact.triangles);
  }
  std::vector<DualTriangle> triangles;
  for (const DualTriangle& t : result.triangles) {
    triangles.push_back({position.at(t[0]), position.at(t[1]), position.at(t[2])});
  }
  return to_polytope(halfspaces, triangles);
}

// The data that the proof of a run needs besides the run.
RunStart start_of(const Shape& shape, const Solid& solid) {
  RunStart start;
  if (const auto* halfspaces = std::get_if<std::vector<Halfspace>>(&shape)) {
    start.input_halfspaces = *halfspaces;
  }
  start.dual = solid.dual;
  start.inside = solid.certificate.inside;
  start.extreme = solid.extreme;
  if (solid.interior) {
    start.interior = *solid.interior;
  } else {
    RationalPoint sum = RationalPoint::Zero();
    for (const PointId corner : solid.certificate.simplex) sum += solid.points[corner];
    start.interior = sum / Rational(4);
  }
  return start;
}

const char* measure_stage(CostMeasure measure) {
  return measure == CostMeasure::Area ? "area" : "mean width";
}

// The measure whose growth is limited, if it is neither the measure of the costs nor the volume: a
// further one to be reported.
std::optional<CostMeasure> limited_measure(const SimplifyRequest& request) {
  if (!request.growth_of || request.growth_of == request.cost ||
      request.growth_of == CostMeasure::Volume) {
    return {};
  }
  return request.growth_of;
}

Measured measure_volume(const Polytope& polytope, bool exact) {
  if (!exact) return {enclose_volume(polytope, kMeasureBits), std::nullopt};
  const Rational value = volume(polytope);
  return {Enclosure(value, kMeasureBits), value};
}

// The final test, by the definition of containment alone. Returns how many points were tested.
std::size_t verify_containment(const PointSet& points, const Polytope& result,
                               const SimplifyRequest& request, StageLog& log) {
  if (request.verify == VerifyLevel::None) {
    log.skip("containment", "no verification was requested");
    return 0;
  }
  const std::size_t outside = log.run(
      "containment", [&] { return count_outside(result.planes, points, jobs_of(request)); });
  if (outside != 0) {
    throw Error(ErrorCode::Internal,
                fmt::format("{} input points lie outside the result", outside));
  }
  return points.size();
}

// The exact engine does this while it runs; the filtered one makes the local checks only.
void verify_steps(const Run& run, const DualHull& dual, const SimplifyRequest& request) {
  StepVerification verification(dual, request.verify, request.seed, request.cost);
  for (const Step& step : run.steps) verification.check(step);
  verification.finish();
}

// The places of the kept facets in the result. @throws Error Internal if it has lost one.
std::vector<KeptFacet> find_kept(const std::vector<Halfspace>& halfspaces,
                                 const std::vector<HalfspaceId>& keep,
                                 const std::vector<Halfspace>& planes) {
  std::vector<KeptFacet> kept;
  for (const HalfspaceId id : keep) {
    const auto plane = std::find(planes.begin(), planes.end(), halfspaces[id.index()]);
    if (plane == planes.end()) throw Error(ErrorCode::Internal, "a facet to be kept is gone");
    kept.push_back({id, static_cast<std::size_t>(plane - planes.begin())});
  }
  return kept;
}

bool keeps_record(const SimplifyRequest& request) {
  return request.engine == Engine::Exact || request.trace || request.verify == VerifyLevel::Full ||
         (request.record && request.engine != Engine::Float);
}

// Whether the whole input is not needed as an exact solid.
bool is_lean(const Shape& shape, const SimplifyRequest& request) {
  const bool needs_solid =
      request.center || !request.keep.empty() || request.search.kind == SearchKind::Optimal;
  return std::holds_alternative<PointSet>(shape) && !keeps_record(request) && !request.record &&
         !needs_solid;
}

}  // namespace

void require_sensible(const SimplifyRequest& request) {
  if (!request.faces && !request.max_growth) {
    throw Error(ErrorCode::InvalidArgument, "give a number of faces, a growth limit, or both");
  }
  if (request.growth_of && !request.max_growth) {
    throw Error(ErrorCode::InvalidArgument,
                "a measure whose growth is limited needs a limit: give the growth as well");
  }
  require_threads(request.jobs);
  if (request.faces && *request.faces < 4) {
    throw Error(ErrorCode::InvalidArgument, "no bounded solid has fewer than 4 faces");
  }
  if (request.max_growth && *request.max_growth < 0) {
    throw Error(ErrorCode::InvalidArgument, "the growth cannot be negative");
  }
  if (request.compare.bits < kLeastTieBits || request.compare.bits > kMostTieBits) {
    throw Error(ErrorCode::InvalidArgument,
                fmt::format("mean widths are compared with {} to {} bits, not {}", kLeastTieBits,
                            kMostTieBits, request.compare.bits));
  }
  require_sensible_search(request);
  if (request.engine == Engine::Float && (request.trace || request.verify == VerifyLevel::Full)) {
    throw Error(ErrorCode::InvalidArgument,
                "the float engine keeps no record of its steps: no trace, no full verification");
  }
  if (request.engine == Engine::Float && request.growth_of.value_or(request.cost) != request.cost) {
    throw Error(ErrorCode::InvalidArgument,
                "the float engine limits the growth of the measure of its costs only; the filtered "
                "engine limits any");
  }
}

std::variant<std::unique_ptr<RunInput>, NotSolid> prepare_run(const Shape& shape,
                                                              const SimplifyRequest& request,
                                                              StageLog& log) {
  auto input = std::make_unique<RunInput>(shape);
  const auto* points = std::get_if<PointSet>(&shape);
  if (is_lean(shape, request)) {
    auto outcome =
        make_hull(*points, {.seed = request.seed, .check = false, .jobs = jobs_of(request)}, log);
    if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
    Hull& hull = input->hull.emplace(std::get<Hull>(std::move(outcome)));
    log.skip("Chebyshev center", "any interior point serves this engine");
    if (request.search.kind != SearchKind::None) {
      // A search names facets by their ids, and visits them in this order.
      log.run("exact planes", [&] { hull.facets = in_canonical_order(hull, *points); });
    } else {
      log.skip("exact planes",
               "formed for the remaining halfspaces, and where doubles cannot decide");
    }
    input->dual.emplace(log.run("dual", [&] { return FastDual::of(*input->hull, *points); }));
    return input;
  }
  SolidOutcome outcome = make_solid(shape,
                                    {.seed = request.seed,
                                     .check = request.verify != VerifyLevel::None,
                                     .jobs = jobs_of(request)},
                                    log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  input->solid = std::get<Solid>(std::move(outcome));
  input->center = find_center(*input->solid, request, log);
  if (!request.keep.empty()) {
    input->keep = log.run("facets to keep", [&] {
      return select_facets(input->solid->dual.halfspaces, points != nullptr ? *points : PointSet(),
                           request.keep, request.faces);
    });
  }
  if (!keeps_record(request)) input->dual.emplace(FastDual::of(input->solid->dual, input->center));
  return input;
}

SimplifyOptions options_of(const SimplifyRequest& request, const RunInput& input) {
  SimplifyOptions options;
  options.keep = input.keep;
  options.faces = request.faces.value_or(4);
  options.max_growth = request.max_growth;
  options.growth_of = request.growth_of;
  options.cost = request.cost;
  options.compare = request.compare;
  options.seed = request.seed;
  options.verify = request.verify;
  // The proof of a run by mean width shows its removals only.
  options.keep_evaluations = request.record && request.cost != CostMeasure::MeanWidth;
  options.jobs = jobs_of(request);
  options.watch = request.watch.of(stage::kSimplify);
  return options;
}

RunEnd end_of(const FastResult& result, const FastDual& dual, Engine engine, StageLog& log) {
  RunEnd end{.steps = result.steps.size(),
             .stop = result.stop,
             .polytope = log.run("polytope", [&] { return polytope_of(result, dual, engine); }),
             .triangles = result.triangles,
             .bound = result.bound,
             .ties = result.ties,
             .growth_bits = result.growth_bits};
  for (const FastStep& step : result.steps) end.removed.push_back(step.removed);
  return end;
}

RunEnd end_of(Run run, StageLog& log) {
  RunEnd end{
      .steps = run.steps.size(),
      .stop = run.stop,
      .polytope = log.run("polytope", [&] { return to_polytope(run.halfspaces, run.triangles); }),
      .triangles = run.triangles,
      .growth_bits = run.growth_bits};
  for (const Step& step : run.steps) end.ties.add(step.tie_evidence);
  end.run = std::move(run);
  return end;
}

const Enclosure& InputMeasures::of(CostMeasure kind, CostMeasure cost) const {
  return kind == CostMeasure::Volume ? volume.bounds : kind == cost ? *measure : *limited;
}

InputMeasures measure_input(const RunInput& input, const SimplifyRequest& request, StageLog& log) {
  const auto* points = std::get_if<PointSet>(&input.shape);
  InputMeasures result{log.run("volume", [&]() -> Measured {
    if (!input.hull) return measure_volume(input.solid->polytope, request.exact_volumes);
    const Rational exact = volume(*input.hull, *points);
    return {Enclosure(exact, kMeasureBits),
            request.exact_volumes ? std::optional(exact) : std::nullopt};
  })};
  const auto enclosed = [&](CostMeasure measure) {
    return log.run(measure_stage(measure), [&] {
      return input.hull ? enclose_measure(*input.hull, *points, measure, kMeasureBits)
                        : enclose_measure(input.solid->polytope, measure, kMeasureBits);
    });
  };
  if (request.cost != CostMeasure::Volume) result.measure = enclosed(request.cost);
  if (const auto measure = limited_measure(request)) result.limited = enclosed(*measure);
  return result;
}

namespace {

// The record of an engine that keeps none, where it is wanted, and the second check of steps.
void complete_record(RunEnd& end, const RunInput& input, const SimplifyRequest& request,
                     StageLog& log) {
  if (request.record && !end.run) {
    end.run = log.run("replay", [&] {
      return replay(input.solid->dual, input.center, end.removed, request.seed);
    });
    end.run->kept = input.keep;
  }
  if (request.engine == Engine::Filtered && request.verify == VerifyLevel::Full) {
    log.run("steps again", [&] { verify_steps(*end.run, input.solid->dual, request); });
  }
}

// The measures of a result, those of InputMeasures beside those before.
struct OutputMeasures {
  Measured volume;
  std::optional<std::array<Enclosure, 2>> measure = {}, limited = {};
};

OutputMeasures measure_output(const Polytope& polytope, const InputMeasures& before,
                              const SimplifyRequest& request, StageLog& log) {
  OutputMeasures after{
      log.run("volume", [&] { return measure_volume(polytope, request.exact_volumes); })};
  if (!request.exact_volumes) log.skip("exact volume", "the fraction was not requested");
  const auto compared = [&](const Enclosure& of_input, CostMeasure measure) {
    return std::array<Enclosure, 2>{of_input, log.run(measure_stage(measure), [&] {
                                      return enclose_measure(polytope, measure, kMeasureBits);
                                    })};
  };
  if (before.measure) {
    after.measure = compared(*before.measure, request.cost);
  } else {
    log.skip("area and mean width", "the run is by volume; hull reports them");
  }
  if (before.limited) after.limited = compared(*before.limited, *request.growth_of);
  return after;
}

}  // namespace

SimplifyResult finish_run(RunInput& input, InputMeasures before, RunEnd end,
                          const SimplifyRequest& request, StageLog& log) {
  std::optional<Solid>& solid = input.solid;
  std::optional<RunStart> start;
  if (request.record) start = start_of(input.shape, *solid);
  complete_record(end, input, request, log);
  std::vector<KeptFacet> kept;
  if (solid) kept = find_kept(solid->dual.halfspaces, input.keep, end.polytope.planes);
  OutputMeasures after = measure_output(end.polytope, before, request, log);
  const PointSet& points = solid ? solid->points : std::get<PointSet>(input.shape);
  const std::vector<PointId>& extreme = solid ? solid->extreme : input.hull->vertices;
  const std::size_t tested = verify_containment(points, end.polytope, request, log);
  Stored stored = store(std::move(end.polytope), points, extreme, request.store, log);
  return SimplifyResult{
      .input_points = solid ? solid->input_points : points.size(),
      .hull_vertices = extreme.size(),
      .redundant = solid ? std::move(solid->redundant) : std::vector<std::size_t>(),
      .input_halfspaces = input.halfspaces(),
      .steps = end.steps,
      .stop = end.stop,
      .kept = std::move(kept),
      .run = std::move(end.run),
      .start = std::move(start),
      .solid = std::move(stored),
      .input_volume = std::move(before.volume),
      .output_volume = std::move(after.volume),
      .cost = request.cost,
      .measure = std::move(after.measure),
      .growth_of = request.max_growth ? std::optional(request.growth_of.value_or(request.cost))
                                      : std::nullopt,
      .limited = std::move(after.limited),
      .growth_bits = end.growth_bits,
      .ties = end.ties,
      .tested_points = tested,
      .engine = request.engine,
      .verified = request.verify,
      .search = std::move(end.search),
      .float_bound = end.bound,
      .stages = log.stages()};
}

bool is_growth_proven(std::size_t steps, StopReason stop, const std::optional<Rational>& least_next,
                      const std::array<Enclosure, 2>& measure, const Rational& max_growth) {
  const auto& [before, after] = measure;
  const Rational most = 1 + max_growth;
  const bool is_kept = steps == 0 || after.high() <= most * before.low();
  if (!is_kept || stop != StopReason::GrowthLimit) return is_kept;
  return !least_next || after.low() + *least_next > most * before.high();
}

std::optional<Rational> least_next(const FloatBound& bound, const RunInput& input,
                                   CostMeasure cost) {
  if (std::isinf(bound.least_next)) return {};
  return scale_by_power_of_two(to_rational(bound.least_next), input.dual->cost_exponent(cost));
}

}  // namespace convexact
