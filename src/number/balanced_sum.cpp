// SPDX-License-Identifier: MIT
#include "number/balanced_sum.hpp"

namespace convexact {

Rational balanced_sum(std::vector<Rational> terms) {
  if (terms.empty()) return 0;
  while (terms.size() > 1) {
    const std::size_t pairs = terms.size() / 2;
    for (std::size_t i = 0; i < pairs; ++i) terms[i] = terms[2 * i] + terms[2 * i + 1];
    if (terms.size() % 2 == 1) terms[pairs] = std::move(terms.back());
    terms.resize((terms.size() + 1) / 2);
  }
  return std::move(terms.front());
}

}  // namespace convexact
