// SPDX-License-Identifier: MIT
#include "convexact/fast/float_engine.hpp"

#include "convexact/fast/float_loop.hpp"
#include "double_arithmetic.hpp"

namespace convexact {

FastResult simplify_float(const FastDual& dual, const SimplifyOptions& options) {
  const Doubles arithmetic{dual, {dual}};
  return FloatLoop<Doubles>(dual, arithmetic, options).run();
}

}  // namespace convexact
