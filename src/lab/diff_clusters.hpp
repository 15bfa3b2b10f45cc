// SPDX-License-Identifier: MIT
// diff_clusters.hpp - diff INPUT --clusters: engines of a decomposition against each other.
#pragma once
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "convexact/cluster.hpp"
#include "convexact/scene.hpp"
#include "wire/field.hpp"

namespace convexact::cli {

struct ClusterDiffOptions {
  bool is_asked = false;  ///< --clusters
  GivenFields given;      ///< Of decompose_fields().

  /// An option that has no meaning for removals; empty if none is given.
  std::string foreign_to_removals() const;
};

/// Adds --clusters, --concavity, --max-parts, --measure and --connect.
void add_cluster_diff_options(Command& command, ClusterDiffOptions& options);

/// Compares the engines on the faces of each object, prints what was found, and returns the exit
/// code.
int run_cluster_diff(const GlobalOptions& global, const std::vector<std::string>& inputs,
                     const SceneOptions& scene, const std::vector<Engine>& engines,
                     const ClusterDiffOptions& options);

}  // namespace convexact::cli
