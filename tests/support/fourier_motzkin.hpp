// SPDX-License-Identifier: MIT
// fourier_motzkin.hpp - the supremum of a linear program from the definition of projection: for a
// handful of rows, in rationals, with no notion of vertex, basis or duality.
#pragma once
#include <algorithm>
#include <set>
#include <vector>

#include "convexact/linear_program.hpp"

namespace convexact::oracle {

enum class LpKind { Optimal, Infeasible, Unbounded };

struct Supremum {
  LpKind kind;
  Rational value;  // if Optimal
};

// a_1 x_1 + ... + a_m x_m + a_0 <= 0 as (a_1, ..., a_m, a_0), scaled so that the first nonzero
// entry is +-1; the set drops repeats.
using Inequality = std::vector<Rational>;

inline void insert_scaled(std::set<Inequality>& rows, Inequality row) {
  const auto lead = std::find_if(row.begin(), row.end(), [](const Rational& a) { return a != 0; });
  if (lead == row.end()) return;
  const Rational scale = abs(*lead);
  for (Rational& a : row) a /= scale;
  rows.insert(std::move(row));
}

// The projection along the first variable: every lower bound lies below every upper bound.
inline std::set<Inequality> eliminate_first(const std::set<Inequality>& rows) {
  std::set<Inequality> projected;
  for (const Inequality& upper : rows) {
    if (upper[0] == 0) insert_scaled(projected, {upper.begin() + 1, upper.end()});
    if (upper[0] <= 0) continue;
    for (const Inequality& lower : rows) {
      if (lower[0] >= 0) continue;
      Inequality sum;
      for (std::size_t k = 1; k < upper.size(); ++k) {
        sum.push_back(upper[k] * -lower[0] + lower[k] * upper[0]);
      }
      insert_scaled(projected, std::move(sum));
    }
  }
  return projected;
}

// sup z with z <= c.x, all coordinates of x projected away.
inline Supremum supremum(const LinearProgram& lp) {
  const auto size = static_cast<std::size_t>(lp.objective.size());
  std::set<Inequality> rows;
  for (Eigen::Index i = 0; i < lp.normals.rows(); ++i) {
    Inequality row(size + 2);
    for (std::size_t k = 0; k < size; ++k) row[k] = lp.normals(i, k);
    row[size + 1] = lp.offsets[i];
    insert_scaled(rows, std::move(row));
  }
  Inequality objective(size + 2);
  for (std::size_t k = 0; k < size; ++k) objective[k] = -lp.objective[k];
  objective[size] = 1;
  insert_scaled(rows, std::move(objective));
  for (std::size_t k = 0; k < size; ++k) rows = eliminate_first(rows);
  Supremum result{LpKind::Unbounded, 0};
  for (const Inequality& row : rows) {  // a z + b <= 0, a >= 0
    if (row[0] == 0 && row[1] > 0) return {LpKind::Infeasible, 0};
    if (row[0] == 0) continue;
    const Rational bound = -row[1] / row[0];
    if (result.kind == LpKind::Unbounded || bound < result.value) {
      result = {LpKind::Optimal, bound};
    }
  }
  return result;
}

}  // namespace convexact::oracle
