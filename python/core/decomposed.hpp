// SPDX-License-Identifier: MIT
// decomposed.hpp - a decomposition and what it was made from, which a tree over it needs.
#pragma once
#include "convexact/decompose.hpp"

namespace convexact::python {

struct Decomposed {
  Decomposition result;
  DecomposeRequest request;
};

}  // namespace convexact::python
