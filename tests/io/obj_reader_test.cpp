// SPDX-License-Identifier: MIT
// OBJ files as found in the wild and broken ones. Expected values are written out by hand.
#include <doctest/doctest.h>

#include <cstdlib>

#include "convexact/io.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

using Polygon = std::vector<std::uint32_t>;

Mesh obj(std::string_view text, Decimal decimal = Decimal::Nearest) {
  return read_mesh_bytes(text, {.decimal = decimal, .format = MeshFormat::Obj});
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("read_obj: nothing, and points without faces") {
  CHECK(obj("").points.size() == 0);
  CHECK(obj("\n\n# nothing\n").points.size() == 0);
  const Mesh mesh = obj("v 1 2 3");
  CHECK(mesh.points.doubles()[0] == Point(1, 2, 3));
  CHECK(mesh.polygons.empty());
  REQUIRE(mesh.parts.size() == 1);
  CHECK(mesh.parts[0].last_polygon == 0);
}

TEST_CASE("read_obj: every spelling of a corner") {
  for (const std::string face :
       {"f 1 2 3 4", "f -4 -3 -2 -1", "f 1/9 2/8 3/7 4/6", "f 1//9 2//8 3//-7 4//6",
        "f 1/9/1 2/8/1 3/7/1 4/6/1", "f\t1\t 2 \t3 4  ", "f 1 2 \\\n 3 4", "fo 1 -3 3/1 4//1"}) {
    CAPTURE(face);
    CHECK(obj(kSquare + face).polygons == std::vector<Polygon>{{0, 1, 2, 3}});
  }
}

TEST_CASE("read_obj: line ends, byte order mark, comments, weights, colours, passed-over lines") {
  const Mesh expected = obj(kSquare + "f 1 2 3\n");
  for (const std::string text :
       {"v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
        "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3",
        "\xEF\xBB\xBFv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 .5 .5 .5\nv 0 1 0 1 0 0 0\nf 1 2 3 # why not",
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nvt 0 0\nv 1 1 0\nv 0 1 0\nusemtl m\ns off\n"
        "  f 1 2 3\nl 1 2\np 1",
        "v 0 0 0\nv 1 0 0\nl 1 2 \\\n 1\nv 1 1 0\nv 0 1 0\nparm u 0\\\r\n1\nf 1 2 3"}) {
    CAPTURE(text);
    const Mesh mesh = obj(text);
    CHECK(mesh.polygons == expected.polygons);
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK(mesh.points.doubles()[k] == expected.points.doubles()[k]);
    }
  }
}

TEST_CASE("read_obj: a backslash that joins the last line with nothing ends it") {
  for (const std::string end :
       {"\\", " \\", "\\\n", " \\\r\n", " \\\r", " \\\n\\", " \\\n \\\n\n"}) {
    CAPTURE(end);
    CHECK(obj(kSquare + "f 1 2 3 4" + end).polygons == std::vector<Polygon>{{0, 1, 2, 3}});
    const Mesh mesh = obj("v 1 2 3" + end);
    REQUIRE(mesh.points.size() == 1);
    CHECK(mesh.points.doubles()[0] == Point(1, 2, 3));
    CHECK(obj(end).points.size() == 0);
  }
}

TEST_CASE("read_obj: an index of any length, and where it ends") {
  for (const std::string face : {"f 01 0000000002 000000000000000000003 4", "f 1\v2\f3 4 #5",
                                 "f 1 2 3\\\n4", "f 1 2 3 \\\r\n\\\n4\\", "f 1 2 3 4\r"}) {
    CAPTURE(face);
    CHECK(obj(kSquare + face).polygons == std::vector<Polygon>{{0, 1, 2, 3}});
  }
  for (const std::string index : {"999999999",   "1000000000",   "2147483647",
                                  "2147483648",  "4294967297",   "18446744073709551617",
                                  "-2147483648", "-2147483649",  "-21474836480",
                                  "0",           "000000000000", "-0",
                                  "-",           "--1",          "+1",
                                  "1-",          "1#",           "1\\2",
                                  "1.",          "1/",           "/1"}) {
    CAPTURE(index);
    const Error error = error_of([&] { return obj(kSquare + "\nf 1 2 " + index + " 3\n"); });
    CHECK(error.code() == ErrorCode::Malformed);
    CHECK(error.line() == 6);
  }
}

