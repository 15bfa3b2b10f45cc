// SPDX-License-Identifier: MIT
#include "wire/tree_report.hpp"

#include <fmt/format.h>

#include "convexact/error.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "scene/objects.hpp"
#include "simplify/run_names.hpp"
#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"
#include "wire/surface_report.hpp"

namespace convexact {
namespace {

std::string parts_name(const TreeOrigin& origin) {
  const auto* method = std::get_if<DecomposeMethod>(&origin.parts);
  return method != nullptr ? name_in(kDecomposeMethodNames, *method)
                           : std::get<std::string>(origin.parts);
}

Json level_json(const TreeLevel& level, std::size_t number) {
  return {{"level", number},
          {"nodes", level.nodes},
          {"leaves", level.leaves},
          {"volume", convexact::interval_json(level.volume)},
          {"area", convexact::interval_json(level.area)}};
}

void add_hull(Json& json, const Mesh& mesh, const TreeOrigin& origin) {
  json["vertices"] = vertices_json(mesh.points, !origin.is_binary);
  json["faces"] = mesh.polygons;
}

Json part_json(const BuiltTree& built, std::size_t part, const TreeOrigin& origin) {
  Json json = {{"name", built.tree.parts[part].name}};
  add_hull(json, built.tree.parts[part].mesh, origin);
  return json;
}

Json node_json(const BuiltTree& built, std::size_t number, const TreeOrigin& origin) {
  const HullTreeNode& node = built.tree.nodes[number];
  Json json = {{"node", number},
               {"parent", or_null(node.parent)},
               {"children", node.children},
               {"part", or_null(node.part)},
               {"facets", built.facets[number]}};
  if (!node.part) add_hull(json, node.mesh, origin);
  return json;
}

bool are_same_points(const PointSet& a, const PointSet& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[PointId(i)] != b[PointId(i)]) return false;
  }
  return true;
}

void require_same_tree(const HullTree& read, const HullTree& written, const std::string& path) {
  if (const auto fault = find_tree_fault(read))
    reject_bytes(path, "has a fault: " + fault->sentence);
  bool is_same = read.nodes.size() == written.nodes.size();
  for (std::size_t i = 0; is_same && i < read.nodes.size(); ++i) {
    is_same = read.nodes[i].part == written.nodes[i].part &&
              are_same_points(read.mesh_of(i).points, written.mesh_of(i).points);
  }
  if (!is_same) reject_bytes(path, "has other hulls");
}

}  // namespace

// ---- The tree

Json tree_json(const BuiltTree& built, const TreeRequest& request, const TreeOrigin& origin) {
  Json levels = Json::array();
  for (const TreeLevel& level : built.levels) levels.push_back(level_json(level, levels.size()));
  const std::size_t parts = built.tree.parts.size();
  return {
      {"bvh", 1},
      {"input", origin.input},
      {"parts_from", parts_name(origin)},
      {"faces", or_null(request.faces)},
      {"leaf_faces", or_null(request.leaf_faces)},
      {"precision", name_in(kPrecisionNames, request.precision)},
      {"uncovered_pieces", or_null(origin.uncovered)},
      {"nodes", built.tree.nodes.size()},
      {"leaves", parts},
      {"joins", {{"by_method", built.given_joins}, {"by_volume", parts - 1 - built.given_joins}}},
      {"levels", std::move(levels)}};
}

std::string proven_tree_file(const BuiltTree& built, const TreeRequest& request,
                             const TreeOrigin& origin, const std::string& path) {
  Json json = tree_json(built, request, origin);
  Json& parts = json["parts"] = Json::array();
  for (std::size_t k = 0; k < built.tree.parts.size(); ++k) {
    parts.push_back(part_json(built, k, origin));
  }
  Json& nodes = json["hull_tree"] = Json::array();
  for (std::size_t i = 0; i < built.tree.nodes.size(); ++i) {
    nodes.push_back(node_json(built, i, origin));
  }
  std::string bytes = write_lines(json);
  const CandidateParts read = read_parts_bytes(bytes, path);
  if (const auto* error = std::get_if<Error>(&read)) reject_bytes(path, error->what());
  const auto* tree = std::get_if<HullTree>(&read);
  if (tree == nullptr) reject_bytes(path, "has no tree");
  require_same_tree(*tree, built.tree, path);
  return bytes;
}

std::string tree_summary(const BuiltTree& built, const TreeOrigin& origin) {
  const std::size_t nodes = built.tree.nodes.size(), parts = built.tree.parts.size();
  std::string text =
      summary_line("tree", fmt::format("{} on {}: {} and {}", counted(nodes, "node", "nodes"),
                                       counted(built.levels.size(), "level", "levels"),
                                       counted(parts, "part", "parts"),
                                       counted(nodes - parts, "branch", "branches")));
  if (nodes > parts) {
    const std::size_t by_volume = nodes - parts - built.given_joins;
    std::vector<std::string> how;
    if (built.given_joins > 0) {
      how.push_back(fmt::format("{} as {}", built.given_joins,
                                origin.parts == TreeOrigin::Parts(DecomposeMethod::Acd)
                                    ? "acd split them"
                                : origin.parts == TreeOrigin::Parts(DecomposeMethod::Cut)
                                    ? "cut parted them"
                                    : "hacd would merge them next"));
    }
    if (by_volume > 0)
      how.push_back(fmt::format("{} by the least volume of the common hull", by_volume));
    text += summary_line("joined", fmt::format("{}", fmt::join(how, ", ")));
  }
  return text +
         summary_line("nested", "every hull holds its children, tested on the stored numbers");
}

