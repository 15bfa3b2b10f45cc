// SPDX-License-Identifier: MIT
// solid_volume.hpp - the volume of a whole solid from the rings of its dual, without subtraction.
#pragma once
#include <cstdint>

namespace convexact {

/// Adds six times the volume of the cone from the center over facet i, whose ring has k members, to
/// `sum`. The facet is cut in a fan from its vertex v = (i, 0, 1); a triangle of it stands on the
/// edge that ring plane q cuts out, between q - 1 and q + 1. As in CapVolume, with the center
/// (where every slack is 1) as the apex, six times the tetrahedron is
///   slack(q, v) |H(i q-1 q, q+1)| / (D(i, q-1, q) D(i, q, q+1)).
/// @param source  As for CapVolume.
template <class Source>
void add_cone(std::uint32_t k, Source& source, typename Source::Sum& sum) {
  using Number = typename Source::Number;
  const Number first = source.base(0);
  for (std::uint32_t q = 2; q < k; ++q) {
    const Number opening = source.slack(q) / first;
    const Number edge = source.leg(q - 1, q + 1 == k ? 0 : q + 1) / source.base(q - 1);
    sum.add(opening * edge / source.base(q));
  }
}

}  // namespace convexact
