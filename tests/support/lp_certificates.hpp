// SPDX-License-Identifier: MIT
// lp_certificates.hpp - whether the outcome of a linear program is proven, from the definition.
#pragma once
#include "convexact/linear_program.hpp"

namespace convexact {

namespace lp_certificates {

inline Rational dot(const RationalMatrix& normals, Eigen::Index row, const RationalVector& x) {
  Rational sum = 0;
  for (Eigen::Index k = 0; k < x.size(); ++k) sum += normals(row, k) * x[k];
  return sum;
}

inline Rational dot(const RationalVector& a, const RationalVector& b) {
  Rational sum = 0;
  for (Eigen::Index k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

inline bool is_feasible(const LinearProgram& lp, const RationalVector& x) {
  if (x.size() != lp.normals.cols()) return false;
  for (Eigen::Index i = 0; i < lp.normals.rows(); ++i) {
    if (dot(lp.normals, i, x) + lp.offsets[i] > 0) return false;
  }
  return true;
}

inline bool are_positive(const LinearProgram& lp, const std::vector<Multiplier>& multipliers) {
  for (const Multiplier& m : multipliers) {
    if (m.value <= 0 || m.row >= static_cast<std::size_t>(lp.normals.rows())) return false;
  }
  return true;
}

// y'N
inline RationalVector combine(const LinearProgram& lp, const std::vector<Multiplier>& multipliers) {
  RationalVector sum = RationalVector::Zero(lp.normals.cols());
  for (const Multiplier& m : multipliers) {
    for (Eigen::Index k = 0; k < sum.size(); ++k) sum[k] += m.value * lp.normals(m.row, k);
  }
  return sum;
}

}  // namespace lp_certificates

// These functions use N, d and c alone and share nothing with the solver. O(k n) rational
// operations for k coordinates and n rows.

// For any feasible z: c'z = sum y_i n_i.z <= -sum y_i d_i = sum y_i n_i.x = c'x.
inline bool check(const LinearProgram& lp, const Optimal& claim) {
  if (!lp_certificates::is_feasible(lp, claim.x) || !lp_certificates::are_positive(lp, claim.tight))
    return false;
  for (const Multiplier& m : claim.tight) {
    if (lp_certificates::dot(lp.normals, m.row, claim.x) + lp.offsets[m.row] != 0) return false;
  }
  return lp_certificates::combine(lp, claim.tight) == lp.objective;
}

// For any feasible z: 0 >= y'(N z + d) = y'd > 0, a contradiction.
inline bool check(const LinearProgram& lp, const Infeasible& claim) {
  if (!lp_certificates::are_positive(lp, claim.farkas)) return false;
  Rational offset = 0;
  for (const Multiplier& m : claim.farkas) offset += m.value * lp.offsets[m.row];
  return lp_certificates::combine(lp, claim.farkas).isZero(0) && offset > 0;
}

inline bool check(const LinearProgram& lp, const Unbounded& claim) {
  if (!lp_certificates::is_feasible(lp, claim.start) || claim.ray.size() != lp.normals.cols())
    return false;
  for (Eigen::Index i = 0; i < lp.normals.rows(); ++i) {
    if (lp_certificates::dot(lp.normals, i, claim.ray) > 0) return false;
  }
  return lp_certificates::dot(lp.objective, claim.ray) > 0;
}

inline bool check(const LinearProgram& lp, const LpOutcome& outcome) {
  return std::visit([&](const auto& claim) { return check(lp, claim); }, outcome);
}

}  // namespace convexact
