// SPDX-License-Identifier: MIT
// glTF and GLB: files put together here, byte by byte. Where nodes turn and mirror a mesh, expected
// points come from the product of quaternions q v q* in fractions, not from a matrix.
#include <doctest/doctest.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include "convexact/io.hpp"
#include "expect_error.hpp"
#include "io/file_kind.hpp"
#include "io/gltf_document.hpp"

using namespace convexact;

namespace {

using Polygons = std::vector<std::vector<std::uint32_t>>;

template <class T>
std::string little_endian(const std::vector<T>& values) {
  std::string bytes;
  for (const T value : values) {
    if constexpr (std::is_same_v<T, float>) {
      bytes += little_endian(std::vector{std::bit_cast<std::uint32_t>(value)});
    } else {
      for (std::size_t k = 0; k < sizeof(T); ++k) {
        bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * k) & 0xFF);
      }
    }
  }
  return bytes;
}

// A .glb of these members of the document, and these bytes.
std::string glb(std::string members, std::string binary) {
  std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" +
                     std::to_string(binary.size()) + "}]," + members + "}";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const auto length = [](std::size_t size) {
    return little_endian(std::vector{static_cast<std::uint32_t>(size)});
  };
  return "glTF" + length(2) + length(28 + text.size() + binary.size()) + length(text.size()) +
         "JSON" + text + length(binary.size()) + std::string("BIN\0", 4) + binary;
}

Mesh gltf(const std::string& bytes, const ReadOptions& options = {}) {
  ReadOptions given = options;
  given.format = MeshFormat::Gltf;
  return read_mesh_bytes(bytes, given);
}

// Points 0 0 0, 1 0 0, 0 1 0, 0 0 1, as binary32.
const std::string kCorners = little_endian<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
// A tetrahedron of them, from outside.
const std::string kFaces = little_endian<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});

// A scene of nodes with that tetrahedron as mesh 0.
std::string tetrahedra(const std::string& nodes, const std::string& roots = "0") {
  return glb(
      R"("scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + nodes +
          R"(],"meshes":[{"name":"tet","primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}])",
      kCorners + kFaces);
}

// One primitive of the corners in a buffer, as these members of it and of the document say.
std::string primitive(const std::string& members, const std::string& accessors,
                      const std::string& views, const std::string& binary) {
  return glb(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{)" + members +
                 R"(}]}],"accessors":[)" + accessors + R"(],"bufferViews":[)" + views + "]",
             binary);
}

std::string refusal(const std::string& bytes) {
  const Error error = error_of([&] { return gltf(bytes); });
  CHECK(exit_code(error.code()) == 3);
  return error.what();
}

bool says(const std::string& bytes, const std::string& words) {
  const std::string said = refusal(bytes);
  CAPTURE(said);
  CAPTURE(words);
  CHECK(said.find(words) != said.npos);
  return said.find(words) != said.npos;
}

// ---- The definition: quaternions of fractions.

using Quaternion = std::array<Rational, 4>;  // x, y, z, w

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
          a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
          a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

RationalPoint turned(const Quaternion& q, const RationalPoint& v) {
  const Rational square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  const Quaternion moved = product(product(q, {v[0], v[1], v[2], 0}), {-q[0], -q[1], -q[2], q[3]});
  return {moved[0] / square, moved[1] / square, moved[2] / square};
}

struct Transform {
  Quaternion turn;
  RationalPoint size, shift;

  RationalPoint operator()(const RationalPoint& x) const {
    return turned(turn, RationalPoint(x.cwiseProduct(size))) + shift;
  }
};

std::string list(const auto& numbers) {
  std::string text;
  for (const Rational& x : numbers) text += (text.empty() ? "[" : ",") + to_decimal(x, 20);
  return text + "]";
}

// Numbers of at most two decimals, so that their spelling is exact.
Transform random_transform(std::mt19937& random) {
  const auto number = [&] { return Rational(int(random() % 401) - 200, 100); };
  const auto nonzero = [&] {
    return Rational((random() % 2 ? 1 : -1) * (int(random() % 200) + 1), 100);
  };
  return {{number(), number(), number(), nonzero()},
          {nonzero(), nonzero(), nonzero()},
          {number(), number(), number()}};
}

