// SPDX-License-Identifier: MIT
// double_halfspace.hpp - a halfspace in doubles, scaled so that n.x + d can be bounded.
#pragma once
#include <cmath>

#include "convexact/halfspace.hpp"
#include "convexact/number.hpp"
#include "stored/coordinates.hpp"

namespace convexact::stored {

/// A value in doubles that is off by at most `error`; NaN where something overflowed.
struct NearValue {
  double value, error;

  bool surely_negative() const { return value + error < 0; }
};

/// A halfspace scaled by a power of two so that its largest normal component is in [1/2, 1].
struct DoubleHalfspace {
  double n[3];
  double d;

  explicit DoubleHalfspace(const Halfspace& h) {
    std::size_t bits = 0;
    for (int k = 0; k < 3; ++k) bits = std::max(bits, bit_length(h.normal()[k]));
    const auto scaled = [&](const Integer& value) {
      return to_double(scale_by_power_of_two(Rational(value), -static_cast<long>(bits)),
                       Rounding::Nearest);
    };
    for (int k = 0; k < 3; ++k) n[k] = scaled(h.normal()[k]);
    d = scaled(h.offset());
  }

  /// n.x + d; `absolute` is absolute_error() of all points.
  NearValue at(double x, double y, double z, double absolute) const {
    const double px = n[0] * x, py = n[1] * y, pz = n[2] * z;
    const double size = std::abs(px) + std::abs(py) + std::abs(pz) + std::abs(d);
    return {px + py + pz + d, kRelative * size + absolute};
  }
  NearValue at(const Coordinates& points, std::size_t j, double absolute) const {
    return at(points.x[j], points.y[j], points.z[j], absolute);
  }
};

}  // namespace convexact::stored
