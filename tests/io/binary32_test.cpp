// SPDX-License-Identifier: MIT
// Meshes whose numbers are binary32: every format, text and binary. Expected values are C++
// literals of type float, rounded by the compiler.
#include <doctest/doctest.h>

#include "convexact/io.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

Mesh read(std::string_view bytes, MeshFormat format) {
  return read_mesh_bytes(bytes, {.decimal = Decimal::Nearest32, .format = format});
}

// A little above the middle between 1 and the next binary32 number, and the double next to it is
// that middle.
const std::string kAbove = "1.000000059604644775390625000001";
constexpr double kNext = 1 + 1.0 / (1 << 23);

std::string ply_of(const std::string& format, const std::string& type, const std::string& body) {
  return "ply\nformat " + format + " 1.0\nelement vertex 1\nproperty " + type +
         " x\nproperty uchar y\nproperty uchar z\nend_header\n" + body;
}

std::string little_endian(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  std::string bytes;
  for (int k = 0; k < 8; ++k) bytes += static_cast<char>(bits >> (8 * k));
  return bytes + std::string(2, '\0');
}

}  // namespace

TEST_CASE("binary32: decimals of every text format mean the nearest binary32 number (#13)") {
  const std::string point = "0.1 -2e-3 " + kAbove + "\n";
  const Point expected(0.1f, -2e-3f, kNext);
  for (const auto& [text, format] : std::vector<std::pair<std::string, MeshFormat>>{
           {"v " + point, MeshFormat::Obj},
           {"OFF\n1 0 0\n" + point, MeshFormat::Off},
           {"ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
            "property double z\nend_header\n" +
                point,
            MeshFormat::Ply},
           {point, MeshFormat::Xyz}}) {
    const std::string bytes = text;  // Clang 14 captures no bindings
    CAPTURE(bytes);
    const Mesh mesh = read(bytes, format);
    REQUIRE(mesh.points.size() == 1);
    CHECK(mesh.points.doubles()[0] == expected);
    CHECK(mesh.points.is_binary());
  }
}

TEST_CASE("binary32: points of a text STL that become equal are one (#13)") {
  const std::string text =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0.1 0 0\nvertex 0.100000001 0 0\n"
      "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  CHECK(read_mesh_bytes(text, {.format = MeshFormat::Stl}).points.size() == 3);
  const Mesh mesh = read(text, MeshFormat::Stl);
  CHECK(mesh.points.size() == 2);
  CHECK(mesh.polygons[0] == std::vector<std::uint32_t>{0, 0, 1});
}

TEST_CASE("binary32: the numbers of a binary PLY are rounded, of doubles and of integers (#13)") {
  const auto x_of = [](const std::string& type, const std::string& body) {
    return read(ply_of("binary_little_endian", type, body), MeshFormat::Ply).points.doubles()[0];
  };
  CHECK(x_of("double", little_endian(0.1)).x() == 0.1f);
  CHECK(x_of("double", little_endian(1 + 3.0 / (1 << 24))).x() == 1 + 2.0 / (1 << 23));
  CHECK(x_of("double", little_endian(1e-46)).x() == 0);
  CHECK(x_of("int", std::string("\x01\0\0\x01\0\0", 6)).x() == 16777216);
}

TEST_CASE("binary32: what rounds beyond its largest number is refused, with the place (#13)") {
  const Error in_text = error_of([] { return read("0 0 0\n1 1 -3.5e38\n", MeshFormat::Xyz); });
  CHECK(in_text.code() == ErrorCode::NotFinite);
  CHECK(in_text.line() == 2);
  CHECK(std::string(in_text.what()).find("binary32") != std::string::npos);
  const Error in_bytes = error_of([] {
    return read(ply_of("binary_little_endian", "double", little_endian(-1e39)), MeshFormat::Ply);
  });
  CHECK(in_bytes.code() == ErrorCode::NotFinite);
  CHECK(std::string(in_bytes.what()).find("point 0, found one beyond binary32") !=
        std::string::npos);
}