std::string tree_text(const BuiltTree& built, const TreeOrigin& origin) {
  std::string text = tree_summary(built, origin);
  if (origin.uncovered) {
    text += summary_line("covers",
                         *origin.uncovered == 0
                             ? "the surface: every triangle lies in the parts' union"
                             : fmt::format("not all: {} in no part",
                                           counted(*origin.uncovered, "piece of a triangle is",
                                                   "pieces of triangles are")));
  }
  text += fmt::format("  {:<12}{:>6} {:>7} {:>24} {:>24}\n", "level", "nodes", "leaves", "volume",
                      "area");
  for (std::size_t k = 0; k < built.levels.size(); ++k) {
    const TreeLevel& level = built.levels[k];
    text += fmt::format("  {:<12}{:>6} {:>7} {:>24} {:>24}\n", k, level.nodes, level.leaves,
                        interval_text(level.volume), interval_text(level.area));
  }
  return text;
}

TreeOfParts tree_of_parts(const DecomposedObject& object, const DecomposeRequest& request,
                          std::optional<std::size_t> faces, const std::string& path) {
  const TreeRequest tree{.faces = faces,
                         .leaf_faces = {},
                         .precision = request.precision,
                         .seed = request.seed,
                         .watch = {.stop = request.watch.stop}};
  const TreeOrigin origin{object.name, request.method, object.result.surface.points.is_binary(), 0};
  BuiltTree built = build_tree(object.result, object.part_names, tree);
  std::string file = proven_tree_file(built, tree, origin, path);
  std::string summary = tree_summary(built, origin);
  return {std::move(built), std::move(file), std::move(summary)};
}

// ---- Answers

namespace {

template <class Answer>
std::size_t visited_in(std::span<const Answer> answers) {
  std::size_t visited = 0;
  for (const Answer& answer : answers) visited += answer.visited.size();
  return visited;
}

Json asked_tree_json(const NamedTree& named) {
  return {
      {"name", named.name}, {"nodes", named.tree.nodes().size()}, {"parts", named.parts.size()}};
}

std::string parts_list(const NamedTree& named, const std::vector<std::size_t>& parts) {
  std::string text;
  for (const std::size_t part : parts) text += (text.empty() ? "" : ", ") + named.parts[part];
  return text;
}

std::string tree_line(const NamedTree& named) {
  return fmt::format("A  {}: {}, {}\n", named.name,
                     counted(named.tree.nodes().size(), "node", "nodes"),
                     counted(named.parts.size(), "part", "parts"));
}

}  // namespace

Json rays_json(const NamedTree& named, std::span<const TreeRayAnswer> answers) {
  Json rays = Json::array();
  std::size_t hits = 0;
  for (const TreeRayAnswer& answer : answers) {
    hits += answer.first ? 1 : 0;
    Json& ray = rays.emplace_back(Json{{"hit", answer.first.has_value()}});
    if (answer.first) ray["t"] = quantity_json(*answer.first);
    ray["parts"] = answer.parts;
    Json& visited = ray["visited"] = Json::array();
    for (const auto& visit : answer.visited) visited.push_back(visit.first);
  }
  return {{"query", "rays"},
          {"tree", asked_tree_json(named)},
          {"rays", std::move(rays)},
          {"hits", hits},
          {"visited", visited_in(answers)}};
}

std::string rays_text(const NamedTree& named, std::span<const TreeRayAnswer> answers) {
  std::string text = tree_line(named);
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const TreeRayAnswer& answer = answers[k];
    const std::string visits = counted(answer.visited.size(), "node", "nodes") + " visited";
    text += answer.first ? fmt::format("{:>5}  hit    t = {}, {}; {}\n", k,
                                       to_decimal(*answer.first, kDigits),
                                       parts_list(named, answer.parts), visits)
                         : fmt::format("{:>5}  miss   {}\n", k, visits);
  }
  const double all = double(named.tree.nodes().size()) * double(answers.size());
  return text + fmt::format("visited  {:.3g}% of all nodes, {:.3g} of {} for a ray\n",
                            100 * double(visited_in(answers)) / all,
                            double(visited_in(answers)) / double(answers.size()),
                            named.tree.nodes().size());
}

Json overlap_json(const NamedTree& named, const NamedPolytope& b, const TreeOverlap& answer) {
  Json json = {{"query", "overlap"},
               {"tree", asked_tree_json(named)},
               {"overlap", !answer.parts.empty()},
               {"parts", answer.parts}};
  Json& visited = json["visited"] = Json::array();
  for (const auto& [node, overlap] : answer.visited) {
    Json entry = overlap_json({"", named.tree.nodes()[node].hull}, b, overlap);
    if (!json.contains("b")) json["b"] = entry["b"];
    for (const char* key : {"query", "a", "b"}) entry.erase(key);
    visited.push_back({{"node", node}, {"part", or_null(named.tree.nodes()[node].part)}});
    visited.back().update(entry);
  }
  return json;
}

std::string overlap_text(const NamedTree& named, const NamedPolytope& b,
                         const TreeOverlap& answer) {
  std::string text =
      tree_line(named) +
      fmt::format("B  {}: {}\n", b.name, counted(b.solid.planes.size(), "halfspace", "halfspaces"));
  text += answer.parts.empty() ? "apart: no part has a common point with B\n"
                               : fmt::format("overlap: {} with B: {}\n",
                                             counted(answer.parts.size(), "part has a common point",
                                                     "parts have common points"),
                                             parts_list(named, answer.parts));
  return text + fmt::format(
                    "visited  {} of {} nodes; --json has each with a common point or a "
                    "separating plane\n",
                    answer.visited.size(), named.tree.nodes().size());
}

}  // namespace convexact
