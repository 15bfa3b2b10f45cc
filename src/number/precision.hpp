// SPDX-License-Identifier: MIT
// precision.hpp - how many bits an enclosure takes: as many as every ordinary comparison needs, or
// as many as a particular one needs.
#pragma once
#include <type_traits>

#include "convexact/number.hpp"

namespace convexact {

/// Bits of enclosures that are printed or compared: some thirty certain decimal digits.
inline constexpr long kMeasureBits = 128;

/// About the middle of x.
[[nodiscard]] inline double middle_double(const Enclosure& x) {
  return (x.low_double() + x.high_double()) / 2;
}

/// The precisions that refine() tries, in bits: first, 2 first, 4 first, ... up to last.
struct PrecisionRange {
  long first = 64;
  long last = 1L << 16;
};

/// The first answer of `decide` to the enclosures compute(first), compute(2 first), ...
/// @param compute  From a precision in bits to an Enclosure of one and the same real number.
/// @param decide   From an Enclosure to a std::optional: empty means undecided.
/// @return  Empty if the last precision does not decide either.
template <class Compute, class Decide>
[[nodiscard]] auto refine(const Compute& compute, const Decide& decide,
                          const PrecisionRange& range = {})
    -> std::invoke_result_t<const Decide&, const Enclosure&> {
  for (long precision = range.first; precision <= range.last; precision *= 2) {
    if (auto answer = decide(compute(precision))) return answer;
  }
  return {};
}

}  // namespace convexact
