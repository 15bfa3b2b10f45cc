// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "convexact/shapes.hpp"

namespace convexact::shapes {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Bytes that are no text, no header and, as numbers, neither small nor regular.
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

// One triangle, with a count that may be another one.
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

void add_obj(Files& list) {
  const std::string points = tetrahedron_points("v ");
  list.push_back(
      {"obj-truncated-point", "ends after two coordinates", points + kObjFaces + "v 1 2", false});
  list.push_back({"obj-truncated-face", "ends after two corners", points + "f 1 3", false});
  list.push_back(
      {"obj-nan", "a coordinate is NaN", tetrahedron_points("v ", "nan") + kObjFaces, true});
  list.push_back(
      {"obj-infinity", "a coordinate is inf", tetrahedron_points("v ", "inf") + kObjFaces, true});
  list.push_back({"obj-overflow", "a coordinate is 1e400",
                  tetrahedron_points("v ", "1e400") + kObjFaces, true});
  list.push_back({"obj-not-a-number", "a coordinate is 1.0.0",
                  tetrahedron_points("v ", "1.0.0") + kObjFaces, false});
  list.push_back({"obj-index-zero", "indices count from 1", points + "f 0 1 2\n", false});
  list.push_back({"obj-index-out-of-range", "index 5 of 4 points", points + "f 1 3 5\n", false});
  list.push_back(
      {"obj-index-before-first", "index -5 of 4 points", points + "f -1 -2 -5\n", false});
  list.push_back({"obj-index-beyond-32-bits", "index 2^32 + 1, which wraps to 1",
                  points + "f 4294967297 2 3\n", false});
  list.push_back({"obj-unknown-statement", "a line begins with 'vertex'",
                  points + kObjFaces + "vertex 0 0 2\n", false});
  list.push_back({"obj-noise", "random bytes", noise(), false});
}

void add_off(Files& list) {
  list.push_back({"off-empty", "no bytes", "", false});
  list.push_back({"off-missing-header", "begins with the counts", off("4 4 6").substr(4), false});
  list.push_back(
      {"off-truncated", "ends before the last polygon", without_last_line(off("4 4 6")), false});
  list.push_back({"off-count-too-small", "3 points announced, 4 written", off("3 4 6"), false});
  list.push_back({"off-count-too-large", "5 polygons announced, 4 written", off("4 5 6"), false});
  list.push_back(
      {"off-count-hostile", "4294967295 points announced", off("4294967295 4 6"), false});
  list.push_back({"off-count-negative", "-4 points announced", off("-4 4 6"), false});
  list.push_back({"off-nan", "a coordinate is NaN", off("4 4 6", "nan"), true});
  list.push_back({"off-infinity", "a coordinate is -inf", off("4 4 6", "-inf"), true});
  list.push_back({"off-overflow", "a coordinate is 1e309", off("4 4 6", "1e309"), true});
  list.push_back(
      {"off-index-out-of-range", "index 4 of 4 points", off("4 1 3", "1", "3 0 2 4\n"), false});
  list.push_back({"off-index-negative", "index -1", off("4 1 3", "1", "3 0 2 -1\n"), false});
  list.push_back(
      {"off-two-corners", "a polygon of two corners", off("4 1 1", "1", "2 0 1 2\n"), false});
  list.push_back({"off-noise", "random bytes", noise(), false});
}

void add_ply(Files& list) {
  const std::string good = ply("4", "4");
  const std::string binary = binary_ply(1);
  list.push_back({"ply-empty", "no bytes", "", false});
  list.push_back({"ply-missing-magic", "does not begin with 'ply'", good.substr(4), false});
  list.push_back({"ply-endless-header", "ends within its header", good.substr(0, 60), false});
  list.push_back({"ply-unknown-format", "format ascii 9.0",
                  "ply\nformat ascii 9.0\n" + good.substr(21), false});
  list.push_back({"ply-missing-coordinate", "points without z",
                  "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                  "property float y\nend_header\n0 0\n",
                  false});
  list.push_back({"ply-truncated", "ends before the last face", without_last_line(good), false});
  list.push_back({"ply-count-too-small", "3 faces announced, 4 written", ply("4", "3"), false});
  list.push_back({"ply-count-too-large", "5 faces announced, 4 written", ply("4", "5"), false});
  list.push_back(
      {"ply-count-hostile", "4294967295 points announced", ply("4294967295", "4"), false});
  list.push_back({"ply-nan", "a coordinate is NaN", ply("4", "4", "nan"), true});
  list.push_back({"ply-infinity", "a coordinate is inf", ply("4", "4", "inf"), true});
  list.push_back({"ply-overflow", "a coordinate is 1e400", ply("4", "4", "1e400"), true});
  list.push_back(
      {"ply-index-out-of-range", "index 4 of 4 points", ply("4", "1", "1", "3 0 2 4\n"), false});
  list.push_back({"ply-index-negative", "index -1", ply("4", "1", "1", "3 0 2 -1\n"), false});
  list.push_back(
      {"ply-binary-truncated", "ends one byte early", binary.substr(0, binary.size() - 1), false});
  list.push_back({"ply-binary-trailing", "four bytes too many", binary + "more", false});
  list.push_back({"ply-binary-nan", "a coordinate is NaN", binary_ply(kNan), true});
  list.push_back({"ply-binary-infinity", "a coordinate is infinite", binary_ply(kInfinity), true});
  list.push_back({"ply-noise", "random bytes", noise(), false});
}

void add_stl(Files& list) {
  const std::string binary = binary_stl(1, 0);
  list.push_back({"stl-empty", "no bytes", "", false});
  list.push_back({"stl-missing-header", "begins with 'facet'", stl("1 0").substr(8), false});
  list.push_back({"stl-truncated", "ends before 'endsolid'", without_last_line(stl("1 0")), false});
  list.push_back({"stl-two-corners", "a facet of two corners",
                  "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"
                  "endfacet\nendsolid s\n",
                  false});
  list.push_back({"stl-four-corners", "a facet of four corners", stl("1 0\nvertex 1 1 0"), false});
  list.push_back({"stl-nan", "a coordinate is NaN", stl("1 nan"), true});
  list.push_back({"stl-infinity", "a coordinate is inf", stl("1 inf"), true});
  list.push_back({"stl-overflow", "a coordinate is 1e400", stl("1 1e400"), true});
  list.push_back(
      {"stl-binary-truncated", "ends one byte early", binary.substr(0, binary.size() - 1), false});
  list.push_back(
      {"stl-binary-count-too-large", "2 triangles announced, 1 written", binary_stl(2, 0), false});
  list.push_back({"stl-binary-nan", "a coordinate is NaN", binary_stl(1, kNan), true});
  list.push_back(
      {"stl-binary-infinity", "a coordinate is infinite", binary_stl(1, kInfinity), true});
  list.push_back({"stl-noise", "random bytes", noise(), false});
}

void add_json(Files& list) {
  const std::string good = json("[1,1,1,-1]");
  list.push_back({"json-empty", "no bytes", "", false});
  list.push_back({"json-truncated", "ends within a number list", good.substr(0, 40), false});
  list.push_back(
      {"json-missing-key", "an object without 'halfspaces'", "{\"planes\": []}\n", false});
  list.push_back({"json-three-numbers", "a row without its offset", json("[1,1,1]"), false});
  list.push_back(
      {"json-five-numbers", "a row with a number too many", json("[1,1,1,-1,0]"), false});
  list.push_back({"json-null", "null for a number", json("[1,1,null,-1]"), false});
  list.push_back({"json-division-by-zero", "the fraction 1/0", json("[1,1,1,\"1/0\"]"), false});
  list.push_back({"json-nan", "NaN, which is no JSON", json("[1,1,NaN,-1]"), false});
  list.push_back({"json-overflow", "the number 1e400", json("[1,1,1,-1e400]"), true});
  list.push_back({"json-noise", "random bytes", noise(), false});
}

void add_ine(Files& list) {
  list.push_back({"ine-empty", "no bytes", "", false});
  list.push_back(
      {"ine-missing-begin", "rows without 'begin'", ine("H-representation\n4 4 integer"), false});
  list.push_back({"ine-truncated", "ends before 'end'", ine(kIneHead, "1 -1 -1 -1", ""), false});
  list.push_back({"ine-count-too-small", "3 rows announced, 4 written",
                  ine("H-representation\nbegin\n3 4 integer"), false});
  list.push_back({"ine-count-too-large", "5 rows announced, 4 written",
                  ine("H-representation\nbegin\n5 4 integer"), false});
  list.push_back({"ine-count-hostile", "4294967295 rows announced",
                  ine("H-representation\nbegin\n4294967295 4 integer"), false});
  list.push_back({"ine-wrong-dimension", "rows of 5 numbers announced",
                  ine("H-representation\nbegin\n4 5 integer"), false});
  list.push_back(
      {"ine-not-an-integer", "1.5 in type integer", ine(kIneHead, "1.5 -1 -1 -1"), false});
  list.push_back({"ine-division-by-zero", "the fraction 1/0",
                  ine("H-representation\nbegin\n4 4 rational", "1/0 -1 -1 -1"), false});
  list.push_back(
      {"ine-vertices", "a V-representation", ine("V-representation\nbegin\n4 4 integer"), false});
  list.push_back({"ine-noise", "random bytes", noise(), false});
}

void add_rows(Files& list) {
  const auto rows = [](const std::string& first) {
    return first + "\n-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n";
  };
  list.push_back(
      {"txt-truncated", "the last row ends after two numbers", rows("1 1 1 -1") + "0 1", false});
  list.push_back(
      {"txt-three-numbers", "a row without its offset", rows("1 1 1 -1") + "1 1 1\n", false});
  list.push_back({"txt-five-numbers", "a row with a number too many",
                  rows("1 1 1 -1") + "1 1 1 -1 0\n", false});
  list.push_back({"txt-not-a-number", "a word for a number", rows("1 1 one -1"), false});
  list.push_back({"txt-division-by-zero", "the fraction 1/0", rows("1 1 1/0 -1"), false});
  list.push_back({"txt-nan", "a number is NaN", rows("1 1 nan -1"), true});
  list.push_back({"txt-infinity", "a number is -inf", rows("1 1 1 -inf"), true});
  list.push_back({"txt-overflow", "a number is 1e400", rows("1.5 1e400 1 -1"), true});
  list.push_back({"txt-noise", "random bytes", noise(), false});
}

void add_xyz(Files& list) {
  const auto points = [](const std::string& last) { return tetrahedron_points("", last); };
  list.push_back({"xyz-truncated", "ends after two coordinates", points("1") + "1 2", false});
  list.push_back({"xyz-not-a-number", "a word for a number", points("one"), false});
  list.push_back({"xyz-nan", "a coordinate is NaN", points("nan"), true});
  list.push_back({"xyz-infinity", "a coordinate is inf", points("inf"), true});
  list.push_back({"xyz-overflow", "a coordinate is 1e400", points("1e400"), true});
  list.push_back({"xyz-noise", "random bytes", noise(), false});
}

Files make_files() {
  Files list;
  add_obj(list);
  add_off(list);
  add_ply(list);
  add_stl(list);
  add_xyz(list);
  add_json(list);
  add_ine(list);
  add_rows(list);
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
