// SPDX-License-Identifier: MIT
// confirm_costs.hpp - computes costs of removals once more, from the definition.
#pragma once
#include "convexact/verify_run.hpp"

namespace convexact {

/// The halfspaces that are left before step `step`, in canonical order; those that were left out
/// are not among them.
[[nodiscard]] std::vector<Halfspace> left_before(const TraceVerdict& verdict, std::size_t step);

/// Checks cost and boundedness of the removal that a step made and of the one that it should have
/// made.
/// @throws Error Internal if they are not what the step says.
void confirm_step(const TraceVerdict& verdict, const RationalPoint& center, std::size_t step);

/// V(before the first step) + costs = V(after the last bounded one), modulo two random primes.
/// @throws Error Internal if not.
void confirm_sum(const TraceVerdict& verdict, const RationalPoint& center);

}  // namespace convexact
