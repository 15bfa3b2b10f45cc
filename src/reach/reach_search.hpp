// SPDX-License-Identifier: MIT
// reach_search.hpp - what a ReachLimit keeps between its questions.
#pragma once
#include <functional>
#include <optional>
#include <span>

#include "convexact/reach.hpp"
#include "reach/met_cell.hpp"
#include "reach/reach_cells.hpp"

namespace convexact {

class ReachLimit::Search {
 public:
  Search(const Surface& surface, const Winding* winding, const Rational& squared,
         std::span<const BoundingBox> boxes);

  /// As ReachLimit::allows() and farthest_of_each(), without making room. Several threads may ask.
  bool allows(NearPart part, const Watch& watch);
  std::optional<FarPlace> farthest(std::span<const Point> points, const Watch& watch);

  /// Calls ask(k) for each k below count, a few at the same time, and makes room between them.
  /// @param goes_on  Called with the number of those done before the next few; false ends it.
  void ask_each(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& ask,
                const std::function<bool(std::size_t)>& goes_on = {});

  Rational squared_limit;
  ReachCells cells;
};

}  // namespace convexact
