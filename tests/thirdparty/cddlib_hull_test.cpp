// SPDX-License-Identifier: MIT
// Hulls against cddlib's double description [Fukuda, cddlib, built on GMP], third-party truth: the
// same planes on every family of solids of up to 150 points (its cost grows steeply).
#include <doctest/doctest.h>

#include <set>

#include "cddlib.hpp"
#include "convexact/shapes.hpp"
#include "hull_outline.hpp"
#include "shapes/makers.hpp"
using namespace convexact;

namespace {

// The facets, sorted; from rows (b, A) with b + A x >= 0.
std::vector<Halfspace> planes_of_cddlib(const PointSet& points) {
  const CddGlobals globals;
  const auto rows = static_cast<dd_rowrange>(points.size());
  dd_MatrixPtr input = dd_CreateMatrix(rows, 4);
  input->representation = dd_Generator;
  input->numbtype = dd_Rational;
  for (dd_rowrange i = 0; i < rows; ++i) {
    mpq_set_si(input->matrix[i][0], 1, 1);
    const RationalPoint p = points[PointId(static_cast<std::size_t>(i))];
    for (int k = 0; k < 3; ++k) mpq_set(input->matrix[i][k + 1], p[k].backend().data());
  }
  dd_ErrorType error = dd_NoError;
  dd_PolyhedraPtr polyhedron = dd_DDMatrix2Poly(input, &error);
  REQUIRE(error == dd_NoError);
  dd_MatrixPtr output = dd_CopyInequalities(polyhedron);
  std::set<Halfspace> planes;
  for (dd_rowrange i = 0; i < output->rowsize; ++i) {
    RationalVector3 normal;
    for (int k = 0; k < 3; ++k) normal[k] = -to_rational(output->matrix[i][k + 1]);
    planes.emplace(normal, Rational(-to_rational(output->matrix[i][0])));
  }
  dd_FreeMatrix(output);
  dd_FreePolyhedra(polyhedron);
  dd_FreeMatrix(input);
  return {planes.begin(), planes.end()};
}

void check_same_planes(const PointSet& points) {
  const HullOutline ours = outline_of(std::get<Hull>(convex_hull(points)), points);
  const std::vector<Halfspace> theirs = planes_of_cddlib(points);
  CHECK(ours.planes.size() == theirs.size());
  CHECK(ours.planes == theirs);
}

}  // namespace

TEST_CASE("convex_hull: the planes of cddlib on every family of solids") {
  for (const shapes::Family& family : shapes::families()) {
    const PointSet points(shapes::generate(family, shapes::usual_values(family)));
    if (family.dimension < 3 || points.size() > 150) continue;
    CAPTURE(family.name);
    check_same_planes(points);
  }
}

TEST_CASE("convex_hull: the planes of cddlib on lattice points") {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    check_same_planes(PointSet(shapes::lattice(20, 1 + seed % 4, seed)));
  }
}
