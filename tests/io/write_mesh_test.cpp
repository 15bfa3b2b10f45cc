// SPDX-License-Identifier: MIT
// What is written is read back to the last bit, in every format; the written text is also compared
// with files written out by hand.
#include <doctest/doctest.h>

#include <cmath>

#include "convexact/io.hpp"
#include "expect_error.hpp"
#include "property.hpp"
#include "same_mesh.hpp"

using namespace convexact;

namespace {

struct Format {
  MeshFormat format;
  MeshWriteOptions options;
};
constexpr Precision kDouble = Precision::Binary64, kFloat = Precision::Binary32;
const std::vector<Format> kDoubleFormats = {{MeshFormat::Obj, {}},
                                            {MeshFormat::Off, {}},
                                            {MeshFormat::Ply, {}},
                                            {MeshFormat::Ply, {kDouble, Encoding::Binary}},
                                            {MeshFormat::Stl, {}}};
const std::vector<Format> kFloatFormats = {
    {MeshFormat::Obj, {kFloat, Encoding::Text}},   {MeshFormat::Off, {kFloat, Encoding::Text}},
    {MeshFormat::Ply, {kFloat, Encoding::Text}},   {MeshFormat::Ply, {kFloat, Encoding::Binary}},
    {MeshFormat::Stl, {kFloat, Encoding::Binary}}, {MeshFormat::Stl, {kDouble, Encoding::Binary}}};

Mesh write_and_read(const Mesh& mesh, const Format& f) {
  return read_mesh_bytes(write_mesh(mesh, f.format, f.options), {.format = f.format});
}

// Any doubles (or floats), any polygons with at least three corners.
Mesh make_mesh(const std::vector<std::uint64_t>& bits,
               const std::vector<std::vector<std::uint32_t>>& corners, Precision precision) {
  const double tiniest = precision == kFloat ? 0x1p-149 : 0x1p-1074;
  std::vector<Point> points(1 + bits.size() / 3, Point(0, -0.0, tiniest));
  for (std::size_t k = 0; k + 1 < bits.size(); ++k) {
    double x = std::bit_cast<double>(bits[k]);
    if (precision == kFloat) x = std::bit_cast<float>(static_cast<std::uint32_t>(bits[k]));
    points[k / 3][static_cast<int>(k % 3)] = std::isfinite(x) ? x : 1.0;
  }
  Mesh mesh;
  for (const auto& raw : corners) {
    std::vector<std::uint32_t> polygon = {0, 0, 0};
    for (const std::uint32_t corner : raw) {
      polygon.push_back(corner % static_cast<std::uint32_t>(points.size()));
    }
    mesh.polygons.push_back(polygon);
  }
  mesh.points = PointSet(std::move(points));
  mesh.parts.push_back({"", 0, mesh.polygons.size()});
  return mesh;
}

// What STL keeps of a mesh: each point that a triangle uses, by value.
std::vector<Point> triangle_corners(const Mesh& mesh) {
  std::vector<Point> corners;
  for (const auto& polygon : mesh.polygons) {
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      for (const std::size_t i : {std::size_t(0), k - 1, k}) {
        corners.push_back(mesh.points.doubles()[polygon[i]]);
      }
    }
  }
  return corners;
}

Mesh two_parts() {
  Mesh mesh;
  mesh.points = PointSet(
      std::vector<Point>{{0, 0, 0}, {1e300, 0, 0}, {0, 0.1, 0}, {0, 0, -5e-324}, {1, 2, 3}});
  mesh.polygons = {{0, 1, 2}, {2, 1, 0, 3}};
  mesh.parts = {{"upper part", 0, 1}, {"#\\", 1, 2}};
  return mesh;
}

}  // namespace

TEST_CASE("write_mesh: any mesh comes back to the last bit") {
  for (const bool is_float : {false, true}) {
    for (const Format& f : is_float ? kFloatFormats : kDoubleFormats) {
      if (f.format == MeshFormat::Stl) continue;
      check_property("comes back", [&](const std::vector<std::uint64_t>& bits,
                                       const std::vector<std::vector<std::uint32_t>>& corners) {
        const Mesh mesh = make_mesh(bits, corners, is_float ? kFloat : kDouble);
        const Mesh back = write_and_read(mesh, f);
        RC_ASSERT(same_points(back.points, mesh.points));
        RC_ASSERT(back.polygons == mesh.polygons);
        RC_ASSERT(same_parts(back, mesh));
      });
    }
  }
}

