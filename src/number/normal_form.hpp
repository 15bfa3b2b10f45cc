// SPDX-License-Identifier: MIT
// normal_form.hpp - sums of roots times angles with every angle reduced to (0, pi/4].
#pragma once
#include <map>
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// sqrt(radicand) * (pi * turns + the sum of factor * atan(sqrt(t))).
struct ReducedAngles {
  /// The factor of an angle, not 0, and the term that it came from first: its own tan^2 is t or
  /// 1/t.
  struct Angle {
    Rational factor;
    Integer squared_cross, dot;
  };
  Integer radicand;
  Rational turns = 0;
  std::map<Rational, Angle> angles = {};  ///< By t, 0 < t < 1, t != 1/3.
};

/// The normal form of a sum: one entry for each square class of lengths, without those that are
/// zero. If it is empty, the sum is zero; that a sum is not zero is for the angle basis to prove.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] std::vector<ReducedAngles> normal_form(const AngleSum& sum, const Watch& watch = {});

/// The sum of which these are the normal form.
[[nodiscard]] AngleSum to_angle_sum(std::span<const ReducedAngles> form);

}  // namespace convexact
