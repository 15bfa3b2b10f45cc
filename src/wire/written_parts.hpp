// SPDX-License-Identifier: MIT
// written_parts.hpp - the files of a decomposition: read back from their bytes, each part holds
// every triangle that it owns.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "convexact/decompose.hpp"
#include "io/json_document.hpp"
#include "wire/decompose_report.hpp"

namespace convexact {

/// A part to be written, of a decomposition of that surface.
struct WrittenPart {
  std::string name;
  const Part* part;
  const Surface* surface;
  const Partition* partition = nullptr;  ///< Whose leaves it holds, if it holds leaves.
};

/// All parts of all objects, which they point into.
[[nodiscard]] std::vector<WrittenPart> written_parts(std::span<const DecomposedObject> objects);

/// @param halfspaces  The halfspaces of the part as a reader of the file takes it.
/// @throws Error Internal if a corner of a triangle that the part owns is outside of one.
void require_held(const std::string& path, const WrittenPart& written,
                  std::span<const Halfspace> halfspaces);

/// An OBJ or, of parts in binary32, a GLB with an object for each part. A segment or a point is a
/// triangle with equal corners.
/// @param path   For messages.
/// @param jobs   As DecomposeRequest::jobs.
/// @throws Error Internal if the bytes lose a part, or a corner of a triangle that it owns.
[[nodiscard]] std::string proven_parts_mesh(std::span<const WrittenPart> parts, MeshFormat format,
                                            const std::string& path,
                                            std::optional<std::size_t> jobs = {});

/// A document with these parts under "parts", each with "vertices" and "halfspaces".
/// @throws Error as proven_parts_mesh(); both the hull of the vertices and the halfspaces must hold
///               what a part owns.
[[nodiscard]] std::string proven_parts_json(const Json& document,
                                            std::span<const WrittenPart> parts,
                                            const std::string& path,
                                            std::optional<std::size_t> jobs = {});

}  // namespace convexact
