// SPDX-License-Identifier: MIT
#include "lp/flat.hpp"

#include "number/arithmetic.hpp"

namespace convexact::detail {
Flat::Flat(std::size_t dimension)
    : forms_(dimension * (dimension + kFirstNormal)), denominator_(1), free_(dimension, true) {
  for (std::size_t i = 0; i < dimension; ++i) forms_[i * width() + kFirstNormal + i] = 1;
}

std::vector<Integer> Flat::restrict(RowView row) const {
  std::vector<Integer> sum(width());
  for (const std::size_t offset : {kFinite, kInfinite}) sum[offset] = row[offset] * denominator_;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const Integer& n = row[kFirstNormal + i];
    if (n == 0) continue;
    for (std::size_t c = 0; c < width(); ++c) add_product(sum[c], n, form(i, c));
  }
  return sum;
}

std::optional<Flat> Flat::cut_by(RowView row) const {
  const std::vector<Integer> g = restrict(row);
  std::size_t pivot = 0;
  while (pivot < free_.size() && g[kFirstNormal + pivot] == 0) ++pivot;
  if (pivot == free_.size()) return std::nullopt;
  // On the hyperplane x_p = -(rest of g) / g_p; put into each form over the denominator g_p:
  // (g_p F(i, c) - F(i, p) g_c) / W. A negative g_p turns all signs.
  const Integer& divisor = g[kFirstNormal + pivot];
  Flat cut = *this;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const Integer& slope = form(i, kFirstNormal + pivot);
    for (std::size_t c = 0; c < width(); ++c) {
      Integer& entry = cut.forms_[i * width() + c];
      mpz_mul(raw(entry), raw(entry), raw(divisor));
      subtract_product(entry, slope, g[c]);
      mpz_divexact(raw(entry), raw(entry), raw(denominator_));
      if (divisor < 0) mpz_neg(raw(entry), raw(entry));
    }
  }
  cut.denominator_ = abs(divisor);
  cut.free_[pivot] = false;
  cut.last_pivot_ = pivot;
  return cut;
}

bool Flat::grows_with(std::size_t coordinate, std::span<const Integer> objective) const {
  const std::size_t column = kFirstNormal + coordinate;
  Integer slope;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    add_product(slope, objective[i], form(i, column));
  }
  for (std::size_t i = 0; slope == 0; ++i) slope = form(i, column);
  return slope > 0;
}

Vertex Flat::corner(const std::vector<bool>& at_top) const {
  const std::size_t dimension = free_.size();
  Vertex vertex{std::vector<Integer>(dimension), std::vector<Integer>(dimension), denominator_,
                true};
  for (std::size_t i = 0; i < dimension; ++i) {
    vertex.finite[i] = form(i, kFinite);
    Integer& infinite = vertex.infinite[i];
    infinite = form(i, kInfinite);
    for (std::size_t j = 0; j < dimension; ++j) {
      if (!free_[j]) continue;
      at_top[j] ? infinite += form(i, kFirstNormal + j) : infinite -= form(i, kFirstNormal + j);
    }
    vertex.is_finite = vertex.is_finite && infinite == 0;
  }
  return vertex;
}

}  // namespace convexact::detail
