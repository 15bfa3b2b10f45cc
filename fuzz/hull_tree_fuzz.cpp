// SPDX-License-Identifier: MIT
// Property of trees of hulls: every hull that is built holds its children; a tree with some numbers
// changed has a fault iff it is not a valid tree by the definition; and queries to a tree without
// fault give the same answers as queries to every part.
#include <algorithm>
#include <set>

#include "convexact/error.hpp"
#include "convexact/hull_tree.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"

using namespace convexact;

namespace {

bool lies_in_hull(const PointSet& points, const PointSet& of) {
  const std::vector<Halfspace> hull = convex_part(of).halfspaces;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RationalPoint x = points[PointId(i)];
    if (std::any_of(hull.begin(), hull.end(), [&](const Halfspace& h) { return h(x) > 0; })) {
      return false;
    }
  }
  return true;
}

bool has_valid_names(const HullTree& tree) {
  const std::size_t nodes = tree.nodes.size();
  return std::all_of(tree.nodes.begin(), tree.nodes.end(), [&](const HullTreeNode& node) {
    return (!node.parent || *node.parent < nodes) &&
           (!node.part || *node.part < tree.parts.size()) &&
           std::all_of(node.children.begin(), node.children.end(),
                       [&](std::size_t child) { return child < nodes; });
  });
}

// By the definition: the edges that children name are those that parents name, one root, every node
// reached, leaves and parts one to one, and nested.
bool is_nested_tree(const HullTree& tree) {
  const std::size_t count = tree.nodes.size();
  if (count == 0 || !has_valid_names(tree)) return false;
  std::multiset<std::pair<std::size_t, std::size_t>> down, up;
  std::multiset<std::size_t> parts;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < count; ++i) {
    const HullTreeNode& node = tree.nodes[i];
    for (const std::size_t child : node.children) down.emplace(i, child);
    if (node.parent) up.emplace(*node.parent, i);
    if (!node.parent) open.push_back(i);
    if (node.part.has_value() != node.children.empty()) return false;
    if (node.part) parts.insert(*node.part);
  }
  if (open.size() != 1 || down != up || parts.size() != tree.parts.size()) return false;
  for (std::size_t k = 0; k < tree.parts.size(); ++k) {
    if (parts.count(k) != 1) return false;
  }
  std::size_t reached = 0;
  for (; !open.empty(); ++reached) {
    const HullTreeNode& node = tree.nodes[open.back()];
    open.pop_back();
    open.insert(open.end(), node.children.begin(), node.children.end());
  }
  return reached == count && std::all_of(down.begin(), down.end(), [&](const auto& edge) {
           return lies_in_hull(tree.mesh_of(edge.second).points, tree.mesh_of(edge.first).points);
         });
}

HullTree build(FuzzInput& in) {
  std::vector<NamedPart> parts;
  const std::size_t count = 1 + in.below(6);
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<Point> points = in.grid_points(7, 4);
    if (points.empty()) points.emplace_back(double(k), 0, 0);
    parts.push_back({"part", {PointSet(std::move(points)), {}, {}}});
  }
  TreeRequest request;
  if (in.below(3) == 0) request.faces = 4 + in.below(5);
  if (in.below(3) == 0) request.leaf_faces = 4 + in.below(5);
  if (in.below(3) == 0) request.precision = Precision::Binary32;
  std::vector<Join> joins;
  if (count > 2 && in.below(2) == 0) joins.emplace_back(in.below(count), in.below(count));
  try {
    const BuiltTree built = build_tree(parts, joins, request);
    FUZZ_CHECK(joins.empty() || joins[0].first != joins[0].second);
    FUZZ_CHECK(is_nested_tree(built.tree));
    FUZZ_CHECK(built.tree.nodes.size() == 2 * count - 1);
    for (std::size_t k = 0; k < count; ++k) {
      FUZZ_CHECK(lies_in_hull(parts[k].mesh.points, built.tree.parts[k].mesh.points));
    }
    return built.tree;
  } catch (const Error& error) {
    FUZZ_CHECK(error.code() == ErrorCode::InvalidArgument && joins[0].first == joins[0].second);
    return {};
  }
}

void change(FuzzInput& in, HullTree& tree) {
  const std::size_t nodes = tree.nodes.size();
  HullTreeNode& node = tree.nodes[in.below(nodes)];
  const std::size_t other = in.below(nodes + 1);
  switch (in.below(6)) {
    case 0:
      node.parent = other;
      break;
    case 1:
      node.parent.reset();
      break;
    case 2:
      node.children.push_back(other);
      break;
    case 3:
      if (!node.children.empty()) node.children[in.below(node.children.size())] = other;
      break;
    case 4:
      node.part = in.below(tree.parts.size() + 1);
      break;
    default:
      if (node.mesh.points.size() > 0) {
        std::vector<Point> points(node.mesh.points.doubles().begin(),
                                  node.mesh.points.doubles().end());
        double& x = points[in.below(points.size())][Eigen::Index(in.below(3))];
        x = in.below(2) == 0 ? std::nextafter(x, 9.0) : std::nextafter(x, -9.0);
        node.mesh.points = PointSet(std::move(points));
      }
  }
}

void ask(FuzzInput& in, const HullTree& read) {
  const SearchTree tree(read);
  std::vector<Polytope> parts;
  for (const NamedPart& part : read.parts) parts.push_back(*convex_part(part.mesh.points).solid);
  Point direction(double(in.below(7)) - 3, double(in.below(7)) - 3, double(in.below(7)) - 3);
  if (direction.isZero()) direction.x() = 1;
  const Ray ray{to_rational(Point(double(in.below(17)) - 8, double(in.below(9)) - 4,
                                  double(in.below(9)) - 4)),
                to_rational(direction)};
  const TreeRayAnswer answer = cast_ray(tree, ray);
  FUZZ_CHECK(check(tree, ray, answer));
  std::optional<Rational> first;
  std::vector<std::size_t> hit;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const RayAnswer met = cast_ray(parts[k], ray);
    if (!met.is_hit() || (first && met.first() > *first)) continue;
    if (!first || met.first() < *first) hit.clear();
    first = met.first();
    hit.push_back(k);
  }
  FUZZ_CHECK(answer.first == first && answer.parts == hit);
  const Polytope& solid = parts[in.below(parts.size())];
  const TreeOverlap overlap = find_overlap(tree, solid);
  FUZZ_CHECK(check(tree, solid, overlap));
  std::vector<std::size_t> met;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (std::holds_alternative<CommonPoint>(find_overlap(parts[k], solid))) met.push_back(k);
  }
  FUZZ_CHECK(overlap.parts == met);
}

void hold_hull_tree(FuzzInput& in) {
  HullTree tree = build(in);
  if (tree.nodes.empty()) return;
  for (std::size_t changes = in.below(4); changes > 0; --changes) change(in, tree);
  const bool is_good = is_nested_tree(tree);
  FUZZ_CHECK(find_tree_fault(tree).has_value() == !is_good);
  if (is_good) ask(in, tree);
}

const FuzzTarget kHullTree("hull_tree", hold_hull_tree);

}  // namespace
