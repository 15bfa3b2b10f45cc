// SPDX-License-Identifier: MIT
// joins_of(): the joins that follow from the method that made the parts.
#include <map>

#include "convexact/hull_tree.hpp"

namespace convexact {
namespace {

using MaybeGroup = std::optional<std::size_t>;  // none of a cluster that became no part

// The groups that parts are joined to, one join after another.
class Joiner {
 public:
  explicit Joiner(const Decomposition& decomposition)
      : parts_(decomposition.parts.size()), part_of_(decomposition.surface.triangles.size()) {
    for (std::size_t k = 0; k < parts_; ++k) {
      for (const TriangleId t : decomposition.parts[k].cluster) part_of_[t.index()] = k;
      joined_to_.push_back(k);
    }
  }

  // The group of the part that has the triangle in its cluster. A cluster within another part is in
  // none.
  MaybeGroup group_at(TriangleId t) const { return part_of_[t.index()]; }

  // The group of both. They may already be the same: a flat cluster joined a part elsewhere.
  MaybeGroup join(MaybeGroup a, MaybeGroup b) {
    if (!a || !b) return a ? a : b;
    const std::size_t first = last_group(*a), second = last_group(*b);
    if (first == second) return first;
    joins_.emplace_back(first, second);
    joined_to_[first] = joined_to_[second] = joined_to_.size();
    joined_to_.push_back(joined_to_.size());
    return joined_to_.back();
  }
  std::vector<Join> joins() { return std::move(joins_); }

 private:
  std::size_t last_group(std::size_t group) const {
    while (joined_to_[group] != group) group = joined_to_[group];
    return group;
  }

  std::size_t parts_;
  std::vector<MaybeGroup> part_of_;     // by triangle
  std::vector<std::size_t> joined_to_;  // by group: itself, as long as nothing joined it
  std::vector<Join> joins_;
};

void undo_splits(const SplitTree& tree, Joiner& joiner) {
  std::vector<MaybeGroup> group_of(tree.nodes.size());
  for (const SplitLeaf& leaf : tree.leaves) {
    group_of[leaf.node] = joiner.group_at(leaf.triangles.front());
  }
  for (std::size_t node = tree.nodes.size(); node-- > 0;) {  // children come after their parents
    if (!tree.nodes[node].is_split) continue;
    const auto& [first, second] = tree.nodes[node].children;
    group_of[node] = joiner.join(group_of[first], group_of[second]);
  }
}

std::vector<Join> undo_cuts(const Decomposition& decomposition, const Partition& partition) {
  Joiner joiner(decomposition);
  std::vector<MaybeGroup> group_of(partition.nodes.size());
  for (std::size_t k = 0; k < decomposition.parts.size(); ++k) {
    for (const std::uint32_t leaf : decomposition.parts[k].leaves) {
      group_of[partition.leaves[leaf].node] = k;
    }
  }
  for (std::size_t node = partition.nodes.size(); node-- > 0;) {
    if (!partition.nodes[node].plane) continue;
    const auto& [first, second] = partition.nodes[node].children;
    group_of[node] = joiner.join(group_of[first], group_of[second]);
  }
  return joiner.joins();
}

void go_on_merging(const Clustering& clustering, Joiner& joiner) {
  std::map<TriangleId, MaybeGroup> group_of;  // by the lowest triangle of a cluster
  for (const auto& cluster : clustering.clusters) {
    group_of[cluster.front()] = joiner.group_at(cluster.front());
  }
  for (const Merge& merge : clustering.further_merges) {
    group_of[merge.kept] = joiner.join(group_of[merge.kept], group_of[merge.gone]);
  }
}

}  // namespace

std::vector<Join> joins_of(const Decomposition& decomposition) {
  if (const auto* partition = std::get_if<Partition>(&decomposition.origin)) {
    return undo_cuts(decomposition, *partition);
  }
  Joiner joiner(decomposition);
  if (const auto* tree = std::get_if<SplitTree>(&decomposition.origin)) {
    undo_splits(*tree, joiner);
  } else {
    go_on_merging(std::get<Clustering>(decomposition.origin), joiner);
  }
  return joiner.joins();
}

}  // namespace convexact
