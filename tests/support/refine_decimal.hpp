// SPDX-License-Identifier: MIT
// refine_decimal.hpp - a real number with certain digits, with as many bits as needed.
#pragma once
#include <optional>
#include <string>

#include "number/precision.hpp"

namespace convexact {

/// The number as to_decimal() writes it, with `digits` certain digits; empty if the last precision
/// does not suffice.
template <class Compute>
[[nodiscard]] std::optional<std::string> refine_decimal(const Compute& compute, int digits) {
  return refine(compute, [=](const Enclosure& x) { return to_decimal(x, digits); });
}

}  // namespace convexact
