// SPDX-License-Identifier: MIT
// Files as programs write them, and files of other formats. Volumes are those of the boxes that the
// files were made of (tests/data/cases/README.md).
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdlib>

#include "convexact/simplify.hpp"
#include "expect_error.hpp"
#include "io/file_kind.hpp"

using namespace convexact;

namespace {

std::string case_path(const std::string& name) {
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  return std::string(folder) + "/cases/" + name;
}

struct CaseFile {
  std::vector<SceneObject> objects;
  std::vector<std::string> notes;
};

CaseFile read_case(const std::string& name, SceneOptions options = {.decimal = Decimal::Exact}) {
  CaseFile found;
  options.on_note = [&](const std::string&, const std::string& note) {
    found.notes.push_back(note);
  };
  found.objects = read_scene({case_path(name)}, options);
  return found;
}

Rational case_volume(const std::string& name) {
  const CaseFile found = read_case(name);
  const auto hull = require_solid(measure_hull(
      found.objects.front().shape, {.area = false, .mean_width = false, .exact_volume = true}));
  return *hull.volume->exact;
}

// Of bytes under a name, as by kind_of_file() and the readers.
Mesh mesh_of_bytes(const std::string& bytes, const std::string& name, ReadOptions options = {}) {
  options.format = kind_of_file(bytes, name).mesh;
  REQUIRE(options.format);
  return read_mesh_bytes(bytes, options);
}

std::string complaint_about(const std::string& bytes, const std::string& name) {
  const Error error = error_of([&] { return mesh_of_bytes(bytes, name); });
  return error.what();
}

std::string bytes_of_float(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  std::string bytes;
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(bits >> (8 * k) & 0xFF);
  return bytes;
}

}  // namespace

TEST_CASE("odd files: each is read as the box that it was made of") {
  const struct {
    const char* name;
    int volume;
  } cases[] = {{"modelnet.off", 24},
               {"free_layout.off", 24},
               {"lrs.ine", 8},
               {"v_representation.ext", 24},
               {"qhull_n.txt", 1},
               {"header.xyz", 24},
               {"commas.xyz", 24},
               {"count.xyz", 24},
               {"two_corner_face.obj", 24},
               {"strips.ply", 24},
               {"trailing.stl", 24},
               {"rbox_c.txt", 1},
               {"qconvex_n.txt", 1},
               {"qconvex_p.txt", 1},
               {"qconvex_o.txt", 1},
               {"lrs_h.ine", 24},
               {"open3d_ascii.pcd", 24},
               {"open3d_cloud.pcd", 24},
               {"open3d_cloud.pts", 24},
               {"open3d.stl", 24},
               {"meshlab.off", 24},
               {"meshlab.dae", 24},
               {"meshlab.xyz", 24},
               {"numpy.csv", 24},
               {"numpy_semicolon.csv", 24},
               {"trimesh.ply", 24},
               {"trimesh.glb", 24}};
  for (const auto& c : cases) {
    CAPTURE(c.name);
    CHECK(case_volume(c.name) == c.volume);
  }
}

TEST_CASE("odd files: a note says what was skipped or guessed, and clean files have none") {
  const auto note = [](const char* name) {
    const CaseFile found = read_case(name);
    REQUIRE(found.notes.size() == 1);
    return found.notes[0];
  };
  CHECK(note("header.xyz") == "the first line, 'X Y Z Intensity', was skipped");
  CHECK(note("two_corner_face.obj") ==
        "1 face of fewer than 3 corners was skipped; the points count");
  CHECK(note("trailing.stl") == "2 bytes behind the last facet were skipped");
  CHECK(note("strips.ply") == "strips of triangles were read as 3 triangles");
  for (const char* name : {"modelnet.off", "commas.xyz", "count.xyz", "rbox_c.txt", "lrs.ine"}) {
    CAPTURE(name);
    CHECK(read_case(name).notes.empty());
  }
}

TEST_CASE("odd files: strips of triangles turn every second one") {
  const Mesh mesh = read_mesh(case_path("strips.ply"));
  CHECK(mesh.polygons == std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {2, 1, 3}, {4, 5, 6}});
}

