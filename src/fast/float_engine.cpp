// SPDX-License-Identifier: MIT
#include "convexact/fast/float_engine.hpp"

#include "convexact/fast/float_loop.hpp"

namespace convexact {
namespace {

struct DoubleDoubles {
  using Scalar = DoubleDouble;
  const FastDual& dual;

  Triple<DoubleDouble> point(HalfspaceId i) const { return dual.long_point(i); }
  static constexpr double unit() { return Roundoff<DoubleDouble>::kUnit; }
};

struct Doubles {
  using Scalar = double;
  using Longer = DoubleDoubles;
  const FastDual& dual;
  DoubleDoubles long_ones;

  const Triple<double>& point(HalfspaceId i) const { return dual.near(i); }
  static constexpr double unit() { return Roundoff<double>::kUnit; }
  const DoubleDoubles& longer() const { return long_ones; }
};

}  // namespace

FastResult simplify_float(const FastDual& dual, const SimplifyOptions& options) {
  const Doubles arithmetic{dual, {dual}};
  return FloatLoop<Doubles>(dual, arithmetic, options).run();
}

}  // namespace convexact
