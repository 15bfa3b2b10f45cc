// SPDX-License-Identifier: MIT
// reach_search.hpp - what a ReachLimit keeps between its questions.
#pragma once
#include <optional>
#include <span>

#include "convexact/reach.hpp"
#include "reach/reach_cells.hpp"

namespace convexact {

class ReachLimit::Search {
 public:
  Search(const Surface& surface, const Winding* winding, const Rational& squared,
         std::span<const BoundingBox> boxes);

  /// As ReachLimit::farthest_of_each(), without making room.
  std::optional<FarPlace> farthest(std::span<const Point> points, const Watch& watch);

  Rational squared_limit;
  ReachCells cells;
};

}  // namespace convexact
