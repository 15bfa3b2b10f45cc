// SPDX-License-Identifier: MIT
#include "parts/part_volumes.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "number/precision.hpp"

namespace convexact {
namespace {

Measured combine(const Measured& a, int sign, const Measured& b) {
  std::optional<Rational> exact;
  if (a.exact && b.exact) exact = *a.exact + Rational(sign) * *b.exact;
  if (exact) return {Enclosure(*exact, kMeasureBits), exact};
  return {sign > 0 ? a.bounds + b.bounds : a.bounds - b.bounds, std::nullopt};
}

Measured volume_of_parts(const std::vector<ConvexPart>& parts, bool exact, const Watch& watch) {
  Measured total{Enclosure(kMeasureBits), exact ? std::optional<Rational>(0) : std::nullopt};
  for (const ConvexPart& part : parts) {
    if (!part.solid) continue;
    watch.ask();
    Measured own{enclose_volume(*part.solid, kMeasureBits), std::nullopt};
    if (exact) own.exact = volume(*part.solid);
    total = combine(total, 1, own);
  }
  return total;
}

Measured nothing(bool exact) {
  return {Enclosure(kMeasureBits), exact ? std::optional<Rational>(0) : std::nullopt};
}

}  // namespace

DecompositionMeasures measure_volumes(const Surface& surface, const std::vector<ConvexPart>& parts,
                                      const VolumesAsked& asked, StageLog& log) {
  const bool exact = asked.exact;
  DecompositionMeasures found;
  if (asked.wanted == PartMeasures::All) {
    const Watch watch = log.watch("union's volume");
    log.run("union's volume", [&] {
      found.union_volume = union_volume(parts, kMeasureBits, exact, watch, asked.jobs);
      found.overlap_volume = combine(volume_of_parts(parts, exact, watch), -1, *found.union_volume);
    });
    const auto solids = std::count_if(
        parts.begin(), parts.end(), [](const ConvexPart& part) { return part.solid.has_value(); });
    if (solids < 2) found.overlap_volume->bounds = Enclosure(kMeasureBits);  // 0
  } else {
    log.skip("union's volume", "not requested");
  }
  if (!surface.is_closed) {
    log.skip("solid's volumes", "the faces of the input do not close");
    return found;
  }
  if (asked.hold_solid && !asked.with_solid && asked.wanted == PartMeasures::Uncovered) {
    log.skip("solid's volumes", "the parts are proven to hold the solid");
    found.uncovered_volume = nothing(exact);
    return found;
  }
  log.run("solid's volumes", [&] {
    const Watch watch = log.watch("solid's volumes");
    found.solid_volume = solid_volume(surface, kMeasureBits, exact, watch, asked.jobs);
    found.uncovered_volume = asked.hold_solid
                                 ? nothing(exact)
                                 : uncovered_volume(surface, Winding(surface), parts, kMeasureBits,
                                                    exact, watch, asked.jobs);
  });
  if (found.union_volume) {
    found.excess_volume =
        combine(combine(*found.union_volume, -1, *found.solid_volume), 1, *found.uncovered_volume);
  }
  return found;
}

std::optional<Rational> exact_excess(const Surface& surface, const std::vector<ConvexPart>& parts,
                                     const StageWatch& watch, std::size_t jobs) {
  const bool are_solid = std::all_of(parts.begin(), parts.end(),
                                     [](const ConvexPart& part) { return part.solid.has_value(); });
  if (!are_solid) return {};
  StageLog within(watch);
  const VolumesAsked asked{.wanted = PartMeasures::All, .exact = true, .jobs = jobs};
  return measure_volumes(surface, parts, asked, within).excess_volume->exact;
}

VolumeLimit::VolumeLimit(const Surface& surface, Rational share, const Watch& watch,
                         std::size_t jobs)
    : surface_(surface),
      share_(std::move(share)),
      jobs_(jobs),
      solid_(solid_volume(surface, kMeasureBits, false, watch, jobs).bounds) {
  if (solid_.low() > 0) return;
  const Rational& exact = exact_solid(watch);
  if (exact == 0) {
    throw Error(ErrorCode::InvalidArgument,
                "the surface encloses no volume that an excess could be a share of");
  }
  solid_ = Enclosure(exact, kMeasureBits);
}

const Rational& VolumeLimit::exact_solid(const Watch& watch) const {
  return exact_solid_.get(
      [&] { return *solid_volume(surface_, kMeasureBits, true, watch, jobs_).exact; });
}

DecompositionExcess VolumeLimit::excess_of(const std::vector<ConvexPart>& parts,
                                           const Watch& watch) const {
  const Enclosure total = volume_of_parts(parts, false, watch).bounds;
  DecompositionExcess found{share_, total / solid_ - Enclosure(Integer(1), kMeasureBits), true};
  if (found.share.high() <= share_) return found;
  found.holds = found.share.low() <= share_ &&
                *volume_of_parts(parts, true, watch).exact <= (1 + share_) * exact_solid(watch);
  return found;
}

}  // namespace convexact
