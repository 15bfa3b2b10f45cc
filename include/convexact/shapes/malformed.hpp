// SPDX-License-Identifier: MIT
// malformed.hpp - files of each format that no reader may accept, for the tests of readers.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace convexact::shapes {

struct MalformedFile {
  std::string name;         ///< "malformed-", the format, "-", what is wrong.
  std::string description;  ///< One line.
  std::string bytes;        ///< The whole file.
  bool not_finite;          ///< Spelled right, but NaN, infinite or beyond the largest double.

  /// The file's extension: obj, off, ply, stl, xyz, json, ine or txt. The last three list
  /// halfspaces.
  [[nodiscard]] std::string_view extension() const;
};

/// All of them, in a fixed order. Each is a small valid file with one mistake in it (or empty, or
/// noise), so that what refuses it has found that very mistake. OBJ and XYZ have no header and no
/// counts: their truncated files end within a line, and an empty one is valid, but without points.
[[nodiscard]] std::span<const MalformedFile> malformed_files();

}  // namespace convexact::shapes
