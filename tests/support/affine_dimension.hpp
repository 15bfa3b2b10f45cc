// SPDX-License-Identifier: MIT
// affine_dimension.hpp - the dimension that points span, by exact Gaussian elimination.
#pragma once
#include <span>

#include "convexact/geometry.hpp"

/// -1 for no points, else the rank of the differences to the first point.
inline int affine_dimension(std::span<const convexact::RationalPoint> points) {
  using namespace convexact;
  if (points.empty()) return -1;
  std::vector<RationalVector3> rows;  // in echelon form: each is zero at the pivots of the others
  std::vector<int> pivots;
  for (const RationalPoint& p : points) {
    RationalVector3 v = p - points.front();
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const Rational factor = v[pivots[r]] / rows[r][pivots[r]];
      for (int k = 0; k < 3; ++k) v[k] -= factor * rows[r][k];
    }
    for (int k = 0; k < 3; ++k) {
      if (v[k] == 0) continue;
      rows.push_back(v);
      pivots.push_back(k);
      break;
    }
    if (rows.size() == 3) break;
  }
  return static_cast<int>(rows.size());
}

inline int affine_dimension(std::span<const convexact::Point> points) {
  std::vector<convexact::RationalPoint> exact;
  for (const convexact::Point& p : points) exact.push_back(convexact::to_rational(p));
  return affine_dimension(exact);
}
