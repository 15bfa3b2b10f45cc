// SPDX-License-Identifier: MIT
// inner_run.hpp - the options of simplify, and its run with --inner.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/outputs.hpp"
#include "cli/stdio_loop.hpp"
#include "convexact/simplify.hpp"
#include "wire/field.hpp"

namespace convexact::cli {

struct SimplifyArguments {
  GlobalOptions global;
  std::vector<std::string> inputs;
  SceneOptions scene;
  OutputOptions output;
  bool inner = false;
  GivenFields given;  ///< Of simplify_fields(), and of inner_fields().
  std::optional<std::size_t> total_faces;
  std::vector<std::string> keep;
  bool exact_values = false;
  ImplicitOptions implicit;
  StdioOptions stdio;

  /// For a picture, the faces of a group, or faces that stick out of their parts.
  bool needs_polygons() const { return !output.picture.empty() || !keep.empty() || total_faces; }
};

void add_inner_options(Command& command, SimplifyArguments& options);

/// @throws Error InvalidArgument for an option of inner runs alone without --inner.
void require_inner(const SimplifyArguments& options);

/// simplify --inner. @return The exit code.
/// @throws Error InvalidArgument for an option that has no meaning here.
int run_inner(const SimplifyArguments& options);

}  // namespace convexact::cli
