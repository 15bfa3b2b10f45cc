// SPDX-License-Identifier: MIT
// split_laws.hpp - the laws of every tree of split(), and whether two trees are the same.
#pragma once
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "convexact/cluster.hpp"
#include "convexact/measure.hpp"

namespace support {

using namespace convexact;

/// The triangles of each node: for a leaf those of the leaf, for a branch those of its children.
inline std::vector<std::set<TriangleId>> triangles_of_nodes(const SplitTree& tree) {
  std::vector<std::set<TriangleId>> of(tree.nodes.size());
  for (const SplitLeaf& leaf : tree.leaves) {
    of.at(leaf.node).insert(leaf.triangles.begin(), leaf.triangles.end());
  }
  for (std::size_t n = of.size(); n-- > 0;) {
    if (!tree.nodes[n].is_split) continue;
    for (const std::uint32_t child : tree.nodes[n].children) {
      of[n].insert(of.at(child).begin(), of[child].end());
    }
  }
  return of;
}

/// The laws of one tree.
class SplitLaws {
 public:
  SplitLaws(const Surface& surface, const SplitOptions& options, const SplitTree& tree)
      : surface_(surface),
        options_(options),
        tree_(tree),
        of_(triangles_of_nodes(tree)),
        pairs_(neighbours(surface, options.connect)) {}

  /// The laws that are broken; nothing if all of them hold.
  std::string broken() const {
    for (const std::string& law :
         {shape(), partition(), numbers(), splits(), order(), statuses()}) {
      if (!law.empty()) return law;
    }
    return {};
  }

 private:
  std::string shape() const {
    const std::size_t count = tree_.nodes.size();
    std::size_t split = 0;
    std::vector<std::size_t> named(count);
    for (std::uint32_t n = 0; n < count; ++n) {
      const SplitNode& node = tree_.nodes[n];
      if (node.parent.has_value() == (n < tree_.roots)) return "a root has no parent";
      if (!node.is_split) continue;
      ++split;
      for (const std::uint32_t child : node.children) {
        if (child <= n || child >= count || tree_.nodes[child].parent != n) return "children";
        ++named[child];
      }
    }
    for (std::uint32_t n = 0; n < count; ++n) {
      if (named[n] != (n < tree_.roots ? 0 : 1)) return "a full binary tree";
    }
    if (tree_.splits.size() != split) return "a split for each branch";
    if (tree_.leaves.size() != split + tree_.roots) return "leaves = splits + roots";
    if (count_groups(surface_, pairs_) != tree_.roots) return "a root for each group";
    return {};
  }

  std::string partition() const {
    std::vector<std::size_t> times(surface_.triangles.size());
    std::set<std::uint32_t> leaves;
    TriangleId last;
    for (const SplitLeaf& leaf : tree_.leaves) {
      if (tree_.nodes[leaf.node].is_split || !leaves.insert(leaf.node).second) return "leaf nodes";
      if (leaf.triangles.empty()) return "leaves have triangles";
      if (!std::is_sorted(leaf.triangles.begin(), leaf.triangles.end())) return "ascending";
      if (leaves.size() > 1 && leaf.triangles[0] <= last) return "leaves by lowest triangles";
      last = leaf.triangles[0];
      for (const TriangleId t : leaf.triangles) ++times[t.index()];
    }
    const auto once = [](std::size_t n) { return n == 1; };
    if (!std::all_of(times.begin(), times.end(), once)) return "leaves partition the triangles";
    for (std::size_t n = 0; n < of_.size(); ++n) {
      if (!is_connected(of_[n])) return "each node is connected";
      if (n > 0 && n < tree_.roots && *of_[n].begin() < *of_[n - 1].begin())
        return "order of roots";
      if (tree_.nodes[n].lowest != *of_[n].begin()) return "the lowest triangle of a node";
      if (tree_.nodes[n].triangle_count != of_[n].size()) return "the count of a node";
    }
    return {};
  }

  std::string numbers() const {
    const Rational squared = bounding_box(surface_.points).squared_diameter();
    if (tree_.squared_diameter != squared) return "the diameter";
    if (tree_.squared_limit != options_.limit.squared(squared)) return "the limit";
    for (std::size_t n = 0; n < of_.size(); ++n) {
      const Concavity& concavity = tree_.nodes[n].concavity;
      const std::vector<TriangleId> list(of_[n].begin(), of_[n].end());
      const std::vector<PointId> points = points_of(surface_, list);
      if (concavity.squared < 0 || concavity.squared > squared) return "concavity in its range";
      if ((concavity.leaves - concavity.at).squaredNorm() != concavity.squared)
        return "its segment";
      if (concavity.squared == 0) continue;
      const PointId notch = tree_.nodes[n].notch;
      if (!std::binary_search(points.begin(), points.end(), notch)) return "the notch is a point";
      if (concavity.at != surface_.points[notch]) return "the segment starts at the notch";
      const auto& corners = surface_.triangles[concavity.triangle.index()];
      if (of_[n].count(concavity.triangle) == 0) return "its triangle is in the part";
      if (std::count(corners.begin(), corners.end(), notch) == 0) return "its triangle is at it";
    }
    return {};
  }

