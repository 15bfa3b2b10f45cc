// SPDX-License-Identifier: MIT
// What convexact-check accepts: the proofs of every engine, of solids full of ties, of every kind
// of input and of every format. The mutations show that an accepted run is right, and so do the
// other tests, which judge the same engines by the definition.

#include "checker.hpp"
#include "convexact/io.hpp"
#include "proofs.hpp"
#include "shapes/makers.hpp"
#include "shipped_meshes.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

constexpr Engine kEngines[] = {Engine::Exact, Engine::Filtered, Engine::Float};

void check_accepted(const std::string& proof) {
  const CheckerVerdict verdict = check_proof(proof);
  CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
}

void check_engines(const Shape& shape, std::size_t faces) {
  for (const Engine engine : kEngines) {
    CAPTURE(static_cast<int>(engine));
    check_accepted(proof_of(shape, engine, faces));
    check_accepted(proof_of(shape, engine, faces, Precision::Binary64));
    check_accepted(proof_of(shape, engine, faces, Precision::Binary32));
    check_accepted(proof_of(shape, engine, faces, {}, CostMeasure::Area));
    check_accepted(proof_of(shape, engine, faces, Precision::Binary64, CostMeasure::MeanWidth));
  }
}

}  // namespace

TEST_CASE("proof: solids full of ties, by every engine, in every format" * sweep) {
  const std::vector<std::pair<const char*, std::vector<Point>>> solids = {
      {"tetrahedron", shapes::tetrahedron()},
      {"cube", shapes::cube()},
      {"octahedron", shapes::octahedron()},
      {"dodecahedron", shapes::dodecahedron()},
      {"icosahedron", shapes::icosahedron()},
      {"prism", shapes::prism(12)},
      {"antiprism", shapes::antiprism(9)},
      {"bipyramid", shapes::bipyramid(8)},
      {"pyramid of 40 sides", shapes::pyramid(40)},
      {"chamfered box", shapes::chamfered_box({3, 2, 1}, 0.25)},
      {"rounded box", shapes::rounded_box({3, 2, 1}, 0.5, 2)},
      {"cut cube", shapes::cut_cube(5, 0.25)},
      {"lattice", shapes::grid(4)},
  };
  for (const auto& solid : solids) {
    CAPTURE(solid.first);
    check_engines(PointSet(solid.second), 7);
    check_accepted(proof_of(PointSet(solid.second), Engine::Filtered, 4));
  }
}

TEST_CASE("proof: nothing to remove is a run too") {
  const Shape cube = PointSet(shapes::cube());
  for (const Engine engine : kEngines) check_accepted(proof_of(cube, engine, 6));
}

TEST_CASE("proof: ties are counted, and a float run claims no greed") {
  // Of the cut cube the corners cut off are equal: all removals of them but the last are tied.
  const Shape shape = PointSet(shapes::cut_cube(8, 0.25));
  const CheckerVerdict exact = check_proof(proof_of(shape, Engine::Filtered, 6));
  CHECK(exact.exit_code == 0);
  CHECK(exact.said.find("proven: each was the cheapest, 7 of them tied") != std::string::npos);
  const CheckerVerdict quick = check_proof(proof_of(shape, Engine::Float, 6));
  CHECK(quick.exit_code == 0);
  CHECK(quick.said.find("not claimed: each was the cheapest") != std::string::npos);
  // Whatever the measure, it shows the volumes: 1/6 of 1/4 cubed for a corner.
  for (const CostMeasure cost : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    const std::string proof = proof_of(shape, Engine::Float, 6, {}, cost);
    CHECK(proof.starts_with("convexact-proof 2 costs\n"));
    CHECK(proof.find(" cost 1/384 ring ") != std::string::npos);
    CHECK(check_proof(proof).said.find("each of 8 removals adds the stated volume") !=
          std::string::npos);
  }
}

TEST_CASE("proof: repeats, and points within facets, edges and the solid") {
  std::vector<Point> points = shapes::cut_cube(3, 0.5);
  const std::vector<Point> corners = points;
  for (const Point& p : corners) {
    points.push_back(p);
    points.push_back(p / 2);
  }
  for (std::size_t k = 1; k < corners.size(); ++k) points.push_back((corners[k] + corners[0]) / 2);
  check_engines(PointSet(points), 5);
}

TEST_CASE("proof: halfspaces, with redundant ones and repeats") {
  const auto row = [](int a, int b, int c, int d) {
    return Halfspace(IntegerVector3(a, b, c), Integer(d));
  };
  // A box with two corners cut off, a weaker parallel, a repeat, and one that touches a vertex.
  const std::vector<Halfspace> halfspaces = {
      row(1, 0, 0, -3), row(-1, 0, 0, -3), row(0, 1, 0, -2),  row(0, -1, 0, -2),
      row(0, 0, 1, -1), row(0, 0, -1, -1), row(1, 1, 1, -5),  row(-3, 5, 1, -19),
      row(1, 0, 0, -4), row(0, 0, 1, -1),  row(1, -1, 1, -6), row(2, 2, 2, -11)};
  check_engines(halfspaces, 6);
  check_engines(halfspaces, 4);
}

TEST_CASE("proof: decimals taken as they are spelt") {
  std::vector<RationalPoint> points;
  for (const Point& p : shapes::cut_cube(8, 0.25)) points.push_back(to_rational(p) / Rational(10));
  points.push_back(RationalPoint(Rational(1, 3), Rational(1, 7), Rational(0)) / Rational(10));
  check_engines(PointSet(points), 5);
}

TEST_CASE("proof: coordinates far from one") {
  for (const double scale : {0x1p-1000, 0x1p-40, 0x1p40, 0x1p900}) {
    std::vector<Point> points = shapes::cut_cube(6, 0.25);
    for (Point& p : points) p *= scale;
    for (const Engine engine : kEngines) {
      check_accepted(proof_of(PointSet(points), engine, 5, Precision::Binary64));
    }
    check_accepted(proof_of(PointSet(points), Engine::Filtered, 5, {}, CostMeasure::Area));
  }
}

TEST_CASE("proof: a shipped mesh" * sweep) {
  for (const std::string& path : shipped_meshes()) {
    if (path.find("spot") == std::string::npos) continue;
    const PointSet points = read_mesh(path).points;
    check_accepted(proof_of(points, Engine::Filtered, 18, Precision::Binary64));
    check_accepted(proof_of(points, Engine::Float, 18, Precision::Binary32));
    check_accepted(proof_of(points, Engine::Filtered, 18, {}, CostMeasure::Area));
    check_accepted(proof_of(points, Engine::Filtered, 18, {}, CostMeasure::MeanWidth));
  }
}
