// SPDX-License-Identifier: MIT
// scene.hpp - the objects that a command works on: files, or the parts of a file.
#pragma once
#include <string>
#include <vector>

#include "convexact/mesh.hpp"
#include "convexact/number.hpp"
#include "convexact/scene.hpp"

namespace convexact::cli {

/// One object, to be enclosed on its own.
struct SceneObject {
  std::string name;  ///< The file, or "file: part".
  std::string part;  ///< The part's name; the file's stem without parts.
  Shape shape;
  std::vector<std::vector<std::uint32_t>> polygons;  ///< Of point input, for its picture.
  TypedRows rows = {};                               ///< Of halfspace input.
};

struct SceneOptions {
  Decimal decimal = Decimal::Nearest;
  bool parts = false;  ///< Each object of a file on its own.
};

/// Names redundant halfspaces by their rows in the file, counted from 0.
void to_typed_rows(std::vector<RedundantHalfspace>& redundant, const TypedRows& rows);

/// Reads files one after another: meshes, or halfspaces (.json, .ine, or by content).
/// @throws Error as the readers; NoInterior if a halfspace list has a row that nothing satisfies;
///         InvalidArgument for parts of a file that has none, or standard input twice.
std::vector<SceneObject> read_scene(const std::vector<std::string>& paths,
                                    const SceneOptions& options);

}  // namespace convexact::cli