  std::string splits() const {
    for (const Split& split : tree_.splits) {
      const SplitNode& node = tree_.nodes[split.node];
      if (!node.is_split) return "a branch is split";
      const std::set<TriangleId>&whole = of_[split.node], &kept = of_[node.children[0]];
      std::set<TriangleId> gone(split.moved.begin(), split.moved.end());
      gone.insert(split.islands.begin(), split.islands.end());
      if (gone.size() != split.moved.size() + split.islands.size()) return "islands do not move";
      if (gone != of_[node.children[1]]) return "moved and islands are the second child";
      if (kept.size() + gone.size() != whole.size()) return "halves partition a node";
      if (kept.empty() || split.moved.empty()) return "both halves have triangles";
      if (split.edge[0] != node.notch) return "the edge is at the notch";
      for (const PointId p : split.edge) {
        if (split.plane(surface_.points[p]) != 0) return "the plane holds the edge";
      }
      if (!is_at(kept, node.notch) || !is_at(gone, node.notch)) return "halves are at the notch";
      for (const auto& [a, b] : tree_.united) {
        if (gone.count(a) != gone.count(b) && whole.count(a) + whole.count(b) == 2) {
          return "what hangs on a triangle goes with it";
        }
      }
      for (const TriangleId t : split.moved) {
        Rational sum = 0;
        for (const PointId p : surface_.triangles[t.index()])
          sum += split.plane(surface_.points[p]);
        if (sum <= 0 && has_area(t)) return "moved triangles are beyond the plane";
      }
    }
    return {};
  }

  // Each split leaf is the worst one at that time that is not known to be unsplittable: worse ones
  // among the others stay leaves for good.
  std::string order() const {
    std::set<std::uint32_t> leaves;
    for (std::uint32_t n = 0; n < tree_.roots; ++n) leaves.insert(n);
    std::uint32_t next = static_cast<std::uint32_t>(tree_.roots);
    for (const Split& split : tree_.splits) {
      if (leaves.erase(split.node) != 1) return "a leaf is split";
      if (tree_.nodes[split.node].concavity.squared <= tree_.squared_limit) return "beyond";
      for (const std::uint32_t n : leaves) {
        if (rank(n) < rank(split.node) && status_of(n) != LeafStatus::Unsplittable) {
          return "the most concave leaf is split";
        }
      }
      if (tree_.nodes[split.node].children != std::array{next, next + 1}) return "order of nodes";
      leaves.insert(next++);
      leaves.insert(next++);
    }
    return {};
  }

  std::string statuses() const {
    if (tree_.stopped_by_count && tree_.leaves.size() != options_.max_parts) return "the count";
    bool has_more = false;
    for (const SplitLeaf& leaf : tree_.leaves) {
      const Rational& squared = tree_.nodes[leaf.node].concavity.squared;
      const bool is_within = squared <= tree_.squared_limit;
      if (is_within != (leaf.status == LeafStatus::WithinLimit)) return "within the limit";
      has_more = has_more || leaf.status == LeafStatus::MaxParts;
      if (leaf.least_squared_concavity < 0) return "the least concavity is not negative";
      if (leaf.least_squared_concavity > squared) return "no association gives less";
    }
    if (has_more != tree_.stopped_by_count) return "as many leaves as allowed";
    return {};
  }

  std::pair<Rational, TriangleId> rank(std::uint32_t n) const {
    return {-tree_.nodes[n].concavity.squared, tree_.nodes[n].lowest};
  }
  std::optional<LeafStatus> status_of(std::uint32_t n) const {
    for (const SplitLeaf& leaf : tree_.leaves) {
      if (leaf.node == n) return leaf.status;
    }
    return {};
  }
  bool has_area(TriangleId t) const {
    const auto& [a, b, c] = surface_.triangles[t.index()];
    const RationalVector3 u = surface_.points[b] - surface_.points[a];
    return !u.cross(surface_.points[c] - surface_.points[a]).isZero();
  }
  bool is_at(const std::set<TriangleId>& triangles, PointId p) const {
    return std::any_of(triangles.begin(), triangles.end(), [&](TriangleId t) {
      const auto& corners = surface_.triangles[t.index()];
      return std::count(corners.begin(), corners.end(), p) > 0;
    });
  }
  bool is_connected(const std::set<TriangleId>& triangles) const {
    std::vector<std::pair<TriangleId, TriangleId>> inside;
    for (const auto& [a, b] : pairs_) {
      if (triangles.count(a) + triangles.count(b) == 2) inside.emplace_back(a, b);
    }
    const std::size_t others = surface_.triangles.size() - triangles.size();
    return count_groups(surface_, inside) == others + 1;
  }

