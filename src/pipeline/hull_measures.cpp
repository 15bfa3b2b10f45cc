// SPDX-License-Identifier: MIT
#include "convexact/pipeline/hull_measures.hpp"

#include "convexact/error.hpp"
#include "convexact/measure/mean_width.hpp"
#include "convexact/measure/surface_area.hpp"
#include "convexact/measure/volume.hpp"
#include "convexact/number/digits.hpp"
#include "convexact/number/refine.hpp"

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

}  // namespace

HullReport measure_hull(const Shape& shape, const HullRequest& request, StageLog& log) {
  if (request.digits < 1 || request.digits > kMostDigits) {
    throw Error(ErrorCode::InvalidArgument, "digits: expected 1 to " + std::to_string(kMostDigits));
  }
  SolidOutcome outcome = make_solid(shape, request.seed, true, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  auto& made = std::get<Solid>(outcome);
  StoredSolid solid =
      store(std::move(made.polytope), made.points, made.extreme, request.store, log);
  const Polytope& hull = solid.exact;
  const BoundingBox box = bounding_box(hull.vertices);
  std::size_t corners = 0;
  for (const auto& facet : hull.facets) corners += facet.size();

  Measured volume_measured = log.run("volume", [&] {
    Measured measured =
        measure([&](long bits) { return enclose_volume(hull, bits); }, request.digits);
    if (request.exact_volume) measured.exact = volume(hull);
    return measured;
  });
  if (!request.exact_volume) log.skip("exact volume", "nobody asked for the fraction");
  const Measured area = log.run("area", [&] {
    return measure([&](long bits) { return surface_area(hull, bits); }, request.digits);
  });
  const Measured width = log.run("mean width", [&] {
    return measure([&](long bits) { return mean_width(hull, bits); }, request.digits);
  });
  const Measured diameter = measure(
      [&](long bits) { return sqrt(Enclosure(box.squared_diameter(), bits)); }, request.digits);
  return HullResult{made.input_points,
                    std::move(made.redundant),
                    std::move(solid),
                    corners / 2,
                    box,
                    diameter,
                    volume_measured,
                    area,
                    width};
}

}  // namespace convexact
