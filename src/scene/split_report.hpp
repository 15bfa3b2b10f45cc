// SPDX-License-Identifier: MIT
// split_report.hpp - the report on the tree of a decomposition by splits, in addition to that of
// every decomposition.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "convexact/decompose.hpp"

namespace convexact {

[[nodiscard]] std::size_t count_leaves(const SplitTree& tree, LeafStatus status);

/// Counts of splits, of planes that were refused, and of islands.
[[nodiscard]] nlohmann::ordered_json splits_json(const SplitTree& tree);
[[nodiscard]] std::string splits_text(const SplitTree& tree);

/// Every node, first the roots, then the children of each split; for a leaf its triangles and its
/// part, for a split its notch and its plane.
[[nodiscard]] nlohmann::ordered_json split_tree_json(const Decomposition& decomposition);

/// Every node with the bridges over it, and every split with the triangles that go
/// (docs/schema/decompose-acd-trace.schema.json).
[[nodiscard]] std::string write_split_trace(const Decomposition& decomposition,
                                            const DecomposeRequest& request);

}  // namespace convexact