std::string members_of(const Transform& transform) {
  return R"("rotation":)" + list(transform.turn) + R"(,"scale":)" + list(transform.size) +
         R"(,"translation":)" + list(transform.shift);
}

// Its numbers as they are taken by default: the nearest doubles.
Transform in_doubles(Transform transform) {
  const auto nearest = [](Rational& x) { x = to_rational(to_double(x, Rounding::Nearest)); };
  for (Rational& x : transform.turn) nearest(x);
  for (Rational& x : transform.size) nearest(x);
  for (Rational& x : transform.shift) nearest(x);
  return transform;
}

const std::vector<RationalPoint> kTetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// Whether the triangles of a part, a tetrahedron, are seen counter-clockwise from outside.
bool is_outward(const Mesh& mesh, const MeshPart& part) {
  Rational six_volumes = 0;
  const auto at = [&](std::uint32_t k) { return mesh.points[PointId(k)]; };
  for (std::size_t f = part.first_polygon; f < part.last_polygon; ++f) {
    const auto& t = mesh.polygons[f];
    six_volumes += at(t[0]).dot(at(t[1]).cross(at(t[2])));
  }
  return six_volumes > 0;
}

}  // namespace

TEST_CASE("gltf: turned, mirrored, nested and repeated meshes lie where quaternions put them") {
  std::mt19937 random(2604);
  for (int run = 0; run < 50; ++run) {
    const Transform outer = random_transform(random), inner = random_transform(random);
    const std::string bytes = tetrahedra("{" + members_of(outer) +
                                         R"(,"children":[1,2]},{"name":"a","mesh":0},{"mesh":0,)" +
                                         members_of(inner) + "}");
    const Mesh mesh = gltf(bytes, {.decimal = Decimal::Exact});
    REQUIRE(mesh.parts.size() == 2);
    CHECK(mesh.parts[0].name == "a");
    CHECK(mesh.parts[1].name == "tet");
    CHECK(mesh.notes.empty());
    const Mesh rounded = gltf(bytes);
    for (std::size_t part = 0; part < 2; ++part) {
      // Corners in the order of the faces; of a mirror image, each face is turned.
      for (std::size_t f = 0; f < 4; ++f) {
        std::vector<std::uint32_t> corners{0, 2, 1};
        if (f == 1) corners = {0, 1, 3};
        if (f == 2) corners = {0, 3, 2};
        if (f == 3) corners = {1, 2, 3};
        std::vector<RationalPoint> expected;
        for (const std::uint32_t c : corners) {
          expected.push_back(part == 0 ? outer(kTetrahedron[c]) : outer(inner(kTetrahedron[c])));
        }
        const auto& found = mesh.polygons[mesh.parts[part].first_polygon + f];
        for (const std::uint32_t corner : found) {
          const RationalPoint point = mesh.points[PointId(corner)];
          CHECK(std::find(expected.begin(), expected.end(), point) != expected.end());
        }
        CHECK(mesh.points[PointId(found[0])] == expected[0]);
      }
      CHECK(is_outward(mesh, mesh.parts[part]));
    }
    REQUIRE(rounded.points.is_binary());
    // By default each is rounded once, from the exact image of the nodes' doubles.
    const Transform outer_double = in_doubles(outer), inner_double = in_doubles(inner);
    REQUIRE(rounded.points.size() == mesh.points.size());
    for (const RationalPoint& corner : kTetrahedron) {
      for (const RationalPoint& exact :
           {outer_double(corner), outer_double(inner_double(corner))}) {
        Point nearest;
        for (int k = 0; k < 3; ++k) nearest[k] = to_double(exact[k], Rounding::Nearest);
        const auto points = rounded.points.doubles();
        CHECK(std::find(points.begin(), points.end(), nearest) != points.end());
      }
    }
    REQUIRE(rounded.notes.size() == 1);
    CHECK(rounded.notes[0].find("rounded once") != std::string::npos);
  }
}

