// SPDX-License-Identifier: MIT
#include "scene/split_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "io/names.hpp"
#include "number/text.hpp"
#include "scene/decompose_report.hpp"

namespace convexact {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::size_t island_count(const SplitTree& tree) {
  std::size_t count = 0;
  for (const Split& split : tree.splits) count += split.islands.size();
  return count;
}

std::size_t refused_count(const SplitTree& tree) {
  std::size_t count = 0;
  for (const Split& split : tree.splits) count += split.refused;
  return count;
}

OrderedJson ids_json(std::span<const PointId> points) {
  OrderedJson list = OrderedJson::array();
  for (const PointId p : points) list.push_back(p.value);
  return list;
}

OrderedJson association_json(const Association& association) {
  OrderedJson bridges = OrderedJson::array(), paths = bridges;
  for (const auto& bridge : association.bridges) {
    OrderedJson facets = OrderedJson::array();
    for (const Association::Facet& facet : bridge) facets.push_back(ids_json(facet));
    bridges.push_back(std::move(facets));
  }
  for (const BridgePath& path : association.paths) {
    paths.push_back({{"bridges", path.bridges},
                     {"points", ids_json(path.points)},
                     {"spans_hole", path.spans_hole},
                     {"joined", path.is_joined}});
  }
  return {{"bridges", std::move(bridges)},
          {"paths", std::move(paths)},
          {"points", ids_json(association.points)},
          {"bridges_of", association.bridges_of}};
}

OrderedJson parent_json(const SplitNode& node) {
  return node.parent ? OrderedJson(*node.parent) : OrderedJson(nullptr);
}

constexpr auto kLeafStatusNames =
    name_table<LeafStatus>({{LeafStatus::WithinLimit, "within-eps"},
                            {LeafStatus::MaxParts, "max-parts"},
                            {LeafStatus::Unsplittable, "unsplittable"}});

}  // namespace

std::size_t count_leaves(const SplitTree& tree, LeafStatus status) {
  return static_cast<std::size_t>(
      std::count_if(tree.leaves.begin(), tree.leaves.end(),
                    [&](const SplitLeaf& leaf) { return leaf.status == status; }));
}

OrderedJson splits_json(const SplitTree& tree) {
  return {{"count", tree.splits.size()},
          {"roots", tree.roots},
          {"refused_planes", refused_count(tree)},
          {"island_triangles", island_count(tree)},
          {"unsplittable", count_leaves(tree, LeafStatus::Unsplittable)}};
}

std::string splits_text(const SplitTree& tree) {
  std::string text = with_separators(tree.splits.size()) + " by planes through the deepest notch";
  if (tree.roots > 1) text += fmt::format(", from {} components", with_separators(tree.roots));
  if (const std::size_t islands = island_count(tree)) {
    text += fmt::format("; {} went along as islands", counted(islands, "triangle", "triangles"));
  }
  return text;
}

OrderedJson split_tree_json(const Decomposition& decomposition) {
  const auto& tree = std::get<SplitTree>(decomposition.origin);
  OrderedJson nodes = OrderedJson::array();
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    nodes.push_back({{"node", n}, {"parent", parent_json(tree.nodes[n])}, {"part", nullptr}});
  }
  for (const SplitLeaf& leaf : tree.leaves) {
    OrderedJson& node = nodes[leaf.node];
    node["part"] = decomposition.owner[leaf.triangles.front().index()];
    node["triangles"] = indices_json(leaf.triangles);
  }
  for (const Split& split : tree.splits) {
    OrderedJson& node = nodes[split.node];
    node["children"] = tree.nodes[split.node].children;
    node["notch"] = vector_json(decomposition.surface.points[split.edge[0]]);
    node["plane"] = plane_json(split.plane);
  }
  return nodes;
}

std::string write_split_trace(const Decomposition& decomposition, const DecomposeRequest& request) {
  const auto& tree = std::get<SplitTree>(decomposition.origin);
  OrderedJson nodes = OrderedJson::array(), splits = nodes;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const SplitNode& node = tree.nodes[n];
    nodes.push_back({{"node", n},
                     {"parent", parent_json(node)},
                     {"lowest", node.lowest.value},
                     {"triangles", node.triangle_count},
                     {"squared_concavity", to_string(node.concavity.squared)},
                     {"notch", nullptr},
                     {"nearest", nullptr},
                     {"status", "split"}});
    if (node.concavity.squared > 0) {
      nodes.back()["notch"] = node.notch.value;
      nodes.back()["nearest"] = vector_json(node.concavity.leaves);
    }
    if (node.association) nodes.back().update(association_json(*node.association));
  }
  for (const SplitLeaf& leaf : tree.leaves)
    nodes[leaf.node]["status"] = name_in(kLeafStatusNames, leaf.status);
  for (const Split& split : tree.splits) {
    splits.push_back({{"node", split.node},
                      {"children", tree.nodes[split.node].children},
                      {"edge", ids_json(split.edge)},
                      {"plane", plane_json(split.plane)},
                      {"refused", split.refused},
                      {"moved", indices_json(split.moved)},
                      {"islands", indices_json(split.islands)}});
  }
  OrderedJson json = trace_head(decomposition, request);
  json["nodes"] = std::move(nodes);
  json["splits"] = std::move(splits);
  return write_lines(json);
}

}  // namespace convexact
