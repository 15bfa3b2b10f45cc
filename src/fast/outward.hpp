// SPDX-License-Identifier: MIT
// outward.hpp - one double further down or up: what a single rounding may have taken away.
#pragma once
#include <cmath>
#include <limits>

namespace convexact {

[[nodiscard]] inline double next_below(double x) {
  return std::nextafter(x, -std::numeric_limits<double>::infinity());
}
[[nodiscard]] inline double next_above(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

}  // namespace convexact
