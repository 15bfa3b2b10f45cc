// SPDX-License-Identifier: MIT
// ordering.hpp - signs of differences as orders.
#pragma once
#include <optional>

#include "convexact/cost.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// Bits that Ordering reports for doubles.
inline constexpr long kDoubleBits = 53;

/// The order of two numbers whose difference has that sign.
[[nodiscard]] constexpr Order order_of(Sign difference) {
  return difference == Sign::Negative   ? Order::Less
         : difference == Sign::Positive ? Order::Greater
                                        : Order::Equal;
}

/// The order of two numbers by an enclosure of their difference; nothing if that may be zero. That
/// it is zero is left to one of the proofs of TieProof.
[[nodiscard]] inline std::optional<Order> order_to_zero(const Enclosure& difference) {
  const std::optional<Sign> sign = difference.sign();
  if (!sign || *sign == Sign::Zero) return std::nullopt;
  return order_of(*sign);
}

}  // namespace convexact