TEST_CASE("odd files: what is not read is named, with what to do") {
  const struct {
    std::string bytes;
    const char* name;
    const char* says;
  } cases[] = {{"Kaydara FBX Binary  ", "a.fbx", "an FBX file"},
               {"; FBX 7.4.0", "a.fbx", "an FBX file"},
               {"\n<!DOCTYPE html>\n<html>", "bunny.obj", "an HTML page"},
               {"PK\x03\x04 3D/3dmodel.model", "a.zip", "a 3MF file"},
               {"PK\x03\x04", "a.zip", "unzip"},
               {"\x1F\x8B", "a.ply.gz", "gunzip"},
               {"\xFF\xFEv", "a.obj", "iconv"},
               {"ISO-10303-21;", "a.step", "a STEP file"},
               {"version https://git-lfs.github.com/spec/v1\n", "a.stl", "git lfs pull"},
               {"PXR-USDC", "a.usd", "a USD crate"},
               {"# vtk DataFile Version 3.0\n", "a.vtk", "a VTK file"},
               {"$MeshFormat\n", "a.msh", "a mesh of Gmsh or Ansys"},
               {"#VRML V2.0 utf8\n", "a.wrl", "a VRML file"},
               {"hello\n", "notes", "expected OBJ, OFF, PLY, STL"}};
  for (const auto& c : cases) {
    CAPTURE(c.says);
    const Error error = error_of([&] { return kind_of_file(c.bytes, c.name); });
    CHECK(error.code() == ErrorCode::Unreadable);
    CHECK(std::string(error.what()).find(c.says) != std::string::npos);
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
  }
  for (const auto& [name, says] : {std::pair{"meshlab.3mf", "3MF"},
                                   {"meshlab.wrl", "VRML"},
                                   {"meshio.vtk", "VTK"},
                                   {"open3d_compressed.pcd", "DATA binary"}}) {
    const Error error = error_of([&, file = name] { return read_case(file); });
    CHECK(exit_code(error.code()) == 3);
    CHECK(std::string(error.what()).find(says) != std::string::npos);
  }
  CHECK(error_of([&] { return read_case("lfs_pointer.obj"); }).code() == ErrorCode::Unreadable);
}

TEST_CASE("off: prefixes in any order, as MeshLab and others write them") {
  for (const std::string header : {"OFF", "COFF", "NOFF", "CNOFF", "NCOFF", "STNCOFF"}) {
    CAPTURE(header);
    CHECK(mesh_of_bytes(header + "\n1 0 0\n1 2 3 0 0 1 255 0 0 255\n", "a.off").points.size() == 1);
  }
}

TEST_CASE("clouds: separators, names of columns, counts") {
  CHECK(mesh_of_bytes("1;2;3\n4;5;6\n", "a.csv").points.doubles()[1] == Point(4, 5, 6));
  CHECK(mesh_of_bytes("1, 2, 3\n", "a.csv").points.doubles()[0] == Point(1, 2, 3));
  CHECK(mesh_of_bytes("\"id\",\"Y\",\"X\",\"Z\"\n7,2,1,3\n", "a.csv").points.doubles()[0] ==
        Point(1, 2, 3));
  CHECK(mesh_of_bytes("x y z label\n1 2 3 tree\n", "a.xyz").points.doubles()[0] == Point(1, 2, 3));
  CHECK(mesh_of_bytes("2\n1 2 3 40 255 0 0\n4 5 6 40 255 0 0\n", "a.pts").points.size() == 2);
  CHECK(mesh_of_bytes("3\n1 2 3\n4 5 6\n7 8 9\n", "a.pts").points.size() == 3);
  const Mesh fewer = mesh_of_bytes("5\n1 2 3\n4 5 6\n", "a.pts");
  CHECK(fewer.notes == std::vector<std::string>{"the file announces 5 points and has 2"});
}

TEST_CASE("clouds: a decimal comma is refused with a sentence") {
  const std::string says = "a decimal comma is not read: expected 1.5 for '1,5'";
  CHECK(complaint_about("1,5 2,0 3,1\n", "a.xyz").find(says) != std::string::npos);
  CHECK(complaint_about("1,5;2,0;3,1\n", "a.csv").find(says) != std::string::npos);
  CHECK(complaint_about("1,2\n", "a.csv").find("a decimal comma") != std::string::npos);
}

