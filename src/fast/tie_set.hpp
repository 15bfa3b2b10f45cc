// SPDX-License-Identifier: MIT
// tie_set.hpp - the removals that cost as little as the cheapest, from one step to the next.
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact {

/// Removals of one cost, in canonical order, in classes of congruent caps. A removal changes the
/// caps of its ring only, and no volume of a cap falls; so what is left of the set after it are
/// still the cheapest. With m of them, each step costs amortised O(log m), not O(m).
class TieSet {
 public:
  using Class = const void*;

  explicit TieSet(std::size_t halfspaces) : place_(halfspaces, kAbsent) {}

  /// @param ids  In canonical order. @param classes  Of each; of a single one none.
  void assign(const std::vector<HalfspaceId>& ids, const std::vector<Class>& classes) {
    clear();
    ids_ = ids;
    size_ = ids.size();
    for (std::size_t k = 0; k < ids.size(); ++k) {
      place_[ids[k].index()] = static_cast<std::uint32_t>(k);
    }
    sorted_ = classes;
    std::sort(sorted_.begin(), sorted_.end());
    sorted_.erase(std::unique(sorted_.begin(), sorted_.end()), sorted_.end());
    in_class_.assign(sorted_.size(), 0);
    classes_left_ = sorted_.size();
    for (const Class c : classes) {
      const auto number = std::lower_bound(sorted_.begin(), sorted_.end(), c) - sorted_.begin();
      class_of_.push_back(static_cast<std::uint32_t>(number));
      ++in_class_[static_cast<std::size_t>(number)];
    }
  }
  void clear() {
    for (const HalfspaceId id : ids_) place_[id.index()] = kAbsent;
    ids_.clear();
    class_of_.clear();
    first_ = size_ = 0;
  }

  std::size_t size() const { return size_; }
  bool contains(HalfspaceId id) const { return place_[id.index()] != kAbsent; }
  /// Precondition: there is one.
  HalfspaceId first() const { return ids_[first_]; }
  /// Whether all that are left are known to be congruent.
  bool is_one_class() const { return classes_left_ == 1; }
  std::vector<HalfspaceId> list() const {
    std::vector<HalfspaceId> left;
    for (const HalfspaceId id : ids_) {
      if (contains(id)) left.push_back(id);
    }
    return left;
  }

  /// Without effect on others.
  void drop(HalfspaceId id) {
    if (!contains(id)) return;
    const std::size_t k = place_[id.index()];
    place_[id.index()] = kAbsent;
    --size_;
    if (!class_of_.empty() && --in_class_[class_of_[k]] == 0) --classes_left_;
    while (first_ < ids_.size() && !contains(ids_[first_])) ++first_;
  }

 private:
  static constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();

  std::vector<HalfspaceId> ids_;         // those dropped, too
  std::vector<std::uint32_t> class_of_;  // of each, a number
  std::vector<std::uint32_t> in_class_;  // of each class, how many are left
  std::size_t classes_left_ = 0;
  std::vector<Class> sorted_;
  std::vector<std::uint32_t> place_;  // by halfspace, in ids_
  std::size_t first_ = 0;             // the first that is left
  std::size_t size_ = 0;
};

}  // namespace convexact
