// SPDX-License-Identifier: MIT
// exact_determinant.hpp - determinants in rationals by expansion along the first row.
#pragma once
#include <vector>

#include "convexact/number.hpp"

inline convexact::Rational exact_determinant(
    const std::vector<std::vector<convexact::Rational>>& rows) {
  using convexact::Rational;
  if (rows.empty()) return 1;
  Rational total = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::vector<std::vector<Rational>> rest;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      rest.push_back(rows[i]);
      rest.back().erase(rest.back().begin() + static_cast<std::ptrdiff_t>(k));
    }
    const Rational term = rows[0][k] * exact_determinant(rest);
    total += k % 2 == 0 ? term : Rational(-term);
  }
  return total;
}
