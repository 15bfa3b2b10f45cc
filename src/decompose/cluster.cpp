// SPDX-License-Identifier: MIT
#include "convexact/cluster.hpp"

#include "decompose/engines.hpp"

namespace convexact {

Clustering cluster(const Surface& surface, const ClusterOptions& options) {
  ClusterStart start = start_clusters(surface, options);
  Clustering made = options.engine == Engine::Exact ? cluster_exact(surface, options, start)
                                                    : cluster_filtered(surface, options, start);
  made.united = std::move(start.united);
  made.squared_limit = std::move(start.squared_limit);
  made.squared_diameter = std::move(start.squared_diameter);
  return made;
}

}  // namespace convexact
