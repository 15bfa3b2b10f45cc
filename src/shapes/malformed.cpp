// SPDX-License-Identifier: MIT
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "convexact/shapes.hpp"

namespace convexact::shapes {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Bytes that are no text and no header and, as numbers, neither small nor regular.
std::string noise() {
  std::string bytes;
  std::uint32_t state = 1;
  for (int k = 0; k < 333; ++k) {  // not 84 + 50 n, the size of a binary STL
    state = state * 1664525 + 1013904223;
    bytes += static_cast<char>(state >> 24 | 0x80);
  }
  return bytes;
}

std::string little_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFF);
  return bytes;
}

std::string little_endian(float value) {
  return little_endian(std::bit_cast<std::uint32_t>(value));
}

// The four points of a tetrahedron, the last coordinate of the last of which is given.
std::string tetrahedron_points(const std::string& before, const std::string& last = "1") {
  std::string text;
  for (const char* point : {"0 0 0", "1 0 0", "0 1 0"}) text += before + point + "\n";
  return text + before + "0 0 " + last + "\n";
}

const char* const kObjFaces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
const char* const kFaces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

std::string off(const std::string& counts, const std::string& last = "1",
                const std::string& faces = kFaces) {
  return "OFF\n" + counts + "\n" + tetrahedron_points("", last) + faces;
}

std::string ply_header(const std::string& format, const std::string& points,
                       const std::string& faces) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + points +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string ply(const std::string& points, const std::string& faces, const std::string& last = "1",
                const std::string& rows = kFaces) {
  return ply_header("ascii", points, faces) + tetrahedron_points("", last) + rows;
}

std::string binary_ply(float last) {
  std::string bytes = ply_header("binary_little_endian", "4", "0");
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, last}) {
    bytes += little_endian(x);
  }
  return bytes;
}

std::string stl(const std::string& last) {
  return "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 " + last +
         "\nendloop\nendfacet\nendsolid s\n";
}

// One triangle, with a count that may be wrong.
std::string binary_stl(std::uint32_t count, float last) {
  std::string bytes(80, ' ');
  bytes += little_endian(count);
  for (const float x : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, last}) {
    bytes += little_endian(x);
  }
  return bytes + std::string(2, '\0');
}

std::string json(const std::string& first_row) {
  return "{\"halfspaces\": [" + first_row + ", [-1,0,0,0], [0,-1,0,0], [0,0,-1,0]]}\n";
}

std::string ine(const std::string& head, const std::string& first_row = "1 -1 -1 -1",
                const std::string& end = "end\n") {
  return head + "\n" + first_row + "\n0 1 0 0\n0 0 1 0\n0 0 0 1\n" + end;
}

const char* const kIneHead = "H-representation\nbegin\n4 4 integer";

std::string without_last_line(const std::string& text) {
  return text.substr(0, text.rfind('\n', text.size() - 2) + 1);
}

using Files = std::vector<MalformedFile>;

Files obj_files() {
  const std::string points = tetrahedron_points("v ");
  return {
      {"obj-truncated-point", "ends after two coordinates", points + kObjFaces + "v 1 2"},
      {"obj-truncated-face", "ends within a corner", points + "f 1 3 4/"},
      {"obj-nan", "a coordinate is NaN", tetrahedron_points("v ", "nan") + kObjFaces, true},
      {"obj-infinity", "a coordinate is inf", tetrahedron_points("v ", "inf") + kObjFaces, true},
      {"obj-overflow", "a coordinate is 1e400", tetrahedron_points("v ", "1e400") + kObjFaces,
       true},
      {"obj-not-a-number", "a coordinate is 1.0.0", tetrahedron_points("v ", "1.0.0") + kObjFaces},
      {"obj-index-zero", "indices count from 1", points + "f 0 1 2\n"},
      {"obj-index-out-of-range", "index 5 of 4 points", points + "f 1 3 5\n"},
      {"obj-index-before-first", "index -5 of 4 points", points + "f -1 -2 -5\n"},
      {"obj-index-beyond-32-bits", "index 2^32 + 1, which wraps to 1",
       points + "f 4294967297 2 3\n"},
      {"obj-unknown-statement", "a line begins with 'vertex'",
       points + kObjFaces + "vertex 0 0 2\n"},
      {"obj-noise", "random bytes", noise()}};
}

