// SPDX-License-Identifier: MIT
// containment.hpp - every input point against every halfspace, exactly: the last word on a result.
#pragma once
#include <atomic>
#include <span>
#include <vector>

#include "convexact/geometry/halfspace.hpp"
#include "convexact/geometry/point_set.hpp"

namespace convexact {

/// The points that lie strictly outside at least one of the halfspaces, ascending. By the
/// definition of containment alone: nothing is taken from a hull, a dual or a certificate.
/// @throws Error Stopped when `stop` becomes true.
/// @par Cost  One product n.x in doubles for each halfspace and block of 128 points, if its proven
///            error bound settles the block's box; else one for each pair; exact arithmetic only
///            where that leaves the sign open.
[[nodiscard]] std::vector<PointId> find_outside(std::span<const Halfspace> halfspaces,
                                                const PointSet& points,
                                                const std::atomic<bool>* stop = nullptr);

/// How many these are.
[[nodiscard]] std::size_t count_outside(std::span<const Halfspace> halfspaces,
                                        const PointSet& points);

}  // namespace convexact
