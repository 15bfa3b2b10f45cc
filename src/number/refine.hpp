// SPDX-License-Identifier: MIT
// refine.hpp - doubles the precision of an enclosure until it decides a question.
#pragma once
#include <type_traits>

#include "convexact/number.hpp"

namespace convexact {

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

/// The sign of a real number; empty if it is still uncertain at the last precision, as it always is
/// for a zero that is not enclosed exactly.
template <class Compute>
[[nodiscard]] std::optional<Sign> refine_sign(const Compute& compute,
                                              const PrecisionRange& range = {}) {
  return refine(
      compute, [](const Enclosure& x) { return x.sign(); }, range);
}

/// A real number as to_decimal() writes it, with `digits` certain digits; empty if the last
/// precision does not suffice.
template <class Compute>
[[nodiscard]] std::optional<std::string> refine_decimal(const Compute& compute, int digits,
                                                        const PrecisionRange& range = {}) {
  return refine(
      compute, [=](const Enclosure& x) { return to_decimal(x, digits); }, range);
}

}  // namespace convexact
