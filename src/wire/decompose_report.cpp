// SPDX-License-Identifier: MIT
#include "wire/decompose_report.hpp"

#include <algorithm>

#include "io/json.hpp"
#include "io/names.hpp"
#include "number/groups.hpp"
#include "number/precision.hpp"
#include "simplify/run_names.hpp"
#include "wire/decompose_options.hpp"
#include "wire/surface_report.hpp"
#include "wire/tie_report.hpp"

namespace convexact {
namespace {

constexpr auto kPartFormNames = name_table<PartForm>({{PartForm::Hull, "hull"},
                                                      {PartForm::Rounded, "rounded"},
                                                      {PartForm::Simplified, "simplified"},
                                                      {PartForm::Thickened, "thickened"},
                                                      {PartForm::Flat, "flat"}});

}  // namespace

Enclosure enclosed_root_of(const Rational& square) { return sqrt(Enclosure(square, kMeasureBits)); }

Enclosure percent_of(const Enclosure& length, const Rational& squared_diameter) {
  if (squared_diameter == 0) return Enclosure(kMeasureBits);  // a single point
  return Enclosure(Integer(100), kMeasureBits) * length / enclosed_root_of(squared_diameter);
}

TieTally ties_of(const Clustering& clustering) {
  TieTally ties;
  for (const Merge& merge : clustering.merges) {
    if (merge.ties > 0) ties.add(merge.tie_evidence);
  }
  return ties;
}

std::size_t count_leaves(const SplitTree& tree, LeafStatus status) {
  return static_cast<std::size_t>(
      std::count_if(tree.leaves.begin(), tree.leaves.end(),
                    [&](const SplitLeaf& leaf) { return leaf.status == status; }));
}

std::size_t island_count(const SplitTree& tree) {
  std::size_t count = 0;
  for (const Split& split : tree.splits) count += split.islands.size();
  return count;
}

std::size_t merges_beyond(const Clustering& clustering) {
  return static_cast<std::size_t>(
      std::count_if(clustering.merges.begin(), clustering.merges.end(),
                    [](const Merge& merge) { return merge.beyond_limit; }));
}

// ---- JSON

Json limit_json(const ConcavityLimit& limit, const Decomposition& decomposition) {
  Json json = {{limit.is_share ? "share" : "length", to_string(limit.value)}};
  json["squared"] = to_string(decomposition.squared_limit());
  json["bounds"] = interval_json(enclosed_root_of(decomposition.squared_limit()));
  return json;
}

Json method_json(const DecomposeRequest& request) {
  Json json = {{"method", name_in(kDecomposeMethodNames, request.method)}};
  if (request.method == DecomposeMethod::Hacd) {
    json["measure"] = name_in(kConcavityMeasureNames, request.measure);
    json["engine"] = name_of(request.engine);
  } else if (request.method == DecomposeMethod::Cut) {
    json["engine"] = name_of(request.engine);
    return json;
  } else {
    json["bridge"] = name_in(kBridgeChoiceNames, request.bridge);
    json["coplanar"] = to_string(request.coplanar);
  }
  json["connect"] = name_in(kConnectNames, request.connect);
  return json;
}

// What the construction proves; measures say more of the solid.
const char* covered_name(const Decomposition& decomposition) {
  const bool is_solid =
      std::holds_alternative<Partition>(decomposition.origin) && decomposition.surface.is_closed;
  return is_solid ? "solid" : "surface";
}

const char* stop_name(const Decomposition& decomposition) {
  if (decomposition.stopped_by_count()) return name_in(kLeafStatusNames, LeafStatus::MaxParts);
  if (const auto* partition = std::get_if<Partition>(&decomposition.origin)) {
    const bool is_stuck = std::any_of(partition->leaves.begin(), partition->leaves.end(),
                                      [](const PartitionLeaf& leaf) { return !leaf.is_within; });
    return is_stuck ? name_in(kLeafStatusNames, LeafStatus::Unsplittable) : "distance";
  }
  const auto* tree = std::get_if<SplitTree>(&decomposition.origin);
  return tree != nullptr && count_leaves(*tree, LeafStatus::Unsplittable) > 0
             ? name_in(kLeafStatusNames, LeafStatus::Unsplittable)
             : "concavity";
}

Json vertices_json(const PointSet& points, bool as_fractions) {
  Json vertices = Json::array();
  for (const Point& p : points.doubles()) {
    if (as_fractions) {
      vertices.push_back(vector_json(to_rational(p)));
    } else {
      vertices.push_back({p.x(), p.y(), p.z()});
    }
  }
  return vertices;
}

namespace {

const char* status_name(const Decomposition& decomposition, std::size_t number) {
  const Part& part = decomposition.parts[number];
  if (std::holds_alternative<Partition>(decomposition.origin) && decomposition.reach) {
    const auto& farther = decomposition.reach->farther;
    return std::any_of(farther.begin(), farther.end(),
                       [&](const auto& x) { return x.part == number; })
               ? "beyond-eps"
               : name_in(kLeafStatusNames, LeafStatus::WithinLimit);
  }
  if (part.is_within_limit) return name_in(kLeafStatusNames, LeafStatus::WithinLimit);
  if (!part.least_squared_concavity) return "beyond-eps";  // no leaf of splits
  return name_in(kLeafStatusNames,
                 part.is_unsplittable ? LeafStatus::Unsplittable : LeafStatus::MaxParts);
}

Json concavity_json(const Concavity& concavity, const Rational& squared_diameter) {
  const Enclosure length = enclosed_root_of(concavity.squared);
  return {{"squared", to_string(concavity.squared)},
          {"bounds", interval_json(length)},
          {"percent", percent_of(length, squared_diameter).high_double()},
          {"triangle", concavity.triangle},
          {"at", vector_json(concavity.at)},
          {"leaves", vector_json(concavity.leaves)}};
}

// How far parts reach beyond planes between them, and the planes.
Json apart_json(const DecompositionApart& apart) {
  Json planes = Json::array();
  for (const auto& [first, second, plane] : apart.planes) {
    Json direction = Json::array();
    for (const Integer& x : plane.direction) direction.push_back(to_string(Rational(x)));
    planes.push_back({{"parts", {first, second}}, {"direction", std::move(direction)}});
  }
  return {{"squared_push", to_string(apart.squared_push)},
          {"push", interval_json(enclosed_root_of(apart.squared_push))},
          {"planes", std::move(planes)}};
}

// Which parts reach farther than allowed, with a point that does, or with bounds.
Json reach_json(const DecompositionReach& reach, const DecomposeRequest& request) {
  Json farther = Json::array();
  for (const auto& [part, found] : reach.farther) {
    Json entry = {{"part", part}, {"reach", found.reach == Reach::Beyond ? "beyond" : "undecided"}};
    if (found.witness) {
      entry["point"] = vector_json(found.witness->point);
      entry["nearest"] = vector_json(found.witness->nearest);
      entry["squared"] = to_string(found.witness->squared);
    }
    if (found.bracket) {
      entry["squared_bounds"] = {to_string(found.bracket->low), to_string(found.bracket->high)};
    }
    farther.push_back(std::move(entry));
  }
  const ConcavityLimit limit = request.distance.value_or(kDefaultDistance);
  return {{"guard", name_in(kReachUseNames, request.guard)},
          {"merge", name_in(kReachUseNames, request.merge)},
          {limit.is_share ? "share" : "length", to_string(limit.value)},
          {"squared", to_string(reach.squared_distance)},
          {"bounds", interval_json(enclosed_root_of(reach.squared_distance))},
          {"holds", reach.farther.empty()},
          {"farther", std::move(farther)},
          {"refused", reach.refused},
          {"merged", reach.merged},
          {"cells", reach.cells}};
}

Json part_entry(const Decomposition& decomposition, std::size_t number, const std::string& name,
                DecompositionDetail detail) {
  const Part& part = decomposition.parts[number];
  Json json = {{"name", name},
               {"form", name_in(kPartFormNames, part.form)},
               {"dimension", part.hull.dimension},
               {"triangles", part.owns.size()},
               {"loose_points", part.loose.size()},
               {"corners", part.mesh.points.size()},
               {"facets", part.faces},
               {"status", status_name(decomposition, number)}};
  if (std::holds_alternative<Partition>(decomposition.origin)) {
    json["leaves"] = part.leaves;
  } else {
    json["concavity"] = concavity_json(part.concavity, decomposition.squared_diameter());
  }
  if (const auto& least = part.least_squared_concavity) {
    json["least_concavity"] = {{"squared", to_string(*least)},
                               {"bounds", interval_json(enclosed_root_of(*least))}};
  }
  if (!part.merged.empty()) json["merged"] = part.merged;
  if (detail == DecompositionDetail::Numbers) return json;
  json["owns"] = part.owns;
  json["vertices"] = vertices_json(part.mesh.points, !decomposition.surface.points.is_binary());
  json["faces"] = part.mesh.polygons;
  json["halfspaces"] = part.halfspaces;
  return json;
}

// The clusters that a run starts with: triangles, those without area together with the one over
// their longest edge. By triangle: the lowest one of its cluster.
std::vector<std::uint32_t> first_clusters(const Clustering& clustering, std::size_t triangles) {
  Groups clusters(triangles);
  for (const auto& [flat, over] : clustering.united) clusters.join(flat.value, over.value);
  return clusters.roots();
}

// First the clusters of the start, by their lowest triangles, then one for each merge.
Json forest_json(const Decomposition& decomposition, const Clustering& clustering) {
  const std::vector<std::uint32_t> lowest =
      first_clusters(clustering, decomposition.surface.triangles.size());
  std::vector<std::vector<std::uint32_t>> triangles(lowest.size());
  for (std::size_t t = 0; t < lowest.size(); ++t) {
    triangles[lowest[t]].push_back(static_cast<std::uint32_t>(t));
  }
  Json nodes = Json::array();
  std::vector<std::size_t> node_of(lowest.size());  // by the lowest triangle of a cluster
  std::vector<bool> is_root(lowest.size());
  const auto add = [&](std::size_t cluster, const char* key, Json value) {
    node_of[cluster] = nodes.size();
    nodes.push_back({{"node", nodes.size()}, {"parent", nullptr}, {"part", nullptr}});
    nodes.back()[key] = std::move(value);
  };
  for (std::size_t t = 0; t < lowest.size(); ++t) {
    if (triangles[t].empty()) continue;
    is_root[t] = true;
    add(t, "triangles", triangles[t]);
  }
  for (const Merge& merge : clustering.merges) {
    const std::size_t kept = merge.kept.index(), gone = merge.gone.index();
    const std::size_t left = node_of[kept], right = node_of[gone];
    is_root[gone] = false;
    add(kept, "children", {left, right});
    nodes[left]["parent"] = nodes[right]["parent"] = node_of[kept];
  }
  for (std::size_t t = 0; t < lowest.size(); ++t) {
    if (is_root[t]) nodes[node_of[t]]["part"] = decomposition.owner[t];
  }
  return nodes;
}

// Every node, first the roots, then the children of each split; of a leaf its triangles and its
// part, of a split its notch and its plane.
Json split_tree_json(const Decomposition& decomposition, const SplitTree& tree) {
  Json nodes = Json::array();
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    nodes.push_back({{"node", n}, {"parent", or_null(tree.nodes[n].parent)}, {"part", nullptr}});
  }
  for (const SplitLeaf& leaf : tree.leaves) {
    Json& node = nodes[leaf.node];
    node["part"] = decomposition.owner[leaf.triangles.front().index()];
    node["triangles"] = leaf.triangles;
  }
  for (const Split& split : tree.splits) {
    Json& node = nodes[split.node];
    node["children"] = tree.nodes[split.node].children;
    node["notch"] = vector_json(decomposition.surface.points[split.edge[0]]);
    node["plane"] = plane_json(split.plane);
  }
  return nodes;
}

// Every node, the root first; of a leaf its triangles and its part, of a cut its plane, with what
// lies within its halfspace first.
Json partition_json(const Decomposition& decomposition, const Partition& partition) {
  Json nodes = Json::array();
  for (std::size_t n = 0; n < partition.nodes.size(); ++n) {
    const PartitionNode& node = partition.nodes[n];
    nodes.push_back({{"node", n}, {"parent", or_null(node.parent)}, {"part", nullptr}});
    if (!node.plane) continue;
    nodes.back()["children"] = node.children;
    nodes.back()["plane"] = plane_json(*node.plane);
  }
  for (std::size_t k = 0; k < decomposition.parts.size(); ++k) {
    for (const std::uint32_t leaf : decomposition.parts[k].leaves) {
      nodes[partition.leaves[leaf].node]["part"] = k;
      nodes[partition.leaves[leaf].node]["triangles"] = partition.leaves[leaf].triangles;
    }
  }
  return nodes;
}

Json tree_json(const Decomposition& decomposition) {
  if (const auto* clustering = std::get_if<Clustering>(&decomposition.origin)) {
    return forest_json(decomposition, *clustering);
  }
  if (const auto* tree = std::get_if<SplitTree>(&decomposition.origin)) {
    return split_tree_json(decomposition, *tree);
  }
  return partition_json(decomposition, std::get<Partition>(decomposition.origin));
}

Json cuts_json(const Partition& partition) {
  return {{"count", (partition.nodes.size() - 1) / 2},
          {"leaves", partition.leaves.size()},
          {"planes_tried", partition.planes_tried}};
}

Json merges_json(const Clustering& clustering) {
  return {{"count", clustering.merges.size()},
          {"beyond_eps", merges_beyond(clustering)},
          {"ties", ties_json(ties_of(clustering))},
          {"evaluations", clustering.evaluations},
          {"exact_evaluations", clustering.exact_evaluations}};
}

Json splits_json(const SplitTree& tree) {
  std::size_t refused = 0;
  for (const Split& split : tree.splits) refused += split.refused;
  return {{"count", tree.splits.size()},
          {"roots", tree.roots},
          {"refused_planes", refused},
          {"island_triangles", island_count(tree)},
          {"unsplittable", count_leaves(tree, LeafStatus::Unsplittable)}};
}

Json measured_or_null(const std::optional<Measured>& x) {
  return x ? interval_json(*x) : Json(nullptr);
}

}  // namespace

