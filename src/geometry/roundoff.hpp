// SPDX-License-Identifier: MIT
// roundoff.hpp - the unit in which errors of doubles are bounded.
#pragma once

namespace convexact::roundoff {

/// x op y is (x op y)(1 + e) with |e| <= u, where nothing overflows or underflows.
inline constexpr double u = 0x1p-53;

}  // namespace convexact::roundoff
