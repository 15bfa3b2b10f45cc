// SPDX-License-Identifier: MIT
#include "convexact/fast/filtered_engine.hpp"

#include "convexact/fast/filtered_loop.hpp"

namespace convexact {

FastResult simplify_filtered(const FastDual& dual, const SimplifyOptions& options) {
  NoAudit audit;
  return FilteredLoop<>(dual, options, audit).run();
}

Simplification simplify_filtered(const DualHull& solid, const RationalPoint& center,
                                 const SimplifyOptions& options) {
  const FastDual dual = FastDual::of(solid, center);
  NoAudit audit;
  Simplification simplification;
  simplification.trace.halfspaces = solid.halfspaces;
  FastResult result = FilteredLoop<>(dual, options, audit).run(&simplification.trace.steps);
  simplification.trace.stop = result.stop;
  simplification.triangles = std::move(result.triangles);
  return simplification;
}

}  // namespace convexact
