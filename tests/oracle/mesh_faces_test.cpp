// SPDX-License-Identifier: MIT
// Faces that a surface may have without being another one, and faces that no surface may have. The
// solids are cubes and tetrahedra, so that what holds is known by looking.
#include <doctest/doctest.h>

#include <algorithm>

#include "convexact/format/candidate_file.hpp"
#include "convexact/oracle/verify.hpp"
#include "convexact/shapes/solids.hpp"

using namespace convexact;
using enum ClaimCode;

namespace {

const std::vector<Point> kCorner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// [-1, 1]^3 with z varying fastest: point 1 is (-1, -1, -1), point 8 is (1, 1, 1).
const std::string kCube =
    "v -1 -1 -1\nv -1 -1 1\nv -1 1 -1\nv -1 1 1\nv 1 -1 -1\nv 1 -1 1\nv 1 1 -1\nv 1 1 1\n";
const std::string kSides = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\n";  // no top

Verdict judge(const std::vector<Point>& input, const std::string& bytes,
              const char* name = "c.obj") {
  VerifyRequest request;
  request.tightness = false;
  StageLog log;
  return std::get<Verdict>(
      verify(PointSet(input), read_candidate_bytes(bytes, name), request, log));
}

Verdict judge_cube(const std::string& faces) { return judge(shapes::cube(), kCube + faces); }

bool has_note(const Verdict& verdict, const std::string& text) {
  return std::any_of(verdict.notes.begin(), verdict.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

bool is_violated(const Verdict& verdict, ClaimCode code) {
  return verdict[code].status == Status::Violated;
}

}  // namespace

TEST_CASE("faces: an edge of length zero is no edge (#13)") {
  const Verdict verdict = judge(kCorner,
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 0\n"
                                "f 1 3 2\nf 1 2 4 5\nf 5 4 3 1\nf 2 3 4\n");
  CHECK(verdict.holds());
  CHECK(has_note(verdict, "2 edges do not count: between points at the same place"));
}

TEST_CASE("faces: a triangle that is a point or an edge does not count (#13)") {
  const std::string tetrahedron =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 0\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  for (const char* more : {"f 1 2 1\n", "f 1 2 5\n", "f 1 1 1\n", "f 1 5 1 5\n", "f 2 3 2 3\n"}) {
    CAPTURE(more);
    const Verdict verdict = judge(kCorner, tetrahedron + more);
    CHECK(verdict.holds());
    CHECK(has_note(verdict, "face 4 does not count"));
  }
  const Verdict many = judge(kCorner, tetrahedron +
                                          "f 1 2 1\nf 1 3 1\nf 1 4 1\nf 2 3 2\nf 2 4 2\n"
                                          "f 3 4 3\n");
  CHECK(has_note(many, "faces 4, 5, 6, 7, 8 and 1 more do not count"));
}

TEST_CASE("faces: an STL with a triangle without area is closed (#13)") {
  const auto facet = [](const char* a, const char* b, const char* c) {
    return std::string("facet normal 0 0 0\nouter loop\nvertex ") + a + "\nvertex " + b +
           "\nvertex " + c + "\nendloop\nendfacet\n";
  };
  const char *o = "0 0 0", *x = "1 0 0", *y = "0 1 0", *z = "0 0 1";
  const Verdict verdict = judge(kCorner,
                                "solid s\n" + facet(o, y, x) + facet(o, x, z) + facet(o, z, y) +
                                    facet(x, y, z) + facet(o, o, x) + "endsolid s\n",
                                "c.stl");
  CHECK(verdict.holds());
}

TEST_CASE("faces: a sliver that closes a T-junction is part of the surface (#13)") {
  // The edge from 1 to 2 has the point 5 in its middle; one face has it as a corner, one has not.
  const std::string points = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nv 1 0 0\n";
  const std::vector<Point> input = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  const std::string rest = "f 1 4 3\nf 2 3 4\nf 1 2 4\n";
  CHECK(is_violated(judge(input, points + rest + "f 1 3 2 5\n"), MeshClosed));
  const Verdict closed = judge(input, points + rest + "f 1 3 2 5\nf 1 5 2\n");
  CHECK(closed.holds());
  CHECK(has_note(closed, "face 4 has no area: all corners on a line"));
  // Four corners on the line, there on one side and back on the other.
  CHECK(judge(input, points + "v 0.5 0 0\n" + rest + "f 1 3 2 5\nf 1 6 5 2\nf 5 6 1\n")[MeshPlanar]
            .status == Status::Holds);
  CHECK(is_violated(judge(input, points + "v 0.5 0 0\n" + rest + "f 1 3 2 5\nf 1 5 6 2\n"),
                    MeshPlanar));
}

TEST_CASE("faces: nothing but faces without three corners is no surface (#13)") {
  const Verdict verdict = judge_cube("f 1 1 1\nf 1 2 1\n");
  CHECK(is_violated(verdict, MeshClosed));
  CHECK(verdict[MeshConvex].status == Status::NotApplicable);
}

TEST_CASE("faces: bow-ties over overlapping triangles are no top of a cube (#13)") {
  // The top 2 6 8 4 as two triangles 2 6 8 and 2 6 4, which overlap, and bow-ties that cancel what
  // they have too much: every edge has two faces that run along it in opposite directions.
  CHECK(judge_cube(kSides + "f 2 6 8 4\n").holds());
  for (const char* top : {"f 2 6 4 8\n", "f 2 8 6 4\n", "f 2 6 8 4 2 6 8 4\n"}) {
    CAPTURE(top);
    const Verdict verdict = judge_cube(kSides + top);
    CHECK(is_violated(verdict, MeshPlanar));
    CHECK(verdict[MeshPlanar].witness.faces == std::vector<std::size_t>{5});
    CHECK_FALSE(verdict.holds());
  }
  // Bow-ties 6 8 2 4 and 8 2 4 6 on top of the overlapping triangles 2 6 8 and 2 6 4... their areas
  // as vectors add up to that of the square.
  const Verdict verdict = judge_cube(kSides + "f 2 6 8\nf 6 8 4 2\nf 2 8 6 4\nf 4 6 2\n");
  CHECK(is_violated(verdict, MeshPlanar));
}

TEST_CASE("faces: a face that runs out along an edge and back is not closed, nor a polygon (#13)") {
  // From 4 back to 2 by way of the middle of the top and back: 9 is (0, 0, 1).
  const Verdict verdict = judge(shapes::cube(), kCube + "v 0 0 1\n" + kSides + "f 2 6 8 9 8 4\n");
  CHECK(is_violated(verdict, MeshClosed));
  CHECK(verdict[MeshClosed].sentence.find("face 5 runs along the edge") != std::string::npos);
  CHECK(is_violated(verdict, MeshPlanar));
}

TEST_CASE("faces: touching itself is as bad as crossing (#13)") {
  const std::string more = "v 0 0 1\nv 0 -1 1\nv 0 1 1\n";  // 9 in the middle, 10 and 11 on edges
  const auto top = [&](const char* faces) {
    return judge(shapes::cube(), kCube + more + kSides + faces)[MeshPlanar].status;
  };
  CHECK(top("f 2 6 8 9\nf 9 8 4\nf 2 9 4\n") == Status::Holds);  // not convex
  CHECK(top("f 2 10 6 8 4 \n") == Status::Holds);                // a straight corner
  CHECK(top("f 2 6 9 8 4 9\n") == Status::Violated);             // a corner twice
  CHECK(top("f 2 6 8 10 4\n") == Status::Violated);              // a corner on an edge
  CHECK(top("f 2 6 10 8 4\n") == Status::Violated);              // back along an edge
  CHECK(top("f 2 10 11 9 6 8 4\n") == Status::Violated);         // out and back, and away
}

TEST_CASE("faces: bent ones are judged as seen along their normal (#13)") {
  // The corner 8 lifted to z = 2. Seen from above, 9 lies on the edge from 2 to 6.
  std::string lifted = kCube + "v 0 -1 1\n";
  lifted.replace(lifted.rfind("v 1 1 1"), 7, "v 1 1 2");
  const Verdict bent = judge(shapes::cube(), lifted + kSides + "f 2 6 8 4\n");
  CHECK(bent[MeshPlanar].witness.squared_distance.has_value());
  const Verdict crossed = judge(shapes::cube(), lifted + kSides + "f 2 6 8 9 4\n");
  CHECK(is_violated(crossed, MeshPlanar));
  CHECK_FALSE(crossed[MeshPlanar].witness.squared_distance.has_value());
}
