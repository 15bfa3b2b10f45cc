// SPDX-License-Identifier: MIT
// Meshes in floating point. Judged by stored_checker.hpp, which computes from the definition.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "convexact/shapes.hpp"
#include "convexact/stored.hpp"
#include "expect_error.hpp"
#include "property.hpp"
#include "shapes/makers.hpp"
#include "solid/solid.hpp"
#include "stored_cases.hpp"

using namespace convexact;
using namespace stored_cases;

namespace {

StoredMesh store(const Case& c, Precision precision) {
  return store_mesh(c.exact, c.input, c.witnesses, precision);
}

stored_file::Solid to_solid(const Mesh& mesh) {
  stored_file::Solid solid;
  for (const Point& p : mesh.points.doubles()) solid.vertices.push_back({p.x(), p.y(), p.z()});
  for (const auto& polygon : mesh.polygons) {
    solid.polygons.emplace_back(polygon.begin(), polygon.end());
  }
  return solid;
}

// What is promised of every mesh: numbers of the format, polygons that are the facets of the hull
// of its points, and every input point in that hull.
bool keeps_promises(const StoredMesh& stored, const Case& c) {
  if (!stored.mesh.points.is_binary() || stored.violations != 0) return false;
  for (const Point& p : stored.mesh.points.doubles()) {
    for (int k = 0; k < 3; ++k) {
      if (stored.precision == Precision::Binary32 && double(float(p[k])) != p[k]) return false;
    }
  }
  const auto planes = stored_checker::hull_planes(to_solid(stored.mesh));
  if (planes.empty()) return false;
  return stored_checker::count_outside(planes, to_homogeneous(c.input)) == 0 &&
         stored.growth.push >= 0 && stored.growth.volume_ratio > 0;
}

// Whether a vertex of the mesh is not the nearest number to a vertex of the result.
bool is_pushed(const StoredMesh& stored, const Case& c) {
  std::vector<Point> nearest;
  for (const RationalPoint& v : c.exact.vertices) {
    Point& p = nearest.emplace_back();
    for (int k = 0; k < 3; ++k) p[k] = round_to(stored.precision, v[k], Rounding::Nearest);
  }
  const auto is_nearest = [&](const Point& p) {
    return std::find(nearest.begin(), nearest.end(), p) != nearest.end();
  };
  const auto points = stored.mesh.points.doubles();
  return !std::all_of(points.begin(), points.end(), is_nearest);
}

bool stored_or_refused(const Case& c, Precision precision) {
  try {
    return keeps_promises(store(c, precision), c);
  } catch (const Error& error) {
    return error.code() == ErrorCode::Unrepresentable;
  }
}

}  // namespace

TEST_CASE("store_mesh: what the format holds exactly is not pushed") {
  const Case cube = *hull_case(PointSet(shapes::cube()));
  for (const Precision precision : kPrecisions) {
    const StoredMesh stored = store(cube, precision);
    CHECK_FALSE(is_pushed(stored, cube));
    CHECK(stored.mesh.points.size() == 8);
    CHECK(stored.mesh.polygons.size() == 6);
    CHECK(stored.growth.push == 0);
    CHECK(stored.growth.volume_ratio == 1);
    CHECK(keeps_promises(stored, cube));
  }
}

TEST_CASE("store_mesh: every family of shapes keeps the promises") {
  for (const shapes::Family& family : shapes::families()) {
    CAPTURE(std::string(family.name));
    std::vector<Point> points = shapes::generate(family, shapes::usual_values(family));
    if (points.size() > 24) points.resize(24);  // the checker is cubic
    const auto c = hull_case(PointSet(points));
    if (!c) continue;
    for (const Precision precision : kPrecisions) {
      CHECK(stored_or_refused(*c, precision));
      CHECK(stored_or_refused(drop_planes(*c, 6, 1), precision));
    }
  }
}

TEST_CASE("store_mesh: a hull of doubles is its own mesh in binary64") {
  const Case c = *hull_case(PointSet(shapes::on_sphere(40, 3)));
  const StoredMesh fine = store(c, Precision::Binary64), coarse = store(c, Precision::Binary32);
  CHECK_FALSE(is_pushed(fine, c));
  CHECK(fine.growth.push == 0);
  CHECK(is_pushed(coarse, c));
  CHECK(coarse.growth.push > 0);
  CHECK(coarse.growth.push < 1e-5);
  CHECK(coarse.growth.volume_ratio > 1);
  CHECK(coarse.growth.volume_ratio < 1 + 1e-4);
}

