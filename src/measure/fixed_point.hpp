// SPDX-License-Identifier: MIT
// fixed_point.hpp - roots and angles of integers as multiples of a power of two, for long sums: in
// integers a term takes a twentieth of the time of enclosures.
#pragma once
#include <array>
#include <optional>

#include "convexact/number.hpp"

namespace convexact {

/// The largest integer that is at most sqrt(x) 2^shift; x, shift >= 0.
struct FixedRoot {
  Integer floor;
  bool is_exact;  ///< Else the root is less than 1 larger.
};
[[nodiscard]] FixedRoot fixed_root(const Integer& x, long shift);

/// The least shift >= 0 for which fixed_root() of x has more than `bits` bits; x > 0.
[[nodiscard]] long shift_for_root(const Integer& x, long bits);

/// Angles in units of 2^-bits.
class FixedAngles {
 public:
  explicit FixedAngles(long bits);

  /// The angle in [0, pi] between the x axis and the point (dot, sqrt(squared_cross)), not both
  /// zero, as computed: off by at most error().
  [[nodiscard]] Integer angle(const Integer& squared_cross, const Integer& dot);
  [[nodiscard]] long error() const;

 private:
  Integer arctangent(const Integer& tangent);
  const Integer& step(unsigned long k);

  static constexpr unsigned long kSteps = 16;
  long bits_, terms_;
  Integer one_, pi_;
  std::array<std::optional<Integer>, kSteps + 1> steps_;  // arctangents of k / kSteps, once needed
};

}  // namespace convexact