Json decomposition_json(const Decomposition& decomposition, const DecomposeRequest& request,
                        std::span<const std::string> names, DecompositionDetail detail) {
  const auto* clustering = std::get_if<Clustering>(&decomposition.origin);
  Json json = {{"decomposition", 1}};
  json.update(method_json(request));
  const auto* partition = std::get_if<Partition>(&decomposition.origin);
  if (partition == nullptr) json["concavity"] = limit_json(request.limit, decomposition);
  json["max_parts"] = or_null(request.max_parts);
  json["stop"] = stop_name(decomposition);
  json["eps_holds"] = decomposition.limit_holds;
  json["covers"] = covered_name(decomposition);
  json["squared_diameter"] = to_string(decomposition.squared_diameter());
  json["surface"] = surface_json(decomposition.surface);
  if (clustering != nullptr) {
    json["merges"] = merges_json(*clustering);
  } else if (partition != nullptr) {
    json["cuts"] = cuts_json(*partition);
  } else {
    json["splits"] = splits_json(std::get<SplitTree>(decomposition.origin));
  }
  if (decomposition.caps > 0) {
    json["closed_by"] = {
        {"caps", decomposition.caps},
        {"largest", interval_json(enclosed_root_of(decomposition.squared_largest_cap))}};
  }
  if (decomposition.reach) json["reach"] = reach_json(*decomposition.reach, request);
  if (const auto& excess = decomposition.excess) {
    json["max_excess"] = {{"allowed", to_string(excess->most)},
                          {"bounds", interval_json(excess->share)},
                          {"holds", excess->holds}};
  }
  if (decomposition.apart) json["disjoint"] = apart_json(*decomposition.apart);
  json["precision"] = name_in(kPrecisionNames, request.precision);
  json["verified"] = {{"triangles", decomposition.tested_triangles}, {"violations", 0}};
  if (const auto& measures = decomposition.measures) {
    json["solid"] = measured_or_null(measures->solid_volume);
    json["uncovered"] = measured_or_null(measures->uncovered_volume);
    if (measures->union_volume) {
      json["excess"] = measured_or_null(measures->excess_volume);
      json["union"] = interval_json(*measures->union_volume);
      json["overlap"] = interval_json(*measures->overlap_volume);
    }
  }
  Json inner = Json::array();
  for (const InnerCluster& cluster : decomposition.inner) {
    inner.push_back({{"triangle", cluster.lowest}, {"part", cluster.part}});
  }
  json["inner"] = std::move(inner);
  json["flat_merged"] = decomposition.flat_merged;
  Json parts = Json::array();
  for (std::size_t k = 0; k < decomposition.parts.size(); ++k) {
    parts.push_back(part_entry(decomposition, k, names[k], detail));
  }
  json["parts"] = std::move(parts);
  if (detail == DecompositionDetail::Numbers) return json;
  json["face_of"] = decomposition.surface.face;
  json["tree"] = tree_json(decomposition);
  return json;
}

Json decomposition_json(std::span<const DecomposedObject> objects, DecompositionDetail detail) {
  if (objects.size() == 1) {
    return decomposition_json(objects[0].result, objects[0].request, objects[0].part_names, detail);
  }
  bool holds = true, is_solid = true;
  Json parts = Json::array(), list = parts;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    Json entry = {{"name", objects[k].name}};
    entry.update(
        decomposition_json(objects[k].result, objects[k].request, objects[k].part_names, detail));
    for (const Json& part : entry["parts"]) {
      parts.push_back({{"name", part["name"]}, {"object", k}});
      parts.back().update(part);
    }
    entry.erase("parts");
    holds = holds && objects[k].result.limit_holds;
    is_solid = is_solid && entry["covers"] == "solid";
    list.push_back(std::move(entry));
  }
  return {{"decomposition", 1},
          {"eps_holds", holds},
          {"covers", is_solid ? "solid" : "surface"},
          {"objects", list},
          {"parts", std::move(parts)}};
}

}  // namespace convexact