TEST_CASE("read_obj: of points only, polygons are checked but neither they nor parts are kept") {
  const auto read = [](const std::string& text, bool points_only) {
    return read_mesh_bytes(text, {.format = MeshFormat::Obj, .points_only = points_only});
  };
  const std::string text = "g a\n" + kSquare + "f 1 2 3\nf 1 2\no b\nv 5 5 5\nf 1/1 2/1 -1/1\n";
  const Mesh mesh = read(text, true);
  CHECK(mesh.points.size() == 5);
  CHECK(mesh.polygons.empty());
  CHECK(mesh.parts.empty());
  CHECK(mesh.notes == read(text, false).notes);
  for (const std::string face : {"f 1 2 9", "f 1 2 0", "f 1 2 x", "f", "f 1 2 -6", "f 1 2 3/"}) {
    CAPTURE(face);
    const auto refused = [&](bool points_only) {
      return std::string(error_of([&] { return read(text + face, points_only); }).what());
    };
    CHECK(refused(true) == refused(false));
  }
}

TEST_CASE("read_obj: points may follow the faces that use them") {
  CHECK(obj("f 1 2 3\n" + kSquare).polygons == std::vector<Polygon>{{0, 1, 2}});
}

TEST_CASE("read_obj: groups become parts, empty ones vanish") {
  const Mesh mesh = obj(kSquare +
                        "f 1 2 3\no first part \ng none\ng second\nf 1 2 4\nf 1 3 4\n"
                        "g second\nf 2 3 4\no last\n");
  REQUIRE(mesh.parts.size() == 2);
  CHECK(mesh.parts[0].name == "");
  CHECK(mesh.parts[0].first_polygon == 0);
  CHECK(mesh.parts[0].last_polygon == 1);
  CHECK(mesh.parts[1].name == "second");
  CHECK(mesh.parts[1].first_polygon == 1);
  CHECK(mesh.parts[1].last_polygon == 4);
}

TEST_CASE("read_obj: decimals as spelled") {
  const Mesh mesh = obj("v 0.1 1e-400 -5.\n", Decimal::Exact);
  const RationalPoint point = mesh.points[PointId(0)];
  CHECK(to_string(point[0]) == "1/10");
  CHECK(point[1] == parse_rational("1e-400"));
  CHECK(point[2] == -5);
  CHECK(mesh.points.doubles()[0] == Point(0.1, 0, -5));
}

TEST_CASE("read_obj: every error has its line and says what was expected") {
  struct Case {
    std::string text;
    std::size_t line;
    ErrorCode code;
    const char* expected;
  };
  const auto malformed = ErrorCode::Malformed, not_finite = ErrorCode::NotFinite;
  for (const Case& c : std::vector<Case>{
           {"v 0 0\n", 1, malformed, "expected three coordinates, found the end of the line"},
           {"\n\nv 0 0 zero\n", 3, malformed, "expected a number, found 'zero'"},
           {"v 0 0 0 x", 1, malformed, "expected a number, found 'x'"},
           {"v 0 0 0 1 1", 1, malformed, "found 5 numbers"},
           {"v 0 0 0 1 1 1 1 1", 1, malformed, "found 8 numbers"},
           {"v 0 0 \\\n \\\n nan", 3, not_finite, "expected a finite number, found 'nan'"},
           {"v 0 0 -inf", 1, not_finite, "'-inf'"},
           {"# x\r\nv 0 1e309 0", 2, not_finite, "'1e309'"},
           {kSquare + "f 1 2 5\nf 1 2 3\n", 5, malformed, "one of 4 points, found 5"},
           {kSquare + "f 1 2 -5", 5, malformed, "4 points so far, found '-5'"},
           {kSquare + "f 0 1 2", 5, malformed, "expected a corner"},
           {kSquare + "f 1 2 3/", 5, malformed, "expected a corner"},
           {kSquare + "f 1 2 3//", 5, malformed, "expected a corner"},
           {kSquare + "f 1 2 3/1/1/1", 5, malformed, "expected a corner"},
           {kSquare + "f 1 2 3.0", 5, malformed, "expected a corner"},
           {kSquare + "f 1 2 99999999999", 5, malformed, "expected a corner"},
           {kSquare + "f", 5, malformed, "expected the corners of a polygon, found the end"},
           {kSquare + "f 1 2\\ 3", 5, malformed, "expected a corner"},
           {kSquare + "f 1 2 3 \\\\", 5, malformed, "expected a corner"},
           {"ply\n", 1, malformed, "expected an OBJ statement such as v, f, o or g, found 'ply'"},
           {std::string("\0\0\0", 3), 1, malformed, "found '"},
       }) {
    CAPTURE(c.text);
    const Error error = error_of([&] { return obj(c.text); });
    CHECK(error.code() == c.code);
    CHECK(error.line() == c.line);
    CHECK(std::string(error.what()).find(c.expected) != std::string::npos);
  }
}

