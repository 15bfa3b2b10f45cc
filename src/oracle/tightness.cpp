// SPDX-License-Identifier: MIT
#include "convexact/oracle/tightness.hpp"

#include "convexact/measure/distance.hpp"
#include "convexact/measure/mean_width.hpp"
#include "convexact/measure/surface_area.hpp"
#include "convexact/measure/volume.hpp"

namespace convexact {
namespace {

constexpr long kBits = 96;  // some twenty certain decimal digits of each ratio

}  // namespace

Tightness measure_tightness(const Polytope& candidate, const Polytope& hull, bool contained) {
  Rational squared = hausdorff_distance(candidate, hull).squared;
  if (!contained) squared = std::max(squared, hausdorff_distance(hull, candidate).squared);
  return {enclose_volume(candidate, kBits) / enclose_volume(hull, kBits),
          surface_area(candidate, kBits) / surface_area(hull, kBits),
          mean_width(candidate, kBits) / mean_width(hull, kBits), std::move(squared)};
}

}  // namespace convexact
