// SPDX-License-Identifier: MIT
// Property of hull: on small grids (repeats, coplanar and flat points) the hull has exactly the
// vertices and facets of the hull by definition, and check_hull() accepts its certificate; points
// that span no volume are reported as flat, with their dimension and a proof. The same holds for
// every seed and insertion order, and for images of the grid in last bits and in thirds of units.
#include <limits>

#include "convexact/hull.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "grid_hull.hpp"

using namespace convexact;

namespace {

// The same grid for each kind of arithmetic: numbers that need no rounding, doubles whose products
// cancel down to the last bits, and rationals that are no doubles. All maps keep orientations.
PointSet image_of(const std::vector<Point>& grid, std::size_t kind) {
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

std::vector<std::uint32_t> indices(std::span<const PointId> ids) {
  std::vector<std::uint32_t> list;
  for (const PointId id : ids) list.push_back(id.value);
  return list;
}

// The polytope's planes pass through the corners of their facets, with all other vertices inside.
void check_planes(const Polytope& polytope) {
  for (std::size_t f = 0; f < polytope.planes.size(); ++f) {
    const std::vector<std::uint32_t>& facet = polytope.facets[f];
    for (std::uint32_t v = 0; v < polytope.vertices.size(); ++v) {
      const bool is_corner = std::find(facet.begin(), facet.end(), v) != facet.end();
      const Rational value = polytope.planes[f](polytope.vertices[v]);
      FUZZ_CHECK(is_corner ? value == 0 : value < 0);
    }
  }
  FUZZ_CHECK(std::is_sorted(polytope.planes.begin(), polytope.planes.end()));
}

void hold_hull(FuzzInput& in) {
  HullOptions options;
  options.seed = in.byte();
  options.furthest_first_effort = static_cast<double>(in.below(3)) / 2;
  const std::size_t kind = in.below(3);
  const std::vector<Point> grid = in.grid_points(in.rarely() ? 20 : 8, 3);
  const PointSet points = image_of(grid, kind);
  const grid_hull::Expected expected(grid);
  const HullOutcome outcome = convex_hull(points, options);
  if (const auto* flat = std::get_if<FlatInput>(&outcome)) {
    FUZZ_CHECK(flat->dimension == expected.dimension);
    FUZZ_CHECK(check_flat(*flat, points));
    return;
  }
  FUZZ_CHECK(expected.dimension == 3);
  const Hull& hull = std::get<Hull>(outcome);
  FUZZ_CHECK(check_hull(hull, points));
  FUZZ_CHECK(indices(hull.vertices) == expected.vertices);
  std::set<std::vector<std::uint32_t>> facets;
  for (std::size_t f = 0; f < hull.facets.size(); ++f) facets.insert(indices(hull.facets[f]));
  FUZZ_CHECK(facets.size() == hull.facets.size() && facets == expected.facets);
  check_planes(to_polytope(hull, points));
}

const FuzzTarget kHull("hull", hold_hull);

}  // namespace
