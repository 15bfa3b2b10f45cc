// SPDX-License-Identifier: MIT
#include "convexact/fast/float_engine.hpp"

#include "convexact/fast/float_loop.hpp"

namespace convexact {
namespace {

struct Doubles {
  using Scalar = double;
  const FastDual& dual;

  const Triple<double>& point(HalfspaceId i) const { return dual.near(i); }
  static constexpr double unit() { return Roundoff<double>::kUnit; }
};

}  // namespace

FastResult simplify_float(const FastDual& dual, const SimplifyOptions& options) {
  const Doubles arithmetic{dual};
  return FloatLoop<Doubles>(dual, arithmetic, options).run();
}

}  // namespace convexact
