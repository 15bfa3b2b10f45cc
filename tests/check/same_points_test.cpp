// SPDX-License-Identifier: MIT
// convexact-check PROOF MESH: a proof about one mesh does not pass for another, however its numbers
// are spelt; what the library reads, the checker reads alike.
#include <cstring>
#include <sstream>

#include "checker.hpp"
#include "process.hpp"
#include "proofs.hpp"
#include "shapes/makers.hpp"

using namespace convexact;
using support::ScratchFolder;

namespace {

// The checker's exit code for a proof about the tetrahedron 0, (8, 0, 0), (0, 8, 0), (x, 0, 8) and
// a mesh file.
int verdict_on(const std::string& name, const std::string& mesh, double x) {
  const std::vector<Point> points = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {x, 0, 8}};
  static const ScratchFolder scratch;
  const std::string path = scratch.write(name, mesh);
  return check_proof(proof_of(PointSet(points), Engine::Filtered, 4), path).exit_code;
}

constexpr const char* kBase = "v 0 0 0\nv 8 0 0\nv 0 8 0\n";

std::string bytes_of_floats(const std::vector<float>& numbers) {
  std::string bytes(4 * numbers.size(), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

}  // namespace

TEST_CASE("same points: decimals mean the nearest double, beyond 17 digits and at ties (#13)") {
  const auto with = [](const std::string& x) { return kBase + ("v " + x) + " 0 8\n"; };
  CHECK(verdict_on("a.obj", with("0.1"), 0.1) == 0);
  CHECK(verdict_on("a.obj", with("0.1000000000000000055511151231257827021181583404541015625"),
                   0.1) == 0);
  // 1 + 2^-53 is the middle between 1 and 1 + 2^-52; the tie goes to 1, the even one.
  const std::string middle = "1.00000000000000011102230246251565404236316680908203125";
  CHECK(verdict_on("a.obj", with(middle), 1.0) == 0);
  CHECK(verdict_on("a.obj", with(middle), 1 + 0x1p-52) == 1);
  CHECK(verdict_on("a.obj", with(middle + "0000000000000000001"), 1 + 0x1p-52) == 0);
  CHECK(verdict_on("a.obj", with(middle + "0000000000000000001"), 1.0) == 1);
  // Three quarters of the smallest double round up to it, half of it to 0.
  CHECK(verdict_on("a.obj", with("3.7e-324"), 0x1p-1074) == 0);
  CHECK(verdict_on("a.obj", with("2.4e-324"), 0.0) == 0);
  CHECK(verdict_on("a.obj", with("1e-99999999999999999999"), 0.0) == 0);
  CHECK(verdict_on("a.obj", with("1e99999999999999999999"), 0.0) == 3);
  CHECK(verdict_on("a.obj", with("1.7976931348623158e308"), 0.0) == 1);  // the largest double
  CHECK(verdict_on("a.obj", with("1.7976931348623159e308"), 0.0) == 3);  // nearer to 2^1024
  CHECK(verdict_on("a.obj", with("+.5e+0001"), 5.0) == 0);
  CHECK(verdict_on("a.obj", with("5."), 5.0) == 0);
  CHECK(verdict_on("a.obj", with("-0"), 0.0) == 0);
}

TEST_CASE("same points: a decimal of a halfspace is the nearest double, or the number it spells") {
  const std::string rows = "2 0 0 -0.1\n";
  const std::string near = to_string(to_rational(0.1) / 2);  // over the first entry
  for (const bool as_spelt : {false, true}) {
    const auto read = rows_by_checker(rows, "a.txt", as_spelt);
    REQUIRE(read.has_value());
    REQUIRE(read->size() == 1);
    std::istringstream words(read->front());
    std::vector<Rational> row;
    for (std::string word; words >> word;) row.push_back(parse_rational(word));
    REQUIRE(row.size() == 4);
    CHECK(to_string(Rational(-row[3] / row[0])) == (as_spelt ? "1/20" : near));
  }
}

TEST_CASE("same points: what looks hexadecimal, infinite or like nothing is refused (#13)") {
  for (const std::string x : {"0x10", "0x1p4", "nan", "inf", "1e", "e5", "1,5", "--1", "+-1", ".",
                              "", "1_0", "1f", "1d0"}) {
    CAPTURE(x);
    CHECK(verdict_on("a.obj", kBase + ("v " + x) + " 0 8\n", 16.0) == 3);
  }
  CHECK(verdict_on("a.obj", kBase + std::string("v 10 0 8\n"), 10.0) == 0);
  CHECK(verdict_on("a.obj", kBase + std::string("v 10 0 8\n"), 16.0) == 1);
}

TEST_CASE("same points: every way to write a vertex line of OBJ is read (#13)") {
  for (const std::string line :
       {"v\t9 0 8\n", "  v 9 0 8\n", "v 9 0 8", "v 9 0 8\r\n", "v 9 0 8\r", "v 9 0 8 2\n",
        "v 9 0 8 0.5 0.5 0.5\n", "v 9 0 8 1 0.5 0.5 0.5\n", "v 9 \\\n 0 8\n", "v \\\r\n9 0 8\n",
        "v 9 0 8 # v 1 1 1\n", "# c \\\nv 9 0 8\n", "o v\nv 9 0 8\n", "o \\\nv 9 0 8\n",
        "v 9\v0\f8\n", "f 1 2 3\nv 9 0 8\nvn 1 1 1\nvt 0 0\n"}) {
    CAPTURE(line);
    CHECK(verdict_on("a.obj", kBase + line, 9.0) == 0);
    CHECK(verdict_on("a.obj", kBase + line, 9.5) == 1);
  }
  CHECK(verdict_on("a.obj", "\xEF\xBB\xBF" + (kBase + std::string("v 9 0 8\n")), 9.0) == 0);
  for (const std::string line : {"#v 9 0 8\n", "V 9 0 8\n", "call other.obj\n", "v 9 0\n",
                                 "v 9 0 8 1 1\n", "vertex 9 0 8\n"}) {
    CAPTURE(line);
    CHECK(verdict_on("a.obj", kBase + line, 9.0) != 0);
  }
}

TEST_CASE("same points: order and repeats say nothing, one point more or less does (#13)") {
  const std::string turned = "v 9 0 8\nv 0 8 0\nv 8 0 0\nv 0 0 0\nv 9 0 8\n";
  CHECK(verdict_on("a.obj", turned, 9.0) == 0);
  CHECK(verdict_on("a.obj", turned + "v 1 1 1\n", 9.0) == 1);  // inside, and yet another mesh
  CHECK(verdict_on("a.obj", "v 9 0 8\nv 0 8 0\nv 8 0 0\n", 9.0) == 1);
  CHECK(verdict_on("a.obj", "", 9.0) == 1);
}

TEST_CASE("same points: OFF, PLY, STL and XYZ, as text and as bytes (#13)") {
  const std::string rows = "0 0 0\n8 0 0\n0 8 0\n9 0 8\n";
  CHECK(verdict_on("a.xyz", "# four\n" + rows, 9.0) == 0);
  CHECK(verdict_on("a.xyz", "0 0 0 0.5\n8 0 0 1\n0 8 0 1\n9 0 8 1\n", 9.0) == 0);
  // Names of columns, as convexact reads it, so that the file has three points.
  CHECK(verdict_on("a.xyz", "0 0 0 e;\n8 0 0\n0 8 0\n9 0 8\n", 9.0) == 3);
  CHECK(verdict_on("a.OFF", "OFF # text\n4 0 0\n" + rows, 9.0) == 0);
  CHECK(verdict_on("a.off", "COFF 4 0\n" + rows, 9.0) == 0);
  CHECK(verdict_on("a.off", "OFF 5 0 0\n" + rows, 9.0) == 3);
  const std::string vertex = "element vertex 4\nproperty float x\nproperty float y\n";
  CHECK(verdict_on("a.ply",
                   "ply\nformat ascii 1.0\n" + vertex + "property float z\nend_header\n" + rows,
                   9.0) == 0);
  const std::vector<float> corners = {0, 0, 0, 8, 0, 0, 0, 8, 0, 9, 0, 8};
  const std::string lists = "element strip 1\nproperty list uchar ushort indices\n";
  const std::string binary = "ply\nformat binary_little_endian 1.0\n" + lists + vertex +
                             "property float z\nend_header\n" + std::string("\2abcd") +
                             bytes_of_floats(corners);
  CHECK(verdict_on("a.ply", binary, 9.0) == 0);
  CHECK(verdict_on("a.ply", binary, 9.5) == 1);
  CHECK(verdict_on("a.ply", binary + "x", 9.0) == 3);
  CHECK(verdict_on("a.ply", binary.substr(0, binary.size() - 1), 9.0) == 3);
  const std::string told = "ply\nformat ascii 1.0\ncomment of\nobj_info or of\n" + vertex;
  CHECK(verdict_on("a.ply", told + "property float z\nend_header\n" + rows, 9.0) == 0);
  // Signed integers down to their lowest.
  for (const int x : {-128, -127, 127}) {
    const std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4\n"
        "property char x\nproperty char y\nproperty char z\nend_header\n" +
        std::string("\0\0\0\x8\0\0\0\x8\0", 9) + std::string{static_cast<char>(x), '\0', '\x8'};
    CHECK(verdict_on("a.ply", bytes, x) == 0);
    CHECK(verdict_on("a.ply", bytes, -x) == 1);
  }
  std::string stl(80, 's');
  stl += std::string("\2\0\0\0", 4);
  for (const int fourth : {6, 9}) {
    std::vector<float> triangle(12);
    std::copy(corners.begin(), corners.begin() + 6, triangle.begin() + 3);
    std::copy(corners.begin() + fourth, corners.begin() + fourth + 3, triangle.begin() + 9);
    stl += bytes_of_floats(triangle) + "ab";
  }
  CHECK(verdict_on("a.stl", stl, 9.0) == 0);
  CHECK(verdict_on("a.stl", stl, 9.5) == 1);
  // Bytes behind the last triangle, which the program skips with a note.
  CHECK(verdict_on("a.stl", stl + "tail", 9.0) == 0);
  CHECK(verdict_on("a.stl", stl + "tail", 9.5) == 1);
  // Nor is it text that stands there, as there are bytes 0. (Found by fuzzing.)
  CHECK(verdict_on("a.stl", stl + "\nvertex 8 8 8\n", 9.0) == 0);
  CHECK(verdict_on("a.stl", stl + "\nvertex 8 8 8\n", 9.5) == 1);
  // What may be either is neither.
  const std::string either = "solid" + std::string(75, ' ') + stl.substr(80);
  CHECK(verdict_on("a.stl", either, 9.0) == 0);
  CHECK(verdict_on("a.stl", either + "tail", 9.0) == 3);
  CHECK(verdict_on("a.stl", stl.substr(0, stl.size() - 1), 9.0) != 0);
  const std::string text =
      "solid vertex 1 1 1\nfacet normal 0 0 1\nouter loop\n VERTEX 0 0 0\nvertex 8 0 0\n"
      "vertex 0 8 0\nendloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex 9 0 8\n"
      "vertex 0 0 0\nvertex 8 0 0\nendloop\nendfacet\nendsolid\n";
  CHECK(verdict_on("a.stl", text, 9.0) == 0);
}

TEST_CASE("same points: a proof of exact decimals is about what they spell (#13)") {
  const ScratchFolder scratch;
  std::vector<RationalPoint> points;
  for (const Point& p : shapes::cut_cube(1, 0.25)) points.push_back(to_rational(p) / Rational(10));
  const std::string proof = proof_of(PointSet(points), Engine::Filtered, 6);
  std::string mesh;  // tenths of multiples of 1/4, so three digits behind the point
  for (const RationalPoint& p : points) {
    mesh += "v";
    for (const Rational& x : p) {
      const Integer thousandths = numerator(Rational(x * 1000));
      mesh += " " + to_string(thousandths) + "e-3";
    }
    mesh += "\n";
  }
  const CheckerVerdict same = check_proof(proof, scratch.write("a.obj", mesh));
  CHECK_MESSAGE(same.exit_code == 0, same.said);
  CHECK(same.said.find("decimals as spelt") != std::string::npos);
  mesh.replace(mesh.find("e-3"), 3, "000000000000000000001e-24");
  CHECK(check_proof(proof, scratch.write("a.obj", mesh)).exit_code == 1);
}

TEST_CASE("same points: rows of halfspaces, as rows and as .ine (#13)") {
  const auto row = [](int a, int b, int c, int d) {
    return Halfspace(IntegerVector3(a, b, c), Integer(d));
  };
  const std::vector<Halfspace> box = {row(1, 0, 0, -3),  row(-1, 0, 0, -3), row(0, 1, 0, -2),
                                      row(0, -1, 0, -2), row(0, 0, 1, -1),  row(0, 0, -1, -1),
                                      row(1, 1, 1, -5),  row(1, 0, 0, -4)};
  const std::string proof = proof_of(box, Engine::Filtered, 6);
  const ScratchFolder scratch;
  const auto verdict = [&](const std::string& name, const std::string& text) {
    return check_proof(proof, scratch.write(name, text)).exit_code;
  };
  const std::string rows =
      "1 0 0 -3\n-2 0 0 -6\n0 1/2 0 -1\n0 -1 0 -2 # y\n0 0 1 -1\n0 0 -.5 -0.5\n1 1 1 -5\n0 0 0 "
      "-1\n";
  CHECK(verdict("a.txt", rows + "1 0 0 -4\n") == 0);
  CHECK(verdict("a.txt", rows) == 1);
  CHECK(verdict("a.txt", rows + "1 0 0 -4.5\n") == 1);
  CHECK(verdict("a.txt", rows + "1 0 0 -4\n0 0 0 1\n") == 3);
  CHECK(verdict("a.txt", rows + "1 0 0 -4 2\n") == 3);
  const std::string ine =
      "box\nH-representation\nbegin\n8 4 rational\n3 -1 0 0\n3 1 0 0\n2 0 -1 0\n2 0 1 0\n1 0 0 -1\n"
      "1 0 0 1\n5/2 -1/2 -1/2 -1/2\n4 -1 0 0\nend\n";
  CHECK(verdict("a.ine", ine) == 0);
  CHECK(verdict("a.json", ine) == 3);
  CHECK(verdict("a.ine", "linearity 1 1\n" + ine) == 3);
  CHECK(verdict("a.obj", kBase) == 1);  // of another kind
}

TEST_CASE("same points: a file with the right points that is malformed in one place") {
  const std::string rows = "0 0 0\n8 0 0\n0 8 0\n9 0 8\n";
  const std::string obj = kBase + std::string("v 9 0 8\n");
  const auto ply = [&](const std::string& format, const std::string& more,
                       const std::string& body) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" + more +
           "end_header\n" + body;
  };
  const auto with = [](const std::string& more) {  // behind each point of a text
    return "0 0 0 " + more + "\n8 0 0 " + more + "\n0 8 0 " + more + "\n9 0 8 " + more + "\n";
  };
  const std::string floats = bytes_of_floats({0, 0, 0, 8, 0, 0, 0, 8, 0, 9, 0, 8});
  const std::string with_fours = bytes_of_floats({0, 0, 0, 1, 8, 0, 0, 1, 0, 8, 0, 1, 9, 0, 8, 1});
  const std::string little = "binary_little_endian";
  CHECK(verdict_on("a.obj", obj, 9.0) == 0);
  CHECK(verdict_on("a.off", "OFF\n4 0 0\n" + rows, 9.0) == 0);
  CHECK(verdict_on("a.ply", ply("ascii", "", rows), 9.0) == 0);
  CHECK(verdict_on("a.ply", ply("ascii", "property list char int w\n", with("1 7")), 9.0) == 0);
  CHECK(verdict_on("a.ply", ply(little, "", floats), 9.0) == 0);
  CHECK(verdict_on("a.ply", ply(little, "property uint w\n", with_fours), 9.0) == 0);
  const std::vector<std::pair<const char*, std::string>> malformed = {
      {"a.json", obj},
      {"a.obj", kBase + std::string("v 9 0 8 1 1 1 1 1\n")},
      {"a.obj", obj + "call other.obj\n"},
      {"a.off", ""},
      {"a.off", "CO\n4 0 0\n" + rows},
      {"a.off", "nOFF\n4 0 0\n" + rows},
      {"a.off", "OFF\n"},
      {"a.off", "OFF\nx 0 0\n" + rows},
      {"a.ply", "x" + ply("ascii", "", rows)},
      {"a.ply", ply("binary_middle_endian", "", floats)},
      {"a.ply", ply(little, "property quux w\n", with_fours)},
      {"a.ply", ply(little, "", floats.substr(0, 20))},
      {"a.ply", ply(little, "", std::string("\0\0\xc0\x7f", 4) + floats.substr(4))},  // NaN
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 4\n"},
      {"a.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n" + rows},
      {"a.ply", ply("ascii", "element edge\n", rows)},
      {"a.ply", ply("ascii", "element edge 0 0\n", rows)},
      {"a.ply", ply("ascii", "element edge x\n", rows)},
      {"a.ply", ply("ascii", "property float w u\n", with("1"))},
      {"a.ply", ply("ascii", "property float w u v\n", with("1"))},
      {"a.ply", ply("ascii", "property list char int\n", with("1 7"))},
      {"a.ply", ply("ascii", "colour blue\n", rows)},
      {"a.ply", ply("ascii", "property float w\n", rows)},
      {"a.ply", ply("ascii", "property list char int w\n", with("-1"))},
      {"a.ply", ply("ascii", "property list char int w\n", with("0.5 7"))},
      {"a.ply", ply("ascii", "property list char int w\n", with("99999999 7"))},
      {"a.ply", ply("ascii", "", with("1"))},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float "
       "y\nproperty float w\nend_header\n" +
           rows},
      {"a.obj", kBase + std::string("v 1e-200001 0 8\n")}};  // as a double it is 0
  for (const auto& file : malformed) {
    CAPTURE(file.second);
    CHECK(verdict_on(file.first, file.second, 9.0) == 3);
  }
}

