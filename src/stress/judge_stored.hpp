// SPDX-License-Identifier: MIT
// judge_stored.hpp - results as bytes: read back, then judged by the oracle.
#pragma once
#include "stress/answer.hpp"

namespace convexact {

/// Reads the bytes by the usual readers and decides whether they are a bounded solid that holds
/// every point of the input (or every vertex of the halfspaces' solid), all its numbers of the
/// precision.
[[nodiscard]] StressStored judge_stored(const Shape& shape, const StoredBytes& stored);

}  // namespace convexact
