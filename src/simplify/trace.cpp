// SPDX-License-Identifier: MIT
#include "convexact/error.hpp"
#include "convexact/run.hpp"

namespace convexact {

std::vector<HalfspaceId> Trace::survivors(std::size_t count) const {
  CONVEXACT_ASSERT(count <= steps.size());
  std::vector<bool> removed(halfspaces.size());
  for (std::size_t s = 0; s < count; ++s) removed[steps[s].removed.index()] = true;
  std::vector<HalfspaceId> left;
  for (std::size_t i = 0; i < halfspaces.size(); ++i) {
    if (!removed[i]) left.emplace_back(i);
  }
  return left;
}

}  // namespace convexact
