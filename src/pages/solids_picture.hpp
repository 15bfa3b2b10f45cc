// SPDX-License-Identifier: MIT
// solids_picture.hpp - pictures of shapes and of the solids that enclose them.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "convexact/scene.hpp"
#include "convexact/simplify.hpp"
#include "pages/picture.hpp"

namespace convexact {

/// One object and the solid that encloses it.
struct DrawnSolid {
  const SceneObject& source;
  const Stored& solid;
  std::vector<std::size_t> kept = {};  ///< Planes of the solid that were to be kept.
  /// The volumes of the input's hull and of the solid, where a run removed halfspaces.
  std::optional<std::array<Enclosure, 2>> volumes = {};
  bool is_simplified = false;  ///< Whether it removed any.
};

[[nodiscard]] DrawnSolid drawn(const SceneObject& source, const HullResult& result);
[[nodiscard]] DrawnSolid drawn(const SceneObject& source, const SimplifyResult& result);

/// The inputs, the points of them that no face uses, the faces that were kept, and the solids,
/// whose facets can be picked. @param objects  At least one.
[[nodiscard]] Picture solids_picture(const std::vector<DrawnSolid>& objects);

/// An object and a solid inside its hull.
struct DrawnInner {
  const SceneObject& source;  ///< Points, maybe with faces.
  const InnerResult& result;
};

/// The solids, whose facets can be picked, the inputs, and their hulls. @param objects  At least
/// one.
[[nodiscard]] Picture inner_picture(const std::vector<DrawnInner>& objects);

}  // namespace convexact
