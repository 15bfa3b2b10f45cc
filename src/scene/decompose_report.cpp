// SPDX-License-Identifier: MIT
#include "scene/decompose_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "scene/result_json.hpp"
#include "scene/split_report.hpp"
#include "scene/surface_report.hpp"
#include "simplify/trace_json.hpp"

namespace convexact {
namespace {

using OrderedJson = nlohmann::ordered_json;

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

std::size_t merges_beyond(const Clustering& clustering) {
  return static_cast<std::size_t>(
      std::count_if(clustering.merges.begin(), clustering.merges.end(),
                    [](const Merge& merge) { return merge.beyond_limit; }));
}

}  // namespace

// ---- JSON

OrderedJson indices_json(std::span<const TriangleId> triangles) {
  OrderedJson list = OrderedJson::array();
  for (const TriangleId t : triangles) list.push_back(t.value);
  return list;
}

OrderedJson limit_json(const ConcavityLimit& limit, const Decomposition& decomposition) {
  OrderedJson json = {{limit.is_share ? "share" : "length", to_string(limit.value)}};
  json["squared"] = to_string(decomposition.squared_limit());
  json["bounds"] = interval_json(enclosed_root_of(decomposition.squared_limit()));
  return json;
}

OrderedJson concavity_json(const Concavity& concavity, const Rational& squared_diameter) {
  const Enclosure length = enclosed_root_of(concavity.squared);
  return {{"squared", to_string(concavity.squared)},
          {"bounds", interval_json(length)},
          {"percent", percent_of(length, squared_diameter).high_double()},
          {"triangle", concavity.triangle.value},
          {"at", vector_json(concavity.at)},
          {"leaves", vector_json(concavity.leaves)}};
}

const char* stop_name(const Decomposition& decomposition) {
  if (decomposition.stopped_by_count()) return "max-parts";
  const auto* tree = std::get_if<SplitTree>(&decomposition.origin);
  return tree != nullptr && count_leaves(*tree, LeafStatus::Unsplittable) > 0 ? "unsplittable"
                                                                              : "concavity";
}

OrderedJson vertices_json(const PointSet& points, bool as_fractions) {
  OrderedJson vertices = OrderedJson::array();
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

const char* status_name(const Part& part) {
  if (part.is_within_limit) return "within-eps";
  if (!part.least_squared_concavity) return "beyond-eps";
  return part.is_unsplittable ? "unsplittable" : "max-parts";
}

OrderedJson part_entry(const Decomposition& decomposition, std::size_t number,
                       const std::string& name, DecompositionDetail detail) {
  const Part& part = decomposition.parts[number];
  OrderedJson json = {
      {"name", name},
      {"form", name_in(kPartFormNames, part.form)},
      {"dimension", part.hull.dimension},
      {"triangles", part.owns.size()},
      {"corners", part.mesh.points.size()},
      {"facets", part.faces},
      {"status", status_name(part)},
      {"concavity", concavity_json(part.concavity, decomposition.squared_diameter())}};
  if (const auto& least = part.least_squared_concavity) {
    json["least_concavity"] = {{"squared", to_string(*least)},
                               {"bounds", interval_json(enclosed_root_of(*least))}};
  }
  if (detail == DecompositionDetail::Numbers) return json;
  json["owns"] = indices_json(part.owns);
  json["vertices"] = vertices_json(part.mesh.points, !decomposition.surface.points.is_binary());
  json["faces"] = part.mesh.polygons;
  json["halfspaces"] = part.halfspaces;
  return json;
}

// The clusters that a run starts with: triangles, those without area together with the one over
// their longest edge. By triangle: the lowest one of its cluster.
std::vector<std::uint32_t> first_clusters(const Clustering& clustering, std::size_t triangles) {
  std::vector<std::uint32_t> lowest(triangles);
  for (std::size_t t = 0; t < lowest.size(); ++t) lowest[t] = static_cast<std::uint32_t>(t);
  const auto find = [&](std::uint32_t t) {
    while (lowest[t] != t) t = lowest[t] = lowest[lowest[t]];
    return t;
  };
  for (const auto& [flat, over] : clustering.united) {
    const std::uint32_t a = find(flat.value), b = find(over.value);
    lowest[std::max(a, b)] = std::min(a, b);
  }
  for (std::size_t t = 0; t < lowest.size(); ++t) lowest[t] = find(static_cast<std::uint32_t>(t));
  return lowest;
}

// First the clusters of the start, by their lowest triangles, then one for each merge.
OrderedJson forest_json(const Decomposition& decomposition, const Clustering& clustering) {
  const std::vector<std::uint32_t> lowest =
      first_clusters(clustering, decomposition.surface.triangles.size());
  std::vector<std::vector<std::uint32_t>> triangles(lowest.size());
  for (std::size_t t = 0; t < lowest.size(); ++t) {
    triangles[lowest[t]].push_back(static_cast<std::uint32_t>(t));
  }
  OrderedJson nodes = OrderedJson::array();
  std::vector<std::size_t> node_of(lowest.size());  // by the lowest triangle of a cluster
  std::vector<bool> is_root(lowest.size());
  const auto add = [&](std::size_t cluster, const char* key, OrderedJson value) {
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

void add_method(OrderedJson& json, const DecomposeRequest& request) {
  json["method"] = name_in(kDecomposeMethodNames, request.method);
  if (request.method == DecomposeMethod::Hacd) {
    json["measure"] = name_in(kConcavityMeasureNames, request.measure);
    json["engine"] = name_of(request.engine);
  } else {
    json["bridge"] = name_in(kBridgeChoiceNames, request.bridge);
    json["coplanar"] = to_string(request.coplanar);
  }
  json["connect"] = name_in(kConnectNames, request.connect);
}

OrderedJson merges_json(const Clustering& clustering) {
  return {{"count", clustering.merges.size()},
          {"beyond_eps", merges_beyond(clustering)},
          {"ties", ties_json(ties_of(clustering))},
          {"evaluations", clustering.evaluations},
          {"exact_evaluations", clustering.exact_evaluations}};
}

OrderedJson measured_or_null(const std::optional<Measured>& x) {
  return x ? interval_json(*x) : OrderedJson(nullptr);
}

// ---- Text

std::string percent_text(const Rational& percent) { return to_decimal(percent, 6) + "%"; }

std::string percent_text(const Enclosure& percent) {
  return percent.high() <= 0 ? "0%" : fmt::format("{:.3g}%", percent.high_double());
}

// A share with its length, or the other way round.
std::string limit_text(const ConcavityLimit& limit, const Decomposition& decomposition) {
  const Enclosure length = enclosed_root_of(decomposition.squared_limit());
  if (limit.is_share) {
    return fmt::format("{} of the diameter, a length of {}", percent_text(limit.value * 100),
                       interval_text(length));
  }
  return fmt::format("a length of {}, {} of the diameter", to_decimal(limit.value, 6),
                     percent_text(percent_of(length, decomposition.squared_diameter())));
}

// Why some cluster is beyond the limit.
std::string cause_text(const Decomposition& decomposition, const DecomposeRequest& request) {
  std::vector<std::string> causes;
  if (const auto* clustering = std::get_if<Clustering>(&decomposition.origin)) {
    const std::size_t beyond = merges_beyond(*clustering);
    if (beyond > 0 && request.max_parts) {
      causes.push_back(fmt::format("--max-parts {} asked for {} beyond it", *request.max_parts,
                                   counted(beyond, "merge", "merges")));
    }
  } else {
    const auto& tree = std::get<SplitTree>(decomposition.origin);
    if (tree.stopped_by_count && request.max_parts) {
      causes.push_back(fmt::format("--max-parts {} allows no more splits", *request.max_parts));
    }
    if (const std::size_t stuck = count_leaves(tree, LeafStatus::Unsplittable)) {
      causes.push_back(counted(stuck, "part", "parts") +
                       " cannot be split: each plane at the deepest notch leaves all on one side");
    }
  }
  if (!decomposition.flat_merged.empty()) {
    causes.push_back(
        fmt::format("{} joined a neighbour",
                    counted(decomposition.flat_merged.size(), "flat cluster", "flat clusters")));
  }
  return fmt::format("{}", fmt::join(causes, "; "));
}

std::string limit_line(const Decomposition& decomposition, const DecomposeRequest& request) {
  const std::string limit = limit_text(request.limit, decomposition);
  if (decomposition.limit_holds) {
    return summary_line("limit", "holds: no cluster is more concave than " + limit);
  }
  const auto beyond = static_cast<std::size_t>(
      std::count_if(decomposition.parts.begin(), decomposition.parts.end(),
                    [](const Part& part) { return !part.is_within_limit; }));
  return summary_line("limit", fmt::format("not held: {} of {} {} more concave than {}", beyond,
                                           counted(decomposition.parts.size(), "part", "parts"),
                                           beyond == 1 ? "is" : "are", limit)) +
         summary_line("", cause_text(decomposition, request));
}

std::string parts_line(const std::vector<Part>& parts) {
  std::size_t facets = 0, corners = 0;
  for (const Part& part : parts) {
    facets = std::max(facets, part.faces);
    corners = std::max(corners, part.mesh.points.size());
  }
  return summary_line(
      "parts",
      fmt::format("{}, of at most {} and {}", with_separators(parts.size()),
                  counted(facets, "facet", "facets"), counted(corners, "corner", "corners")));
}

std::string concavity_line(const Decomposition& decomposition, std::span<const std::string> names) {
  const auto& parts = decomposition.parts;
  const auto worst = std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return a.concavity.squared < b.concavity.squared;
  });
  if (worst == parts.end()) return "";
  if (worst->concavity.squared == 0) return summary_line("concavity", "0 in every part");
  const Enclosure length = enclosed_root_of(worst->concavity.squared);
  return summary_line(
      "concavity",
      fmt::format("at most {} ({} of the diameter), in {} at triangle {}", interval_text(length),
                  percent_text(percent_of(length, decomposition.squared_diameter())),
                  names[static_cast<std::size_t>(worst - parts.begin())],
                  worst->concavity.triangle.value));
}

std::string merges_line(const Clustering& clustering) {
  std::string text = with_separators(clustering.merges.size()) + " of two neighbours";
  const TieTally ties = ties_of(clustering);
  std::vector<std::string> proofs;
  std::size_t tied = 0;
  for (const auto& [proof, name] : kTieProofNames) {
    const std::size_t merges = ties.steps[static_cast<std::size_t>(proof)];
    tied += merges;
    if (merges > 0) proofs.push_back(fmt::format("{} {}", with_separators(merges), name));
  }
  if (tied > 0) {
    text += fmt::format("; in {} several pairs cost the same ({}{}), and the first goes",
                        with_separators(tied), fmt::join(proofs, ", "),
                        ties.bits > 0 ? fmt::format("; not told apart by {} bits", ties.bits) : "");
  }
  return summary_line("merges", text);
}

// The volumes are of the stored parts. That the surface is covered says nothing about them.
std::string measures_lines(const DecompositionMeasures& measures) {
  std::string text;
  if (measures.solid_volume) {
    const Enclosure& solid = measures.solid_volume->bounds;
    text += summary_line("uncovered",
                         fmt::format("volume {} of {}{} of the solid is in no part",
                                     interval_text(*measures.uncovered_volume),
                                     interval_text(*measures.solid_volume),
                                     share_text(measures.uncovered_volume->bounds, solid)));
    text += summary_line("excess", fmt::format("volume {}{} of the parts is outside of the solid",
                                               interval_text(*measures.excess_volume),
                                               share_text(measures.excess_volume->bounds, solid)));
  }
  return text + summary_line("union", fmt::format("volume {}; the parts overlap by {}",
                                                  interval_text(measures.union_volume),
                                                  interval_text(measures.overlap_volume)));
}

std::string stored_line(const Decomposition& decomposition, Precision precision) {
  const auto count = [&](PartForm form) {
    return static_cast<std::size_t>(
        std::count_if(decomposition.parts.begin(), decomposition.parts.end(),
                      [&](const Part& part) { return part.form == form; }));
  };
  constexpr std::pair<PartForm, const char*> kSaid[] = {
      {PartForm::Hull, "with corners of the input, bit by bit"},
      {PartForm::Rounded, "rounded outward"},
      {PartForm::Simplified, "simplified"},
      {PartForm::Thickened, "flat, and thickened"},
      {PartForm::Flat, "flat, and left so"}};
  std::vector<std::string> forms;
  for (const auto& [form, said] : kSaid) {
    if (const std::size_t parts = count(form)) {
      forms.push_back(fmt::format("{} {}", with_separators(parts), said));
    }
  }
  return summary_line("stored", fmt::format("in {}: {}", name_in(kPrecisionNames, precision),
                                            fmt::join(forms, ", ")));
}

// What was done to the surface, and what of it may surprise.
std::string surface_notes(const Surface& surface) {
  std::size_t turned = 0, reversed = 0;
  for (const SurfaceComponent& component : surface.components) {
    turned += component.turned;
    reversed += component.is_reversed ? 1 : 0;
  }
  std::string text;
  const auto note = [&](std::size_t count, const char* one, const char* many,
                        const std::string& what) {
    if (count > 0) text += summary_line("note", counted(count, one, many) + what);
  };
  note(turned, "triangle was", "triangles were", " turned; --orient keep turns none");
  note(reversed, "component was", "components were", " inside out");
  note(surface.contradictions, "edge joins", "edges join",
       " triangles that cannot both look outward");
  note(surface.fans.size(), "face is", "faces are", " not planar: cut as a fan of triangles");
  note(surface.flat_triangles, "triangle has", "triangles have", " no area");
  note(surface.unused_points, "point belongs", "points belong",
       " to no face: nothing is promised of it");
  return text;
}

}  // namespace

OrderedJson decomposition_json(const Decomposition& decomposition, const DecomposeRequest& request,
                               std::span<const std::string> names, DecompositionDetail detail) {
  const auto* clustering = std::get_if<Clustering>(&decomposition.origin);
  OrderedJson json = {{"decomposition", 1}};
  add_method(json, request);
  json["concavity"] = limit_json(request.limit, decomposition);
  json["max_parts"] = or_null(request.max_parts);
  json["stop"] = stop_name(decomposition);
  json["eps_holds"] = decomposition.limit_holds;
  json["covers"] = "surface";
  json["squared_diameter"] = to_string(decomposition.squared_diameter());
  json["surface"] = surface_json(decomposition.surface);
  if (clustering != nullptr) {
    json["merges"] = merges_json(*clustering);
  } else {
    json["splits"] = splits_json(std::get<SplitTree>(decomposition.origin));
  }
  json["precision"] = name_in(kPrecisionNames, request.precision);
  json["verified"] = {{"triangles", decomposition.tested_triangles}, {"violations", 0}};
  if (const auto& measures = decomposition.measures) {
    json["solid"] = measured_or_null(measures->solid_volume);
    json["uncovered"] = measured_or_null(measures->uncovered_volume);
    json["excess"] = measured_or_null(measures->excess_volume);
    json["union"] = interval_json(measures->union_volume);
    json["overlap"] = interval_json(measures->overlap_volume);
  }
  OrderedJson inner = OrderedJson::array();
  for (const InnerCluster& cluster : decomposition.inner) {
    inner.push_back({{"triangle", cluster.lowest.value}, {"part", cluster.part}});
  }
  json["inner"] = std::move(inner);
  json["flat_merged"] = indices_json(decomposition.flat_merged);
  OrderedJson parts = OrderedJson::array();
  for (std::size_t k = 0; k < decomposition.parts.size(); ++k) {
    parts.push_back(part_entry(decomposition, k, names[k], detail));
  }
  json["parts"] = std::move(parts);
  if (detail == DecompositionDetail::Numbers) return json;
  json["face_of"] = decomposition.surface.face;
  json["tree"] = clustering != nullptr ? forest_json(decomposition, *clustering)
                                       : split_tree_json(decomposition);
  return json;
}

std::string write_lines(const OrderedJson& document) {
  std::string text = "{";
  const char* comma = "\n";
  for (const auto& [key, value] : document.items()) {
    text += comma + write_json(key) + ": ";
    comma = ",\n";
    const bool is_list = value.is_array() && !value.empty() && value[0].is_structured();
    if (!is_list) {
      text += write_json(value);
      continue;
    }
    for (std::size_t k = 0; k < value.size(); ++k) {
      text += (k == 0 ? "[\n  " : ",\n  ") + write_json(value[k]);
    }
    text += "\n]";
  }
  return text + "\n}\n";
}

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
  add_method(json, request);
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

std::string write_decompose_trace(const Decomposition& decomposition,
                                  const DecomposeRequest& request) {
  const auto* clustering = std::get_if<Clustering>(&decomposition.origin);
  if (clustering == nullptr) return write_split_trace(decomposition, request);
  OrderedJson merges = OrderedJson::array();
  for (const Merge& merge : clustering->merges) {
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
  OrderedJson json = trace_head(decomposition, request);
  json["merges"] = std::move(merges);
  return write_lines(json);
}

std::string summary(const Decomposition& decomposition, const DecomposeRequest& request,
                    std::span<const std::string> names) {
  std::string text = summary_line("input", surface_text(decomposition.surface));
  text += surface_notes(decomposition.surface);
  text += parts_line(decomposition.parts);
  if (const std::size_t inner = decomposition.inner.size()) {
    text += summary_line("", counted(inner, "cluster", "clusters") +
                                 " inside of other parts left out; --keep-inner keeps such parts");
  }
  text += concavity_line(decomposition, names) + limit_line(decomposition, request);
  if (const auto* clustering = std::get_if<Clustering>(&decomposition.origin)) {
    text += merges_line(*clustering);
  } else {
    text += summary_line("splits", splits_text(std::get<SplitTree>(decomposition.origin)));
  }
  text += summary_line(
      "covers", fmt::format("surface: each of {} lies in the part that owns it, tested exactly",
                            counted(decomposition.tested_triangles, "triangle", "triangles")));
  if (decomposition.measures) text += measures_lines(*decomposition.measures);
  return text + stored_line(decomposition, request.precision);
}

}  // namespace convexact
