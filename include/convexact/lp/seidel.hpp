// SPDX-License-Identifier: MIT
// seidel.hpp - exact linear programming in few dimensions.
#pragma once
#include <cstdint>

#include "convexact/lp/linear_program.hpp"

namespace convexact {

struct LpOptions {
  std::uint64_t seed =
      1;  ///< Of the order of the rows; kind of outcome and optimum do not depend on it.
};

/// Solves a linear program by randomised incremental construction, exactly. Of several optimal
/// points it takes the lexicographically largest if that is a finite point.
/// @throws Error InvalidArgument if the shapes of N, d and c do not fit.
/// @par Cost    Expected O(k! n) dot products of integers in k coordinates; memory O(k n).
/// @par Source  [Seidel1991]; infinity and certificates: docs/design/lp.md
[[nodiscard]] LpOutcome maximise(const LinearProgram& lp, const LpOptions& options = {});

}  // namespace convexact
