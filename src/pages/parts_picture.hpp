// SPDX-License-Identifier: MIT
// parts_picture.hpp - pictures of a decomposition.
#pragma once
#include <string>

#include "convexact/decompose.hpp"
#include "convexact/hull_tree.hpp"
#include "convexact/verify_parts.hpp"
#include "pages/picture.hpp"

namespace convexact {

/// The parts in colours, in red the pieces of the input's surface that none of them covers, and the
/// input itself, which is hidden at first.
[[nodiscard]] Picture parts_picture(const Mesh& input, const PartsVerdict& verdict,
                                    const std::string& title);

/// The parts, which can be drawn apart; the input coloured by the clusters after any number of
/// merges; and the input coloured by the length, in doubles, of a ray from the middle of each
/// triangle inside the hull of its cluster. Both colourings are hidden at first.
[[nodiscard]] Picture decomposition_picture(const Decomposition& decomposition,
                                            const std::string& title);

/// A layer for each level of a tree, from the root down: the hulls of its nodes. All are hidden at
/// first.
[[nodiscard]] std::vector<PictureLayer> tree_layers(const BuiltTree& built);

/// The parts, which can be drawn apart, in the hulls of the level below the root; the other levels
/// are hidden at first.
[[nodiscard]] Picture tree_picture(const BuiltTree& built, const std::string& title);

}  // namespace convexact
