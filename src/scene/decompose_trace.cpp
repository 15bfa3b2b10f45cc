// SPDX-License-Identifier: MIT
// A decomposition as a trace: every merge, or every split.
#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "scene/decompose_options.hpp"
#include "scene/decompose_report.hpp"
#include "simplify/run_names.hpp"

namespace convexact {
namespace {

using OrderedJson = nlohmann::ordered_json;

// What every trace begins with: the question, and the surface.
OrderedJson trace_head(const Decomposition& decomposition, const DecomposeRequest& request) {
  const Surface& surface = decomposition.surface;
  OrderedJson points = OrderedJson::array(), triangles = points, united = points;
  for (std::size_t k = 0; k < surface.points.size(); ++k) {
    points.push_back(vector_json(surface.points[PointId(k)]));
  }
  for (const auto& [a, b, c] : surface.triangles) triangles.push_back({a.value, b.value, c.value});
  const auto& pairs = std::visit(
      [](const auto& x) -> const auto& { return x.united; }, decomposition.origin);
  for (const auto& [flat, over] : pairs) united.push_back({flat.value, over.value});
  OrderedJson json = {{"decompose_trace", 1}};
  json.update(method_json(request));
  json["orient"] = name_in(kOrientationNames, request.orient);
  json["concavity"] = limit_json(request.limit, decomposition);
  json["squared_diameter"] = to_string(decomposition.squared_diameter());
  json["max_parts"] = or_null(request.max_parts);
  json["stop"] = stop_name(decomposition);
  json["points"] = std::move(points);
  json["triangles"] = std::move(triangles);
  json["united"] = std::move(united);
  return json;
}

OrderedJson merge_entries(const Clustering& clustering) {
  OrderedJson merges = OrderedJson::array();
  for (const Merge& merge : clustering.merges) {
    OrderedJson entry = {{"kept", merge.kept.value},
                         {"gone", merge.gone.value},
                         {"squared_concavity", or_null(merge.squared_concavity)},
                         {"cost", nullptr},
                         {"ties", merge.ties},
                         {"beyond_limit", merge.beyond_limit}};
    if (merge.cost) {
      entry["cost"] = {{"low", merge.cost->low_double()}, {"high", merge.cost->high_double()}};
    }
    if (merge.tie_evidence.proof) {
      entry["tie"] = name_of(*merge.tie_evidence.proof);
      if (merge.tie_evidence.proof == TieProof::Undecided) entry["bits"] = merge.tie_evidence.bits;
    }
    merges.push_back(std::move(entry));
  }
  return merges;
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

// Every node with the bridges over it, and every split with the triangles that go.
OrderedJson nodes_and_splits(const SplitTree& tree) {
  OrderedJson nodes = OrderedJson::array(), splits = nodes;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const SplitNode& node = tree.nodes[n];
    nodes.push_back({{"node", n},
                     {"parent", or_null(node.parent)},
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
  return {{"nodes", std::move(nodes)}, {"splits", std::move(splits)}};
}

}  // namespace

std::string write_decompose_trace(const Decomposition& decomposition,
                                  const DecomposeRequest& request) {
  OrderedJson json = trace_head(decomposition, request);
  if (const auto* clustering = std::get_if<Clustering>(&decomposition.origin)) {
    json["merges"] = merge_entries(*clustering);
  } else {
    json.update(nodes_and_splits(std::get<SplitTree>(decomposition.origin)));
  }
  return write_lines(json);
}

}  // namespace convexact
