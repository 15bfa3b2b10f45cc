// SPDX-License-Identifier: MIT
// search.hpp - beyond greedy: kept halfspaces exchanged for others as long as the solid shrinks.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/run.hpp"

namespace convexact {

/// The search for a solid smaller than the one that a run leaves, with as many halfspaces.
enum class SearchKind {
  None,
  Walk,     ///< Exchanges of one halfspace for a facet next to it, until none helps.
  Local,    ///< The same, then kicks: random exchanges with a walk after them, kept if that helped.
  Optimal,  ///< The same, then all other choices, until it is proven that no equal number of
            ///< halfspaces of the input bounds less. By volume only.
};

struct SearchRequest {
  SearchKind kind = SearchKind::None;
  std::size_t kicks = 200;         ///< Of SearchKind::Local and Optimal.
  std::size_t nodes = 10'000'000;  ///< Of SearchKind::Optimal: most states to be looked at.
};

struct SearchOptions {
  SearchRequest request = {SearchKind::Walk};
  Engine engine = Engine::Filtered;    ///< Not Float.
  std::vector<HalfspaceId> keep = {};  ///< Among those at the start, ascending: never exchanged.
  CostMeasure cost = CostMeasure::Volume;
  CompareLimits compare = {};  ///< For mean widths. If undecided, a measure counts as not smaller.
  std::uint64_t seed = 1;      ///< Of the kicks: another one may lead elsewhere.
  /// Told after each kick of those made and of `request.kicks`; ends the search with Error Stopped.
  Watch watch = {};
  /// Called from time to time by search_optimal() with the number of states looked at so far, and a
  /// bound: at most this share of the incumbent's volume can be saved.
  std::function<void(std::size_t nodes, double gap)> bounded = {};
  /// When it becomes true, no further kicks or states are tried, and the best result so far is
  /// returned.
  const std::atomic<bool>* settle = nullptr;

  bool is_told_to_settle() const {
    return settle != nullptr && settle->load(std::memory_order_relaxed);
  }
};

/// The facts that search_optimal() has proven.
struct Optimality {
  bool is_proven = false;  ///< No equal number of halfspaces of the input bounds a smaller volume.
  /// They bound no smaller volume than this, which is the volume of the result if that is proven
  /// the least.
  Rational lower_bound;
  std::size_t nodes = 0;  ///< States looked at. The engines may differ where volumes are equal.
};

/// How a search went.
struct SearchRun {
  std::vector<Move> moves;  ///< Each proven to make the measure smaller; without measures.
  /// The approximate change of the measure by each of them, below 0, in a unit of the run.
  std::vector<double> changes;
  std::size_t tried = 0;                      ///< Exchanges whose measures were compared.
  std::optional<Optimality> optimality = {};  ///< Of search_optimal().
};

/// Exchanges kept halfspaces for facets of the input, so that the measure falls. Both engines
/// follow the same rule, and so make the same moves. The walk visits the kept halfspaces in
/// canonical order. Of all facets that share an edge with a visited halfspace on the input and are
/// not kept, the one that leaves the least measure takes its place, the first in canonical order on
/// a tie, if that measure is proven to be less than before. The walk repeats this until a pass over
/// all kept halfspaces changes nothing. A kick draws one to three kept halfspaces, and for each a
/// facet two to eleven edges away; facets that are kept already, or that leave the solid unbounded,
/// are passed over. The walk follows. If the measure is not proven to be less than before the kick,
/// all of that is undone; otherwise it is one move.
/// @param dual   The dual hull of the input.
/// @param input  The same as a polytope.
/// @param start  The halfspaces kept at the start, at least 4, ascending; they bound a solid.
/// @throws Error InvalidArgument for the float engine, or if the center is not strictly inside;
///               Stopped.
/// @par Cost     An exchange of k halfspaces inserts and removes a dual point: 2k - 4 signs and two
///               caps. A pass compares one for each edge of a kept facet.
/// @par Source   docs/design/search.md
[[nodiscard]] SearchRun search_exchanges(const DualHull& dual, const Polytope& input,
                                         const RationalPoint& center,
                                         std::vector<HalfspaceId> start,
                                         const SearchOptions& options = {});

/// Finds the least volume that is bounded by as many halfspaces of the input as there are at the
/// start, those to be kept among them. A local search leads to the incumbent. Branch and bound then
/// looks at all sets of removals, except those that are proven to end at no smaller volume; a
/// result that is proven to be smaller becomes the incumbent. If that helped, it is one more move.
/// Of several sets of the least volume the result is the one that the local search found, or else
/// the first in the order of the branches; it is the same for both engines unless the limit of
/// nodes ends the search.
/// @throws Error As search_exchanges(); InvalidArgument unless the measure is the volume: by area
///               and mean width the cost of a removal may fall later, so that nothing bounds it.
/// @par Cost     Exponential in the worst case. Each state costs some thirty caps.
/// @par Source   docs/design/search.md
[[nodiscard]] SearchRun search_optimal(const DualHull& dual, const Polytope& input,
                                       const RationalPoint& center, std::vector<HalfspaceId> start,
                                       const SearchOptions& options = {});

}  // namespace convexact
