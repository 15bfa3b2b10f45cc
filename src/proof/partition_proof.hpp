// SPDX-License-Identifier: MIT
// partition_proof.hpp - the proof that parts hold a solid, and stay near it, for convexact-check.
#pragma once
#include "convexact/decompose.hpp"
#include "proof/proof_lines.hpp"

namespace convexact {

/// The points and triangles of a surface.
void write_surface(const Surface& surface, ProofLines& out);

/// Where all parts are proven by cells alone: how far they reach; else nothing.
void write_reach(const Decomposition& made, const DecomposeRequest& request, ProofLines& out);

/// Of a decomposition by cut(): the parts, the planes of the tree, and for each leaf its part.
/// @throws Error InvalidArgument if a part is flat; Stopped when the watch of the request ends it.
[[nodiscard]] std::string write_partition_proof(const Decomposition& made,
                                                const DecomposeRequest& request);

}  // namespace convexact
