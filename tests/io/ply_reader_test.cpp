// SPDX-License-Identifier: MIT
// PLY files in their three encodings, and broken ones. Expected values are written out by hand.
#include <doctest/doctest.h>

#include "convexact/io.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

Mesh ply(std::string_view text) { return read_mesh_bytes(text, {.format = MeshFormat::Ply}); }

std::string header(const std::string& format, const std::string& declarations) {
  return "ply\nformat " + format + " 1.0\n" + declarations + "end_header\n";
}

const std::string kTriangle =
    "comment made by hand\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\n";

// The bytes of small integers and floats, most significant first.
std::string big(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) text += static_cast<char>(byte);
  return text;
}

void check_triangle(const Mesh& mesh) {
  REQUIRE(mesh.points.size() == 3);
  CHECK(mesh.points.doubles()[0] == Point(0, 0, 0));
  CHECK(mesh.points.doubles()[1] == Point(1, 0, 0));
  CHECK(mesh.points.doubles()[2] == Point(0, -2, 0));
  CHECK(mesh.polygons == std::vector<std::vector<std::uint32_t>>{{0, 1, 2}});
}

}  // namespace

TEST_CASE("read_ply: text") {
  check_triangle(ply(header("ascii", kTriangle) + "0 0 0\n1 0 0\n\n0 -2 0\n3 0 1 2\n"));
  // A decimal means itself, whatever type the header gives it.
  CHECK(
      ply(header("ascii", kTriangle) + "0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2").points.doubles()[0].x() ==
      0.1);
  // Properties in any order, lists in points, elements before, between and behind.
  check_triangle(
      ply(header("ascii",
                 "obj_info x\nelement camera 1\nproperty list int float view\nelement nothing 7\n"
                 "element vertex 3\nproperty uchar red\nproperty double z\nproperty int32 x\n"
                 "property list uint8 short tags\nproperty float64 y\nelement face 1\n"
                 "property float quality\nproperty list uint16 uint32 vertex_index\n"
                 "element edge 2\nproperty int vertex1\nproperty int vertex2\n") +
          "2 .5 nan\n9 0 0 0 0\n9 0 1 2 7 7 0\n9 0 0 1 7 -2\n.25 3 0 1 2\n0 1\n1 2\n"));
}

TEST_CASE("read_ply: binary of both byte orders, with all types") {
  const std::string declarations =
      "element extra 2\nproperty char a\nproperty short b\nproperty list uchar double c\n"
      "element vertex 3\nproperty float x\nproperty double y\nproperty char z\n"
      "element face 1\nproperty uchar flag\nproperty list ushort uint vertex_indices\n";
  const std::string one = big({0x3F, 0x80, 0, 0}), zero4(4, '\0'), zero8(8, '\0');
  const std::string minus_two = big({0xC0, 0}) + std::string(6, '\0');
  const std::string body = big({1, 0, 2, 1}) + zero8 + big({1, 0, 2, 0}) +  // extra
                           zero4 + zero8 + big({0}) + one + zero8 + big({0}) + zero4 + minus_two +
                           big({0}) +  // vertex
                           big({7, 0, 3}) + zero4 + big({0, 0, 0, 1}) + big({0, 0, 0, 2});  // face
  check_triangle(ply(header("binary_big_endian", declarations) + body));
  const std::string reversed_one = big({0, 0, 0x80, 0x3F});
  const std::string reversed_minus_two = std::string(6, '\0') + big({0, 0xC0});
  const std::string little = big({1, 2, 0, 1}) + zero8 + big({1, 2, 0, 0}) + zero4 + zero8 +
                             big({0}) + reversed_one + zero8 + big({0}) + zero4 +
                             reversed_minus_two + big({0}) + big({7, 3, 0}) + zero4 +
                             big({1, 0, 0, 0}) + big({2, 0, 0, 0});
  check_triangle(ply(header("binary_little_endian", declarations) + little));
}

TEST_CASE("read_ply: integers as coordinates keep their sign and size") {
  const Mesh mesh = ply(header("binary_big_endian",
                               "element vertex 1\nproperty short x\nproperty uint y\n"
                               "property uchar z\n") +
                        big({0x80, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}));
  CHECK(mesh.points.doubles()[0] == Point(-32768, 4294967295.0, 255));
  // The same bits by each other type, in both byte orders: two's complement.
  const std::string others = "property char x\nproperty ushort y\nproperty int z\n";
  const std::string named = "property int8 x\nproperty uint16 y\nproperty int32 z\n";
  const std::string bytes = big({0x80, 0xFF, 0xFE, 0x80, 0, 0, 1}) + big({0xFF, 0, 1, 0xFF, 0xFF}) +
                            big({0xFF, 0xFE}) + big({0x7F, 0x80, 0, 0x7F, 0xFF, 0xFF, 0xFF});
  for (const std::string& properties : {others, named}) {
    const std::string declared = "element vertex 3\n" + properties;
    const Mesh read = ply(header("binary_big_endian", declared) + bytes);
    CHECK(read.points.doubles()[0] == Point(-128, 65534, -2147483647.0));
    CHECK(read.points.doubles()[1] == Point(-1, 1, -2));
    CHECK(read.points.doubles()[2] == Point(127, 32768, 2147483647.0));
    const Mesh little = ply(header("binary_little_endian", "element vertex 1\n" + properties) +
                            big({0x80, 0xFE, 0xFF, 1, 0, 0, 0x80}));
    CHECK(little.points.doubles()[0] == Point(-128, 65534, -2147483647.0));
  }
}

