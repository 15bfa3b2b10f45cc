// SPDX-License-Identifier: MIT
// Which format a file has. Expected values are written out by hand.
#include <doctest/doctest.h>

#include "convexact/io.hpp"

using namespace convexact;

TEST_CASE("mesh_format_of_path: by extension, in any case") {
  CHECK(mesh_format_of_path("a.obj") == MeshFormat::Obj);
  CHECK(mesh_format_of_path("dir.x/A.OFF") == MeshFormat::Off);
  CHECK(mesh_format_of_path(".Ply") == MeshFormat::Ply);
  CHECK(mesh_format_of_path("a.b.stl") == MeshFormat::Stl);
  CHECK(mesh_format_of_path("a.Xyz") == MeshFormat::Xyz);
  for (const char* other : {"", "-", "obj", "a.objx", "a.json", "a.ine", "stl.txt"}) {
    CHECK(!mesh_format_of_path(other).has_value());
  }
}

TEST_CASE("mesh_format_of_content: by the first word, else OBJ") {
  CHECK(mesh_format_of_content("ply\r\nformat ascii 1.0\n") == MeshFormat::Ply);
  CHECK(mesh_format_of_content("# from somewhere\nCOFF\n") == MeshFormat::Off);
  CHECK(mesh_format_of_content("4OFF 0 0 0") == MeshFormat::Off);
  CHECK(mesh_format_of_content("\n solid x") == MeshFormat::Stl);
  CHECK(mesh_format_of_content("# scan\n1 -2.5 3e4\n") == MeshFormat::Xyz);
  for (const char* obj : {"1 2", "1 2 3 x", "", "v 0 0 0", "# ply", "s off", "plywood"}) {
    CHECK(mesh_format_of_content(obj) == MeshFormat::Obj);
  }
}