TEST_CASE("gltf: a matrix is read by columns, and rounds nothing that doubles hold") {
  const Mesh mesh =
      gltf(tetrahedra(R"({"mesh":0,"matrix":[0,1,0,0, -1,0,0,0, 0,0,2,0, 5,6,7,1]})"));
  const std::vector<Point> expected = {{5, 6, 7}, {4, 6, 7}, {5, 7, 7}, {5, 6, 9}};
  REQUIRE(mesh.points.size() == 4);
  for (const Point& p : expected) {
    const auto points = mesh.points.doubles();
    CHECK(std::find(points.begin(), points.end(), p) != points.end());
  }
  CHECK(mesh.notes.empty());
}

TEST_CASE("gltf: strips, fans, points and lists without indices") {
  const std::string view = R"({"buffer":0,"byteLength":48})";
  const auto of_mode = [&](int mode, const std::string& more = "") {
    return gltf(primitive(R"("attributes":{"POSITION":0},"mode":)" + std::to_string(mode) + more,
                          R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})", view,
                          kCorners));
  };
  CHECK(of_mode(5).polygons == Polygons{{0, 1, 2}, {1, 3, 2}});
  CHECK(of_mode(6).polygons == Polygons{{0, 1, 2}, {1, 3, 2}});  // (1, 2, 0) and (2, 3, 0)
  CHECK(of_mode(0).polygons.empty());
  CHECK(of_mode(0).parts[0].loose == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(of_mode(3).parts[0].loose.size() == 4);
  CHECK(says(
      primitive(R"("attributes":{"POSITION":0})",
                R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})", view, kCorners),
      "a multiple of 3 corners, found 4"));
}

TEST_CASE("gltf: strides, offsets, sparse elements, and points that nothing uses") {
  // Each point is followed by a number that is none; the last one is replaced.
  const std::string strided = little_endian<float>({9, 9, 9, 0, 0, 0, 7, 1, 0, 0, 7, 0, 1, 0, 7,  //
                                                    5, 5, 5, 7});
  const std::string bytes = strided + little_endian<std::uint8_t>({3, 0, 0, 0}) +
                            little_endian<float>({0, 0, 1}) +
                            little_endian<std::uint8_t>({0, 1, 2, 0, 3, 1});
  const std::size_t start = strided.size();
  const Mesh mesh = gltf(primitive(
      R"("attributes":{"POSITION":0},"indices":1)",
      R"({"bufferView":0,"byteOffset":12,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,
"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}}},
{"bufferView":3,"componentType":5121,"count":6,"type":"SCALAR"})",
      R"({"buffer":0,"byteLength":)" + std::to_string(start) +
          R"(,"byteStride":16},{"buffer":0,"byteOffset":)" + std::to_string(start) +
          R"(,"byteLength":1},{"buffer":0,"byteOffset":)" + std::to_string(start + 4) +
          R"(,"byteLength":12},{"buffer":0,"byteOffset":)" + std::to_string(start + 16) +
          R"(,"byteLength":6})",
      bytes));
  CHECK(mesh.polygons == Polygons{{0, 1, 2}, {0, 3, 1}});
  REQUIRE(mesh.points.size() == 4);
  CHECK(mesh.points.doubles()[3] == Point(0, 0, 1));
}

TEST_CASE("gltf: integers, normalized or not") {
  // Sec. 3.11: c / 32767, and at least -1.
  const std::string bytes =
      little_endian<std::uint16_t>({0, 0, 0, 0, 32767, 0, 0, 0, 0, 0x8000, 0, 0});
  const auto with = [&](const char* normalized) {
    return gltf(
        primitive(R"("attributes":{"POSITION":0},"mode":0)",
                  std::string(R"({"bufferView":0,"componentType":5122,"count":3,"type":"VEC3",)") +
                      R"("normalized":)" + normalized + "}",
                  R"({"buffer":0,"byteLength":24,"byteStride":8})", bytes),
        {.decimal = Decimal::Exact});
  };
  CHECK(with("false").points.doubles()[1] == Point(32767, 0, 0));
  CHECK(with("false").points.doubles()[2] == Point(0, -32768, 0));
  CHECK(with("true").points.doubles()[1] == Point(1, 0, 0));
  CHECK(with("true").points.doubles()[2] == Point(0, -1, 0));
}

