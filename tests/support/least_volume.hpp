// SPDX-License-Identifier: MIT
// least_volume.hpp - the least volume that a given number of the halfspaces of a solid bound, by
// its definition: every choice is intersected from scratch, without duality.
#pragma once
#include <bit>
#include <optional>

#include "convexact/search.hpp"
#include "definitional_search.hpp"
#include "halfspace_arrangement.hpp"

namespace definition {

struct Least {
  Rational volume;
  std::size_t choices = 0;  ///< Those that bound a solid.
};

/// @param keep  In every choice. Precondition: some choice bounds a solid.
inline Least least_volume(const HalfspaceArrangement& arrangement, std::size_t count,
                          Subset keep = 0) {
  Least least;
  for (Subset chosen = 1; chosen <= arrangement.all(); ++chosen) {
    if (static_cast<std::size_t>(std::popcount(chosen)) != count) continue;
    if ((keep & ~chosen) != 0) continue;
    const std::optional<Rational> volume = arrangement.volume(chosen);
    if (!volume) continue;
    if (least.choices++ == 0 || *volume < least.volume) least.volume = *volume;
  }
  return least;
}

/// The halfspaces that are left of a start after the moves of a search.
inline Subset left_by(const SearchRun& run, const Ids& start) {
  Subset kept = subset_of(start);
  for (const Move& move : run.moves) {
    kept = (kept & ~subset_of(move.removed)) | subset_of(move.inserted);
  }
  return kept;
}

}  // namespace definition
