// SPDX-License-Identifier: MIT
// ring_geometry.hpp - a dual point and its one-ring in one arithmetic, with the bounds that hold
// for all of their determinants.
#pragma once
#include <vector>

#include "fast/plane_filter.hpp"
#include "fast/triple.hpp"

namespace convexact {

/// Dual point `center` and the points around it. `arm[m]` = point[m] - center, `side[m]` =
/// arm[m] x arm[m + 1], cyclic.
template <class Scalar>
struct RingGeometry {
  Triple<Scalar> center;
  std::vector<Triple<Scalar>> point, arm, side;
  Extent extent;  ///< Of the arms.

  /// @param coordinates  From an id to Triple<Scalar>.
  template <class Coordinates, class Id, class Ids>
  void load(Id i, const Ids& ring, const Coordinates& coordinates) {
    center = coordinates(i);
    const std::size_t k = ring.size();
    point.resize(k);
    arm.resize(k);
    side.resize(k);
    extent = Extent();
    for (std::size_t m = 0; m < k; ++m) {
      point[m] = coordinates(ring[m]);
      arm[m] = point[m] - center;
      extent.include(arm[m]);
    }
    for (std::size_t m = 0; m + 1 < k; ++m) side[m] = cross(arm[m], arm[m + 1]);
    side[k - 1] = cross(arm[k - 1], arm[0]);
  }
  /// Bounds for determinants of arms, and of arms with one of the points.
  PlaneFilter arm_filter(double unit) const { return filter_for<Scalar>(extent.size, unit); }
  /// Bounds for determinants of any of these points: differences between ring points are at most
  /// twice the arms.
  PlaneFilter filter(double unit) const { return filter_for<Scalar>(extent.doubled(), unit); }
};

}  // namespace convexact
