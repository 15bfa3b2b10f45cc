// SPDX-License-Identifier: MIT
// containment.hpp - every input point against every halfspace, exactly: the last word on a result.
#pragma once
#include <span>

#include "convexact/geometry/halfspace.hpp"
#include "convexact/geometry/point_set.hpp"

namespace convexact {

/// How many of the points lie strictly outside at least one of the halfspaces. By the definition of
/// containment alone: nothing is taken from a hull, a dual or a certificate.
/// @par Cost  One product n.x in doubles for each pair; exact arithmetic only where its proven
/// error
///            bound leaves the sign open.
[[nodiscard]] std::size_t count_outside(std::span<const Halfspace> halfspaces,
                                        const PointSet& points);

}  // namespace convexact