TEST_CASE("pcd: text and binary, further fields, points that are not finite") {
  const std::string header =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS rgb x y z\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
      "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\n";
  const Mesh text = mesh_of_bytes(header + "DATA ascii\n0 1 2 3\n0 4 5 6.5\n", "a.pcd");
  CHECK(text.points.doubles()[1] == Point(4, 5, 6.5));
  std::string binary = header + "DATA binary\n";
  for (const float x : {0.f, 1.f, 2.f, 3.f, 0.f, 4.f, 5.f, 6.5f}) binary += bytes_of_float(x);
  CHECK(mesh_of_bytes(binary, "a.pcd").points.doubles()[1] == Point(4, 5, 6.5));
  CHECK(complaint_about(binary.substr(0, binary.size() - 1), "a.pcd").find("expected 32 bytes") !=
        std::string::npos);
  CHECK(complaint_about(header + "DATA binary_compressed\n", "a.pcd").find("DATA binary") !=
        std::string::npos);

  const std::string bad = header + "DATA ascii\n0 1 2 3\n0 nan nan nan\n";
  CHECK(error_of([&] { return mesh_of_bytes(bad, "a.pcd"); }).code() == ErrorCode::NotFinite);
  const Mesh without = mesh_of_bytes(bad, "a.pcd", {.skip_bad = true});
  CHECK(without.points.size() == 1);
  CHECK(without.notes ==
        std::vector<std::string>{"1 point was skipped: a coordinate is not finite"});
  CHECK(mesh_of_bytes("1 2 3\ninf 0 0\n", "a.xyz", {.skip_bad = true}).points.size() == 1);
}

TEST_CASE("stl: two words for an end, facets that are not finite") {
  const auto facet = [](const std::string& last) {
    return "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex " + last +
           "\nend loop\nend facet\n";
  };
  const std::string good = "solid a\n" + facet("0 1 0") + "end solid\n";
  CHECK(mesh_of_bytes(good, "a.stl").polygons.size() == 1);
  const std::string bad = "solid a\n" + facet("0 1 0") + facet("nan 1 0") + "endsolid\n";
  const Error error = error_of([&] { return mesh_of_bytes(bad, "a.stl"); });
  CHECK(error.code() == ErrorCode::NotFinite);
  CHECK(error.line() == 13);
  const Mesh without = mesh_of_bytes(bad, "a.stl", {.skip_bad = true});
  CHECK(without.polygons.size() == 1);
  CHECK(without.points.size() == 3);
  REQUIRE(without.notes.size() == 1);
  CHECK(without.notes[0].starts_with("1 facet was skipped"));

  std::string binary(80, ' ');
  binary += std::string("\x01\0\0\0", 4) + std::string(12, '\0');
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, NAN, 0.f}) binary += bytes_of_float(x);
  binary += std::string(2, '\0');
  CHECK(complaint_about(binary, "a.stl").find("in triangle 0, found NaN") != std::string::npos);
  CHECK(mesh_of_bytes(binary, "a.stl", {.skip_bad = true}).points.size() == 2);
}

TEST_CASE("ine: an equation is two halfspaces; rays and lines are unbounded") {
  const auto halfspaces = read_halfspaces_bytes(
      "linearity 1 1\nbegin\n2 4 integer\n-1 1 0 0\n1 0 1 0\nend\n", HalfspaceFormat::Ine);
  REQUIRE(halfspaces.halfspaces.size() == 3);
  CHECK(halfspaces.halfspaces[2](RationalPoint(2, 0, 0)) > 0);
  CHECK(halfspaces.halfspaces[0](RationalPoint(0, 0, 0)) > 0);
  CHECK(error_of([] {
          return read_halfspaces_bytes("linearity 1 3\nbegin\n1 4 integer\n1 0 0 1\nend\n",
                                       HalfspaceFormat::Ine);
        }).code() == ErrorCode::Malformed);
  const std::string ray = "V-representation\nbegin\n2 4 integer\n1 0 0 0\n0 1 0 0\nend\n";
  const Error error = error_of([&] { return mesh_of_bytes(ray, "a.ext"); });
  CHECK(error.code() == ErrorCode::NoInterior);
  CHECK(std::string(error.what()).find("row 1 (counted from 0) is a ray") != std::string::npos);
  const std::string line =
      "V-representation\nlinearity 1 2\nbegin\n2 4 integer\n1 0 0 0\n0 1 0 0\nend\n";
  CHECK(complaint_about(line, "a.ext").find("is a line") != std::string::npos);
}

TEST_CASE("obj, off, ply: faces of one or two corners are skipped, their points are not") {
  const Mesh obj = mesh_of_bytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1\nf 1 2\nf 1 2 3\n", "a.obj");
  CHECK(obj.polygons.size() == 1);
  CHECK(obj.points.size() == 3);
  CHECK(obj.notes ==
        std::vector<std::string>{"2 faces of fewer than 3 corners were skipped; the points count"});
  const Mesh off =
      mesh_of_bytes("OFF\n3 2 0\n0 0 0 255 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n", "a.off");
  CHECK(off.polygons.size() == 1);
  CHECK(off.notes.size() == 1);
}