Files off_files() {
  return {{"off-empty", "no bytes", ""},
          {"off-missing-header", "begins with the counts", off("4 4 6").substr(4)},
          {"off-truncated", "ends before the last polygon", without_last_line(off("4 4 6"))},
          {"off-count-too-small", "3 points announced, 4 written", off("3 4 6")},
          {"off-count-too-large", "5 polygons announced, 4 written", off("4 5 6")},
          {"off-count-hostile", "4294967295 points announced", off("4294967295 4 6")},
          {"off-count-negative", "-4 points announced", off("-4 4 6")},
          {"off-nan", "a coordinate is NaN", off("4 4 6", "nan"), true},
          {"off-infinity", "a coordinate is -inf", off("4 4 6", "-inf"), true},
          {"off-overflow", "a coordinate is 1e309", off("4 4 6", "1e309"), true},
          {"off-index-out-of-range", "index 4 of 4 points", off("4 1 3", "1", "3 0 2 4\n")},
          {"off-index-negative", "index -1", off("4 1 3", "1", "3 0 2 -1\n")},
          {"off-no-corners", "a polygon of no corner", off("4 1 1", "1", "0 0 1 2\n")},
          {"off-noise", "random bytes", noise()}};
}

Files ply_files() {
  const std::string good = ply("4", "4");
  const std::string binary = binary_ply(1);
  return {{"ply-empty", "no bytes", ""},
          {"ply-missing-magic", "does not begin with 'ply'", good.substr(4)},
          {"ply-endless-header", "ends within its header", good.substr(0, 60)},
          {"ply-unknown-format", "format ascii 9.0", "ply\nformat ascii 9.0\n" + good.substr(21)},
          {"ply-missing-coordinate", "points without z",
           "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
           "property float y\nend_header\n0 0\n"},
          {"ply-truncated", "ends before the last face", without_last_line(good)},
          {"ply-count-too-small", "3 faces announced, 4 written", ply("4", "3")},
          {"ply-count-too-large", "5 faces announced, 4 written", ply("4", "5")},
          {"ply-count-hostile", "4294967295 points announced", ply("4294967295", "4")},
          {"ply-nan", "a coordinate is NaN", ply("4", "4", "nan"), true},
          {"ply-infinity", "a coordinate is inf", ply("4", "4", "inf"), true},
          {"ply-overflow", "a coordinate is 1e400", ply("4", "4", "1e400"), true},
          {"ply-index-out-of-range", "index 4 of 4 points", ply("4", "1", "1", "3 0 2 4\n")},
          {"ply-index-negative", "index -1", ply("4", "1", "1", "3 0 2 -1\n")},
          {"ply-binary-truncated", "ends one byte early", binary.substr(0, binary.size() - 1)},
          {"ply-binary-trailing", "four bytes too many", binary + "more"},
          {"ply-binary-nan", "a coordinate is NaN", binary_ply(kNan), true},
          {"ply-binary-infinity", "a coordinate is infinite", binary_ply(kInfinity), true},
          {"ply-noise", "random bytes", noise()}};
}

Files stl_files() {
  const std::string binary = binary_stl(1, 0);
  return {{"stl-empty", "no bytes", ""},
          {"stl-missing-header", "begins with 'facet'", stl("1 0").substr(8)},
          {"stl-truncated", "ends before 'endsolid'", without_last_line(stl("1 0"))},
          {"stl-two-corners", "a facet of two corners",
           "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"
           "endfacet\nendsolid s\n"},
          {"stl-four-corners", "a facet of four corners", stl("1 0\nvertex 1 1 0")},
          {"stl-nan", "a coordinate is NaN", stl("1 nan"), true},
          {"stl-infinity", "a coordinate is inf", stl("1 inf"), true},
          {"stl-overflow", "a coordinate is 1e400", stl("1 1e400"), true},
          {"stl-binary-truncated", "ends one byte early", binary.substr(0, binary.size() - 1)},
          {"stl-binary-count-too-large", "2 triangles announced, 1 written", binary_stl(2, 0)},
          {"stl-binary-nan", "a coordinate is NaN", binary_stl(1, kNan), true},
          {"stl-binary-infinity", "a coordinate is infinite", binary_stl(1, kInfinity), true},
          {"stl-noise", "random bytes", noise()}};
}

