// SPDX-License-Identifier: MIT
// tree_report.hpp - a tree of hulls as its file (docs/schema/hull-tree.schema.json), and for
// people; the answers of a tree to questions.
#pragma once
#include <span>
#include <string>
#include <variant>

#include "convexact/decompose.hpp"
#include "convexact/hull_tree.hpp"
#include "io/json_document.hpp"
#include "wire/decompose_report.hpp"
#include "wire/query_report.hpp"

namespace convexact {

/// Where the parts of a tree come from, and how much of the input they leave uncovered.
struct TreeOrigin {
  using Parts = std::variant<DecomposeMethod, std::string>;  ///< A method, or the name of a file.
  std::string input;
  Parts parts;
  bool is_binary = true;
  /// Pieces of triangles that no part holds, as stored; 0 is proven. Unset if not asked for.
  std::optional<std::size_t> uncovered;
};

/// Counts and levels, without the hulls.
[[nodiscard]] Json tree_json(const BuiltTree& built, const TreeRequest& request,
                             const TreeOrigin& origin);

/// The file: these counts, the parts, and the nodes under "hull_tree", one node per line. Read back
/// from its bytes, the tree has no fault and the same hulls.
/// @param path   For messages.
/// @throws Error Internal if the bytes lose something.
[[nodiscard]] std::string proven_tree_file(const BuiltTree& built, const TreeRequest& request,
                                           const TreeOrigin& origin, const std::string& path);

/// Three lines: its size, how parts were joined, and what is proven.
[[nodiscard]] std::string tree_summary(const BuiltTree& built, const TreeOrigin& origin);
/// These, what is covered, and a table of the levels.
[[nodiscard]] std::string tree_text(const BuiltTree& built, const TreeOrigin& origin);

/// A tree over the parts of a decomposition, its file and its summary.
struct TreeOfParts {
  BuiltTree built;
  std::string file, summary;
};

/// @param request  Of the decomposition: its precision, seed and stop are the tree's.
/// @param faces    Halfspaces to keep of each branch.
/// @param path     For messages.
/// @throws Error as build_tree() and proven_tree_file().
[[nodiscard]] TreeOfParts tree_of_parts(const DecomposedObject& object,
                                        const DecomposeRequest& request,
                                        std::optional<std::size_t> faces, const std::string& path);

/// A tree that is asked, under the name of its file, with the names of its parts.
struct NamedTree {
  std::string name;
  const SearchTree& tree;
  std::vector<std::string> parts;
};

/// "rays", in the order of the file, "hits", and the number of nodes visited.
[[nodiscard]] Json rays_json(const NamedTree& named, std::span<const TreeRayAnswer> answers);
[[nodiscard]] std::string rays_text(const NamedTree& named, std::span<const TreeRayAnswer> answers);

/// The parts that overlap, each with a common point; and the nodes that do not, with the proofs.
[[nodiscard]] Json overlap_json(const NamedTree& named, const NamedPolytope& b,
                                const TreeOverlap& answer);
[[nodiscard]] std::string overlap_text(const NamedTree& named, const NamedPolytope& b,
                                       const TreeOverlap& answer);

}  // namespace convexact