  const Surface& surface_;
  const SplitOptions& options_;
  const SplitTree& tree_;
  const std::vector<std::set<TriangleId>> of_;  // by node
  const std::vector<std::pair<TriangleId, TriangleId>> pairs_;
};

/// The difference between two trees in structure, and in squares of lengths, where those of `b` are
/// to be `factor` times those of `a`; nothing if there is none.
inline std::string difference(const SplitTree& a, const SplitTree& b, const Rational& factor = 1) {
  if (a.roots != b.roots || a.nodes.size() != b.nodes.size()) return "the number of nodes";
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    const SplitNode &x = a.nodes[n], &y = b.nodes[n];
    const std::string at = " of node " + std::to_string(n);
    if (x.concavity.squared * factor != y.concavity.squared) return "the concavity" + at;
    if (x.concavity.squared != 0 && x.notch != y.notch) return "the notch" + at;
    if (x.concavity.triangle != y.concavity.triangle) return "the triangle at the notch" + at;
    if (x.parent != y.parent || x.is_split != y.is_split) return "the parent" + at;
    if (x.is_split && x.children != y.children) return "the children" + at;
    if (x.lowest != y.lowest || x.triangle_count != y.triangle_count) return "the triangles" + at;
  }
  if (a.splits.size() != b.splits.size()) return "the number of splits";
  for (std::size_t k = 0; k < a.splits.size(); ++k) {
    const Split &x = a.splits[k], &y = b.splits[k];
    const std::string at = " of split " + std::to_string(k);
    if (x.node != y.node || x.edge != y.edge) return "the edge" + at;
    if (x.moved != y.moved || x.islands != y.islands) return "the halves" + at;
    if (x.refused != y.refused) return "the planes refused" + at;
  }
  if (a.leaves.size() != b.leaves.size()) return "the number of leaves";
  for (std::size_t k = 0; k < a.leaves.size(); ++k) {
    const SplitLeaf &x = a.leaves[k], &y = b.leaves[k];
    const std::string at = " of leaf " + std::to_string(k);
    if (x.node != y.node || x.triangles != y.triangles) return "the triangles" + at;
    if (x.status != y.status) return "the status" + at;
    if (x.least_squared_concavity * factor != y.least_squared_concavity) return "the least" + at;
  }
  if (a.united != b.united) return "what is united";
  if (a.stopped_by_count != b.stopped_by_count) return "why it ended";
  if (a.squared_limit * factor != b.squared_limit) return "the limit";
  if (a.squared_diameter * factor != b.squared_diameter) return "the diameter";
  return {};
}

/// The same for two trees of surfaces at the same place, including points and planes.
inline std::string difference_in_place(const SplitTree& a, const SplitTree& b) {
  if (const std::string found = difference(a, b); !found.empty()) return found;
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    const Concavity &x = a.nodes[n].concavity, &y = b.nodes[n].concavity;
    if (x.at != y.at || x.leaves != y.leaves) return "the segment of node " + std::to_string(n);
  }
  for (std::size_t k = 0; k < a.splits.size(); ++k) {
    if (a.splits[k].plane != b.splits[k].plane) return "the plane of split " + std::to_string(k);
  }
  return {};
}

/// The difference between two associations.
inline std::string difference(const Association& a, const Association& b) {
  if (a.bridges != b.bridges) return "the bridges";
  if (a.points != b.points) return "the points";
  if (a.paths.size() != b.paths.size()) return "the number of paths";
  for (std::size_t k = 0; k < a.paths.size(); ++k) {
    const BridgePath &x = a.paths[k], &y = b.paths[k];
    const std::string at = " of path " + std::to_string(k);
    if (x.bridges != y.bridges) return "the bridges" + at;
    if (x.spans_hole != y.spans_hole) return "the hole" + at;
    if (x.is_joined != y.is_joined || x.points != y.points) return "the points" + at;
  }
  if (a.bridges_of != b.bridges_of) return "the bridges of points";
  return {};
}

}  // namespace support
