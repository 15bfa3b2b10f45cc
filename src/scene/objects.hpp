// SPDX-License-Identifier: MIT
// objects.hpp - the parts of a mesh as objects.
#pragma once
#include <string>
#include <vector>

#include "convexact/scene.hpp"

namespace convexact {

/// How many parts of the mesh have faces.
[[nodiscard]] std::size_t objects_with_faces(const Mesh& mesh);

/// Each part that has faces, with the points that they use.
/// @throws Error InvalidArgument if there is none.
[[nodiscard]] std::vector<SceneObject> parts_of(const Mesh& mesh, const std::string& file);

}  // namespace convexact
