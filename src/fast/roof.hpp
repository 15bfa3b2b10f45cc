// SPDX-License-Identifier: MIT
// roof.hpp - the edges of a cap that are not on its base, in any arithmetic.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "fast/mesh.hpp"

namespace convexact {

/// The roof edges of the cap of a dual point i with ring 0 .. k-1 and triangulation T: the edge
/// between the ring planes x and y, from the vertex of a triangle xyz of T to that of the triangle
/// yxt on its other side, or to the base vertex (i, x, y). As in CapVolume, with dual points P, it
/// is lambda P_x x P_y long, where
///
///   lambda = |H(xyz, t)| / (D(xyz) D(yxt)),  on the ring  |H(xyz, i)| / (D(xyz) D(i, x, y)).
///
/// Area and mean width weigh these lambdas (MetricCost); so each edge is visited once.
template <class Determinants>
class Roof {
 public:
  using Number = typename Determinants::Number;

  /// Calls visit(x, y, lambda) for every roof edge; on the ring y is x + 1, cyclic, otherwise the
  /// edge is an inner diagonal of T and x < y.
  /// @param of  As for CapVolume; slack() is not used.
  template <class Visit>
  void for_each_edge(std::uint32_t k, std::span<const RingTriangle> triangles, Determinants& of,
                     Visit&& visit);

  /// After for_each_edge(): slack(q, v_m) = 1 - P_q.v_m, v_m the base vertex (i, m, m + 1).
  Number slack(std::uint32_t m, std::uint32_t q, Determinants& of) const {
    return of.leg(m, q) / base_[m];
  }
  /// After for_each_edge(): lambda of the base edge in ring plane q, from v_(q-1) to v_q.
  Number base_edge(std::uint32_t q, Determinants& of) const {
    const auto k = static_cast<std::uint32_t>(base_.size());
    const std::uint32_t before = q == 0 ? k - 1 : q - 1, after = q + 1 == k ? 0 : q + 1;
    return of.leg(before, after) / (base_[before] * base_[q]);
  }

 private:
  std::vector<Number> base_, vertex_;
};

template <class Determinants>
template <class Visit>
void Roof<Determinants>::for_each_edge(std::uint32_t k, std::span<const RingTriangle> triangles,
                                       Determinants& of, Visit&& visit) {
  base_.clear();
  vertex_.clear();
  for (std::uint32_t m = 0; m < k; ++m) base_.push_back(of.base(m));
  for (const auto& [low, middle, high, parent] : triangles) {
    of.set_triangle(low, middle, high);
    vertex_.push_back(of.vertex());
    const bool first = middle == low + 1, second = high == middle + 1, closing = parent == kNone;
    if (first || second || closing) {
      const Number to_base = of.to_center() / vertex_.back();
      if (first) visit(low, middle, Number(to_base / base_[low]));
      if (second) visit(middle, high, Number(to_base / base_[middle]));
      if (closing) visit(high, low, Number(to_base / base_[high]));
    }
    if (closing) continue;
    const RingTriangle& above = triangles[parent];
    visit(low, high,
          Number(of.to(above.low == low ? above.high : above.low) /
                 (vertex_.back() * vertex_[parent])));
  }
}

}  // namespace convexact
