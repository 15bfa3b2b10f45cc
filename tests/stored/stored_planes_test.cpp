// SPDX-License-Identifier: MIT
// Halfspaces in floating point. Judged by stored_checker.hpp, which computes from the definition.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "convexact/shapes.hpp"
#include "convexact/stored.hpp"
#include "expect_error.hpp"
#include "property.hpp"
#include "shapes/makers.hpp"
#include "stored_cases.hpp"

using namespace convexact;
using namespace stored_cases;

namespace {

StoredPlanes store_planes(const Case& c, Precision precision) {
  return store_planes(c.exact, c.input, c.witnesses, precision);
}

std::vector<stored_checker::Plane> planes_of(const StoredPlanes& stored) {
  std::vector<stored_checker::Plane> planes;
  for (const auto& p : stored.planes) planes.push_back(stored_checker::plane(p));
  return planes;
}

double above(double x, Precision precision) {
  if (precision == Precision::Binary64) {
    return std::nextafter(x, std::numeric_limits<double>::infinity());
  }
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

// What is promised of every result: numbers of the format, largest normal component in [1/2, 1],
// every input point inside, bounded, and no larger offset would do.
bool keeps_promises(const StoredPlanes& stored, const Case& c) {
  const auto points = to_homogeneous(c.input);
  const auto planes = planes_of(stored);
  if (planes.size() != c.exact.planes.size() || stored.violations != 0) return false;
  if (stored_checker::count_outside(planes, points) != 0) return false;
  if (!stored_checker::is_bounded(planes)) return false;
  for (std::array<double, 4> p : stored.planes) {
    for (const double x : p) {
      if (stored.precision == Precision::Binary32 && double(float(x)) != x) return false;
    }
    const double largest = std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    if (largest < 0.5 || largest > 1) return false;
    p[3] = above(p[3], stored.precision);
    if (stored_checker::count_outside({stored_checker::plane(p)}, points) == 0) return false;
  }
  return stored.growth.push >= 0 && stored.growth.volume_ratio > 0;
}

// Stored, or refused with the documented code.
bool planes_stored_or_refused(const Case& c, Precision precision) {
  try {
    return keeps_promises(store_planes(c, precision), c);
  } catch (const Error& error) {
    return error.code() == ErrorCode::Unrepresentable;
  }
}

// Whether a stored normal is not the nearest one to the exact normal, scaled by a power of two.
bool has_turned_normal(const StoredPlanes& stored, const Case& c) {
  for (std::size_t i = 0; i < stored.planes.size(); ++i) {
    const IntegerVector3& n = c.exact.planes[i].normal();
    const std::size_t bits = std::max({bit_length(n[0]), bit_length(n[1]), bit_length(n[2])});
    for (int k = 0; k < 3; ++k) {
      const Rational scaled = scale_by_power_of_two(Rational(n[k]), -static_cast<long>(bits));
      const double nearest = round_to(stored.precision, scaled, Rounding::Nearest);
      if (stored.planes[i][static_cast<std::size_t>(k)] != nearest) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("store_planes: what the format holds exactly is not pushed") {
  const Case cube = *hull_case(PointSet(shapes::cube()));
  for (const Precision precision : kPrecisions) {
    const StoredPlanes stored = store_planes(cube, precision);
    CHECK(stored.halfspaces == cube.exact.planes);
    CHECK(stored.growth.push == 0);
    CHECK(stored.growth.volume_ratio == 1);
    // x >= -1 comes first in canonical order.
    CHECK(stored.planes.front() == std::array<double, 4>{-0.5, 0, 0, -0.5});
    CHECK(keeps_promises(stored, cube));
  }
}

TEST_CASE("store_planes: every family of shapes keeps the promises") {
  for (const shapes::Family& family : shapes::families()) {
    CAPTURE(std::string(family.name));
    std::vector<Point> points = shapes::generate(family, shapes::usual_values(family));
    if (points.size() > 24) points.resize(24);  // the checker is cubic
    const auto c = hull_case(PointSet(points));
    if (!c) continue;
    for (const Precision precision : kPrecisions) {
      CHECK(planes_stored_or_refused(*c, precision));
      CHECK(planes_stored_or_refused(drop_planes(*c, 6, 1), precision));
    }
  }
}

TEST_CASE("store_planes: a binary64 result of ordinary points is pushed by a few ulps") {
  const Case c = *hull_case(PointSet(shapes::on_sphere(40, 3)));
  const StoredPlanes fine = store_planes(c, Precision::Binary64),
                     coarse = store_planes(c, Precision::Binary32);
  CHECK(fine.growth.push > 0);
  CHECK(fine.growth.push < 1e-14);
  CHECK(coarse.growth.push > 0);
  CHECK(coarse.growth.push < 1e-5);
  CHECK(std::abs(coarse.growth.volume_ratio - 1) < 1e-4);
}

TEST_CASE("store_planes: a scale of 2^k scales the offsets by 2^k") {
  const std::vector<Point> points = shapes::on_sphere(30, 7);
  const Case c = *hull_case(PointSet(points));
  for (const int k : {-300, 300}) {
    std::vector<Point> scaled = points;
    for (Point& p : scaled) p *= std::ldexp(1.0, k);
    const StoredPlanes one = store_planes(c, Precision::Binary64);
    const StoredPlanes other = store_planes(*hull_case(PointSet(scaled)), Precision::Binary64);
    for (std::size_t i = 0; i < one.planes.size(); ++i) {
      std::array<double, 4> expected = one.planes[i];
      expected[3] = std::ldexp(expected[3], k);
      CHECK(other.planes[i] == expected);
    }
    CHECK(one.growth.push == other.growth.push);
    CHECK(one.growth.volume_ratio == other.growth.volume_ratio);
  }
}

TEST_CASE("store_planes: needles pass or are refused") {
  for (const double aspect : {1e8, 1e16, 1e30}) {
    const Case c = *hull_case(PointSet(shapes::needle(25, aspect, 5)));
    for (const Precision precision : kPrecisions) {
      CAPTURE(aspect);
      CHECK(planes_stored_or_refused(c, precision));
      CHECK(planes_stored_or_refused(drop_planes(c, 6, 2), precision));
    }
  }
}

TEST_CASE("store_planes: a skew needle whose nearest normals are unbounded is turned") {
  // Two tips along (1, 2, 3), a triangle around the middle: rounded to nearest, the component of a
  // normal along the needle is noise.
  const double length = 0x1p60;
  const Case c = *hull_case(PointSet(std::vector<Point>{{length, 2 * length, 3 * length},
                                                        {-length, -2 * length, -3 * length},
                                                        {3, 0, -1},
                                                        {-2, 1, 1},
                                                        {-1, -1, 1}}));
  for (const Precision precision : kPrecisions) {
    const StoredPlanes stored = store_planes(c, precision);
    CHECK(has_turned_normal(stored, c));
    CHECK(keeps_promises(stored, c));
  }
}

TEST_CASE("store_planes: the ends of the exponent range") {
  const Case huge = *hull_case(PointSet(shapes::huge(20, 1)));
  CHECK(keeps_promises(store_planes(huge, Precision::Binary64), huge));
  CHECK(error_of([&] { return store_planes(huge, Precision::Binary32); }).code() ==
        ErrorCode::Unrepresentable);
  const double most = std::numeric_limits<double>::max();
  std::vector<Point> largest = shapes::cube();
  for (Point& p : largest) p *= most;
  const Case box = *hull_case(PointSet(largest));
  CHECK(store_planes(box, Precision::Binary64).halfspaces == box.exact.planes);
  const Case tiny = *hull_case(PointSet(shapes::subnormal(20, 1000, 1)));
  CHECK(keeps_promises(store_planes(tiny, Precision::Binary64), tiny));
  // 2^-149 is the least offset but zero: the solid would be far longer than the input.
  CHECK(error_of([&] { return store_planes(tiny, Precision::Binary32); }).code() ==
        ErrorCode::Unrepresentable);
}

TEST_CASE("store_planes: far from the origin") {
  const Case c = *hull_case(PointSet(shapes::offset_ball(30, 1e8, 1)));
  CHECK(keeps_promises(store_planes(c, Precision::Binary64), c));
  CHECK(planes_stored_or_refused(c, Precision::Binary32));
}

TEST_CASE("store_planes: rational input, as the vertices of halfspaces are") {
  std::vector<RationalPoint> points;
  for (const Point& p : shapes::on_sphere(12, 2)) points.push_back(to_rational(p) / Rational(3));
  const Case c = *hull_case(PointSet(points));
  CHECK_FALSE(c.input.is_binary());
  for (const Precision precision : kPrecisions) {
    CHECK(keeps_promises(store_planes(c, precision), c));
    const Case fewer = drop_planes(c, 7, 1);
    CHECK(keeps_promises(store_planes(fewer, precision), fewer));
  }
}

TEST_CASE("store_planes: lattice solids") {
  check_property("store_planes keeps its promises on lattice points", [] {
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    const auto range = *rc::gen::inRange<std::uint64_t>(1, 40);
    const auto c = hull_case(PointSet(shapes::lattice(12, range, seed)));
    if (!c) return;
    for (const Precision precision : kPrecisions) {
      const Case fewer = drop_planes(*c, 5, seed);
      RC_ASSERT(keeps_promises(store_planes(*c, precision), *c));
      RC_ASSERT(keeps_promises(store_planes(fewer, precision), fewer));
    }
  });
}

// The witnesses are a promise of the caller, that the hull of these points is that of all. Where it
// is broken, the offset is that of the others, and only the last pass over all points can tell.
TEST_CASE("store_planes: a point that the witnesses leave out is held too, or nothing is stored") {
  const Case whole = *hull_case(PointSet(shapes::on_sphere(20, 3)));
  std::size_t refused = 0;
  for (std::size_t i = 0; i < whole.witnesses.size(); ++i) {
    Case less = whole;
    less.witnesses.erase(less.witnesses.begin() + static_cast<std::ptrdiff_t>(i));
    try {
      const StoredPlanes stored = store_planes(less, Precision::Binary32);
      CHECK(stored_checker::count_outside(planes_of(stored), to_homogeneous(less.input)) == 0);
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::Internal);
      ++refused;
    }
  }
  CHECK(refused > 0);
}
