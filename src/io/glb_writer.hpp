// SPDX-License-Identifier: MIT
// glb_writer.hpp - a mesh as glTF 2.0 in one file.
#pragma once
#include <string>

#include "convexact/io.hpp"

namespace convexact {

/// A node, a mesh and a material of its own for each part that has polygons; polygons become fans.
/// @pre Every coordinate is a binary32 number.
/// @throws Error Unrepresentable for 4 GiB or more.
[[nodiscard]] std::string write_glb(const Mesh& mesh, const std::vector<MeshPart>& parts);

}  // namespace convexact
