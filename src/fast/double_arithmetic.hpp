// SPDX-License-Identifier: MIT
// double_arithmetic.hpp - what the float engine computes with.
#pragma once
#include "fast/dual_signs.hpp"
#include "fast/fast_dual.hpp"
#include "fast/plane_filter.hpp"

namespace convexact {

struct DoubleDoubles {
  using Scalar = DoubleDouble;
  const FastDual& dual;
  DualSigns exact{dual};

  Triple<DoubleDouble> point(HalfspaceId i) const { return dual.long_point(i); }
  static constexpr double unit() { return Roundoff<DoubleDouble>::kUnit; }
  const DualSigns& signs() const { return exact; }
};

struct Doubles {
  using Scalar = double;
  using Longer = DoubleDoubles;
  const FastDual& dual;
  DoubleDoubles long_ones;

  const Triple<double>& point(HalfspaceId i) const { return dual.near(i); }
  static constexpr double unit() { return Roundoff<double>::kUnit; }
  const DualSigns& signs() const { return long_ones.exact; }
  const DoubleDoubles& longer() const { return long_ones; }
};

}  // namespace convexact
