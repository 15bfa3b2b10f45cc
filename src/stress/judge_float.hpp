// SPDX-License-Identifier: MIT
// judge_float.hpp - the float engine: how wrong it is, and whether it says so.
#pragma once
#include "stress/judge_order.hpp"

namespace convexact {

/// Adds to the run its errors against exact costs and minima in its own states, and what is wrong.
/// To be wrong is no fault; to be more wrong than it says it can be is one, and so is an unbounded
/// solid. @param verdict  Of follow().
void judge_float(const EngineAnswer& answer, const TraceVerdict& verdict, StressRun& run);

/// How far the ends of a reported range are from the true cost at most, relative to that; rounded
/// up, infinite if one of them is.
[[nodiscard]] double error_of_cost(const Range& reported, const Rational& cost);

}  // namespace convexact
