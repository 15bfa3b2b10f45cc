// SPDX-License-Identifier: MIT
// linear_program.hpp - a linear program in rationals, and its three certified outcomes.
#pragma once
#include <cstddef>
#include <variant>
#include <vector>

#include "convexact/number/rational.hpp"

namespace convexact {

using RationalMatrix = Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic>;

/// Maximise dot(c, x) subject to N x + d <= 0, row by row. Rows of zeros are allowed.
struct LinearProgram {
  RationalMatrix normals;    ///< N: n >= 0 rows, as many columns as x has coordinates.
  RationalVector offsets;    ///< d: n entries.
  RationalVector objective;  ///< c: one entry per coordinate; may be zero.
};

/// A positive factor of one row in a linear combination of rows; rows not named have factor 0.
struct Multiplier {
  std::size_t row;  ///< 0-based.
  Rational value;   ///< > 0.
};

/// No feasible point is better than x: `tight` proves c = sum of y_i n_i with n_i.x + d_i = 0.
struct Optimal {
  RationalVector x;
  std::vector<Multiplier> tight;  ///< At most as many as x has coordinates; none if c = 0.
};

/// No point is feasible: y >= 0, y'N = 0 and y'd > 0 [Farkas1902].
struct Infeasible {
  std::vector<Multiplier> farkas;  ///< At most one more than there are coordinates.
};

/// dot(c, x) grows without bound along start + t ray, t >= 0, which stays feasible:
/// N start + d <= 0, N ray <= 0, c'ray > 0.
struct Unbounded {
  RationalVector start;
  RationalVector ray;  ///< Coprime integers.
};

using LpOutcome = std::variant<Optimal, Infeasible, Unbounded>;

}  // namespace convexact