Files json_files() {
  const std::string good = json("[1,1,1,-1]");
  return {{"json-empty", "no bytes", ""},
          {"json-truncated", "ends within a number list", good.substr(0, 40)},
          {"json-missing-key", "an object without 'halfspaces'", "{\"planes\": []}\n"},
          {"json-three-numbers", "a row without its offset", json("[1,1,1]")},
          {"json-five-numbers", "a row with a number too many", json("[1,1,1,-1,0]")},
          {"json-null", "null for a number", json("[1,1,null,-1]")},
          {"json-division-by-zero", "the fraction 1/0", json("[1,1,1,\"1/0\"]")},
          {"json-nan", "NaN, which is no JSON", json("[1,1,NaN,-1]")},
          {"json-overflow", "the number 1e400", json("[1,1,1,-1e400]"), true},
          {"json-noise", "random bytes", noise()}};
}

Files ine_files() {
  return {{"ine-empty", "no bytes", ""},
          {"ine-missing-begin", "rows without 'begin'", ine("H-representation\n4 4 integer")},
          {"ine-truncated", "ends before 'end'", ine(kIneHead, "1 -1 -1 -1", "")},
          {"ine-count-too-small", "3 rows announced, 4 written",
           ine("H-representation\nbegin\n3 4 integer")},
          {"ine-count-too-large", "5 rows announced, 4 written",
           ine("H-representation\nbegin\n5 4 integer")},
          {"ine-count-hostile", "4294967295 rows announced",
           ine("H-representation\nbegin\n4294967295 4 integer")},
          {"ine-wrong-dimension", "rows of 5 numbers announced",
           ine("H-representation\nbegin\n4 5 integer")},
          {"ine-not-an-integer", "1.5 in type integer", ine(kIneHead, "1.5 -1 -1 -1")},
          {"ine-division-by-zero", "the fraction 1/0",
           ine("H-representation\nbegin\n4 4 rational", "1/0 -1 -1 -1")},
          {"ine-vertices", "a V-representation", ine("V-representation\nbegin\n4 4 integer")},
          {"ine-noise", "random bytes", noise()}};
}

Files row_files() {
  const auto rows = [](const std::string& first) {
    return first + "\n-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n";
  };
  return {{"txt-truncated", "the last row ends after two numbers", rows("1 1 1 -1") + "0 1"},
          {"txt-three-numbers", "a row without its offset", rows("1 1 1 -1") + "1 1 1\n"},
          {"txt-five-numbers", "a row with a number too many", rows("1 1 1 -1") + "1 1 1 -1 0\n"},
          {"txt-not-a-number", "a word for a number", rows("1 1 one -1")},
          {"txt-division-by-zero", "the fraction 1/0", rows("1 1 1/0 -1")},
          {"txt-nan", "a number is NaN", rows("1 1 nan -1"), true},
          {"txt-infinity", "a number is -inf", rows("1 1 1 -inf"), true},
          {"txt-overflow", "a number is 1e400", rows("1.5 1e400 1 -1"), true},
          {"txt-noise", "random bytes", noise()}};
}

Files xyz_files() {
  const auto points = [](const std::string& last) { return tetrahedron_points("", last); };
  return {{"xyz-truncated", "ends after two coordinates", points("1") + "1 2"},
          {"xyz-not-a-number", "a word for a number", points("one")},
          {"xyz-nan", "a coordinate is NaN", points("nan"), true},
          {"xyz-infinity", "a coordinate is inf", points("inf"), true},
          {"xyz-overflow", "a coordinate is 1e400", points("1e400"), true},
          {"xyz-noise", "random bytes", noise()}};
}

Files make_files() {
  Files list;
  for (const Files& files : {obj_files(), off_files(), ply_files(), stl_files(), xyz_files(),
                             json_files(), ine_files(), row_files()}) {
    list.insert(list.end(), files.begin(), files.end());
  }
  for (MalformedFile& file : list) file.name.insert(0, "malformed-");
  return list;
}

}  // namespace

std::string_view MalformedFile::extension() const {
  const std::size_t first = name.find('-') + 1;
  return std::string_view(name).substr(first, name.find('-', first) - first);
}

std::span<const MalformedFile> malformed_files() {
  static const Files list = make_files();
  return list;
}

}  // namespace convexact::shapes
