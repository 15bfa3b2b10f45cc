// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "convexact/io.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

Mesh read(std::string_view text, Decimal decimal = Decimal::Nearest) {
  return read_mesh_bytes(text, {.decimal = decimal, .format = MeshFormat::Xyz});
}

}  // namespace

TEST_CASE("xyz: points, comments, further numbers") {
  const Mesh mesh = read("# a scan\r\n1 -2.5 3e2 # here\n\n0 0 0  0 0 1  255 0 0\n");
  REQUIRE(mesh.points.size() == 2);
  CHECK(mesh.points.doubles()[0] == Point(1, -2.5, 300));
  CHECK(mesh.polygons.empty());
  CHECK(read("").points.size() == 0);
  CHECK(read("0.1 0 0\n", Decimal::Exact).points[PointId(0)].x() == Rational(1, 10));
}

TEST_CASE("xyz: what is wrong, and in which line") {
  struct Case {
    const char* text;
    ErrorCode code;
  };
  for (const Case& c : {Case{"0 0 0\n1 2\n", ErrorCode::Malformed},
                        Case{"0 0 0\n1 2 three\n", ErrorCode::Malformed},
                        Case{"0 0 0\n1 2 3 red\n", ErrorCode::Malformed},
                        Case{"0 0 0\n1 2 nan\n", ErrorCode::NotFinite},
                        Case{"0 0 0\n1 2 1e999\n", ErrorCode::NotFinite}}) {
    CAPTURE(c.text);
    const Error error = error_of([&] { return read(c.text); });
    CHECK(error.code() == c.code);
    CHECK(error.line() == 2);
  }
}

TEST_CASE("xyz: the points that are written are read again") {
  Mesh mesh;
  mesh.points = PointSet(std::vector<Point>{{0.1, -5e-324, 1e308}, {0, 1, 1.0 / 3}});
  mesh.polygons = {{0, 1, 0}};
  const std::string bytes = write_mesh(mesh, MeshFormat::Xyz);
  const Mesh again = read(bytes);
  CHECK(again.points.doubles()[0] == mesh.points.doubles()[0]);
  CHECK(again.points.doubles()[1] == mesh.points.doubles()[1]);
  CHECK(mesh_format_of_content(bytes) == MeshFormat::Xyz);
}
