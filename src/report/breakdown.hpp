// SPDX-License-Identifier: MIT
// breakdown.hpp - where each arithmetic breaks down as shapes become stiff or extreme.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "report/work_precision.hpp"

namespace convexact {

/// Every way of computing at one value of a family's parameter.
struct BreakdownPoint {
  double value = 0;
  std::string why_not;  ///< Why there is no solid to measure on; empty if there is.
  std::optional<WorkPrecision> precision;
};

/// A family of shapes, swept over the parameter that makes it stiff.
struct Breakdown {
  std::string family, parameter;  ///< As `convexact generate` names them.
  std::vector<BreakdownPoint> points;
};

/// The families that can be swept, by name.
[[nodiscard]] std::vector<std::string> breakdown_families();

/// A few dozen points per shape, down to four halfspaces.
/// @param family  One of breakdown_families(). @throws Error InvalidArgument if it is not.
[[nodiscard]] Breakdown measure_breakdown(const std::string& family, const Effort& effort);

}  // namespace convexact
