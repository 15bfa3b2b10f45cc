// SPDX-License-Identifier: MIT
// Exact volumes against lrs [Avis2000], third-party truth: hulls of lattice points and of every
// family of shapes, and the shipped meshes at 100, 18 and 6 halfspaces. For these lrs gets the
// planes only: it finds the vertices itself and takes their volume.
#include "lrs.hpp"

#include <doctest/doctest.h>

#include "convexact/dual.hpp"
#include "convexact/hull.hpp"
#include "convexact/io.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"
#include "convexact/shapes.hpp"
#include "lp/interior_point.hpp"
#include "number/arithmetic.hpp"
#include "shapes/makers.hpp"
#include "shipped_meshes.hpp"
#include "simplify/exact_engine.hpp"
using namespace convexact;

namespace {

std::vector<RationalPoint> to_list(const PointSet& points) {
  std::vector<RationalPoint> list;
  for (std::size_t i = 0; i < points.size(); ++i) list.push_back(points[PointId(i)]);
  return list;
}

Rational hull_volume(const PointSet& points) {
  return volume(to_polytope(std::get<Hull>(convex_hull(points)), points));
}

RationalPoint interior_point(const Hull& hull, const PointSet& points, const DualHull& dual) {
  RationalPoint sum = RationalPoint::Zero();
  for (const PointId id : hull.certificate.simplex) sum += points[id];
  return short_dyadic_interior_point(dual.halfspaces, sum / Rational(4)).value();
}

// By the steps down to `faces` halfspaces.
Rational added_volume(const Run& trace, std::size_t faces) {
  std::vector<Rational> costs;
  for (const Step& step : trace.steps) {
    if (step.left >= faces) costs.push_back(step.cost->rational());
  }
  return balanced_sum(std::move(costs));
}

}  // namespace

TEST_CASE("volume: hulls of lattice points agree with lrs") {
  const Lrs lrs("lattice");
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const PointSet points(shapes::lattice(25, 1 + seed % 5, seed));
    CHECK(hull_volume(points) == lrs.volume(to_list(points)));
  }
}

TEST_CASE("volume: every family of solids agrees with lrs") {
  const Lrs lrs("families");
  for (const shapes::Family& family : shapes::families()) {
    const auto points = PointSet(shapes::generate(family, shapes::usual_values(family)));
    if (family.dimension < 3 || points.size() > 200) continue;
    CAPTURE(family.name);
    CHECK(hull_volume(points) == lrs.volume(to_list(points)));
  }
}

TEST_CASE("volume: shipped meshes at 100, 18 and 6 halfspaces agree with lrs") {
  const Lrs lrs("meshes");
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    const PointSet points = read_mesh(path).points;
    const Hull hull = std::get<Hull>(convex_hull(points));
    const DualHull dual = dual_of(hull, points);
    const RationalPoint center = interior_point(hull, points, dual);
    const Run trace = simplify_exact(dual, center, {.faces = 6, .verify = VerifyLevel::None});
    REQUIRE(trace.stop == StopReason::Reached);
    const Rational input_volume = volume(to_polytope(hull, points));
    for (const std::size_t faces : {100u, 18u, 6u}) {
      CAPTURE(faces);
      const std::vector<Halfspace> planes = left_after(trace, trace.halfspaces.size() - faces);
      const DualHull left = dual_of(planes, center).dual;
      const Polytope polytope = to_polytope(left.halfspaces, left.triangles);
      CHECK(volume(polytope) == lrs.volume(lrs.vertices(planes)));
      CHECK(volume(polytope) == input_volume + added_volume(trace, faces));
    }
  }
}
