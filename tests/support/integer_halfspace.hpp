// SPDX-License-Identifier: MIT
// integer_halfspace.hpp - halfspaces as tests write them by hand.
#pragma once
#include "convexact/geometry.hpp"

/// a x + b y + c z + d <= 0
inline convexact::Halfspace halfspace(int a, int b, int c, int d) {
  return {convexact::IntegerVector3(a, b, c), convexact::Integer(d)};
}
