// SPDX-License-Identifier: MIT
#include "convexact/run.hpp"

#include "convexact/error.hpp"

namespace convexact {

std::vector<HalfspaceId> removed_in(const Run& run, std::size_t count) {
  CONVEXACT_ASSERT(count <= run.steps.size());
  std::vector<HalfspaceId> removed;
  for (std::size_t s = 0; s < count; ++s) removed.push_back(run.steps[s].removed);
  return removed;
}

std::vector<HalfspaceId> all_but(std::span<const HalfspaceId> removed, std::size_t size) {
  std::vector<bool> is_gone(size, false);
  for (const HalfspaceId id : removed) is_gone[id.index()] = true;
  std::vector<HalfspaceId> left;
  for (std::size_t i = 0; i < size; ++i) {
    if (!is_gone[i]) left.emplace_back(i);
  }
  return left;
}

std::vector<HalfspaceId> survivors(const Run& run, std::size_t count) {
  return all_but(removed_in(run, count), run.halfspaces.size());
}

std::vector<Halfspace> left_after(std::span<const Halfspace> halfspaces,
                                  std::span<const HalfspaceId> removed) {
  std::vector<Halfspace> left;
  for (const HalfspaceId id : all_but(removed, halfspaces.size())) {
    left.push_back(halfspaces[id.index()]);
  }
  return left;
}

std::vector<Halfspace> left_after(const Run& run, std::size_t count) {
  return left_after(run.halfspaces, removed_in(run, count));
}

}  // namespace convexact
