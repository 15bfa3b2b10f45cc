// SPDX-License-Identifier: MIT
// seidel.hpp - exact linear programming in few dimensions.
#pragma once
#include <cstdint>

#include "convexact/lp/linear_program.hpp"

namespace convexact {

struct LpOptions {
  /// Of the order of the rows. Kind, x, start and ray do not depend on it; where more rows are
  /// tight than needed, multipliers may.
  std::uint64_t seed = 1;
};

/// Solves a linear program by randomised incremental construction, exactly. Of several optimal
/// points it takes the lexicographically largest if there is one.
/// @throws Error InvalidArgument if the shapes of N, d and c do not fit.
/// @par Cost    Expected O(k! n) dot products of integers in k coordinates; memory O(k n).
/// @par Source  [Seidel1991]; infinity and certificates: docs/design/lp.md
[[nodiscard]] LpOutcome maximise(const LinearProgram& lp, const LpOptions& options = {});

}  // namespace convexact
