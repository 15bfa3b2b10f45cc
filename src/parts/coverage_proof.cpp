// SPDX-License-Identifier: MIT
#include "parts/coverage_proof.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/stored.hpp"

namespace convexact {
namespace {

void require_held(const Part& part, const PointSet& points, const Watch& watch) {
  const std::size_t outside = find_outside(part.halfspaces, points, watch).size();
  if (outside > 0) {
    throw Error(ErrorCode::Internal, fmt::format("{} points of a part lie outside of it", outside));
  }
}

// Each loose point lies in its part.
void prove_loose_points(const Decomposition& made, const Watch& watch) {
  std::size_t loose = 0;
  for (const Part& part : made.parts) {
    loose += part.loose.size();
    require_held(part, subset(made.surface.unused, part.loose), watch);
  }
  if (loose != made.surface.unused.size()) {
    throw Error(ErrorCode::Internal, "a loose point has no part");
  }
}

}  // namespace

void prove_owners(Decomposition& made, const Watch& watch) {
  made.owner.assign(made.surface.triangles.size(), kNoOwner);
  for (std::uint32_t k = 0; k < made.parts.size(); ++k) {
    const Part& part = made.parts[k];
    const auto corners = points_of(made.surface, part.owns);
    require_held(part, subset(made.surface.points, corners), watch);
    for (const TriangleId t : part.owns) {
      if (made.owner[t.index()] != kNoOwner) {
        throw Error(ErrorCode::Internal, "a triangle has two owners");
      }
      made.owner[t.index()] = k;
      ++made.tested_triangles;
    }
  }
  if (made.tested_triangles != made.surface.triangles.size()) {
    throw Error(ErrorCode::Internal, "a triangle has no owner");
  }
  prove_loose_points(made, watch);
}

void prove_leaves(Decomposition& made, const Watch& watch) {
  const Partition& partition = std::get<Partition>(made.origin);
  made.owner.assign(made.surface.triangles.size(), kNoOwner);
  std::vector<bool> is_shared(made.owner.size(), false);
  std::vector<bool> is_held(partition.leaves.size(), false);
  for (std::uint32_t k = 0; k < made.parts.size(); ++k) {
    const Part& part = made.parts[k];
    for (const std::uint32_t leaf : part.leaves) {
      if (is_held[leaf]) throw Error(ErrorCode::Internal, "a leaf has two parts");
      is_held[leaf] = true;
      require_held(part, partition.leaves[leaf].corners, watch);
      for (const TriangleId t : partition.leaves[leaf].triangles) {
        std::uint32_t& owner = made.owner[t.index()];
        is_shared[t.index()] = is_shared[t.index()] || (owner != kNoOwner && owner != k);
        owner = k;
      }
    }
  }
  if (std::find(is_held.begin(), is_held.end(), false) != is_held.end()) {
    throw Error(ErrorCode::Internal, "a leaf has no part");
  }
  for (std::size_t t = 0; t < is_shared.size(); ++t) {
    if (is_shared[t]) made.owner[t] = kNoOwner;
    if (made.owner[t] != kNoOwner) made.parts[made.owner[t]].owns.emplace_back(t);
  }
  made.tested_triangles = made.owner.size();
  prove_loose_points(made, watch);
}

}  // namespace convexact
