// SPDX-License-Identifier: MIT
#include "lp/combination.hpp"

#include "convexact/error.hpp"

namespace convexact::detail {

// Gauss-Jordan elimination on the columns (basis | target).
std::vector<Rational> combination(const std::vector<RationalVector>& basis,
                                  const RationalVector& target) {
  const auto size = static_cast<Eigen::Index>(basis.size());
  Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic> system(target.size(), size + 1);
  for (Eigen::Index j = 0; j < size; ++j) system.col(j) = basis[static_cast<std::size_t>(j)];
  system.col(size) = target;
  for (Eigen::Index j = 0; j < size; ++j) {
    Eigen::Index pivot = j;
    while (system(pivot, j) == 0) ++pivot;  // exists: the vectors are independent
    system.row(j).swap(system.row(pivot));
    const Rational divisor = system(j, j);
    for (Eigen::Index c = j; c <= size; ++c) system(j, c) /= divisor;
    for (Eigen::Index i = 0; i < target.size(); ++i) {
      const Rational factor = system(i, j);
      if (i == j || factor == 0) continue;
      for (Eigen::Index c = j; c <= size; ++c) system(i, c) -= factor * system(j, c);
    }
  }
  std::vector<Rational> factors;
  for (Eigen::Index j = 0; j < size; ++j) factors.push_back(system(j, size));
  for (Eigen::Index i = size; i < target.size(); ++i) CONVEXACT_ASSERT(system(i, size) == 0);
  return factors;
}

}  // namespace convexact::detail