TEST_CASE("gltf: buffers in the text, and in files beside it but nowhere else") {
  const auto folder = std::filesystem::temp_directory_path() / "convexact_gltf_test";
  std::filesystem::create_directories(folder / "inside" / "deeper");
  const auto write = [](const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  };
  write(folder / "inside" / "deeper" / "a b.bin", kCorners);
  write(folder / "outside.bin", kCorners);
  const auto text = [](const std::string& uri) {
    return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"buffers":[{"byteLength":48,"uri":")" +
           uri + R"("}],"bufferViews":[{"buffer":0,"byteLength":48}],"meshes":[{"primitives":[
{"mode":0,"attributes":{"POSITION":0}}]}],"accessors":[
{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}]})";
  };
  const ReadOptions options{.format = MeshFormat::Gltf, .folder = (folder / "inside").string()};
  CHECK(read_mesh_bytes(text("deeper/a%20b.bin"), options).points.size() == 4);
  write(folder / "inside" / "a.gltf", text("deeper/a%20b.bin"));
  CHECK(read_mesh((folder / "inside" / "a.gltf").string()).points.size() == 4);
  std::filesystem::remove(folder / "inside" / "link.bin");
  std::filesystem::create_symlink(folder / "outside.bin", folder / "inside" / "link.bin");
  for (const char* uri : {"../outside.bin", "deeper/../../outside.bin", "link.bin", "/etc/passwd",
                          "http://example.com/a.bin", "%2e%2e/outside.bin", "..\\\\outside.bin"}) {
    CAPTURE(uri);
    const Error error = error_of([&] { return read_mesh_bytes(text(uri), options); });
    CHECK(exit_code(error.code()) == 3);
    CHECK(std::string(error.what()).find("only files in its own folder") != std::string::npos);
  }
  // Sixteen zero bytes three times, in base64.
  const std::string zeros = "data:application/octet-stream;base64," + std::string(64, 'A');
  CHECK(read_mesh_bytes(text(zeros), options).points.size() == 1);
  std::filesystem::remove_all(folder);
}

TEST_CASE("gltf: what is malformed is refused by name") {
  CHECK(says(tetrahedra(R"({"mesh":0,"rotation":[0,0,0,0]})"),
             "nodes[0].rotation: expected a quaternion"));
  CHECK(says(tetrahedra(R"({"mesh":0,"scale":[1,0,1]})"), "found one that flattens"));
  CHECK(says(tetrahedra(R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1]})"), "flattens"));
  CHECK(says(tetrahedra(R"({"mesh":0,"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]})"), "0 0 0 1"));
  CHECK(says(tetrahedra(R"({"mesh":0,"matrix":[1,0,0]})"), "an array of 16 numbers"));
  CHECK(says(tetrahedra(R"({"mesh":0,"scale":[1,1,"1"]})"), "numbers"));
  CHECK(says(tetrahedra(R"({"mesh":0,"scale":[1e999,1,1]})"), "within the doubles"));
  CHECK(says(tetrahedra(R"({"children":[1]},{"children":[0]})"), "below two others or itself"));
  CHECK(says(tetrahedra(R"({"mesh":1})"),
             "nodes[0].mesh: expected an integer from 0 to 0, found '1'"));
  CHECK(says(tetrahedra(R"({"mesh":4294967296})"), "from 0 to 0, found '4294967296'"));
  CHECK(says(tetrahedra(R"({"mesh":-1})"), "an integer"));
  CHECK(says(tetrahedra(R"({"mesh":0.5})"), "an integer"));
  CHECK(says(tetrahedra(R"({"mesh":0})", "7"), "scenes[0].nodes"));
  const std::string position = R"("attributes":{"POSITION":0},"mode":0)";
  const auto with = [&](const std::string& accessor, const std::string& view) {
    return primitive(position, accessor, view, kCorners);
  };
  const std::string view = R"({"buffer":0,"byteLength":48})";
  CHECK(says(with(R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"})", view),
             "accessors[0]: expected 60 bytes from byte 0 on, found 48 bytes"));
  CHECK(says(
      with(
          R"({"bufferView":0,"byteOffset":18446744073709551614,"componentType":5126,"count":4,"type":"VEC3"})",
          view),
      "bytes"));
  CHECK(says(
      with(R"({"bufferView":0,"componentType":5126,"count":4611686018427387905,"type":"VEC3"})",
           view),
      "elements"));
  CHECK(says(with(R"({"componentType":5126,"count":4000000000,"type":"VEC3"})", view), "bytes"));
  CHECK(says(with(R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})",
                  R"({"buffer":0,"byteOffset":1,"byteLength":48})"),
             "bufferViews[0]"));
  CHECK(says(with(R"({"bufferView":0,"componentType":5130,"count":2,"type":"VEC3"})", view),
             "componentType"));
  CHECK(
      says(with(R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})", view), "VEC3"));
  const std::string tight = R"({"buffer":0,"byteLength":48,"byteStride":8})";
  CHECK(says(with(R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})", tight),
             "byteStride"));
  const std::string out_of_range = tetrahedra(R"({"mesh":0})");
  std::string bytes = out_of_range;
  bytes[bytes.size() - 2] = 4;  // the last index
  CHECK(says(bytes, "indices of 4 points, found 4 at place 11"));
  bytes = out_of_range;
  const std::size_t binary = bytes.size() - 72;
  bytes[binary + 3] = '\x7F', bytes[binary + 2] = '\xC0';  // NaN
  CHECK(says(bytes, "accessors[0][0]: expected three finite numbers"));
  const Mesh skipped = gltf(bytes, {.skip_bad = true});
  CHECK(skipped.points.size() == 3);
  CHECK(skipped.polygons.size() == 1);
  CHECK(skipped.notes.size() == 1);
}

