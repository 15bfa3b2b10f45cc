// SPDX-License-Identifier: MIT
// Faces that a surface may have without being another one, and faces that no surface may have. The
// solids are cubes and tetrahedra, so the claims that hold are evident.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "convexact/verify.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"

using namespace convexact;
using enum ClaimCode;

namespace {

const std::vector<Point> kCorner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// [-1, 1]^3 with z varying fastest: point 1 is (-1, -1, -1), point 8 is (1, 1, 1).
const std::string kCube =
    "v -1 -1 -1\nv -1 -1 1\nv -1 1 -1\nv -1 1 1\nv 1 -1 -1\nv 1 -1 1\nv 1 1 -1\nv 1 1 1\n";
const std::string kSides = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\n";  // no top

Verdict judge(const std::vector<Point>& input, const Candidate& candidate,
              const char* tolerance = "0") {
  VerifyRequest request;
  request.tightness = false;
  request.tolerance = parse_tolerance(tolerance);
  return std::get<Verdict>(verify(PointSet(input), candidate, request));
}

Verdict judge(const std::vector<Point>& input, const std::string& bytes,
              const char* name = "c.obj") {
  return judge(input, read_candidate_bytes(bytes, name));
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

TEST_CASE("faces: a bent one is not in the surface of the hull, a point beyond it or not (#13)") {
  // The corner 4 of the top lower or higher by 2^-30: no facet plane holds the bent face.
  for (const double z : {1 - 0x1p-30, 1 + 0x1p-30}) {
    CAPTURE(z);
    Mesh mesh = std::get<Mesh>(read_candidate_bytes(kCube + kSides + "f 2 6 8 4\n", "c.obj"));
    std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
    points[3][2] = z;
    mesh.points = PointSet(points);
    CHECK(is_violated(judge(shapes::cube(), mesh), MeshConvex));
    CHECK(judge(shapes::cube(), mesh, "1e-6")[MeshConvex].status == Status::Holds);
  }
}

TEST_CASE("faces: a spike out of the plane of its face is no bend (#13)") {
  // Down from corner 6 to 5 and back: seen from above, the spike is a point.
  const Verdict verdict = judge_cube(kSides + "f 2 6 5 6 8 4\n");
  CHECK(is_violated(verdict, MeshPlanar));
  CHECK_FALSE(verdict[MeshPlanar].witness.squared_distance.has_value());
}

TEST_CASE("faces: with a tolerance, too, the hull is covered once (#13)") {
  Mesh mesh = std::get<Mesh>(read_candidate_bytes(kCube + kSides + "f 2 6 8 4\n", "c.obj"));
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  for (std::size_t k = 0; k < 8; ++k) points.push_back(points[k] * (1 - 0x1p-20));
  mesh.points = PointSet(points);
  for (std::size_t f = 0; f < 6; ++f) {
    auto inner = mesh.polygons[f];
    for (std::uint32_t& corner : inner) corner += 8;
    mesh.polygons.push_back(inner);
  }
  const Verdict exact = judge(shapes::cube(), mesh);
  CHECK(is_violated(exact, MeshConvex));
  CHECK(exact[MeshConvex].witness.squared_distance.has_value());
  CHECK_FALSE(exact.smallest_tolerance.has_value());  // as there is none
  CHECK(is_violated(judge(shapes::cube(), mesh, "1e-3"), MeshConvex));
}

namespace {

using Place = std::array<long, 2>;

long turn(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool is_on(const Place& a, const Place& b, const Place& p) {
  return turn(a, b, p) == 0 && (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]) <= 0;
}

bool do_cross(const Place& a, const Place& b, const Place& c, const Place& d) {
  const auto sign = [](long x) { return (x > 0) - (x < 0); };
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 &&
         sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

// Every pair of a corner and an edge, and of two edges.
bool is_simple_by_definition(const std::vector<Place>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Place &a = polygon[i], &b = polygon[(i + 1) % n];
    for (std::size_t j = 0; j < n; ++j) {
      if (j != i && j != (i + 1) % n && is_on(a, b, polygon[j])) return false;
      if (do_cross(a, b, polygon[j], polygon[(j + 1) % n])) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("faces: outlines of random polygons, by the definition (#13)") {
  Random random(7);
  std::size_t simple = 0, others = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const std::size_t n = 4 + uniform_below(random, 3);
    std::vector<Place> polygon;
    while (polygon.size() < n) {
      const Place p = {static_cast<long>(uniform_below(random, 5)),
                       static_cast<long>(uniform_below(random, 5))};
      if (std::find(polygon.begin(), polygon.end(), p) == polygon.end()) polygon.push_back(p);
    }
    long area = 0;
    for (std::size_t k = 1; k + 1 < n; ++k) area += turn(polygon[0], polygon[k], polygon[k + 1]);
    if (area == 0) continue;
    std::vector<Point> points;
    std::vector<std::uint32_t> face;
    for (const auto& [x, y] : polygon) {
      face.push_back(static_cast<std::uint32_t>(points.size()));
      points.emplace_back(x, y, x - 2 * y);  // in a slanted plane
    }
    CAPTURE(trial);
    Mesh mesh;
    mesh.points = PointSet(points);
    mesh.polygons = {face};
    const Status status = judge(shapes::cube(), mesh)[MeshPlanar].status;
    CHECK((status == Status::Holds) == is_simple_by_definition(polygon));
    (is_simple_by_definition(polygon) ? simple : others) += 1;
  }
  CHECK(simple > 500);
  CHECK(others > 500);
}