TEST_CASE("same points: a list with the right rows that is malformed in one place") {
  const auto row = [](int a, int b, int c, int d) {
    return Halfspace(IntegerVector3(a, b, c), Integer(d));
  };
  const std::vector<Halfspace> solid = {row(-1, 0, 0, 0), row(0, -1, 0, 0), row(0, 0, -1, 0),
                                        row(1, 1, 1, -1)};
  const std::string proof = proof_of(solid, Engine::Filtered, 4);
  const ScratchFolder scratch;
  const auto verdict = [&](const std::string& name, const std::string& text) {
    return check_proof(proof, scratch.write(name, text)).exit_code;
  };
  const std::string rows = "0 1 0 0\n0 0 1 0\n0 0 0 1\n", last = "1 -1 -1 -1\n";
  const std::string begin = "begin\n4 4 rational\n";
  CHECK(verdict("a.ine", begin + rows + last + "end\n") == 0);
  CHECK(verdict("a.ine", begin + rows + "1/1 -1 -1 -1\nend\n") == 0);
  const std::string malformed[] = {
      "4 4 rational\n" + rows + last + "end\n",
      "begin\n4 4\n" + rows + last + "end\n",
      "begin\nx 4 rational\n" + rows + last + "end\n",
      "begin\n4 5 rational\n" + rows + last + "end\n",
      begin + rows + last + "stop\n",
      begin + rows + last + "end\nlinearity 1 1\n",
      begin + rows + "1 -1 -1 -1 0\nend\n",
      begin + rows + "1/0 -1 -1 -1\nend\n",
      begin + rows + "-1/-1 -1 -1 -1\nend\n",
      begin + rows + "1/x -1 -1 -1\nend\n",
  };
  for (const std::string& text : malformed) {
    CAPTURE(text);
    CHECK(verdict("a.ine", text) == 3);
  }
}

TEST_CASE("same points: points are no halfspaces of the same four numbers, and none are no file") {
  const std::vector<Point> points = {{1, 1, 1}, {9, 1, 1}, {1, 9, 1}, {1, 1, 9}};
  const std::string proof = proof_of(PointSet(points), Engine::Filtered, 4);
  const ScratchFolder scratch;
  const std::string rows = "1 1 1\n9 1 1\n1 9 1\n1 1 9\n",
                    halfspaces = "1 1 1 1\n9 1 1 1\n1 9 1 1\n1 1 9 1\n";
  CHECK(check_proof(proof, scratch.write("a.xyz", rows)).exit_code == 0);
  CHECK(check_proof(proof, scratch.write("a.txt", halfspaces)).exit_code == 1);
  CHECK(check_proof(proof, scratch.file("absent.xyz")).exit_code == 3);
}
