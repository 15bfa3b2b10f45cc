// SPDX-License-Identifier: MIT
#include "convexact/simplify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"
#include "convexact/stored.hpp"
#include "fast/checks.hpp"
#include "fast/filtered_engine.hpp"
#include "fast/float_engine.hpp"
#include "lp/interior_point.hpp"
#include "number/precision.hpp"
#include "scene/solid.hpp"
#include "simplify/exact_engine.hpp"
#include "simplify/replay.hpp"

namespace convexact {
namespace {

// Of CompareLimits. Fewer bits than the first enclosures have would be none; more take minutes.
constexpr long kLeastTieBits = 128, kMostTieBits = 1L << 20;

void require_sensible(const SimplifyRequest& request) {
  if (!request.faces && !request.max_growth) {
    throw Error(ErrorCode::InvalidArgument, "give a number of faces, a growth limit, or both");
  }
  if (request.growth_of && !request.max_growth) {
    throw Error(ErrorCode::InvalidArgument,
                "a measure whose growth is limited needs a limit: give the growth as well");
  }
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

SimplifyOptions options_of(const SimplifyRequest& request, std::size_t at_start,
                           std::vector<HalfspaceId> keep) {
  SimplifyOptions options;
  options.keep = std::move(keep);
  options.faces = request.faces.value_or(4);
  options.max_growth = request.max_growth;
  options.growth_of = request.growth_of;
  options.cost = request.cost;
  options.compare = request.compare;
  options.seed = request.seed;
  options.verify = request.verify;
  // The proof of a run by mean width shows its removals only.
  options.keep_evaluations = request.record && request.cost != CostMeasure::MeanWidth;
  options.stop = request.watch.stop;
  if (request.watch.progress) {
    options.progress = [&request, at_start, faces = options.faces](std::size_t left) {
      request.watch.progress(stage::kSimplify, at_start - left, at_start - faces);
    };
  }
  return options;
}

// Where a run led, whichever engine made it.
struct End {
  std::size_t halfspaces, steps;
  StopReason stop;
  Polytope polytope;
  std::vector<HalfspaceId> removed;  // by an engine that keeps no record
  std::optional<Run> run;
  std::optional<FloatBound> bound;
  long cost_exponent = 0;  // of costs in `bound`
  TieTally ties = {};
  long growth_bits = 0;
};

// What the result is measured against.
struct Reference {
  PointSet points;
  std::vector<PointId> extreme;
  std::size_t input_points;
  std::vector<std::size_t> redundant;
  Measured volume;
  std::optional<Enclosure> measure = {};  // that the run keeps small, unless it is the volume
  std::optional<Enclosure> limited = {};  // whose growth is limited, unless it is one of those
};

RationalPoint chebyshev_stage(const std::vector<Halfspace>& halfspaces, std::uint64_t seed,
                              StageLog& log) {
  return log.run("Chebyshev center", [&] {
    const auto outcome = chebyshev_center(halfspaces, LpOptions{.seed = seed});
    const auto* center = std::get_if<ChebyshevCenter>(&outcome);
    if (center == nullptr || !check(halfspaces, *center)) {
      throw Error(ErrorCode::Internal, "the certificate fails: a largest ball in the hull");
    }
    return center->center;
  });
}

RationalPoint find_center(const Solid& solid, const SimplifyRequest& request, StageLog& log) {
  const std::vector<Halfspace>& halfspaces = solid.dual.halfspaces;
  if (request.center) {
    log.skip("Chebyshev center", "the caller gave a center");
    if (!is_strictly_inside(halfspaces, *request.center)) {
      throw Error(ErrorCode::InvalidArgument, "the center is not strictly inside the input's hull");
    }
    return *request.center;
  }
  if (request.engine != Engine::Exact) {
    log.skip("Chebyshev center", "any interior point serves this engine");
    return log.run("center", [&] { return interior_point_of(solid); });
  }
  return chebyshev_stage(halfspaces, request.seed, log);
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

// @param keep  Of a dual whose ids are canonical.
End run_lean(const FastDual& dual, const std::vector<HalfspaceId>& keep,
             const SimplifyRequest& request, StageLog& log) {
  const FastResult result = log.run(stage::kSimplify, [&] {
    const SimplifyOptions options = options_of(request, dual.size(), keep);
    return request.engine == Engine::Float ? simplify_float(dual, options)
                                           : simplify_filtered(dual, options);
  });
  Polytope polytope =
      log.run("polytope", [&] { return polytope_of(result, dual, request.engine); });
  End end{dual.size(),  result.steps.size(),
          result.stop,  std::move(polytope),
          {},           {},
          result.bound, dual.cost_exponent(request.cost),
          result.ties,  result.growth_bits};
  for (const FastStep& step : result.steps) end.removed.push_back(step.removed);
  return end;
}

End run_with_record(const Solid& solid, const RationalPoint& center,
                    const std::vector<HalfspaceId>& keep, const SimplifyRequest& request,
                    StageLog& log) {
  Run run = log.run(stage::kSimplify, [&] {
    const SimplifyOptions options = options_of(request, solid.dual.halfspaces.size(), keep);
    return request.engine == Engine::Exact ? simplify_exact(solid.dual, center, options)
                                           : simplify_filtered(solid.dual, center, options);
  });
  Polytope polytope =
      log.run("polytope", [&] { return to_polytope(run.halfspaces, run.triangles); });
  const std::size_t halfspaces = run.halfspaces.size(), steps = run.steps.size();
  const StopReason stop = run.stop;
  End end{halfspaces, steps, stop, std::move(polytope), {}, {}, {}};
  for (const Step& step : run.steps) end.ties.add(step.tie_evidence);
  end.growth_bits = run.growth_bits;
  end.run = std::move(run);
  return end;
}

// What the proof of a run needs beside the run.
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

// If it is neither the measure of the costs nor the volume: a further one to be reported.
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
std::size_t verify_containment(const PointSet& points, const Polytope& result, VerifyLevel level,
                               StageLog& log) {
  if (level == VerifyLevel::None) {
    log.skip("containment", "no verification was requested");
    return 0;
  }
  const std::size_t outside =
      log.run("containment", [&] { return count_outside(result.planes, points); });
  if (outside != 0) {
    throw Error(ErrorCode::Internal,
                fmt::format("{} input points lie outside the result", outside));
  }
  return points.size();
}

// A growth limit is compared in doubles while the float engine runs; here are enclosed measures.
bool is_growth_proven(const End& end, const Enclosure& before, const Enclosure& after,
                      const Rational& max_growth) {
  const Rational most = 1 + max_growth;
  const bool is_kept = end.steps == 0 || after.high() <= most * before.low();
  if (!is_kept || end.stop != StopReason::GrowthLimit) return is_kept;
  if (std::isinf(end.bound->least_next)) return true;
  const Rational next =
      scale_by_power_of_two(to_rational(end.bound->least_next), end.cost_exponent);
  return after.low() + next > most * before.high();
}

SimplifyResult finish(Reference reference, End end, const SimplifyRequest& request, StageLog& log) {
  std::optional<std::array<Enclosure, 2>> result_measure;
  Measured output_volume =
      log.run("volume", [&] { return measure_volume(end.polytope, request.exact_volumes); });
  if (!request.exact_volumes) log.skip("exact volume", "the fraction was not requested");
  if (reference.measure) {
    result_measure =
        std::array<Enclosure, 2>{*reference.measure, log.run(measure_stage(request.cost), [&] {
                                   return enclose_measure(end.polytope, request.cost, kMeasureBits);
                                 })};
  } else {
    log.skip("area and mean width", "the run is by volume; hull reports them");
  }
  std::optional<std::array<Enclosure, 2>> limited;
  if (const auto measure = limited_measure(request)) {
    limited =
        std::array<Enclosure, 2>{*reference.limited, log.run(measure_stage(*measure), [&] {
                                   return enclose_measure(end.polytope, *measure, kMeasureBits);
                                 })};
  }
  if (end.bound && request.max_growth) {
    const auto [before, after] =
        result_measure.value_or(std::array{reference.volume.bounds, output_volume.bounds});
    end.bound->is_end_proven &= is_growth_proven(end, before, after, *request.max_growth);
  }
  const std::size_t tested =
      verify_containment(reference.points, end.polytope, request.verify, log);
  Stored stored =
      store(std::move(end.polytope), reference.points, reference.extreme, request.store, log);
  return SimplifyResult{.input_points = reference.input_points,
                        .hull_vertices = reference.extreme.size(),
                        .redundant = std::move(reference.redundant),
                        .input_halfspaces = end.halfspaces,
                        .steps = end.steps,
                        .stop = end.stop,
                        .kept = {},
                        .run = std::move(end.run),
                        .start = {},
                        .solid = std::move(stored),
                        .input_volume = std::move(reference.volume),
                        .output_volume = std::move(output_volume),
                        .cost = request.cost,
                        .measure = std::move(result_measure),
                        .growth_of = request.max_growth
                                         ? std::optional(request.growth_of.value_or(request.cost))
                                         : std::nullopt,
                        .limited = std::move(limited),
                        .growth_bits = end.growth_bits,
                        .ties = end.ties,
                        .tested_points = tested,
                        .engine = request.engine,
                        .verified = request.verify,
                        .float_bound = end.bound,
                        .stages = log.stages()};
}

// Points, without a record of the steps: exact planes are formed for the remaining halfspaces only.
SimplifyOutcome simplify_lean(const PointSet& points, const SimplifyRequest& request,
                              StageLog& log) {
  auto outcome = make_hull(points, request.seed, false, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  const auto& hull = std::get<Hull>(outcome);
  log.skip("Chebyshev center", "any interior point serves this engine");
  log.skip("exact planes", "formed for the remaining halfspaces, and where doubles cannot decide");
  const FastDual dual = log.run("dual", [&] { return FastDual::of(hull, points); });
  End end = run_lean(dual, {}, request, log);
  Measured input_volume = log.run("volume", [&] {
    const Rational exact = volume(hull, points);
    return Measured{Enclosure(exact, kMeasureBits), exact};
  });
  if (!request.exact_volumes) input_volume.exact.reset();
  Reference reference{points, hull.vertices, points.size(), {}, std::move(input_volume)};
  return finish(std::move(reference), std::move(end), request, log);
}

// Where the result has them. @throws Error Internal if it has lost one.
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

SimplifyOutcome simplify_solid(const Shape& shape, const SimplifyRequest& request, bool record,
                               StageLog& log) {
  SolidOutcome outcome = make_solid(shape, request.seed, request.verify != VerifyLevel::None, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  auto& solid = std::get<Solid>(outcome);
  const RationalPoint center = find_center(solid, request, log);
  const auto* points = std::get_if<PointSet>(&shape);
  std::vector<HalfspaceId> keep;
  if (!request.keep.empty()) {
    keep = log.run("facets to keep", [&] {
      return select_facets(solid.dual.halfspaces, points != nullptr ? *points : PointSet(),
                           request.keep, request.faces);
    });
  }
  End end = record ? run_with_record(solid, center, keep, request, log)
                   : run_lean(FastDual::of(solid.dual, center), keep, request, log);
  const std::vector<KeptFacet> kept = find_kept(solid.dual.halfspaces, keep, end.polytope.planes);
  Measured input_volume =
      log.run("volume", [&] { return measure_volume(solid.polytope, request.exact_volumes); });
  std::optional<Enclosure> input_measure;
  if (request.cost != CostMeasure::Volume) {
    input_measure = log.run(measure_stage(request.cost), [&] {
      return enclose_measure(solid.polytope, request.cost, kMeasureBits);
    });
  }
  std::optional<Enclosure> input_limited;
  if (const auto measure = limited_measure(request)) {
    input_limited = log.run(measure_stage(*measure), [&] {
      return enclose_measure(solid.polytope, *measure, kMeasureBits);
    });
  }
  std::optional<RunStart> start;
  if (request.record) start = start_of(shape, solid);
  if (request.record && !end.run) {
    end.run =
        log.run("replay", [&] { return replay(solid.dual, center, end.removed, request.seed); });
    end.run->kept = keep;
  }
  Reference reference{std::move(solid.points), std::move(solid.extreme),
                      solid.input_points,      std::move(solid.redundant),
                      std::move(input_volume), std::move(input_measure),
                      std::move(input_limited)};
  SimplifyResult result = finish(std::move(reference), std::move(end), request, log);
  result.start = std::move(start);
  result.kept = kept;
  return result;
}

}  // namespace

SimplifyOutcome simplify(const Shape& shape, const SimplifyRequest& request) {
  require_sensible(request);
  StageLog log(request.watch);
  const bool record = request.engine == Engine::Exact || request.trace ||
                      request.verify == VerifyLevel::Full ||
                      (request.record && request.engine != Engine::Float);
  const auto* points = std::get_if<PointSet>(&shape);
  const bool needs_polytope = request.center || request.cost != CostMeasure::Volume ||
                              limited_measure(request) || !request.keep.empty();
  if (points != nullptr && !record && !request.record && !needs_polytope) {
    return simplify_lean(*points, request, log);
  }
  return simplify_solid(shape, request, record, log);
}

}  // namespace convexact
