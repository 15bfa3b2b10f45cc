// SPDX-License-Identifier: MIT
// certificates.hpp - re-checks the outcome of a linear program from its definition.
#pragma once
#include "convexact/linear_program.hpp"

namespace convexact {

/// Whether the certificate proves the claim. The check uses N, d and c alone and shares no code
/// with the solver.
/// @par Cost  O(k n) rational operations for k coordinates and n rows.
[[nodiscard]] bool check(const LinearProgram& lp, const LpOutcome& outcome);
[[nodiscard]] bool check(const LinearProgram& lp, const Optimal& claim);
[[nodiscard]] bool check(const LinearProgram& lp, const Infeasible& claim);
[[nodiscard]] bool check(const LinearProgram& lp, const Unbounded& claim);

}  // namespace convexact
