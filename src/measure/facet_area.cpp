// SPDX-License-Identifier: MIT
#include "measure/facet_area.hpp"

#include "number/balanced_sum.hpp"

namespace convexact {
namespace {

int largest_component(const IntegerVector3& n) {
  int k = 0;
  if (abs(n[1]) > abs(n[k])) k = 1;
  if (abs(n[2]) > abs(n[k])) k = 2;
  return k;
}

}  // namespace

Rational area_per_normal(const Polytope& polytope, std::size_t facet) {
  // Projected along axis k, the facet shrinks by |n_k| / |n|, and keeps its orientation if n_k > 0.
  // So area / |n| = S / (2 n_k) with the shoelace sum S = sum of u_i (v_{i+1} - v_{i-1}).
  const IntegerVector3& n = polytope.planes[facet].normal();
  const int k = largest_component(n), u = (k + 1) % 3, v = (k + 2) % 3;
  const std::vector<std::uint32_t>& corners = polytope.facets[facet];
  const std::size_t m = corners.size();
  const auto corner = [&](std::size_t i) -> const RationalPoint& {
    return polytope.vertices[corners[i % m]];
  };
  std::vector<Rational> terms;
  for (std::size_t i = 0; i < m; ++i) {
    terms.push_back(corner(i)[u] * (corner(i + 1)[v] - corner(i + m - 1)[v]));
  }
  return balanced_sum(std::move(terms)) / Rational(Integer(2 * n[k]));
}

}  // namespace convexact
