// SPDX-License-Identifier: MIT
// The float loop in doubles: the float engine.
#include "fast/float_loop_steps.hpp"

namespace convexact {

template class FloatLoop<Doubles>;

FastResult simplify_float(const FastDual& dual, const SimplifyOptions& options) {
  const Doubles arithmetic{dual, {dual}};
  return FloatLoop<Doubles>(dual, arithmetic, options).run();
}

}  // namespace convexact
