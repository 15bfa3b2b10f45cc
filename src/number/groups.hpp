// SPDX-License-Identifier: MIT
// groups.hpp - numbered things in groups that join (union-find).
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace convexact {

/// The numbers 0, 1, ..., at first each in a group of its own. The lowest number of a group is its
/// root.
class Groups {
 public:
  explicit Groups(std::size_t count) : above_(count) {
    std::iota(above_.begin(), above_.end(), 0u);
  }

  /// Of the group of i. Shortens the way there, for later calls.
  std::uint32_t root(std::uint32_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  /// Joins the groups of a and b. Returns whether they were different ones.
  bool join(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    above_[high] = low;
    return low != high;
  }
  /// By number: the root of its group.
  std::vector<std::uint32_t> roots() {
    for (std::uint32_t i = 0; i < above_.size(); ++i) above_[i] = above_[above_[i]];
    return above_;
  }

 private:
  std::vector<std::uint32_t> above_;  // a lower number of the same group, or the root itself
};

}  // namespace convexact
