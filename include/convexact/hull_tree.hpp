// SPDX-License-Identifier: MIT
// hull_tree.hpp - convex parts under a binary tree of hulls, each of which holds its children as
// they are stored; and questions that go down only where a hull is met.
//
// docs/hull-trees.md has the construction, its source [Backenhof2011], and what is ours.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "convexact/decompose.hpp"
#include "convexact/number.hpp"
#include "convexact/overlay.hpp"
#include "convexact/query.hpp"
#include "convexact/scene.hpp"

namespace convexact {

// ---- Building

/// Two groups of parts become one. Groups are numbered: first each part alone, by its number, then
/// one for each join.
using Join = std::pair<std::size_t, std::size_t>;

/// How the method that made the parts joins them: by undoing its splits, the last one first, or by
/// the merges that it would have made next (DecomposeRequest::for_tree). Parts that neither joins,
/// as those of several components, stay apart.
[[nodiscard]] std::vector<Join> joins_of(const Decomposition& decomposition);

struct TreeRequest {
  /// Halfspaces to keep of each branch, and of each part, >= 4: these are simplified and still hold
  /// what is below them. A hull keeps more if every removal is unbounded, as from a box.
  std::optional<std::size_t> faces = {}, leaf_faces = {};
  Precision precision = Precision::Binary64;
  std::uint64_t seed = 1;  ///< Of every random order. The answer does not depend on it.
  StageWatch watch = {};
};

/// The nodes at the same distance from the root.
struct TreeLevel {
  std::size_t nodes = 0, leaves = 0;
  Enclosure volume, area;  ///< Sums over the nodes' hulls.
};

struct BuiltTree {
  HullTree tree;                    ///< The root first, then level by level.
  std::vector<std::size_t> facets;  ///< By node, before corners were rounded, as Part::faces.
  std::size_t given_joins = 0;      ///< The number of branches that the caller chose.
  std::vector<TreeLevel> levels;    ///< From the root down.
  std::vector<Stage> stages;
};

/// Builds bottom-up, on stored numbers: a branch is the hull of its two children's stored points,
/// simplified and rounded outward like a part. So numbers do not grow from level to level, and
/// every hull holds those below it as they are written, which is proven. Flat parts are thickened.
/// Groups that `joins` leaves apart are joined where the common hull has the least volume, among
/// the eight neighbours of each whose common boxes are smallest.
/// @param parts  At least one, each with a point.
/// @param joins  Each of two groups that exist, and that no other join has.
/// @throws Error InvalidArgument for impossible joins and numbers; Unrepresentable if the
///               format cannot hold a hull; Stopped; Internal if a proof fails.
/// @par Cost     For each branch a hull of its children's corners, simplify() of them, and the test
///               of each corner against its parent.
/// @par Source   [Backenhof2011] for the tree by splits
[[nodiscard]] BuiltTree build_tree(std::span<const NamedPart> parts, std::span<const Join> joins,
                                   const TreeRequest& request = {});

/// The tree over the parts of a decomposition as they are stored, joined by joins_of().
/// @param names  One for each part.
[[nodiscard]] BuiltTree build_tree(const Decomposition& decomposition,
                                   std::span<const std::string> names,
                                   const TreeRequest& request = {});

// ---- What can be wrong

/// Why a tree is not one of hulls that hold their children.
struct TreeFault {
  std::string sentence;
  std::vector<std::size_t> nodes;    ///< The nodes in question; for a corner outside: parent,
                                     ///< child.
  std::optional<std::size_t> part;   ///< The part in question.
  std::optional<std::size_t> point;  ///< The point of the child that lies outside of the parent.
  std::optional<Halfspace> plane;    ///< The plane of the parent that the point is beyond.
};

/// Nothing if there is one root; children and parents name each other; every node is reached from
/// the root; the leaves are those that name a part, and each part belongs to one leaf; and the hull
/// of each branch holds every point of its children, all numbers taken exactly. The first fault in
/// that order.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] std::optional<TreeFault> find_tree_fault(const HullTree& tree,
                                                       const Watch& watch = {});

// ---- Questions

/// A tree that was found without fault, ready for questions.
class SearchTree {
 public:
  struct Node {
    std::vector<std::size_t> children;
    std::optional<std::size_t> part;
    Polytope hull;
  };

  /// @throws Error Malformed with the fault, if the tree has one or is empty; NoInterior if a part
  ///               or branch is flat; Stopped when the watch ends the call.
  explicit SearchTree(const HullTree& tree, const Watch& watch = {});

  std::size_t root() const { return root_; }
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  std::size_t root_ = 0;
  std::vector<Node> nodes_;
};

/// Where a ray first meets the union of the parts, and the proof.
struct TreeRayAnswer {
  std::optional<Rational> first;   ///< The least t >= 0; nothing if the ray misses every part.
  std::vector<std::size_t> parts;  ///< All parts that the ray first meets at that t, ascending.
  /// The nodes whose hulls were met with the ray, in that order. Nodes below one that the ray
  /// misses, or meets only after `first`, were not looked at.
  std::vector<std::pair<std::size_t, RayAnswer>> visited;
};

/// @throws Error InvalidArgument if the direction is zero.
[[nodiscard]] TreeRayAnswer cast_ray(const SearchTree& tree, const Ray& ray);

/// Whether an answer is true, by the definition, given that hulls hold their children: all visits
/// are true, they reach every part that they do not exclude, and the parts are those that they
/// give.
[[nodiscard]] bool check(const SearchTree& tree, const Ray& ray, const TreeRayAnswer& claim);

/// Which parts have a common point with a solid, and the proof.
struct TreeOverlap {
  std::vector<std::size_t> parts;  ///< Ascending.
  /// The nodes whose hulls were compared with the solid, in that order.
  std::vector<std::pair<std::size_t, Overlap>> visited;
};

[[nodiscard]] TreeOverlap find_overlap(const SearchTree& tree, const Polytope& solid,
                                       std::uint64_t seed = 1);
[[nodiscard]] bool check(const SearchTree& tree, const Polytope& solid, const TreeOverlap& claim);

}  // namespace convexact
