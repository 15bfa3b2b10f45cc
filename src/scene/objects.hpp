// SPDX-License-Identifier: MIT
// objects.hpp - the objects of a file: taken out of a mesh, joined into one, read back from bytes.
#pragma once
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "convexact/scene.hpp"

namespace convexact {

/// Whether a part has faces or loose points.
[[nodiscard]] bool is_object(const MeshPart& part);
/// How many parts of the mesh have them.
[[nodiscard]] std::size_t objects_in(const Mesh& mesh);

/// Each of them: the points that its faces use, then its loose points.
/// @throws Error InvalidArgument if there is none.
[[nodiscard]] std::vector<SceneObject> parts_of(const Mesh& mesh, const std::string& file);

/// The object of a list of halfspaces. @throws Error NoInterior if no point satisfies some row.
[[nodiscard]] SceneObject halfspace_object(const std::string& path, HalfspaceList list);

/// By point of the object, whether a face uses it; empty if it has no faces.
[[nodiscard]] std::vector<bool> used_flags(const SceneObject& object);

/// The faces of an object: of halfspaces, the facets of their solid, or why they have none.
[[nodiscard]] std::variant<Mesh, NotSolid> mesh_of(SceneObject object);

/// The same with faces for each object that has only points: those of its hull, one polygon if it
/// is flat, and a triangle with equal corners for a segment or a point. A mesh that has no parts
/// and no faces is one such object.
[[nodiscard]] Mesh with_hulls_of_clouds(Mesh mesh);

/// An object to be written, under its name in the file.
struct NamedMesh {
  std::string name;
  const Mesh* mesh;  ///< With a point, and points in doubles.
};

/// The inverse of parts_of(): points and polygons one after another, a part for each object. A
/// segment or a point becomes a triangle with equal corners, since a file would lose an object
/// without a face.
[[nodiscard]] Mesh joined(std::span<const NamedMesh> objects);

/// Refuses what was written. @throws Error Internal: "read back from its bytes, PATH WHY".
[[noreturn]] void reject_bytes(const std::string& path, const std::string& why);

}  // namespace convexact
