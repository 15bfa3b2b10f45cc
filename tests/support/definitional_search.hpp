// SPDX-License-Identifier: MIT
// definitional_search.hpp - the walk of search_exchanges() by its definition: every exchange is
// intersected from scratch, without duality, and its measure compared as a whole.
#pragma once
#include <algorithm>
#include <vector>

#include "convexact/run.hpp"
#include "halfspace_arrangement.hpp"
#include "polytope_by_definition.hpp"

namespace definition {

using Ids = std::vector<HalfspaceId>;

inline Subset subset_of(const Ids& ids) {
  Subset set = 0;
  for (const HalfspaceId i : ids) set |= Subset{1} << i.index();
  return set;
}

/// For each facet those that share two corners, and so an edge, with it.
inline std::vector<Ids> facets_next_to(const Polytope& polytope) {
  std::vector<Ids> next(polytope.facets.size());
  for (std::size_t i = 0; i < next.size(); ++i) {
    for (std::size_t j = 0; j < next.size(); ++j) {
      const auto &a = polytope.facets[i], &b = polytope.facets[j];
      const auto common = std::count_if(a.begin(), a.end(), [&](std::uint32_t v) {
        return std::find(b.begin(), b.end(), v) != b.end();
      });
      if (i != j && common >= 2) next[i].emplace_back(j);
    }
  }
  return next;
}

/// The exchanges that a walk makes, in order. @param keep  Never exchanged.
inline std::vector<Move> walk_by_definition(const HalfspaceArrangement& arrangement,
                                            const std::vector<Ids>& next, Subset kept,
                                            CostMeasure measure, Subset keep = 0) {
  std::vector<Move> moves;
  const auto has = [](Subset set, HalfspaceId i) { return (set >> i.index() & 1) != 0; };
  for (bool helped = true; helped;) {
    helped = false;
    Ids pass;
    for (std::size_t i = 0; i < arrangement.size(); ++i) {
      if (has(kept & ~keep, HalfspaceId(i))) pass.emplace_back(i);
    }
    for (const HalfspaceId out : pass) {
      Cost least = arrangement.measure(kept, measure).value();
      std::optional<HalfspaceId> best;
      for (const HalfspaceId in : next[out.index()]) {
        if (has(kept, in)) continue;
        const auto now = arrangement.measure((kept & ~subset_of({out})) | subset_of({in}), measure);
        if (!now || compare(*now, least).order != Order::Less) continue;
        least = *now;
        best = in;
      }
      if (!best) continue;
      kept = (kept & ~subset_of({out})) | subset_of({*best});
      moves.push_back({{out}, {*best}, least});
      helped = true;
    }
  }
  return moves;
}

}  // namespace definition
