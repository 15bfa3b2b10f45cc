// SPDX-License-Identifier: MIT
// merge_by_reach.hpp - few parts from many pieces, as long as each stays near the solid.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/reach.hpp"

namespace convexact {

struct ReachMergeOptions {
  /// How often everything is done: with other preferences each time but the first.
  int rounds = 1;
  std::uint64_t seed = 1;
  /// Give the pieces of a part to other parts, if that makes it needless.
  bool eliminate = true;
  /// How many exchanges to try for that in each round, for each piece: a part takes a piece in and
  /// gives away another one.
  std::size_t exchanges = 0;
  /// Parts to end with even if they reach too far; 0: none are merged for that.
  std::size_t most_parts = 0;
  /// A volume in the frame that the parts' volumes together must not exceed, up to roundings. Where
  /// the pieces exceed it already, merging adds no volume.
  double most_volume = HUGE_VAL;
  /// Each two parts must have a plane between them, up to kApart (joined_hulls.hpp), except for
  /// `most_parts`.
  bool keeps_apart = false;
  /// Threads, at least 1. The parts are the same for any number of them.
  std::size_t jobs = 1;
};

/// The pieces of each part, ascending; the parts in the order of their lowest pieces.
struct ReachMerged {
  std::vector<std::vector<std::uint32_t>> parts;
  /// Whether parts were merged for `most_parts` although they reach too far.
  bool is_beyond = false;
};

/// Each piece becomes a part. Then, again and again, the two parts are merged whose common hull
/// adds the least volume among those that the limit allows. Then each part whose pieces all find a
/// place in other parts, as far as the limit allows, is given up, smallest first; a piece goes to
/// the part that grows least, or takes the place of another one. Of several rounds the fewest parts
/// are kept, of these the least volume. Volumes are those of hulls of doubles, so that every
/// machine sorts alike; no proof depends on the order.
/// @param pieces  The points of each, in the frame of the limit.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] ReachMerged merge_by_reach(std::span<const std::vector<Point>> pieces,
                                         ReachLimit& limit, const ReachMergeOptions& options,
                                         const Watch& watch);

}  // namespace convexact
