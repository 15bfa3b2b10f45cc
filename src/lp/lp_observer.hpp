// SPDX-License-Identifier: MIT
// lp_observer.hpp - watching the rows of a linear program being inserted.
#pragma once
#include <cstddef>
#include <optional>

#include "convexact/linear_program.hpp"

namespace convexact {

/// A point, possibly at infinity: x + M direction for every M that is large enough.
struct LpPoint {
  RationalVector x;
  RationalVector direction;  ///< Zero: the point is x.
};

/// The effect of one constraint on the optimum of those before it.
struct LpInsertion {
  std::size_t row;
  bool moved;  ///< Whether the constraint cut the old optimum off.
  /// The lexicographically largest of the optimal points so far, within a box of size M; nothing if
  /// no point satisfies the constraints so far. Then this is the last insertion.
  std::optional<LpPoint> optimum;
};

/// Sees the rows of a linear program inserted, for lessons.
class LpObserver {
 public:
  virtual ~LpObserver() = default;
  /// The optimum without any row: a corner of the box.
  virtual void start(const LpPoint& optimum) = 0;
  virtual void inserted(const LpInsertion& insertion) = 0;
};

}  // namespace convexact
