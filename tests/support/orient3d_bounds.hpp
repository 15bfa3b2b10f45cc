// SPDX-License-Identifier: MIT
// orient3d_bounds.hpp - the values of orient3d's stages before they decide, with their bounds.
#pragma once
#include "geometry/orient3d_stages.hpp"

namespace convexact {

/// For the true determinant T and the determinant B of the rounded differences the stages claim
/// |value_a - T| <= bound_a, |B - T| <= bound_b and |value_c - T| <= bound_c.
struct Orient3dBounds {
  double value_a, bound_a, bound_b, value_c, bound_c;
};

/// Precondition: coordinates are in the range that orient3d() has without rationals.
inline Orient3dBounds orient3d_bounds(const Point& a, const Point& b, const Point& c,
                                      const Point& d) {
  using namespace orient3d_stages;
  const Difference x = subtract(a, d), y = subtract(b, d), z = subtract(c, d);
  const double magnitude = permanent(x.rounded, y.rounded, z.rounded);
  const double corrected =
      exact_determinant(x.rounded, y.rounded, z.rounded).estimate() + linear_correction(x, y, z);
  return {determinant(x.rounded, y.rounded, z.rounded), kBoundA * magnitude, kBoundB * magnitude,
          corrected, bound_c(magnitude, corrected)};
}

}  // namespace convexact
