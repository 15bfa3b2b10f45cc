// SPDX-License-Identifier: MIT
// Property: on small grids (repeats, coplanar and flat points) the hull has exactly the vertices
// and facets of the hull by definition, and check_hull() accepts its certificate; points that span
// no volume are said to, with their dimension and a proof. Neither seed nor insertion order
// matters.
#include <limits>

#include "affine_dimension.hpp"
#include "convexact/hull/hull.hpp"
#include "fuzz_check.hpp"
#include "fuzz_input.hpp"
#include "polytope_by_definition.hpp"

using namespace convexact;

namespace {

// The same grid for each kind of arithmetic: numbers that need no rounding, doubles whose products
// cancel down to the last bits, and rationals that are no doubles.
PointSet grid_of_some_kind(FuzzInput& in) {
  const std::size_t kind = in.below(3);
  const std::vector<Point> grid = in.grid_points(16, 3);
  if (kind == 0) return PointSet(grid);
  if (kind == 1) {
    std::vector<Point> close;
    for (const Point& p : grid) {
      close.push_back(Point::Ones() + p * std::numeric_limits<double>::epsilon());
    }
    return PointSet(close);
  }
  std::vector<RationalPoint> thirds;
  for (const Point& p : grid) thirds.push_back(to_rational(p) / Rational(3));
  return PointSet(thirds);
}

void check_flat_input(const FlatInput& flat, const PointSet& points, int dimension) {
  FUZZ_CHECK(flat.dimension == dimension);
  FUZZ_CHECK(check_flat(flat, points));
}

void check_solid(const Hull& hull, const PointSet& points, int dimension) {
  FUZZ_CHECK(dimension == 3);
  FUZZ_CHECK(check_hull(hull, points));
  const Polytope found = to_polytope(hull, points);
  const Polytope expected = polytope_by_definition(points);
  FUZZ_CHECK(found.vertices == expected.vertices);
  FUZZ_CHECK(found.planes == expected.planes);
  FUZZ_CHECK(found.facets == expected.facets);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput in(data, size);
  HullOptions options;
  options.seed = in.byte();
  options.furthest_first_effort = static_cast<double>(in.below(3)) / 2;
  const PointSet points = grid_of_some_kind(in);
  std::vector<RationalPoint> exact;
  for (std::size_t i = 0; i < points.size(); ++i) exact.push_back(points[PointId(i)]);
  const int dimension = affine_dimension(exact);
  const HullOutcome outcome = convex_hull(points, options);
  if (const auto* flat = std::get_if<FlatInput>(&outcome)) {
    check_flat_input(*flat, points, dimension);
  } else {
    check_solid(std::get<Hull>(outcome), points, dimension);
  }
  return 0;
}
