// SPDX-License-Identifier: MIT
// candidate.hpp - what somebody's program wrote, however wrong it may be.
#pragma once
#include <variant>

#include "convexact/error.hpp"
#include "convexact/geometry/halfspace_list.hpp"
#include "convexact/io/mesh.hpp"

namespace convexact {

/// A mesh, which stands for the convex hull of its points; halfspaces, which stand for their
/// intersection; or the error (Malformed or NotFinite) that reading it met.
using Candidate = std::variant<Mesh, HalfspaceList, Error>;

}  // namespace convexact
