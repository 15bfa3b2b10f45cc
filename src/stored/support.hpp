// SPDX-License-Identifier: MIT
// support.hpp - the exact maximum of n.x over points, by doubles first.
#pragma once
#include "stored/coordinates.hpp"

namespace convexact::stored {

/// The support function of some of the points of a set.
class WitnessSupport {
 public:
  WitnessSupport(const PointSet& points, std::span<const PointId> witnesses)
      : points_(points), witnesses_(witnesses), doubles_(points, witnesses) {}

  /// max over the witnesses of n.x; |n_k| <= 1. At least one witness.
  Rational operator()(const Point& n);

 private:
  const PointSet& points_;
  std::span<const PointId> witnesses_;
  Coordinates doubles_;
  std::vector<double> values_;  // of the last call, kept for its memory
};

}  // namespace convexact::stored
