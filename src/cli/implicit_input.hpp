// SPDX-License-Identifier: MIT
// implicit_input.hpp - simplify --implicit: its options, the corners of cells as an object, and
// their report.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/parser.hpp"
#include "convexact/implicit.hpp"
#include "convexact/scene.hpp"
#include "io/json_document.hpp"

namespace convexact::cli {

/// The data on a shape and its cells.
struct ImplicitFound {
  ImplicitBounds bounds;
  ImplicitCells cells;
  std::optional<ImplicitMeasures> measures;
};

/// The options of simplify that stand in for INPUT.
struct ImplicitOptions {
  std::string file;  ///< Empty if not given.
  std::optional<ImplicitBox> box;
  std::optional<std::size_t> depth;
  /// Filled by read_implicit_object().
  std::shared_ptr<ImplicitFound> found = std::make_shared<ImplicitFound>();

  bool is_given() const { return !file.empty(); }
  /// @param inputs  Meshes that were named.
  /// @throws Error InvalidArgument unless there is either an input or all of these options.
  void require_complete(const std::vector<std::string>& inputs) const;
};

/// Adds the options; INPUT of the command may be left out from now on.
void add_implicit_options(Command& command, ImplicitOptions& options);

/// Reads the shape and finds its cells; their corners are the points of the object.
/// @throws Error as read_bytes(), and as read_implicit_bytes() and kept_cells() with the file.
[[nodiscard]] SceneObject read_implicit_object(const ImplicitOptions& options,
                                               const SceneOptions& scene, const Watch& watch);

/// Level by level, and the bounds that are known.
[[nodiscard]] Json implicit_json(const ImplicitFound& found);
[[nodiscard]] std::string implicit_summary(const ImplicitFound& found);

}  // namespace convexact::cli
