// SPDX-License-Identifier: MIT
// verify_union.hpp - verify INPUT PARTS: judges the union of a decomposition's parts.
#pragma once
#include <optional>
#include <string>

#include "cli/command.hpp"
#include "cli/measures_options.hpp"
#include "convexact/scene.hpp"
#include "convexact/verify_parts.hpp"
#include "wire/judge_fields.hpp"

namespace convexact::cli {

struct UnionOptions {
  bool is_asked = false;  ///< --union
  GivenFields given;      ///< Of parts_fields(), without exact_volumes, which is in `measures`.
  std::optional<std::size_t> max_part_vertices;
  MeasuresOptions measures;
  std::string picture;

  /// An option that has no meaning for a single solid; empty if none is given.
  std::string foreign_to_one_solid() const;
};

/// Adds --union, --max-parts, --max-part-vertices, --orient, --measures, --exact-volumes and
/// --picture.
void add_union_options(Command& command, UnionOptions& options);

/// Whether a candidate can only be a decomposition: a folder, JSON with "parts", or a model for
/// simulators.
[[nodiscard]] bool is_decomposition(const std::string& path);

/// Judges the parts, prints the verdict, writes the picture, and returns the exit code: 0 if every
/// claim holds, else 1 (4 for an empty input).
/// @param reading  How the input is read; the parts with its meaning of decimals.
/// @param request  The request without the entries of `options`.
int run_verify_union(const GlobalOptions& global, const std::string& input,
                     const std::string& candidate, const SceneOptions& reading,
                     PartsRequest request, const UnionOptions& options);

}  // namespace convexact::cli