TEST_CASE("read_ply: a negative length or index of a signed type is refused, not wrapped (#13)") {
  const std::string points =
      "element vertex 1\nproperty char x\nproperty char y\nproperty char z\n";
  for (const auto& [list, bytes] : std::vector<std::pair<std::string, std::string>>{
           {"list char uchar", big({1, 2, 3, 0xFF, 0, 0, 0})},
           {"list uchar char", big({1, 2, 3, 3, 0, 0xFF, 0})}}) {
    const Error error =
        error_of([&, text = header("binary_big_endian", points + "element face 1\nproperty " +
                                                            list + " vertex_indices\n") +
                            bytes] { return ply(text); });
    CHECK(std::string(error.what()).find("expected a length or index, found -1") !=
          std::string::npos);
  }
}

TEST_CASE("read_ply: line ends of the header, and a body that begins with a line feed") {
  const std::string declaration =
      "element vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\n";
  std::string text = header("binary_little_endian", declaration);
  const std::string body = "\n\r\n";
  CHECK(ply(text + body).points.doubles()[0] == Point(10, 13, 10));
  std::string dos, mac;
  for (const char c : text) {
    dos += c == '\n' ? "\r\n" : std::string(1, c);
    mac += c == '\n' ? '\r' : c;
  }
  CHECK(ply(dos + body).points.doubles()[0] == Point(10, 13, 10));
  CHECK(ply(mac + body).points.doubles()[0] == Point(10, 13, 10));
}

TEST_CASE("read_ply: every error says where it is and what was expected") {
  struct Case {
    std::string text;
    std::optional<std::size_t> line;
    const char* expected;
  };
  const std::string vertex = "element vertex 1\nproperty float x\nproperty float y\n";
  const std::string text = header("ascii", kTriangle), points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string binary = header("binary_little_endian", kTriangle);
  const std::string nan = big({0, 0, 0xC0, 0x7F});
  for (const Case& c : std::vector<Case>{
           {"", 1, "expected ply"},
           {"plyx\n", 1, "expected ply, found 'plyx'"},
           {"ply\nelement", 2, "expected format"},
           {"ply\nformat ascii 2.0\n", 2, "expected version 1.0, found '2.0'"},
           {"ply\nformat binary 1.0\n", 2, "expected ascii, binary_little_endian"},
           {"ply\nformat ascii 1.0\nproperty float x\n", 3, "expected element, property"},
           {"ply\nformat ascii 1.0\n" + vertex, 6, "expected end_header"},
           {header("ascii", vertex), 6, "properties x, y and z"},
           {header("ascii", vertex + "property list uchar float z\n"), 7, "properties x, y and z"},
           {header("ascii", ""), 3, "expected an element vertex"},
           {header("ascii", vertex + "property float x\n"), 6, "'x' again"},
           {header("ascii", vertex + "element vertex 2\n"), 6, "'vertex' again"},
           {header("ascii", vertex + "property real z\n"), 6, "expected a PLY type"},
           {header("ascii", vertex + "property list float int z\n"), 6, "expected an integer type"},
           {header("ascii", "element vertex -1\n"), 3, "expected the number of elements"},
           {header("ascii", "element vertex 5000000000\n"), 3, "expected the number of elements"},
           {header("ascii", vertex + "property float z\nelement face 1\n"
                                     "property list uchar float vertex_indices\n"),
            9, "list of integers"},
           {header("ascii", vertex + "property float z\nelement face 1\n"
                                     "property int vertex_indices\n"),
            9, "list of integers"},
           {text + "0 0 0\n", 10, "3 rows of element 'vertex', found a file too short"},
           {text + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 11, "expected a coordinate"},
           {text + "0 0 x\n1 0 0\n0 1 0\n3 0 1 2\n", 11, "expected a number, found 'x'"},
           {text + "0 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n", 11, "expected a finite number"},
           {text + "0 0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 11, "expected the end of the line"},
           {text + points, 14, "expected face 0, found the end of the file"},
           {text + points + "3 0 1 3\n", 14, "expected an index below 3, found 3"},
           {text + points + "3 0 1\n", 14,
            "the index of a point, from 0, found the end of the line"},
           {text + points + "4000000000 0 1\n", 14, "a list of 4000000000 values"},
           {text + points + "3 0 1 2\n3 0 1 2\n", 15, "expected the end of the file"},
           {binary + std::string(35, '\0'), {}, "3 rows of element 'vertex'"},
           {binary + nan + std::string(45, '\0'), {}, "expected a finite number in point 0"},
           {binary + std::string(36, '\0') + big({3, 0}), {}, "found a file too short"},
           {binary + std::string(36, '\0') + big({3}) + std::string(8, '\0') + "\xFF\xFF\xFF\xFF",
            {},
            "expected a length or index, found -1"},
           {binary + std::string(36, '\0') + big({3}) + std::string(8, '\0') + big({3, 0, 0, 0}),
            {},
            "expected an index below 3, found 3"},
           {binary + std::string(36, '\0') + big({3}) + std::string(13, '\0'),
            {},
            "expected the end of the file, found more bytes"},
       }) {
    CAPTURE(c.text);
    const Error error = error_of([&] { return ply(c.text); });
    CAPTURE(std::string(error.what()));
    CHECK(exit_code(error.code()) == 3);
    CHECK(error.line() == c.line);
    CHECK(std::string(error.what()).find(c.expected) != std::string::npos);
  }
}
