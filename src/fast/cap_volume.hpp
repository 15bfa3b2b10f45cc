// SPDX-License-Identifier: MIT
// cap_volume.hpp - the volume of a cap as a sum of products without a single subtraction.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "fast/ring_triangles.hpp"

namespace convexact {

/// Six times the volume of the cap of a dual point i with ring 0 .. k-1 and triangulation T, from
/// determinants of dual points P (all w = 1). Write D(abc) = det(P_a, P_b, P_c) and H(abc,p) as in
/// DualSigns::height; the plane of p cuts the vertex of abc at slack |H(abc,p)| / D(abc).
///
/// The cap is cut into tetrahedra: from the base vertex v_0 = (i, 0, 1) over each facet in a ring
/// plane r, that facet in a fan from its base vertex v_r = (i, r, r + 1). A triangle of the fan
/// stands on the segment that plane q, a neighbour of r in T or in the ring, cuts out of the facet,
/// between the vertices of (r, a, q) and (r, q, b). The segment is H(raq,b) / (D(raq) D(rqb)) times
/// P_r x P_q long, and with det(u, v, p x q) = (u.p)(v.q) - (u.q)(v.p) six times the volume of the
/// tetrahedron comes out as
///
///   slack(r, v_0) slack(q, v_r) |H(raq,b)| / (D(raq) D(rqb)).
///
/// No factor is ever negative, and the D are those of true vertices, all positive: nothing
/// cancels, and there is no singular case. (In the sum over T of H^3 / (D D D D) [Lawrence1991] the
/// D of an inner diagonal may vanish, and does on every prism.)
///
/// Source computes the determinants, all of them >= 0, in numbers of its own:
///   Number base(m)       D(i, m, m + 1)
///   Number slack(m)      |H(i, 0, 1, m)|
///   Number leg(m, q)     |H(i, m, m + 1, q)|
///   void set_triangle(low, middle, high)      abc, which the next three refer to
///   Number vertex()      D(abc)
///   Number to_center()   |H(abc, i)|
///   Number to(q)         |H(abc, q)|
/// and Source::Sum has add(Number) and scaled_down(Number), the sum divided by its argument.
template <class Source>
class CapVolume {
 public:
  using Number = typename Source::Number;

  Number six_times(std::uint32_t k, std::span<const RingTriangle> triangles, Source& source);

 private:
  std::vector<Number> base_, slack_, vertex_;
};

template <class Source>
typename Source::Number CapVolume<Source>::six_times(std::uint32_t k,
                                                     std::span<const RingTriangle> triangles,
                                                     Source& source) {
  base_.clear();
  slack_.clear();
  vertex_.clear();
  for (std::uint32_t m = 0; m < k; ++m) base_.push_back(source.base(m));
  for (std::uint32_t m = 0; m < k; ++m) slack_.push_back(source.slack(m));
  // slack(m, v_0) slack(q, v_m), less the common 1 / D(i, 0, 1). Zero for m = 0, 1: v_0 lies there.
  const auto legs = [&](std::uint32_t m, std::uint32_t q) {
    return slack_[m] * source.leg(m, q) / base_[m];
  };
  typename Source::Sum sum;
  for (const auto& [low, middle, high, parent] : triangles) {
    source.set_triangle(low, middle, high);
    vertex_.push_back(source.vertex());
    // A segment along an edge of the ring ends in the base: there b is i itself.
    const bool first = middle == low + 1 && middle >= 2, second = high == middle + 1;
    if (first || second) {
      const Number to_base = source.to_center() / vertex_.back();
      if (first) sum.add(legs(middle, low) * to_base / base_[low]);
      if (second) sum.add(legs(high, middle) * to_base / base_[middle]);
    }
    if (parent == kNone) continue;
    const RingTriangle& above = triangles[parent];
    const Number segment =
        source.to(above.low == low ? above.high : above.low) / (vertex_.back() * vertex_[parent]);
    if (low >= 2) sum.add(legs(low, high) * segment);
    sum.add(legs(high, low) * segment);
  }
  return sum.scaled_down(base_[0]);
}

}  // namespace convexact
