// SPDX-License-Identifier: MIT
#include "convexact/measure.hpp"
#include "convexact/verify.hpp"

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
