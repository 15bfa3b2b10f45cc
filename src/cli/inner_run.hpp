// SPDX-License-Identifier: MIT
// inner_run.hpp - the options of simplify, and its run with --inner.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/outputs.hpp"
#include "convexact/simplify.hpp"

namespace convexact::cli {

/// The options of simplify that only an inner run has.
struct InnerOnly {
  bool inner = false;
  std::optional<std::size_t> vertices;
  std::string max_loss;
};

struct SimplifyArguments {
  GlobalOptions global;
  std::vector<std::string> inputs;
  SceneOptions scene;
  OutputOptions output;
  SimplifyRequest request;  ///< Without what the fields below say.
  std::optional<std::size_t> total_faces;
  std::vector<std::string> keep;
  std::string max_growth, center = "chebyshev";
  std::optional<std::size_t> moves, nodes;  ///< Of the search.
  InnerOnly only;
  ImplicitOptions implicit;
};

void add_inner_options(Command& command, InnerOnly& options);

/// @throws Error InvalidArgument for one of these options without --inner.
void require_inner(const InnerOnly& options);

/// simplify --inner. @return The exit code.
/// @throws Error InvalidArgument for an option that has no meaning here.
int run_inner(const SimplifyArguments& options);

}  // namespace convexact::cli
