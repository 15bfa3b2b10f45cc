// SPDX-License-Identifier: MIT
// find_tree_fault(): is this a tree, are its leaves the parts, and does each hull hold those below?
#include <fmt/format.h>

#include <algorithm>

#include "convexact/hull_tree.hpp"
#include "convexact/stored.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

using Nodes = std::vector<std::size_t>;

std::string list_text(const Nodes& nodes) { return fmt::format("{}", fmt::join(nodes, ", ")); }

// The faults of a tree, each tested when those before it are excluded.
class TreeInspection {
 public:
  TreeInspection(const HullTree& tree, const Watch& watch)
      : tree_(tree), nodes_(tree.nodes), watch_(watch) {}

  std::optional<TreeFault> find() const {
    if (nodes_.empty()) return TreeFault{"there is no node", {}, {}, {}, {}};
    using Look = std::optional<TreeFault> (TreeInspection::*)() const;
    for (const Look look :
         {&TreeInspection::missing, &TreeInspection::roots, &TreeInspection::disagreement,
          &TreeInspection::cycle, &TreeInspection::leaves, &TreeInspection::escape}) {
      if (auto fault = (this->*look)()) return fault;
    }
    return {};
  }

 private:
  static TreeFault fault(std::string sentence, Nodes nodes, std::optional<std::size_t> part = {}) {
    return {std::move(sentence), std::move(nodes), part, {}, {}};
  }

  std::optional<TreeFault> missing() const {
    const std::string range = fmt::format("nodes are 0 to {}", nodes_.size() - 1);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const HullTreeNode& node = nodes_[i];
      if (node.parent && *node.parent >= nodes_.size()) {
        return fault(fmt::format("node {} names {} as its parent; {}", i, *node.parent, range),
                     {i});
      }
      for (const std::size_t child : node.children) {
        if (child >= nodes_.size()) {
          return fault(fmt::format("node {} names {} as a child; {}", i, child, range), {i});
        }
      }
      if (node.part && *node.part >= tree_.parts.size()) {
        return fault(fmt::format("node {} names part {}, and the number of parts is {}", i,
                                 *node.part, tree_.parts.size()),
                     {i}, node.part);
      }
    }
    return {};
  }

  std::optional<TreeFault> roots() const {
    Nodes roots;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!nodes_[i].parent) roots.push_back(i);
    }
    if (roots.size() == 1) return {};
    if (roots.empty()) {
      const Nodes round = way_up_from(0);
      return fault("no node is the root: upwards, nodes " + list_text(round) + " go round", round);
    }
    return fault(fmt::format("nodes {} have no parent, and a tree has one root", list_text(roots)),
                 roots);
  }

  std::optional<TreeFault> disagreement() const {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      Nodes children = nodes_[i].children;
      std::sort(children.begin(), children.end());
      const auto twice = std::adjacent_find(children.begin(), children.end());
      if (twice != children.end()) {
        return fault(fmt::format("node {} names child {} twice", i, *twice), {i, *twice});
      }
      for (const std::size_t child : children) {
        const auto& parent = nodes_[child].parent;
        if (parent == i) continue;
        return fault(fmt::format("node {} names node {} as a child, which names {}", i, child,
                                 parent ? fmt::format("node {} as its parent", *parent)
                                        : std::string("no parent")),
                     {i, child});
      }
      if (!nodes_[i].parent) continue;
      const Nodes& siblings = nodes_[*nodes_[i].parent].children;
      if (std::find(siblings.begin(), siblings.end(), i) == siblings.end()) {
        return fault(fmt::format("node {} names node {} as its parent, which does not name it as a "
                                 "child",
                                 i, *nodes_[i].parent),
                     {*nodes_[i].parent, i});
      }
    }
    return {};
  }

  // Every node but the root has one parent, so nodes that are not reached from the root lead into a
  // cycle.
  std::optional<TreeFault> cycle() const {
    std::vector<bool> is_reached(nodes_.size(), false);
    Nodes open;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!nodes_[i].parent) open.push_back(i);
    }
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      is_reached[node] = true;
      open.insert(open.end(), nodes_[node].children.begin(), nodes_[node].children.end());
    }
    const auto lost = std::find(is_reached.begin(), is_reached.end(), false);
    if (lost == is_reached.end()) return {};
    const Nodes round = way_up_from(static_cast<std::size_t>(lost - is_reached.begin()));
    return fault("nodes " + list_text(round) + " form a cycle, away from the root", round);
  }

  // The cycle that going up leads into. Precondition: it never ends.
  Nodes way_up_from(std::size_t node) const {
    for (std::size_t step = 0; step < nodes_.size(); ++step) node = *nodes_[node].parent;
    Nodes round = {node};
    for (std::size_t up = *nodes_[node].parent; up != node; up = *nodes_[up].parent) {
      round.push_back(up);
    }
    std::rotate(round.begin(), std::min_element(round.begin(), round.end()), round.end());
    return round;
  }

  std::optional<TreeFault> leaves() const {
    std::vector<std::optional<std::size_t>> leaf_of(tree_.parts.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const HullTreeNode& node = nodes_[i];
      if (node.part && !node.children.empty()) {
        return fault(fmt::format("node {} names part {}, but it has children", i, *node.part), {i},
                     node.part);
      }
      if (!node.part && node.children.empty()) {
        return fault(fmt::format("node {} has neither children nor a part", i), {i});
      }
      if (!node.part) continue;
      auto& leaf = leaf_of[*node.part];
      if (leaf) {
        return fault(
            fmt::format("nodes {} and {} are both the leaf of {}", *leaf, i, part_text(*node.part)),
            {*leaf, i}, node.part);
      }
      leaf = i;
    }
    for (std::size_t k = 0; k < leaf_of.size(); ++k) {
      if (!leaf_of[k]) return fault(part_text(k) + " is missing: no leaf names it", {}, k);
    }
    return {};
  }

  std::string part_text(std::size_t part) const {
    return fmt::format("part {} ({})", part, in_quotes(tree_.parts[part].name));
  }

  std::optional<TreeFault> escape() const {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      watch_.at(i, nodes_.size());
      if (nodes_[i].children.empty()) continue;
      const std::vector<Halfspace> hull = convex_part(tree_.mesh_of(i).points, watch_).halfspaces;
      for (const std::size_t child : nodes_[i].children) {
        const PointSet& points = tree_.mesh_of(child).points;
        const std::vector<PointId> outside = find_outside(hull, points);
        if (outside.empty()) continue;
        const RationalPoint first = points[outside.front()];
        const auto plane = std::find_if(hull.begin(), hull.end(),
                                        [&](const Halfspace& h) { return h(first) > 0; });
        return TreeFault{
            fmt::format("node {} does not hold its child {}: {} of {} points lie "
                        "outside, first point {}",
                        i, child, outside.size(), points.size(), outside.front().index()),
            {i, child},
            nodes_[child].part,
            outside.front().index(),
            *plane};
      }
    }
    return {};
  }

  const HullTree& tree_;
  const std::vector<HullTreeNode>& nodes_;
  const Watch& watch_;
};

}  // namespace

std::optional<TreeFault> find_tree_fault(const HullTree& tree, const Watch& watch) {
  return TreeInspection(tree, watch).find();
}

}  // namespace convexact
