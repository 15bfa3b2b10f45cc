// SPDX-License-Identifier: MIT
// coverage_proof.hpp - the last stage: on the stored numbers, parts hold what they were made for.
#pragma once

#include "convexact/decompose.hpp"

namespace convexact {

/// Each corner of each triangle lies in all halfspaces of the triangle's owner, and each loose
/// point in those of its part. Fills `owner` and `tested_triangles`.
/// @param jobs  Threads, at least 1, on which nothing depends.
/// @throws Error Internal if one does not; Stopped.
void prove_owners(Decomposition& made, std::size_t jobs, const Watch& watch);

/// Of Cut: each leaf's hull lies in its part; so the parts hold the solid, and each triangle. Fills
/// `owner`, `tested_triangles` and what the parts own.
/// @throws Error as prove_owners().
void prove_leaves(Decomposition& made, std::size_t jobs, const Watch& watch);

}  // namespace convexact
