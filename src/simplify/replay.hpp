// SPDX-License-Identifier: MIT
// replay.hpp - removals that were chosen elsewhere, made again in exact arithmetic.
#pragma once
#include <span>

#include "convexact/dual.hpp"
#include "convexact/run.hpp"

namespace convexact {

/// Makes the removals and records each of them; ties are left empty, since no costs are compared.
/// The evaluations are those of the removals.
/// @param dual    The dual hull from which the removals start.
/// @param center  Strictly inside. The costs do not depend on it.
/// @param removed  Each once; every prefix leaves a bounded solid.
/// @throws Error  InvalidArgument if the center is not strictly inside or a removal is unbounded.
/// @par Cost      Expected O(k) exact operations per removal with a ring of k.
[[nodiscard]] Run replay(const DualHull& dual, const RationalPoint& center,
                         std::span<const HalfspaceId> removed, std::uint64_t seed = 1);

}  // namespace convexact
