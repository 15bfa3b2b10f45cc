// SPDX-License-Identifier: MIT
// Meshes that lose edges: closed at every step, whatever the rule; and the three methods on solids
// whose answer is known.
#include "compare/collapse.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "compared_hulls.hpp"
#include "convexact/shapes.hpp"
#include "shapes/makers.hpp"

using namespace convexact;
using support::ComparedHull;
using support::refit_of;

namespace {

// The shortest edge goes to its middle.
class ShortestFirst : public CollapseRule {
 public:
  std::vector<Contraction> contractions(const CollapsingMesh& mesh, MeshCorner a,
                                        MeshCorner b) const override {
    return {{(mesh.at(a) - mesh.at(b)).norm(), Point((mesh.at(a) + mesh.at(b)) / 2)}};
  }
  void merged(MeshCorner, MeshCorner) override { ++merges; }

  std::size_t merges = 0;
};

// By the definition: each directed edge once, the reversed one too, and V - E + F = 2.
void check_closed_sphere(const CollapsingMesh& mesh) {
  std::map<std::pair<MeshCorner, MeshCorner>, int> directed;
  const std::vector<MeshTriangle> triangles = mesh.triangles();
  for (const MeshTriangle& t : triangles) {
    for (const std::size_t k : {0u, 1u, 2u}) ++directed[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : directed) {
    const std::pair<MeshCorner, MeshCorner> reversed(edge.second, edge.first);
    CHECK(count == 1);
    CHECK(directed.contains(reversed));
  }
  CHECK(mesh.corners().size() + triangles.size() == directed.size() / 2 + 2);
}

// [-4, 4]^3 without a corner of legs 1/2.
ComparedHull cut_cube() {
  std::vector<Point> points;
  for (int k = 0; k < 7; ++k) points.emplace_back(k & 1 ? 4 : -4, k & 2 ? 4 : -4, k & 4 ? 4 : -4);
  points.emplace_back(3.5, 4, 4);
  points.emplace_back(4, 3.5, 4);
  points.emplace_back(4, 4, 3.5);
  return ComparedHull(points);
}

}  // namespace

TEST_CASE("collapse: the mesh stays a closed sphere down to a tetrahedron") {
  for (const auto& points : {shapes::octahedron(), shapes::fibonacci_sphere(60)}) {
    const ComparedHull compared(points);
    ShortestFirst rule;
    CollapsingMesh mesh(compared.hull.vertices, compared.hull.triangles, rule);
    const std::size_t start = mesh.corners().size();
    for (std::size_t left = start; left-- > 4;) {
      mesh.reduce_to(left);
      check_closed_sphere(mesh);
    }
    CHECK(mesh.corners().size() == start - rule.merges);
    CHECK(mesh.corners().size() >= 4);
    mesh.reduce_to(1);  // a tetrahedron stays
    CHECK(mesh.corners().size() >= 4);
  }
}

TEST_CASE("collapse: without a legal collapse the mesh stays as it is") {
  class Never : public CollapseRule {
    std::vector<Contraction> contractions(const CollapsingMesh&, MeshCorner,
                                          MeshCorner) const override {
      return {{std::numeric_limits<double>::quiet_NaN(), Point(0, 0, 0)}};
    }
    void merged(MeshCorner, MeshCorner) override {}
  };
  const ComparedHull compared(shapes::fibonacci_sphere(20));
  Never rule;
  CollapsingMesh mesh(compared.hull.vertices, compared.hull.triangles, rule);
  mesh.reduce_to(4);
  CHECK(mesh.corners().size() == 20);
}

TEST_CASE("bloom, tlg: with room for every facet they are the hull") {
  const ComparedHull cube(shapes::cube());
  for (const char* name : {"bloom", "tlg"}) {
    CAPTURE(name);
    CHECK(refit_of(cube, name, 12).volume_ratio == 1);
  }
  const ComparedHull sphere(shapes::fibonacci_sphere(40));
  for (const char* name : {"bloom", "tlg", "qem-dual"}) {  // whose points are rounded
    const Rational ratio = refit_of(sphere, name, 76).volume_ratio;
    CHECK(ratio >= 1);
    CHECK(to_double(ratio, Rounding::Nearest) == doctest::Approx(1).epsilon(1e-9));
  }
}

// The cut takes 1/48 of 512 away, so the cube would be 1.00004 times as large.
TEST_CASE("bloom, tlg: a small cut goes first") {
  const ComparedHull cut = cut_cube();
  for (const char* name : {"bloom", "tlg"}) {
    CAPTURE(name);
    const double ratio = to_double(refit_of(cut, name, 12).volume_ratio, Rounding::Nearest);
    CHECK(ratio >= 1);
    CHECK(ratio < 1.001);
  }
}

TEST_CASE("collapsed meshes: few faces, and no more than asked for") {
  const ComparedHull sphere(shapes::fibonacci_sphere(100));
  for (const char* name : {"bloom", "tlg", "qem-dual"}) {
    for (const std::size_t faces : {4u, 6u, 18u}) {
      CAPTURE(std::string(name));
      CAPTURE(faces);
      const Normals normals = support::method(name).propose(sphere.hull, faces, 1);
      // Few edges at the end may have no point beyond all their planes.
      CHECK((normals.size() <= faces || (std::string(name) == "tlg" && faces == 4)));
      CHECK(normals.size() >= 4);
    }
  }
}
