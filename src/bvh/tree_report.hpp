// SPDX-License-Identifier: MIT
// tree_report.hpp - a tree of hulls as its file (docs/schema/hull-tree.schema.json), and for
// people; the answers of a tree to questions.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "convexact/hull_tree.hpp"
#include "query/query_report.hpp"

namespace convexact {

/// Where the parts of a tree come from, and how much of the input they leave uncovered.
struct TreeOrigin {
  std::string input;
  std::string parts;  ///< "hacd", "acd", or the name of a file.
  bool is_binary = true;
  /// Pieces of triangles that no part holds, as stored; 0 is proven. Unset if not asked for.
  std::optional<std::size_t> uncovered;
};

/// Counts and levels, without the hulls.
[[nodiscard]] nlohmann::ordered_json tree_json(const BuiltTree& built, const TreeRequest& request,
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

/// A tree that queries refer to, with the name of its file and the names of its parts.
struct NamedTree {
  std::string name;
  const SearchTree& tree;
  std::vector<std::string> parts;
};

/// "rays", in the order of the file, "hits", and the number of nodes visited.
[[nodiscard]] nlohmann::ordered_json rays_json(const NamedTree& named,
                                               std::span<const TreeRayAnswer> answers);
[[nodiscard]] std::string rays_text(const NamedTree& named, std::span<const TreeRayAnswer> answers);

/// The parts that overlap, each with a common point; and the nodes that do not, with the proofs.
[[nodiscard]] nlohmann::ordered_json overlap_json(const NamedTree& named, const NamedPolytope& b,
                                                  const TreeOverlap& answer);
[[nodiscard]] std::string overlap_text(const NamedTree& named, const NamedPolytope& b,
                                       const TreeOverlap& answer);

}  // namespace convexact
