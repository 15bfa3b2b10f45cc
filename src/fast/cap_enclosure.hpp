// SPDX-License-Identifier: MIT
// cap_enclosure.hpp - encloses the volume of a cap: the quick way, or else the sure way.
#pragma once
#include "fast/cap_range.hpp"
#include "fast/lawrence_sum.hpp"

namespace convexact {

template <class Scalar>
class CapEnclosure {
 public:
  /// Six times the volume of the cap of ring.center, T given. T is taken as it is: the enclosure is
  /// as true as the signs that T was made with.
  /// @param unit  As of Roundoff.
  CapRange<Scalar> run(const RingGeometry<Scalar>& ring, std::span<const RingTriangle> triangles,
                       double unit) {
    const CapRange<Scalar> quick = lawrence_.run(ring, triangles, unit);
    if (quick.kind != CapRange<Scalar>::Kind::Doubtful) return quick;
    RangeSource<Scalar> source(ring, unit);
    const auto k = static_cast<std::uint32_t>(ring.arm.size());
    return source.widened(volume_.six_times(k, triangles, source));
  }

 private:
  LawrenceSum<Scalar> lawrence_;
  CapVolume<RangeSource<Scalar>> volume_;
};

}  // namespace convexact
