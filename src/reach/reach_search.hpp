// SPDX-License-Identifier: MIT
// reach_search.hpp - what a ReachLimit keeps between its questions.
#pragma once
#include "convexact/reach.hpp"
#include "reach/reach_cells.hpp"

namespace convexact {

class ReachLimit::Search {
 public:
  Search(const Surface& surface, const Winding* winding, const Rational& squared,
         std::span<const BoundingBox> boxes);

  Rational squared_limit;
  ReachCells cells;
};

}  // namespace convexact
