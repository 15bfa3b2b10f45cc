// SPDX-License-Identifier: MIT
// linear_programs.hpp - linear programs in a few small integers, written out or drawn.
#pragma once
#include <initializer_list>

#include "convexact/linear_program.hpp"
#include "number/random.hpp"

namespace convexact::data {

/// Each row is n_1, ..., n_k, d.
inline LinearProgram linear_program(std::initializer_list<int> objective,
                                    std::initializer_list<std::initializer_list<int>> rows) {
  const auto size = static_cast<Eigen::Index>(objective.size());
  LinearProgram lp;
  lp.normals.resize(static_cast<Eigen::Index>(rows.size()), size);
  lp.offsets.resize(lp.normals.rows());
  lp.objective.resize(size);
  Eigen::Index k = 0, i = 0;
  for (const int c : objective) lp.objective[k++] = c;
  for (const auto& row : rows) {
    for (k = 0; k < size; ++k) lp.normals(i, k) = *(row.begin() + k);
    lp.offsets[i++] = *(row.begin() + size);
  }
  return lp;
}

/// Entries in [-reach, reach]; small reach makes ties, repeats, parallel rows and rows of zeros.
inline LinearProgram random_linear_program(Random& random, Eigen::Index size, Eigen::Index rows,
                                           int reach) {
  const auto entry = [&] {
    return Rational(static_cast<int>(uniform_below(random, 2 * reach + 1)) - reach);
  };
  LinearProgram lp;
  lp.normals.resize(rows, size);
  lp.offsets.resize(rows);
  lp.objective.resize(size);
  for (Eigen::Index k = 0; k < size; ++k) lp.objective[k] = entry();
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index k = 0; k < size; ++k) lp.normals(i, k) = entry();
    lp.offsets[i] = entry();
  }
  return lp;
}

}  // namespace convexact::data
