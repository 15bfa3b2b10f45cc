// SPDX-License-Identifier: MIT
#include "convexact/fast/filtered_engine.hpp"

#include "convexact/fast/filtered_loop.hpp"

namespace convexact {

FastResult simplify_filtered(const FastDual& dual, const SimplifyOptions& options) {
  NoAudit audit;
  return FilteredLoop<>(dual, options, audit).run();
}

}  // namespace convexact
