// SPDX-License-Identifier: MIT
#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/simplify.hpp"
#include "number/precision.hpp"
#include "solid/solid.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

constexpr int kMostDigits = 10000;

// Bounds narrow enough to print `digits` certain digits.
template <class Compute>
Measured measure(const Compute& compute, int digits) {
  const auto narrow_enough = [digits](const Enclosure& bounds) -> std::optional<Enclosure> {
    if (!to_decimal(bounds, digits)) return std::nullopt;
    return bounds;
  };
  const auto bounds = refine(compute, narrow_enough, PrecisionRange{.first = 64 + 4 * digits});
  if (!bounds) throw Error(ErrorCode::Internal, "a measure does not settle");
  return {*bounds, std::nullopt};
}

// Each measure that is asked for, as a separate stage.
void add_measures(HullResult& result, const HullRequest& request, StageLog& log) {
  const Polytope& hull = result.solid.exact;
  const auto run = [&](const char* name, bool is_asked, const auto& compute) {
    std::optional<Measured> measured;
    if (is_asked) {
      measured = log.run(name, [&] {
        const Watch watch = log.watch(name);
        return measure([&](long bits) { return compute(bits, watch); }, request.digits);
      });
    } else {
      log.skip(name, "not among the measures asked for");
    }
    return measured;
  };
  result.volume = run("volume", request.volume,
                      [&](long bits, const Watch&) { return enclose_volume(hull, bits); });
  if (result.volume && request.exact_volume) {
    result.volume->exact = log.run("exact volume", [&] { return volume(hull); });
  } else {
    log.skip("exact volume", "the fraction was not requested");
  }
  result.area = run("area", request.area,
                    [&](long bits, const Watch& watch) { return surface_area(hull, bits, watch); });
  result.mean_width = run("mean width", request.mean_width, [&](long bits, const Watch& watch) {
    return mean_width(hull, bits, watch);
  });
  if (request.inertia) {
    result.mass = log.run("inertia", [&] { return mass_properties(hull); });
  } else {
    log.skip("inertia", "not among the measures asked for");
  }
}

}  // namespace

HullReport measure_hull(const Shape& shape, const HullRequest& request) {
  if (request.digits < 1 || request.digits > kMostDigits) {
    throw Error(ErrorCode::InvalidArgument, "digits: expected 1 to " + std::to_string(kMostDigits));
  }
  require_threads(request.jobs);
  StageLog log(request.watch);
  SolidOutcome outcome =
      make_solid(shape, {.seed = request.seed, .wants_dual = false, .jobs = jobs_of(request)}, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  auto& made = std::get<Solid>(outcome);
  const BoundingBox box = bounding_box(made.polytope.vertices);
  const Measured diameter = measure(
      [&](long bits) { return sqrt(Enclosure(box.squared_diameter(), bits)); }, request.digits);
  std::size_t corners = 0;
  for (const auto& facet : made.polytope.facets) corners += facet.size();
  Stored stored = store(std::move(made.polytope), made.points, made.extreme, request.store, log);
  HullResult result{.input_points = made.input_points,
                    .redundant = std::move(made.redundant),
                    .solid = std::move(stored),
                    .edges = corners / 2,
                    .box = box,
                    .diameter = diameter,
                    .volume = {},
                    .area = {},
                    .mean_width = {},
                    .stages = {}};
  add_measures(result, request, log);
  result.stages = log.stages();
  return result;
}

}  // namespace convexact
