// SPDX-License-Identifier: MIT
// inner_run.hpp - simplify --inner: the options that it takes, and its run.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/outputs.hpp"
#include "convexact/inner.hpp"

namespace convexact::cli {

/// The options of simplify that only an inner run has.
struct InnerOnly {
  bool inner = false;
  std::optional<std::size_t> vertices;
  std::string max_loss;
};

void add_inner_options(CLI::App& command, InnerOnly& options);

/// @throws Error InvalidArgument for one of these options without --inner.
void require_inner(const InnerOnly& options);

/// The options of simplify that an inner run uses.
struct InnerArguments {
  const GlobalOptions& global;
  const std::vector<std::string>& inputs;
  const SceneOptions& scene;
  const OutputOptions& output;
  const InnerOnly& only;
  std::size_t triangles;  ///< --faces; 0 if not given.
  Engine engine;
  VerifyLevel verify;
  bool exact_values;
};

/// @param foreign  Names of options that were given and have no meaning here.
/// @return         The exit code.
int run_inner(const InnerArguments& options, const std::vector<std::string>& foreign);

}  // namespace convexact::cli
