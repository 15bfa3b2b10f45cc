// SPDX-License-Identifier: MIT
#include "oracle/engine_run.hpp"

#include "fast/dual.hpp"
#include "fast/filtered_engine.hpp"
#include "fast/float_engine.hpp"
#include "simplify/exact_engine.hpp"

namespace convexact {

Run run_engine(Engine engine, const DualHull& dual, const RationalPoint& center,
               const SimplifyOptions& options, bool record) {
  if (engine == Engine::Exact) return simplify_exact(dual, center, options);
  if (engine == Engine::Filtered && record) return simplify_filtered(dual, center, options);
  const FastDual fast = FastDual::of(dual, center);
  return run_of(
      engine == Engine::Float ? simplify_float(fast, options) : simplify_filtered(fast, options),
      dual.halfspaces);
}

}  // namespace convexact
