// SPDX-License-Identifier: MIT
// decomposition_proof.hpp - the proof of a decomposition, for convexact-check.
#pragma once
#include <string>

#include "convexact/decompose.hpp"

namespace convexact {

/// Writes the proof of a decomposition; docs/decomposition-proof.md has the format and why it
/// proves what it does. It claims that neighbours cannot be merged, and that clusters are
/// connected, if only common edges connect triangles; for the float engine only where this is true.
/// @param request  Of the decomposition.
/// @throws Error   Internal if there is no proof: then the decomposition was wrong. Stopped when
///                 the request's watch ends the call.
/// @par Cost       Hulls of clusters and of pairs of neighbours, and a product for each triangle
///                 and facet of these, mostly in doubles; linear programs where these do not
///                 decide.
[[nodiscard]] std::string write_decomposition_proof(const Decomposition& made,
                                                    const DecomposeRequest& request);

/// Whether a proof claims how far the parts reach: not if cells alone do not prove that, or not
/// without more of them than are kept.
[[nodiscard]] bool claims_reach(const std::string& proof);

}  // namespace convexact
