// SPDX-License-Identifier: MIT
// homogeneous_point.hpp - a rational point as four integers.
#pragma once
#include "convexact/number/rational.hpp"

namespace convexact {

/// The point n / w, w > 0. The dual point of a halfspace is one of these.
struct HomogeneousPoint {
  IntegerVector3 n;
  Integer w;
};

}  // namespace convexact