TEST_CASE("gltf: versions, containers and extensions") {
  std::string bytes = tetrahedra(R"({"mesh":0})");
  CHECK(gltf(bytes + "tail").notes ==
        std::vector<std::string>{"4 bytes behind the end of the GLB were skipped"});
  bytes[4] = 1;
  CHECK(says(bytes, "version 2, found 1"));
  CHECK(says("{}", "asset.version: expected glTF 2.0"));
  CHECK(says(R"({"asset":{"version":"1.0"}})", "found '1.0'"));
  CHECK(says("glTF", "a header of 12 bytes"));
  const std::string begin = R"({"asset":{"version":"2.0"},"extensionsRequired":[")";
  CHECK(says(begin + R"(KHR_draco_mesh_compression"]})", "export it without compression"));
  CHECK(says(begin + R"(EXT_meshopt_compression"]})", "export it without compression"));
  CHECK(says(begin + R"(ACME_shapes"]})", "ACME_shapes"));
  CHECK(gltf(begin + R"(KHR_materials_unlit"]})").points.size() == 0);
  const Mesh skinned = gltf(tetrahedra(R"({"mesh":0,"skin":0})"));
  REQUIRE(skinned.notes.size() == 1);
  CHECK(skinned.notes[0].find("1 skin was passed over") == 0);
  CHECK(kind_of_file(tetrahedra(R"({"mesh":0})"), "a.obj").mesh == MeshFormat::Gltf);
  CHECK(kind_of_file("{}", "a.gltf").mesh == MeshFormat::Gltf);
}

TEST_CASE("gltf: what is written is read again, part by part, with the same bits") {
  Mesh mesh;
  mesh.points = PointSet(
      std::vector<Point>{{0, 0, 0}, {0.1f, 0, 0}, {0, 0x1p-140, 0}, {0, 0, -1e20f}, {1, 1, 1}});
  mesh.polygons = {{0, 2, 1}, {0, 1, 3, 2}, {2, 1, 4}};
  mesh.parts = {{"left \"one\"", 0, 2}, {"right", 2, 3}};
  const std::string bytes = write_mesh(mesh, MeshFormat::Gltf);
  CHECK(mesh_format_of_content(bytes) == MeshFormat::Gltf);
  const Mesh again = gltf(bytes);
  REQUIRE(again.parts.size() == 2);
  CHECK(again.parts[0].name == mesh.parts[0].name);
  const Polygons triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {2, 1, 4}};
  REQUIRE(again.polygons.size() == 4);
  for (std::size_t f = 0; f < 4; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(again.points.doubles()[again.polygons[f][k]] == mesh.points.doubles()[triangles[f][k]]);
    }
  }
  mesh.points =
      PointSet(std::vector<Point>{{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
  CHECK(error_of([&] { return write_mesh(mesh, MeshFormat::Gltf); }).code() ==
        ErrorCode::Unrepresentable);
}
