// SPDX-License-Identifier: MIT
#include "convexact/run.hpp"

#include <algorithm>
#include <iterator>

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

std::vector<HalfspaceId> after_moves(std::vector<HalfspaceId> left, std::span<const Move> moves) {
  std::vector<HalfspaceId> others;
  for (const Move& move : moves) {
    others.clear();
    std::ranges::set_difference(left, move.removed, std::back_inserter(others));
    left.clear();
    std::ranges::merge(others, move.inserted, std::back_inserter(left));
  }
  return left;
}

}  // namespace convexact
