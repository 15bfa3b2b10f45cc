// SPDX-License-Identifier: MIT
#include <algorithm>

#include "convexact/hull.hpp"

namespace convexact {
namespace {

// Rank by elimination.
std::size_t rank(std::vector<std::vector<Rational>> rows) {
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 4; ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const auto& row) { return row[column] != 0; });
    if (pivot == rows.end()) continue;
    std::iter_swap(pivot, rows.begin() + static_cast<std::ptrdiff_t>(rank));
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      const Rational factor = rows[i][column] / rows[rank][column];
      for (std::size_t k = column; k < 4; ++k) rows[i][k] -= factor * rows[rank][k];
    }
    ++rank;
  }
  return rank;
}

std::vector<Rational> row(const Halfspace& h) {
  return {h.normal()[0], h.normal()[1], h.normal()[2], h.offset()};
}
std::vector<Rational> row(const RationalPoint& p) { return {p[0], p[1], p[2], 1}; }

}  // namespace

bool check_flat(const FlatInput& flat, const PointSet& points) {
  if (flat.dimension > 2) return false;
  const std::size_t size = static_cast<std::size_t>(flat.dimension) + 1;  // -1 wraps to 0
  if (flat.basis.size() != size || flat.equations.size() != 4 - size) return false;
  std::vector<std::vector<Rational>> basis, equations;
  for (const PointId p : flat.basis) {
    if (p.index() >= points.size()) return false;
    basis.push_back(row(points[p]));
  }
  for (const Halfspace& h : flat.equations) equations.push_back(row(h));
  if (rank(basis) != size || rank(equations) != 4 - size) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RationalPoint p = points[PointId(i)];
    if (!std::ranges::all_of(flat.equations, [&](const Halfspace& h) { return h(p) == 0; }))
      return false;
  }
  return true;
}

}  // namespace convexact
