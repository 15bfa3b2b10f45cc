// SPDX-License-Identifier: MIT
// robot_model.hpp - a URDF whose collision meshes are replaced by parts, every other byte kept.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wire/part_models.hpp"

namespace convexact {

/// A collision of a link by a mesh, and where it stands in the text.
struct RobotCollision {
  std::string link;
  std::string mesh;  ///< The file name as it is spelled.
  std::size_t line;
  std::size_t first, last;  ///< The bytes [first, last) are the element.
  std::size_t mesh_tag;     ///< Where <mesh begins.
};

/// What stands in the place of a collision.
struct RobotParts {
  std::vector<PartFile> parts;  ///< Relative to the new model; none: the collision stays.
  /// What the scale of the mesh is multiplied by: meters for each unit of a COLLADA, as readers of
  /// URDF do it, while OBJ has no unit.
  double unit = 1;
};

class RobotModel {
 public:
  /// @throws Error Unreadable for bytes that are no URDF, with a document type, or with xacro that
  /// is
  ///               yet to be run; Malformed for XML that does not parse, with the line.
  explicit RobotModel(std::string bytes);

  const std::string& name() const { return name_; }
  std::size_t links() const { return links_; }
  /// In the order of the text.
  const std::vector<RobotCollision>& collisions() const { return collisions_; }

  /// The text in which each collision is one for each of its parts: the same text but for the file
  /// name and, if it has one, the name of the collision.
  /// @param parts  For each of collisions().
  [[nodiscard]] std::string with_parts(std::span<const RobotParts> parts) const;

 private:
  std::string bytes_;
  std::string name_;
  std::size_t links_ = 0;
  std::vector<RobotCollision> collisions_;
};

/// A folder that may be read, by the name that package://NAME/ has for it.
struct RobotPackage {
  std::string name, folder;
};

/// The path of a mesh that a URDF names: relative to the URDF, or below package://NAME/. Without a
/// folder for NAME, the folder of that name above the URDF is taken, if there is one.
/// @throws Error Unreadable for a package that is not known, for other schemes, and for paths that,
///               links followed, are neither in the folder of the URDF nor in that of a package.
[[nodiscard]] std::string robot_mesh_path(const std::string& urdf, std::string_view spelled,
                                          std::span<const RobotPackage> packages);

}  // namespace convexact
