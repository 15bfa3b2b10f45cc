// SPDX-License-Identifier: MIT
// The enclosure of a whole solid's volume that a limit of growth is a share of: never broken, by
// the sum over the hull's facets in rationals, and narrow even where doubles are too short.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/hull.hpp"
#include "convexact/io.hpp"
#include "convexact/measure.hpp"
#include "fast/cap.hpp"
#include "fast/dual.hpp"
#include "fast/engines.hpp"
#include "fast/filtered_loop.hpp"
#include "number/arithmetic.hpp"
#include "process.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

struct NamedPoints {
  std::string name;
  std::vector<Point> points;
};

std::vector<NamedPoints> shapes_to_measure() {
  return {{"cube", shapes::cube()},
          {"rounded box", shapes::rounded_box({1, 1, 1}, 0.25, 8)},
          {"flat rounded box", shapes::rounded_box({3, 2, 0.01}, 0.005, 6)},
          {"cylinder", shapes::cylinder(60, 3)},
          {"needle", shapes::needle(40, 0x1p40, 3)},
          {"nearly coplanar", shapes::nearly_coplanar(40, 3)},
          {"ball", shapes::in_ball(200, 1)}};
}

}  // namespace

TEST_CASE("six_times_volume: encloses the volume of the hull, to a millionth") {
  for (const NamedPoints& shape : shapes_to_measure()) {
    CAPTURE(shape.name);
    const PointSet points(shape.points);
    const Hull hull = std::get<Hull>(convex_hull(points));
    const FastDual dual = FastDual::of(hull, points);
    const Interval<double> bounds = six_times_volume(dual);
    const Rational six_times =
        scale_by_power_of_two(volume(hull, points) * 6, -dual.volume_exponent());
    CHECK(to_rational(bounds.lower) <= six_times);
    CHECK(to_rational(bounds.upper) >= six_times);
    CHECK(bounds.upper - bounds.lower <= 1e-6 * bounds.upper);
  }
}

// Its volume is doubtful in doubles. The box of half sides 1.25 is all that is left of it.
TEST_CASE("a limit of growth on a rounded box is decided without exact measures") {
  const PointSet points(shapes::rounded_box({1, 1, 1}, 0.25, 8));
  const Hull hull = std::get<Hull>(convex_hull(points));
  const FastDual dual = FastDual::of(hull, points);
  const Rational box(Integer(15625), Integer(1000)), before = volume(hull, points);
  for (const auto& [share, is_enough] : {std::pair(Rational(Integer(3), Integer(100)), true),
                                         std::pair(Rational(Integer(1), Integer(100)), false)}) {
    SimplifyOptions options;
    options.faces = 4;
    options.max_growth = share;
    GrowthBudget growth(dual, options);
    CHECK((before * (1 + share) >= box) == is_enough);
    const double all =
        to_double(scale_by_power_of_two(box - before, -dual.volume_exponent()), Rounding::Nearest);
    CHECK(growth.allows({all, all}) == is_enough);
  }
}

// Once it was not: on the teapot 2% became 2.075%, on another mesh 175%.
TEST_CASE("a limit of growth is kept by the float engine, as far as the filtered one goes") {
  std::vector<NamedPoints> all = shapes_to_measure();
  const PointSet teapot = read_mesh(support::data("teapot.obj")).points;
  all.push_back({"teapot", {teapot.doubles().begin(), teapot.doubles().end()}});
  for (const NamedPoints& shape : all) {
    CAPTURE(shape.name);
    const PointSet points(shape.points);
    const Hull hull = std::get<Hull>(convex_hull(points));
    const FastDual dual = FastDual::of(hull, points);
    SimplifyOptions options;
    options.faces = 4;
    options.max_growth = Rational(Integer(1), Integer(50));
    const Rational before = volume(hull, points);
    const auto volume_after = [&](const FastResult& result) {
      return exact_measure(dual, result.triangles, CostMeasure::Volume).rational();
    };
    const Rational by_float = volume_after(simplify_float(dual, options));
    CHECK(by_float <= before * (1 + *options.max_growth));
    // The order among ties may differ, and with it what the last steps add.
    const Rational by_filtered = volume_after(simplify_filtered(dual, options));
    CHECK(by_float - before >= (by_filtered - before) * Rational(Integer(3), Integer(4)));
  }
}
