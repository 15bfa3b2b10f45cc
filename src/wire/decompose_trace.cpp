// SPDX-License-Identifier: MIT
// A decomposition as a trace: every merge, or every split.

#include "io/json.hpp"
#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"
#include "wire/tie_report.hpp"

namespace convexact {
namespace {

// What every trace begins with: the question, and the surface.
Json trace_head(const Decomposition& decomposition, const DecomposeRequest& request) {
  const Surface& surface = decomposition.surface;
  Json points = Json::array();
  for (std::size_t k = 0; k < surface.points.size(); ++k) {
    points.push_back(vector_json(surface.points[PointId(k)]));
  }
  Json json = {{"decompose_trace", 1}};
  json.update(method_json(request));
  json["orient"] = name_in(kOrientationNames, request.orient);
  if (!std::holds_alternative<Partition>(decomposition.origin)) {
    json["concavity"] = limit_json(request.limit, decomposition);
  }
  json["squared_diameter"] = to_string(decomposition.squared_diameter());
  json["max_parts"] = or_null(request.max_parts);
  json["stop"] = stop_name(decomposition);
  json["points"] = std::move(points);
  json["triangles"] = surface.triangles;
  if (const auto* clustering = std::get_if<Clustering>(&decomposition.origin)) {
    json["united"] = clustering->united;
  } else if (const auto* tree = std::get_if<SplitTree>(&decomposition.origin)) {
    json["united"] = tree->united;
  }
  return json;
}

Json merge_entries(const Clustering& clustering) {
  Json merges = Json::array();
  for (const Merge& merge : clustering.merges) {
    Json entry = {{"kept", merge.kept},
                  {"gone", merge.gone},
                  {"squared_concavity", or_null(merge.squared_concavity)},
                  {"cost", nullptr},
                  {"ties", merge.ties},
                  {"beyond_limit", merge.beyond_limit}};
    if (merge.cost) entry["cost"] = bounds_json(*merge.cost);
    entry.update(tie_json(merge.tie_evidence, "tie"));
    merges.push_back(std::move(entry));
  }
  return merges;
}

Json association_json(const Association& association) {
  Json paths = Json::array();
  for (const BridgePath& path : association.paths) {
    paths.push_back({{"bridges", path.bridges},
                     {"points", path.points},
                     {"spans_hole", path.spans_hole},
                     {"joined", path.is_joined}});
  }
  return {{"bridges", association.bridges},
          {"paths", std::move(paths)},
          {"points", association.points},
          {"bridges_of", association.bridges_of}};
}

// Every node with the bridges over it, and every split with the triangles that go.
Json nodes_and_splits(const SplitTree& tree) {
  Json nodes = Json::array(), splits = nodes;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const SplitNode& node = tree.nodes[n];
    nodes.push_back({{"node", n},
                     {"parent", or_null(node.parent)},
                     {"lowest", node.lowest},
                     {"triangles", node.triangle_count},
                     {"squared_concavity", to_string(node.concavity.squared)},
                     {"notch", nullptr},
                     {"nearest", nullptr},
                     {"status", "split"}});
    if (node.concavity.squared > 0) {
      nodes.back()["notch"] = node.notch;
      nodes.back()["nearest"] = vector_json(node.concavity.leaves);
    }
    if (node.association) nodes.back().update(association_json(*node.association));
  }
  for (const SplitLeaf& leaf : tree.leaves)
    nodes[leaf.node]["status"] = name_in(kLeafStatusNames, leaf.status);
  for (const Split& split : tree.splits) {
    splits.push_back({{"node", split.node},
                      {"children", tree.nodes[split.node].children},
                      {"edge", split.edge},
                      {"plane", plane_json(split.plane)},
                      {"refused", split.refused},
                      {"moved", split.moved},
                      {"islands", split.islands}});
  }
  return {{"nodes", std::move(nodes)}, {"splits", std::move(splits)}};
}

// Every cut, the leaves as the hulls of what they hold, and which leaves each part joins.
Json cuts_and_leaves(const Decomposition& decomposition, const Partition& partition) {
  Json cuts = Json::array(), leaves = cuts, parts = cuts;
  for (std::size_t n = 0; n < partition.nodes.size(); ++n) {
    const PartitionNode& node = partition.nodes[n];
    if (!node.plane) continue;
    cuts.push_back({{"node", n}, {"children", node.children}, {"plane", plane_json(*node.plane)}});
  }
  for (const PartitionLeaf& leaf : partition.leaves) {
    Json corners = Json::array();
    for (std::size_t k = 0; k < leaf.corners.size(); ++k) {
      corners.push_back(vector_json(leaf.corners[PointId(k)]));
    }
    leaves.push_back({{"node", leaf.node},
                      {"triangles", leaf.triangles},
                      {"corners", std::move(corners)},
                      {"within_half", leaf.is_within}});
  }
  for (const Part& part : decomposition.parts) parts.push_back(part.leaves);
  return {{"cuts", std::move(cuts)}, {"leaves", std::move(leaves)}, {"parts", std::move(parts)}};
}

}  // namespace

std::string write_decompose_trace(const Decomposition& decomposition,
                                  const DecomposeRequest& request) {
  Json json = trace_head(decomposition, request);
  if (const auto* clustering = std::get_if<Clustering>(&decomposition.origin)) {
    json["merges"] = merge_entries(*clustering);
  } else if (const auto* partition = std::get_if<Partition>(&decomposition.origin)) {
    json.update(cuts_and_leaves(decomposition, *partition));
  } else {
    json.update(nodes_and_splits(std::get<SplitTree>(decomposition.origin)));
  }
  return write_lines(json);
}

}  // namespace convexact
