// SPDX-License-Identifier: MIT
// Files cut off anywhere, files with any byte changed, and headers that promise too much: each is
// read or refused by a documented error, and none allocates much more than its own size.
#include <doctest/doctest.h>

#include "allocation_watch.hpp"
#include "convexact/io.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

Mesh small_mesh() {
  Mesh mesh;
  mesh.points =
      PointSet(std::vector<Point>{{0, 0, 0}, {1.5, 0, 0}, {0, 0x1p-20, 0}, {0, 0, -1e20f}});
  mesh.polygons = {{0, 1, 2}, {2, 1, 0, 3}};
  mesh.parts = {{"", 0, 2}};
  return mesh;
}

Mesh in_binary32() {
  Mesh mesh = small_mesh();
  mesh.points =
      PointSet(std::vector<Point>{{0, 0, 0}, {1.5, 0, 0}, {0, 0x1p-20, 0}, {0, 0, -1e20f}});
  return mesh;
}

const std::string kCollada =
    R"(<COLLADA><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a">
0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common><accessor source="#a" count="4" stride="3"/>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist><input semantic="VERTEX" source="#v"/><vcount>3 4</vcount><p>0 1 2 0 1 2 3</p></polylist>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node>
<rotate>0 0 1 30</rotate><matrix>2 0 0 0 0 1 0 0 0 0 1 9 0 0 0 1</matrix><instance_geometry url="#g"/>
</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

struct Sample {
  MeshFormat format;
  std::string bytes;
};

std::vector<Sample> samples() {
  std::vector<Sample> all;
  for (const MeshFormat format :
       {MeshFormat::Obj, MeshFormat::Off, MeshFormat::Ply, MeshFormat::Stl}) {
    all.push_back({format, write_mesh(small_mesh(), format)});
  }
  for (const MeshFormat format : {MeshFormat::Ply, MeshFormat::Stl}) {
    all.push_back(
        {format, write_mesh(small_mesh(), format, {Precision::Binary32, Encoding::Binary})});
  }
  all.push_back({MeshFormat::Gltf, write_mesh(in_binary32(), MeshFormat::Gltf)});
  all.push_back({MeshFormat::Collada, kCollada});
  return all;
}

// Whether it was read. Any exception but an Error of exit code 3 fails the test.
bool is_read(std::string_view bytes, std::optional<MeshFormat> format) {
  for (const Decimal decimal : {Decimal::Nearest, Decimal::Exact}) {
    try {
      (void)read_mesh_bytes(bytes, {.decimal = decimal, .format = format});
    } catch (const Error& error) {
      REQUIRE(exit_code(error.code()) == 3);
      return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("read_mesh: a file cut off anywhere is read or refused") {
  for (const Sample& sample : samples()) {
    const bool counted = sample.format == MeshFormat::Ply || sample.format == MeshFormat::Stl;
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      const std::string prefix = sample.bytes.substr(0, size);
      (void)is_read(prefix, {});
      const bool read = is_read(prefix, sample.format);
      // What announces its length or its end shows that it was cut; up to the last few bytes, by
      // which "1e20" may become "1e2" and "endsolid \n" remains "endsolid".
      if (counted && size + 3 < sample.bytes.size()) {
        CAPTURE(prefix);
        CHECK_FALSE(read);
      }
    }
  }
}

TEST_CASE("read_mesh: a file with any byte changed is read or refused") {
  for (const Sample& sample : samples()) {
    for (std::size_t k = 0; k < sample.bytes.size(); ++k) {
      for (const char c : {'\0', '\xFF', '9', ' ', '\n', '\r', '-', 'e', '\\', '#', '/'}) {
        std::string bytes = sample.bytes;
        bytes[k] = c;
        (void)is_read(bytes, sample.format);
      }
    }
  }
}

TEST_CASE("read_mesh: headers that promise too much are refused before memory is taken") {
  const std::string count = "4294967295";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string points = "element vertex " + count + "\n" + xyz;
  const std::string list = "element face " + count + "\nproperty list uchar int vertex_indices\n";
  std::vector<Sample> hostile = {
      {MeshFormat::Off, "OFF\n" + count + " 0 0\n"},
      {MeshFormat::Off, "OFF\n0 " + count + " 0\n"},
      {MeshFormat::Off, "OFF\n1 1 0\n0 0 0\n" + count + " 0 0 0\n"},
      {MeshFormat::Obj, "v 0 0 0\nf 1 1 " + count + "\n"},
      {MeshFormat::Stl, std::string(80, ' ') + "\xFF\xFF\xFF\xFF" + std::string(50, '\0')}};
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string start = "ply\nformat " + format + " 1.0\n";
    for (const std::string& elements :
         {points, "element vertex 0\n" + xyz + list,
          "element x " + count + "\nproperty list char char y\nelement vertex 0\n" + xyz,
          "element vertex 1\n" + xyz + "property list uint double more\n"}) {
      hostile.push_back(
          {MeshFormat::Ply, start + elements + "end_header\n" + std::string(20, '\x7F')});
    }
  }
  for (const Sample& sample : hostile) {
    CAPTURE(sample.bytes);
    largest_allocation = 0;
    CHECK_FALSE(is_read(sample.bytes, sample.format));
    CHECK(largest_allocation < 10000);
  }
  // Rows of nothing: there is nothing to refuse, and nothing to wait for.
  CHECK(is_read(
      "ply\nformat ascii 1.0\nelement x " + count + "\nelement vertex 0\n" + xyz + "end_header\n",
      MeshFormat::Ply));
}