TEST_CASE("read_mesh: the shipped meshes have the documented sizes") {
  const std::string data = std::getenv("CONVEXACT_TEST_DATA");
  CHECK(read_mesh(data + "/bunny.obj").points.size() == 35947);
  CHECK(read_mesh(data + "/bunny.obj").polygons.size() == 69451);
  CHECK(read_mesh(data + "/spot.obj").points.size() == 2930);
  CHECK(read_mesh(data + "/teapot.obj").polygons.size() == 6320);
}

TEST_CASE("read_mesh: what cannot be read is named") {
  const std::string data = std::getenv("CONVEXACT_TEST_DATA");
  for (const std::string& path : {data, data + "/none.obj"}) {
    const Error error = error_of([&] { return read_mesh(path); });
    CHECK(error.code() == ErrorCode::Unreadable);
    CHECK(std::string(error.what()).starts_with(path + ": cannot be read: "));
  }
}

TEST_CASE("OBJ: an object is its points, those that no face uses as well") {
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  using Points = std::vector<std::uint32_t>;
  const auto parts_of = [](const std::string& bytes) {
    return read_mesh_bytes(bytes, {.format = MeshFormat::Obj}).parts;
  };
  SUBCASE("one has no face") {
    const auto parts = parts_of("o a\n" + tetrahedron + faces + "o cloud\n" + tetrahedron);
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].loose.empty());
    CHECK(parts[1].name == "cloud");
    CHECK(parts[1].first_polygon == parts[1].last_polygon);
    CHECK(parts[1].loose == Points{4, 5, 6, 7});
  }
  SUBCASE("none has a face") {
    const auto parts = parts_of("o a\n" + tetrahedron + "o b\n" + tetrahedron);
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].loose == Points{0, 1, 2, 3});
    CHECK(parts[1].loose == Points{4, 5, 6, 7});
  }
  SUBCASE("points under one are the corners of another") {
    const auto parts =
        parts_of("o corners\n" + tetrahedron + "g a\nf 1 3 2\nf 1 2 4\ng b\nf 1 4 3\n");
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].name == "a");
    CHECK(parts[1].name == "b");
  }
  SUBCASE("what stands before the first belongs to none") {
    const auto parts = parts_of("v 9 9 9\no a\n" + tetrahedron + "f 2 4 3\no b\nf 2 3 5\n");
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].loose.empty());
    CHECK(parts[1].loose.empty());
  }
  SUBCASE("one name twice in a row is one part, also if what stood between them is gone") {
    const auto parts =
        parts_of("o a\n" + tetrahedron + "f 1 3 2\no b\nv 2 2 2\no a\nf 1 2 5\nv 7 7 7\n");
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].last_polygon == 2);
    CHECK(parts[0].loose == Points{3, 5});
  }
}
