// SPDX-License-Identifier: MIT
// mesh_file.hpp - the points of a mesh, or the rows of a list of halfspaces, for comparison.
#pragma once
#include <string>
#include <vector>

#include "words.hpp"

namespace check {

// In the order of the file, each as often as it is there.
struct MeshFile {
  bool is_mesh = true;      // points; or else halfspaces
  std::vector<Row> rows{};  // points as scaled(), halfspaces as primitive()
};

// Reads a file, told by its name: .obj, .off, .ply, .stl, .xyz; halfspaces as .ine or as rows n1 n2
// n3 d (.txt). Only what says where points are is looked at. @throws Failure of exit code 3, with
// the place.
MeshFile read_mesh_file(const std::string& path, Decimals decimals);
MeshFile parse_mesh_file(const std::string& bytes, const std::string& path, Decimals decimals);

}  // namespace check
