// SPDX-License-Identifier: MIT
// searched.hpp - a solid simplified, and searched from there, for the tests of this room.
#pragma once
#include "convexact/search.hpp"
#include "simplify_points.hpp"

namespace convexact {

inline constexpr CostMeasure kMeasures[] = {CostMeasure::Volume, CostMeasure::Area,
                                            CostMeasure::MeanWidth};

/// A solid, and what the greedy removals leave of it.
struct Greedy {
  Greedy(const std::vector<Point>& points, std::size_t faces, CostMeasure measure)
      : dual(dual_of_doubles(points)),
        input(to_polytope(dual.halfspaces, dual.triangles)),
        center(center_of(dual)),
        left(survivors(simplify_exact(
            dual, center, {.faces = faces, .cost = measure, .verify = VerifyLevel::None}))) {}

  SearchRun search(const SearchOptions& options) const {
    return search_exchanges(dual, input, center, left, options);
  }

  DualHull dual;
  Polytope input;
  RationalPoint center;
  std::vector<HalfspaceId> left;
};

inline SearchRun find_optimum(const Greedy& greedy, const SearchOptions& options) {
  return search_optimal(greedy.dual, greedy.input, greedy.center, greedy.left, options);
}

inline bool same_moves(const SearchRun& a, const SearchRun& b) {
  return a.tried == b.tried && std::equal(a.moves.begin(), a.moves.end(), b.moves.begin(),
                                          b.moves.end(), [](const Move& x, const Move& y) {
                                            return x.removed == y.removed &&
                                                   x.inserted == y.inserted;
                                          });
}

}  // namespace convexact
