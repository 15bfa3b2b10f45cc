// SPDX-License-Identifier: MIT
// acceptance.hpp - the tests that a stored solid must pass before it is written, planes and meshes
// alike.
#pragma once
#include <span>
#include <string>

#include "convexact/number.hpp"
#include "convexact/point_set.hpp"
#include "convexact/polytope.hpp"
#include "convexact/stored.hpp"

namespace convexact::stored {

/// @throws Error Unrepresentable, always: "binary32 cannot hold the result: WHY; ...".
[[noreturn]] void refuse(Precision precision, const std::string& why);

/// The final pass: every input point against every halfspace that is about to be written.
/// @return 0. @throws Error Internal if a point is outside.
[[nodiscard]] std::size_t final_pass(std::span<const Halfspace> halfspaces, const PointSet& input);

/// growth() about an interior point.
/// @throws Error Unrepresentable if the solids are farther apart than the exact one is long.
[[nodiscard]] Growth checked_growth(const Polytope& exact, const Polytope& polytope,
                                    const PointSet& input, std::span<const PointId> witnesses,
                                    Precision precision);

}  // namespace convexact::stored
