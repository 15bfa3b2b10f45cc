// SPDX-License-Identifier: MIT
// request_rules.hpp - what requests of decompositions mean together, and which are refused.
#pragma once
#include "convexact/decompose.hpp"

namespace convexact {

[[nodiscard]] inline bool cuts(const DecomposeRequest& request) {
  return request.method == DecomposeMethod::Cut;
}

/// Whether parts must be within the distance.
[[nodiscard]] bool uses_reach(const DecomposeRequest& request);

/// Whether it asks for something that only clusters of triangles have.
[[nodiscard]] bool has_clusters(const DecomposeRequest& request);

/// @throws Error InvalidArgument for options that contradict each other, or the method, and for
///               numbers out of their range.
void require_sensible(const DecomposeRequest& request);

}  // namespace convexact
