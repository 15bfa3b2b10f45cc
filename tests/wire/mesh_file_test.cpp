// SPDX-License-Identifier: MIT
// The shape in a file, as requests have it.
#include "wire/mesh_file.hpp"

#include <doctest/doctest.h>

#include "expect_error.hpp"
#include "io/json_text.hpp"

using namespace convexact;
using nlohmann::json;

TEST_CASE("mesh file: a mesh of one object has points, faces and notes") {
  const json mesh =
      parse_json(shape_in_file("a.obj", "v 0 0 0\nv 0.1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\n"));
  CHECK(mesh.size() == 3);
  CHECK(mesh.at("points") == parse_json("[[0, 0, 0], [0.1, 0, 0], [0, 1, 0]]"));
  CHECK(mesh.at("triangles") == parse_json("[[0, 1, 2]]"));
  CHECK(mesh.at("notes").size() == 1);
}

TEST_CASE("mesh file: objects have names, triangles, and points that no triangle uses") {
  const json mesh = parse_json(shape_in_file(
      "a.obj", "o x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no y\nv 0 0 1\nv 5 5 5\nf 1 2 4\n"));
  CHECK(mesh.at("objects") == parse_json(R"([{"name": "x", "first": 0, "end": 1, "loose": []},
                       {"name": "y", "first": 1, "end": 2, "loose": [4]}])"));
}

TEST_CASE("mesh file: what has neither faces nor points is no object") {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\n";
  const json mesh =
      parse_json(shape_in_file("a.stl", "solid a\n" + facet + "endsolid a\nsolid b\nendsolid b\n"));
  CHECK(mesh.at("triangles").size() == 1);
  CHECK(!mesh.contains("objects"));
}

TEST_CASE("mesh file: halfspaces are planes, and a fault names the file") {
  const json planes = parse_json(shape_in_file("a.txt", "1 0 0 -1/3\n"));
  CHECK(planes.at("planes") == parse_json(R"([["3", "0", "0", "-1"]])"));
  const Error error = error_of([] { return shape_in_file("a.obj", "v 0 0\n"); });
  CHECK(error.code() == ErrorCode::Malformed);
  CHECK(std::string(error.what()).find("a.obj:1: ") == 0);
}
