// SPDX-License-Identifier: MIT
// sum.hpp - sums whose terms grow as they are added.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

namespace convexact {

/// Sum of the terms as a balanced tree; a value-initialised Number if there are none. The
/// denominator of a sum of n rationals grows with n; added left to right that costs O(n^2) digits,
/// in a tree O(n log n).
template <class Number>
[[nodiscard]] Number balanced_sum(std::vector<Number> terms) {
  for (std::size_t count = terms.size(); count > 1; count = (count + 1) / 2) {
    for (std::size_t k = 0; k < count / 2; ++k) terms[k] = terms[2 * k] + terms[2 * k + 1];
    if (count % 2 == 1) terms[count / 2] = std::move(terms[count - 1]);
  }
  return terms.empty() ? Number() : std::move(terms.front());
}

}  // namespace convexact
