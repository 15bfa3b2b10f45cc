// SPDX-License-Identifier: MIT
// measured.hpp - a measured real number: bounds always, the fraction where it was asked for.
#pragma once
#include <optional>

#include "convexact/number/enclosure.hpp"
#include "convexact/number/rational.hpp"

namespace convexact {

struct Measured {
  Enclosure bounds;
  std::optional<Rational> exact;
};

/// Bits of the bounds of a volume: some thirty certain decimal digits.
inline constexpr long kVolumeBits = 128;

}  // namespace convexact
