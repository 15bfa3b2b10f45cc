// SPDX-License-Identifier: MIT
#include "parts/coverage_proof.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "stored/prepared_halfspaces.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

// The corners of the triangles that a part owns, of its leaves, and its loose points lie in it.
void require_all_held(const Decomposition& made, const Part& part, const Watch& watch) {
  const PreparedHalfspaces halfspaces(part.halfspaces);
  const auto require_held = [&](const PointSet& points) {
    const std::size_t outside = find_outside(halfspaces, points, watch).size();
    if (outside == 0) return;
    throw Error(ErrorCode::Internal, fmt::format("{} points of a part lie outside of it", outside));
  };
  require_held(subset(made.surface.points, points_of(made.surface, part.owns)));
  require_held(subset(made.surface.unused, part.loose));
  for (const std::uint32_t leaf : part.leaves) {
    require_held(std::get<Partition>(made.origin).leaves[leaf].corners);
  }
}

void require_all_held(const Decomposition& made, std::size_t jobs, const Watch& watch) {
  for_each_in_parallel(made.parts.size(), jobs, watch, [&](std::size_t k, const Watch& quiet) {
    require_all_held(made, made.parts[k], quiet);
  });
}

void require_each_loose_point_once(const Decomposition& made) {
  std::vector<bool> is_held(made.surface.unused.size(), false);
  for (const Part& part : made.parts) {
    for (const PointId p : part.loose) {
      if (is_held[p.index()]) throw Error(ErrorCode::Internal, "a loose point has two parts");
      is_held[p.index()] = true;
    }
  }
  if (std::find(is_held.begin(), is_held.end(), false) != is_held.end()) {
    throw Error(ErrorCode::Internal, "a loose point has no part");
  }
}

}  // namespace

void prove_owners(Decomposition& made, std::size_t jobs, const Watch& watch) {
  require_all_held(made, jobs, watch);
  made.owner.assign(made.surface.triangles.size(), kNoOwner);
  for (std::uint32_t k = 0; k < made.parts.size(); ++k) {
    for (const TriangleId t : made.parts[k].owns) {
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
  require_each_loose_point_once(made);
}

void prove_leaves(Decomposition& made, std::size_t jobs, const Watch& watch) {
  require_all_held(made, jobs, watch);
  const Partition& partition = std::get<Partition>(made.origin);
  made.owner.assign(made.surface.triangles.size(), kNoOwner);
  std::vector<bool> is_shared(made.owner.size(), false);
  std::vector<bool> is_held(partition.leaves.size(), false);
  for (std::uint32_t k = 0; k < made.parts.size(); ++k) {
    for (const std::uint32_t leaf : made.parts[k].leaves) {
      if (is_held[leaf]) throw Error(ErrorCode::Internal, "a leaf has two parts");
      is_held[leaf] = true;
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
  require_each_loose_point_once(made);
}

}  // namespace convexact
