// SPDX-License-Identifier: MIT
#include "convexact/oracle/tightness.hpp"

#include "convexact/measure/distance.hpp"
#include "convexact/measure/mean_width.hpp"
#include "convexact/measure/surface_area.hpp"
#include "convexact/measure/volume.hpp"

namespace convexact {
namespace {

constexpr long kRatioBits = 96;  // some twenty certain decimal digits of each ratio

}  // namespace

Tightness measure_tightness(const Polytope& candidate, const Polytope& hull, bool contained,
                            const std::atomic<bool>* stop) {
  Rational squared = hausdorff_distance(candidate, hull, stop).squared;
  if (!contained) squared = std::max(squared, hausdorff_distance(hull, candidate, stop).squared);
  return {enclose_volume(candidate, kRatioBits) / enclose_volume(hull, kRatioBits),
          surface_area(candidate, kRatioBits) / surface_area(hull, kRatioBits),
          mean_width(candidate, kRatioBits, stop) / mean_width(hull, kRatioBits, stop),
          std::move(squared)};
}

}  // namespace convexact