TEST_CASE("store_mesh: a result of ordinary points is pushed by a few ulps") {
  const Case c = drop_planes(*hull_case(PointSet(shapes::on_sphere(40, 3))), 12, 1);
  const StoredMesh stored = store(c, Precision::Binary64);
  CHECK(is_pushed(stored, c));
  CHECK(stored.growth.push < 1e-13);
  CHECK(keeps_promises(stored, c));
}

TEST_CASE("store_mesh: needles pass or are refused") {
  for (const double aspect : {1e8, 1e16, 1e30}) {
    const Case c = *hull_case(PointSet(shapes::needle(25, aspect, 5)));
    for (const Precision precision : kPrecisions) {
      CAPTURE(aspect);
      CHECK(stored_or_refused(c, precision));
      CHECK(stored_or_refused(drop_planes(c, 6, 2), precision));
    }
  }
}

TEST_CASE("store_mesh: flat after rounding is refused") {
  // A cube of edge 2 at 1e8 lies between neighbouring floats.
  std::vector<Point> far = shapes::cube();
  for (Point& p : far) p += Point(1e8 + 3, 1e8 + 3, 1e8 + 3);
  const Case c = *hull_case(PointSet(far));
  CHECK(keeps_promises(store(c, Precision::Binary64), c));
  CHECK(error_of([&] { return store(c, Precision::Binary32); }).code() ==
        ErrorCode::Unrepresentable);
}

TEST_CASE("store_mesh: the ends of the exponent range") {
  const Case huge = *hull_case(PointSet(shapes::huge(20, 1)));
  CHECK(keeps_promises(store(huge, Precision::Binary64), huge));
  const Error refused = error_of([&] { return store(huge, Precision::Binary32); });
  CHECK(refused.code() == ErrorCode::Unrepresentable);
  CHECK(exit_code(refused.code()) == 5);
  const Case tiny = *hull_case(PointSet(shapes::subnormal(20, 1000, 1)));
  CHECK(keeps_promises(store(tiny, Precision::Binary64), tiny));
  CHECK(error_of([&] { return store(tiny, Precision::Binary32); }).code() ==
        ErrorCode::Unrepresentable);
  // The planes of a rounded solid at the top of the range meet beyond the largest double.
  std::vector<Point> largest = shapes::on_sphere(20, 4);
  for (Point& p : largest) p *= std::numeric_limits<double>::max();
  const Case top = drop_planes(*hull_case(PointSet(largest)), 5, 1);
  CHECK(error_of([&] { return store(top, Precision::Binary64); }).code() ==
        ErrorCode::Unrepresentable);
}

TEST_CASE("store_mesh: rational input, as the vertices of halfspaces are") {
  std::vector<RationalPoint> points;
  for (const Point& p : shapes::on_sphere(12, 2)) points.push_back(to_rational(p) / Rational(3));
  const Case c = *hull_case(PointSet(points));
  for (const Precision precision : kPrecisions) {
    CHECK(keeps_promises(store(c, precision), c));
    const Case fewer = drop_planes(c, 7, 1);
    CHECK(keeps_promises(store(fewer, precision), fewer));
  }
}

TEST_CASE("count_outside_hull: by the hull of the points, and all if they are flat") {
  const PointSet input(std::vector<Point>{{0, 0, 0}, {1, 1, 1}, {1, 1, 1.5}, {-3, 0, 0}});
  CHECK(count_outside_hull(PointSet(shapes::cube()), input) == 2);
  CHECK(count_outside_hull(PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), input) ==
        4);
}

TEST_CASE("store_mesh: lattice solids") {
  check_property("store_mesh keeps its promises on lattice points", [] {
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    const auto range = *rc::gen::inRange<std::uint64_t>(1, 40);
    const auto c = hull_case(PointSet(shapes::lattice(12, range, seed)));
    if (!c) return;
    for (const Precision precision : kPrecisions) {
      const Case fewer = drop_planes(*c, 5, seed);
      RC_ASSERT(keeps_promises(store(*c, precision), *c));
      RC_ASSERT(keeps_promises(store(fewer, precision), fewer));
    }
  });
}
