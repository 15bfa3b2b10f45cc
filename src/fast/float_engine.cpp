// SPDX-License-Identifier: MIT
#include "fast/float_engine.hpp"

#include "fast/float_cap.hpp"
#include "fast/float_loop.hpp"

namespace convexact {

FastResult simplify_float(const FastDual& dual, const SimplifyOptions& options) {
  const Doubles arithmetic{dual, {dual}};
  return FloatLoop<Doubles>(dual, arithmetic, options).run();
}

}  // namespace convexact
