// SPDX-License-Identifier: MIT
// inflation.hpp - how far all halfspaces can be pushed inwards together.
#pragma once
#include <span>
#include <variant>
#include <vector>

#include "convexact/linear_program.hpp"

namespace convexact::detail {

/// The largest t, > 0, such that n_i.point + d_i + w_i t <= 0 for all i.
struct Inflated {
  RationalPoint point;
  Rational size;                     // t
  std::vector<Multiplier> touching;  // y >= 0, y'N = 0, y'w = 1, y'd = -t
};

/// Any t is possible; n_i.direction <= -w_i for all i.
struct Inflatable {
  RationalPoint interior;
  RationalVector3 direction;
};

/// max t subject to n_i.x + d_i + w_i t <= 0 and t >= 0.
/// @param weights  w: one positive number per halfspace.
std::variant<Inflated, Inflatable, FlatProof, EmptyProof> inflate(
    std::span<const Halfspace> halfspaces, std::span<const Rational> weights,
    const LpOptions& options);

}  // namespace convexact::detail
