// SPDX-License-Identifier: MIT
// Questions to a tree of hulls: rays nearest first, and solids, each with the visits that prove it.
#include <algorithm>
#include <functional>
#include <map>
#include <queue>

#include "convexact/error.hpp"
#include "convexact/hull_tree.hpp"
#include "number/text.hpp"

namespace convexact {

SearchTree::SearchTree(const HullTree& tree, const Watch& watch) {
  if (const auto fault = find_tree_fault(tree, watch)) {
    throw Error(ErrorCode::Malformed,
                "expected a tree whose hulls hold their children: " + fault->sentence);
  }
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const HullTreeNode& node = tree.nodes[i];
    ConvexPart hull = convex_part(tree.mesh_of(i).points, watch);
    if (!hull.solid) {
      throw Error(
          ErrorCode::NoInterior,
          "node " + std::to_string(i) +
              (node.part ? ", part " + in_quotes(tree.parts[*node.part].name) : "") +
              ", is flat: questions need hulls with a volume; convexact bvh thickens parts");
    }
    if (!node.parent) root_ = i;
    nodes_.push_back({node.children, node.part, std::move(*hull.solid)});
  }
}

namespace {

// The visits by node; nothing if one has two, or if one is of no node.
template <class Answer>
std::optional<std::map<std::size_t, const Answer*>> visits_of(
    const SearchTree& tree, const std::vector<std::pair<std::size_t, Answer>>& visited) {
  std::map<std::size_t, const Answer*> answers;
  for (const auto& [node, answer] : visited) {
    if (node >= tree.nodes().size() || !answers.emplace(node, &answer).second) return {};
  }
  return answers;
}

// Collects the parts below a node that visits find, where `is_found` decides for each visit;
// nothing if a visit is missing or false. Goes further down where a visit finds something.
template <class Answer>
bool collect_parts(
    const SearchTree& tree, std::size_t root, const std::map<std::size_t, const Answer*>& visits,
    const std::function<std::optional<bool>(const Polytope&, const Answer&)>& is_found,
    std::vector<std::size_t>& parts) {
  std::vector<std::size_t> open = {root};
  while (!open.empty()) {
    const SearchTree::Node& node = tree.nodes()[open.back()];
    const auto visit = visits.find(open.back());
    open.pop_back();
    if (visit == visits.end()) return false;
    const std::optional<bool> found = is_found(node.hull, *visit->second);
    if (!found) return false;
    if (!*found) continue;
    if (node.part) parts.push_back(*node.part);
    open.insert(open.end(), node.children.begin(), node.children.end());
  }
  std::sort(parts.begin(), parts.end());
  return true;
}

}  // namespace

// ---- Rays

TreeRayAnswer cast_ray(const SearchTree& tree, const Ray& ray) {
  TreeRayAnswer answer;
  // Hulls that the ray meets, the nearest on top; of equally near ones the lowest node.
  using Met = std::pair<Rational, std::size_t>;
  std::priority_queue<Met, std::vector<Met>, std::greater<>> open;
  const auto visit = [&](std::size_t node) {
    RayAnswer met = cast_ray(tree.nodes()[node].hull, ray);
    if (met.is_hit()) open.emplace(met.first(), node);
    answer.visited.emplace_back(node, std::move(met));
  };
  visit(tree.root());
  while (!open.empty() && (!answer.first || open.top().first <= *answer.first)) {
    const auto [first, index] = open.top();
    open.pop();
    const SearchTree::Node& node = tree.nodes()[index];
    if (node.part) {
      answer.first = first;
      answer.parts.push_back(*node.part);
    }
    for (const std::size_t child : node.children) visit(child);
  }
  std::sort(answer.parts.begin(), answer.parts.end());
  return answer;
}

bool check(const SearchTree& tree, const Ray& ray, const TreeRayAnswer& claim) {
  const auto visits = visits_of(tree, claim.visited);
  if (!visits) return false;
  // A hull that is met only behind the first hit holds no part that is met before that hit.
  const auto is_found = [&](const Polytope& hull, const RayAnswer& met) -> std::optional<bool> {
    if (!check(hull, ray, met)) return {};
    return met.is_hit() && !(claim.first && met.first() > *claim.first);
  };
  std::vector<std::size_t> parts;
  if (!collect_parts<RayAnswer>(tree, tree.root(), *visits, is_found, parts)) return false;
  if (parts != claim.parts || parts.empty() == claim.first.has_value()) return false;
  return std::all_of(claim.visited.begin(), claim.visited.end(), [&](const auto& visit) {
    const auto& part = tree.nodes()[visit.first].part;
    return !part || !std::binary_search(parts.begin(), parts.end(), *part) ||
           visit.second.first() == *claim.first;
  });
}

// ---- Solids

TreeOverlap find_overlap(const SearchTree& tree, const Polytope& solid, std::uint64_t seed) {
  TreeOverlap answer;
  std::vector<std::size_t> open = {tree.root()};
  while (!open.empty()) {
    const std::size_t index = open.back();
    const SearchTree::Node& node = tree.nodes()[index];
    open.pop_back();
    answer.visited.emplace_back(index, find_overlap(node.hull, solid, seed));
    if (std::holds_alternative<Separation>(answer.visited.back().second)) continue;
    if (node.part) answer.parts.push_back(*node.part);
    open.insert(open.end(), node.children.rbegin(), node.children.rend());
  }
  std::sort(answer.parts.begin(), answer.parts.end());
  return answer;
}

bool check(const SearchTree& tree, const Polytope& solid, const TreeOverlap& claim) {
  const auto visits = visits_of(tree, claim.visited);
  if (!visits) return false;
  const auto is_found = [&](const Polytope& hull, const Overlap& met) -> std::optional<bool> {
    if (!check(hull, solid, met)) return {};
    return std::holds_alternative<CommonPoint>(met);
  };
  std::vector<std::size_t> parts;
  return collect_parts<Overlap>(tree, tree.root(), *visits, is_found, parts) &&
         parts == claim.parts;
}

}  // namespace convexact
