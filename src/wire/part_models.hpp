// SPDX-License-Identifier: MIT
// part_models.hpp - the parts of a decomposition as collision shapes for simulators: MJCF and URDF,
// which name the files of the parts, and USD, which holds their points. docs/formats.md describes
// what the simulators do to the numbers.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wire/model_body.hpp"
#include "wire/written_parts.hpp"

namespace convexact {

/// @throws Error Unrepresentable unless XML and USD can hold the text: UTF-8, no control character.
void require_model_text(const std::string& text);

/// A part, and the path of its mesh relative to the model.
struct PartFile {
  std::string name, path;
};

/// MuJoCo's MJCF: a mesh for each part and one body of all, which takes the hull of each mesh.
/// @throws Error as require_model_text(), of each name and path.
[[nodiscard]] std::string write_mjcf(const ModelBody& body, std::span<const PartFile> parts);

/// URDF: a link with a collision for each part, and the mesh itself to be seen.
/// @throws Error as write_mjcf().
[[nodiscard]] std::string write_urdf(const ModelBody& body, std::span<const PartFile> parts);

/// Text of USD: an Xform with a Mesh for each part, each a collider by its convex hull. The names
/// of prims are identifiers, all different; a name that is no identifier is kept for display. Mass
/// and center of mass are those of the body; a simulator computes the tensor of inertia itself.
/// @param parts  With a volume, in binary32.
/// @param path   For messages.
/// @throws Error as write_mjcf(); Internal if the points, read back as USD reads them, lose a
///               corner of a triangle that their part owns.
[[nodiscard]] std::string proven_parts_usd(const ModelBody& body,
                                           std::span<const WrittenPart> parts,
                                           const std::string& path);

/// The parts in the bytes of an MJCF or a URDF of one body, in their order; nothing for a model
/// that places or scales its meshes, or has shapes that are no meshes.
[[nodiscard]] std::optional<std::vector<PartFile>> part_files_of_model(std::string_view bytes);

/// The parts in the bytes of a USD that proven_parts_usd() made, as USD reads them; nothing for any
/// other.
[[nodiscard]] std::optional<std::vector<NamedPart>> parts_of_usd(const std::string& bytes);

/// Whether a path ends in .mjcf.xml, .urdf or .usda: a model for simulators.
[[nodiscard]] bool is_part_model(const std::string& path);

/// The names of prims for these names, in their order.
[[nodiscard]] std::vector<std::string> prim_names(std::span<const WrittenPart> parts);

}  // namespace convexact
