// SPDX-License-Identifier: MIT
// engines.hpp - the same clustering in several ways: from the start that start_clusters() gives,
// the merges and the clusters that are left.
#pragma once
#include "decompose/start.hpp"

namespace convexact {

/// Cuts off and returns the merges from this one on.
[[nodiscard]] inline std::vector<Merge> tail_after(std::size_t count, std::vector<Merge>& merges) {
  std::vector<Merge> tail(std::make_move_iterator(merges.begin() + std::ptrdiff_t(count)),
                          std::make_move_iterator(merges.end()));
  merges.resize(count);
  return tail;
}

/// By the definitions, in exact numbers.
[[nodiscard]] Clustering cluster_exact(const Surface& surface, const ClusterOptions& options,
                                       const ClusterStart& start);

/// The same merges; exact numbers only where doubles cannot decide. Or, if the options say
/// Engine::Float, by doubles alone; then ties are not counted.
[[nodiscard]] Clustering cluster_filtered(const Surface& surface, const ClusterOptions& options,
                                          const ClusterStart& start);

}  // namespace convexact