TEST_CASE("write_mesh: STL gives the same triangles back") {
  for (const Format& f : {kDoubleFormats.back(), kFloatFormats.back()}) {
    check_property("triangles come back",
                   [&](const std::vector<std::uint64_t>& bits,
                       const std::vector<std::vector<std::uint32_t>>& corners) {
                     const bool is_float = f.options.encoding == Encoding::Binary;
                     const Mesh mesh = make_mesh(bits, corners, is_float ? kFloat : kDouble);
                     const Mesh back = write_and_read(mesh, f);
                     RC_ASSERT(triangle_corners(back) == triangle_corners(mesh));
                   });
  }
}

TEST_CASE("write_mesh: OBJ and STL as text keep parts") {
  const Mesh mesh = two_parts();
  const Mesh obj = write_and_read(mesh, {MeshFormat::Obj, {}});
  CHECK(same_points(obj.points, mesh.points));
  CHECK(same_parts(obj, mesh));
  const Mesh stl = write_and_read(mesh, {MeshFormat::Stl, {}});
  REQUIRE(stl.parts.size() == 2);
  CHECK(stl.parts[1].name == "#\\");
  CHECK(stl.parts[1].last_polygon == 3);
}

TEST_CASE("write_mesh: the bytes") {
  const Mesh mesh = two_parts();
  CHECK(write_mesh(mesh, MeshFormat::Obj) ==
        "v 0 0 0\nv 1e+300 0 0\nv 0 0.1 0\nv 0 0 -5e-324\nv 1 2 3\n"
        "o upper part\nf 1 2 3\no #\\\nf 3 2 1 4\n");
  CHECK(write_mesh(mesh, MeshFormat::Off) ==
        "OFF\n5 2 0\n0 0 0\n1e+300 0 0\n0 0.1 0\n0 0 -5e-324\n1 2 3\n3 0 1 2\n4 2 1 0 3\n");
  CHECK(write_mesh(mesh, MeshFormat::Ply) ==
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
        "property double z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1e+300 0 0\n0 0.1 0\n0 0 -5e-324\n1 2 3\n3 0 1 2\n4 2 1 0 3\n");
  Mesh triangle;
  triangle.points = PointSet(std::vector<Point>{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}});
  triangle.polygons = {{0, 1, 2}};
  CHECK(write_mesh(triangle, MeshFormat::Stl) ==
        "solid \nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 3 0\n"
        "endloop\nendfacet\nendsolid \n");
  const std::string binary = write_mesh(triangle, MeshFormat::Stl, {.encoding = Encoding::Binary});
  CHECK(binary.size() == 134);
  CHECK(binary.substr(80, 4) == std::string("\1\0\0\0", 4));
  CHECK(binary.substr(84 + 24, 4) == std::string("\0\0\0\x40", 4));  // 2.0f, x of the second point
}

TEST_CASE("write_mesh: a polygon of more than 255 corners") {
  Mesh mesh = two_parts();
  mesh.polygons[0].resize(300, 4);
  for (const Encoding encoding : {Encoding::Text, Encoding::Binary}) {
    CHECK(write_and_read(mesh, {MeshFormat::Ply, {kDouble, encoding}}).polygons == mesh.polygons);
  }
}

TEST_CASE("write_mesh: what a format cannot hold is refused") {
  const Mesh mesh = two_parts();
  const auto code = [](const Mesh& m, MeshFormat format, MeshWriteOptions options) {
    return error_of([&] { return write_mesh(m, format, options); }).code();
  };
  const ErrorCode unrepresentable = ErrorCode::Unrepresentable;
  CHECK(code(mesh, MeshFormat::Stl, {.encoding = Encoding::Binary}) == unrepresentable);
  CHECK(code(mesh, MeshFormat::Ply, {.precision = kFloat}) == unrepresentable);
  CHECK(code(mesh, MeshFormat::Obj, {.precision = kFloat}) == unrepresentable);
  CHECK(code(mesh, MeshFormat::Obj, {.encoding = Encoding::Binary}) == ErrorCode::InvalidArgument);
  Mesh rational = mesh;
  rational.points = PointSet(std::vector<RationalPoint>(5, RationalPoint(Rational(1, 3), 0, 0)));
  CHECK(code(rational, MeshFormat::Obj, {}) == unrepresentable);
  Mesh named = mesh;
  named.parts[0].name = "a\nf 1 1 1";
  CHECK(code(named, MeshFormat::Obj, {}) == ErrorCode::InvalidArgument);
}
