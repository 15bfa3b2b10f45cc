// SPDX-License-Identifier: MIT
// Parts from meshes with several objects, folders, and JSON.
#include <doctest/doctest.h>

#include "convexact/verify_parts.hpp"
#include "expect_error.hpp"
#include "process.hpp"

using namespace convexact;
using enum ClaimCode;

namespace {

const std::string kTetrahedra =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 5 5\n"
    "o first\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
    "v 1 1 1\no second\nf 2 3 4\nf 2 4 6\n";

const std::vector<NamedPart>& parts_in(const CandidateParts& candidate) {
  return std::get<std::vector<NamedPart>>(candidate);
}

// The claim that is violated because of the bytes, and its sentence.
Claim refusal(const std::string& bytes, const std::string& path) {
  const PartsVerdict verdict = verify_parts(Mesh{PointSet(std::vector<Point>{{0, 0, 0}}), {}, {}},
                                            read_parts_bytes(bytes, path));
  for (const Claim& claim : verdict.claims) {
    if (claim.status == Status::Violated) return claim;
  }
  FAIL("nothing was refused");
  return {};
}

}  // namespace

TEST_CASE("read_parts: objects of an OBJ, with the points that they use and those that none uses") {
  const auto parts = read_parts_bytes(kTetrahedra, "a.obj");
  REQUIRE(parts_in(parts).size() == 2);
  CHECK(parts_in(parts)[0].name == "first");
  CHECK(parts_in(parts)[0].mesh.points.size() == 4);
  CHECK(parts_in(parts)[0].mesh.polygons.size() == 4);
  CHECK(parts_in(parts)[1].name == "second");
  CHECK(parts_in(parts)[1].mesh.points.size() == 4);
}

TEST_CASE("read_parts: a single part has all points, and the name of the file") {
  const auto parts = read_parts_bytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n", "x/box.obj");
  REQUIRE(parts_in(parts).size() == 1);
  CHECK(parts_in(parts)[0].name == "box");
  CHECK(parts_in(parts)[0].mesh.points.size() == 4);
  CHECK(parts_in(read_parts_bytes("", "empty.obj")).empty());
}

TEST_CASE("read_parts: JSON") {
  const auto parts = read_parts_bytes(
      R"({"method": "any", "parts": [{"name": "a", "vertices": [[0, 0.5, "1/3"]], "x": 1},
          {"vertices": [[1, 2, 3], [0x0, 0, 0]], "faces": []}]})",
      "parts.json");
  CHECK(std::holds_alternative<Error>(parts));  // 0x0 is no JSON
  const auto good = read_parts_bytes(
      R"({"parts": [{"name": "a", "vertices": [[0, 0.5, "1/3"]], "x": 1},
          {"vertices": [[1, 2, 3], [0, 0, 0], [1, 1, 1]], "faces": [[0, 1, 2]]}]})",
      "parts.json");
  REQUIRE(parts_in(good).size() == 2);
  CHECK(parts_in(good)[0].name == "a");
  CHECK(parts_in(good)[0].mesh.points[PointId(0)][2] == Rational(1, 3));
  CHECK(parts_in(good)[1].name == "part_001");
  CHECK(parts_in(good)[1].mesh.polygons.size() == 1);
}

TEST_CASE("read_parts: what is malformed is a violated claim, with its place") {
  const Claim line = refusal("v 0 0 0\nv 1 0\n", "a.obj");
  CHECK(line.code == PartsReadable);
  CHECK(line.witness.line == std::size_t(2));
  CHECK(refusal("v 0 0 nan\n", "a.obj").code == PartsFinite);
  CHECK(refusal(R"({"parts": [{"vertices": [[0, 0, 1e999]]}]})", "a.json").code == PartsFinite);
  for (const char* bytes :
       {"{", "[]", "{\"parts\": 1}", R"({"parts": [1]})", R"({"parts": [{}]})",
        R"({"parts": [{"name": 1, "vertices": [[0, 0, 0]]}]})", R"({"parts": [{"vertices": []}]})",
        R"({"parts": [{"vertices": [[1, 2]]}]})",
        R"({"parts": [{"vertices": [[1, 2, 3]], "faces": [[0, 1, 2]]}]})"}) {
    CAPTURE(bytes);
    CHECK(refusal(bytes, "a.json").code == PartsReadable);
  }
}

TEST_CASE("read_parts: a folder, its meshes by their numbers") {
  const support::ScratchFolder folder;
  for (const char* name : {"part_10.obj", "part_2.obj", "part_1.OBJ"}) {
    folder.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  }
  folder.write("notes.txt", "no mesh");
  folder.write(".hidden.obj", "no mesh");
  folder.write("two.obj", kTetrahedra);
  const auto parts = read_parts(folder.file(""));
  REQUIRE(parts_in(parts).size() == 5);
  const char* names[] = {"part_1", "part_2", "part_10", "two: first", "two: second"};
  for (std::size_t k = 0; k < 5; ++k) CHECK(parts_in(parts)[k].name == names[k]);

  folder.write("part_3.obj", "# nothing\n");
  CHECK(std::holds_alternative<Error>(read_parts(folder.file(""))));
  folder.write("part_3.obj", "f 1 2 3\n");
  const auto broken = read_parts(folder.file(""));
  REQUIRE(std::holds_alternative<Error>(broken));
  CHECK(std::string(std::get<Error>(broken).what()).find("part_3.obj:1: ") != std::string::npos);
}

TEST_CASE("read_parts: no file, and a folder without a mesh") {
  const support::ScratchFolder folder;
  CHECK(error_of([&] { return read_parts(folder.file("none.obj")); }).code() ==
        ErrorCode::Unreadable);
  const Error empty = error_of([&] { return read_parts(folder.file("")); });
  CHECK(empty.code() == ErrorCode::Unreadable);
  CHECK(std::string(empty.what()).find("holds no mesh") != std::string::npos);
}
