// SPDX-License-Identifier: MIT
// sign.hpp - the three outcomes of an exact comparison with zero.
#pragma once

namespace convexact {

enum class Sign : signed char { Negative = -1, Zero = 0, Positive = 1 };

/// Sign of any number that compares with 0 (NaN has none and must not come here).
template <class Number>
[[nodiscard]] constexpr Sign sign_of(const Number& x) {
  return x < 0 ? Sign::Negative : x > 0 ? Sign::Positive : Sign::Zero;
}

[[nodiscard]] constexpr Sign operator-(Sign s) { return Sign(-static_cast<signed char>(s)); }
[[nodiscard]] constexpr Sign operator*(Sign a, Sign b) {
  return Sign(static_cast<signed char>(a) * static_cast<signed char>(b));
}

}  // namespace convexact
