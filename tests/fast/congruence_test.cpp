// SPDX-License-Identifier: MIT
// Caps that a symmetry of the axes carries to each other, expected from the definition: the plane
// of one facet is the other's image.
#include <doctest/doctest.h>

#include <algorithm>

#include "convexact/hull.hpp"
#include "fast/cap.hpp"
#include "fast/congruence.hpp"
#include "fast/engines.hpp"
#include "oracle/order/removal_cost.hpp"
#include "same_run.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

// x -> S x + t, S given by its rows: row k is sign[k] times unit vector axis[k].
struct Isometry {
  std::array<int, 3> axis, sign;
  Point shift;

  Point operator()(const Point& x) const {
    return Point(sign[0] * x[axis[0]], sign[1] * x[axis[1]], sign[2] * x[axis[2]]) + shift;
  }
  Halfspace operator()(const Halfspace& h) const {
    IntegerVector3 normal;
    Integer offset = h.offset();
    for (int k = 0; k < 3; ++k) {
      normal[k] = sign[k] * h.normal()[axis[k]];
      offset -= normal[k] * Integer(shift[k]);
    }
    return {normal, offset};
  }
};

std::vector<Isometry> isometries(const Point& shift) {
  std::vector<Isometry> all;
  std::array<int, 3> axis{0, 1, 2};
  do {
    for (const int x : {1, -1}) {
      for (const int y : {1, -1}) {
        for (const int z : {1, -1}) all.push_back({axis, {x, y, z}, shift});
      }
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
  return all;
}

// A solid, the outlines of all its caps, and what each costs by definition.
struct Caps {
  std::vector<Halfspace> planes;
  std::vector<FacetOutline> outlines;
  std::vector<std::optional<Rational>> costs;
  FastDual dual;

  // `solid` must outlive the object.
  Caps(const DualHull& solid, const RationalPoint& center)
      : planes(solid.halfspaces), dual(FastDual::of(solid, center)) {
    const HalfEdgeMesh mesh(dual.size(), dual.triangles());
    FilteredCap cap(dual, mesh, CostMeasure::Volume, 1);
    const RemovalOracle oracle(planes, center);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      outlines.push_back(cap.outline(HalfspaceId(i)));
      const auto cost = oracle.without(planes[i]).cost;
      costs.push_back(cost ? std::optional(cost->rational()) : std::nullopt);
    }
  }
};

RationalPoint mean(const std::vector<RationalPoint>& points) {
  RationalPoint sum = RationalPoint::Zero();
  for (const RationalPoint& p : points) sum += p;
  return sum / Rational(points.size());
}

}  // namespace

TEST_CASE("are_congruent: a facet and its image under each of the 48 symmetries, translated") {
  std::size_t mirrored = 0;
  std::uint64_t seed = 0;
  for (const Point& shift : {Point(0, 0, 0), Point(3, -40, 8)}) {
    for (const Isometry& isometry : isometries(shift)) {
      // With its image, and the image's image and so on: no isometry here has an order above 6.
      std::vector<Point> points = shapes::lattice(5, 9, ++seed);
      if (shift != Point(0, 0, 0) && isometry(isometry(points[0])) != points[0]) continue;
      for (std::size_t i = 0; i < points.size() && i < 30; ++i) {
        const Point image = isometry(points[i]);
        if (std::find(points.begin(), points.end(), image) == points.end()) points.push_back(image);
      }
      const PointSet set(points);
      const HullOutcome hull = convex_hull(set);
      if (!std::holds_alternative<Hull>(hull)) continue;
      const DualHull solid = dual_of(std::get<Hull>(hull), set);
      const Caps caps(solid, mean(solid.vertices));
      for (std::size_t i = 0; i < caps.planes.size(); ++i) {
        for (std::size_t j = 0; j < caps.planes.size(); ++j) {
          const bool congruent = are_congruent(caps.dual, caps.outlines[i], caps.outlines[j]);
          if (caps.planes[j] == isometry(caps.planes[i])) {
            CHECK(congruent);
            ++mirrored;
          }
          if (congruent) CHECK(caps.costs[i] == caps.costs[j]);
        }
      }
    }
  }
  CHECK(mirrored > 500);
}

TEST_CASE("are_congruent: one offset that differs by one decides") {
  // A box with a roof that slopes alike to x and y: swapping these carries it to itself.
  const auto box = [](long depth) {
    return std::vector<Halfspace>{
        {IntegerVector3(1, 0, 0), -5},     {IntegerVector3(-1, 0, 0), -5},
        {IntegerVector3(0, 1, 0), -depth}, {IntegerVector3(0, -1, 0), -5},
        {IntegerVector3(1, 1, 9), -5 * 9}, {IntegerVector3(0, 0, -1), -5}};
  };
  const auto count = [](std::vector<Halfspace> planes) {
    const RationalPoint center(0, 0, 0);
    const DualHull solid = dual_of(planes, center).dual;
    const Caps caps(solid, center);
    std::size_t result = 0;
    for (const FacetOutline& a : caps.outlines) {
      for (const FacetOutline& b : caps.outlines) result += are_congruent(caps.dual, a, b);
    }
    return result;
  };
  CHECK(count(box(5)) == 6 + 4);  // each with itself, and two pairs of walls
  CHECK(count(box(6)) == 6);
}

TEST_CASE("simplify_filtered: mirror images tie without a rational") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    std::vector<Point> points = shapes::on_sphere(60, seed);
    for (Point& p : points) p = (0x1p20 * p).array().round();  // so that the mirror image is exact
    for (std::size_t i = 0, n = points.size(); i < n; ++i) {
      points.push_back(Point(0x1p20 - points[i][0], points[i][1], points[i][2]));
    }
    const PointSet set(points);
    const HullOutcome hull = convex_hull(set);
    const FastDual dual = FastDual::of(std::get<Hull>(hull), set);
    const FastResult result = simplify_filtered(dual, {.faces = 40});
    const auto tied = std::count_if(result.steps.begin(), result.steps.end(),
                                    [](const FastStep& step) { return step.tied > 1; });
    CHECK(tied > 30);
    CHECK(result.counts.congruent >= static_cast<std::uint64_t>(tied));
    CHECK(result.counts.exact < 20);
  }
}

TEST_CASE("simplify_filtered: symmetric, in axes whose numbers have no common range of doubles") {
  // Permutations of 0, +-1, +-2, each axis stretched by itself: the weight of an axis may be zero.
  std::vector<Point> points;
  std::array<double, 3> order{0, 1, 2};
  do {
    for (const double s : {1.0, -1.0}) {
      for (const double t : {1.0, -1.0}) {
        Point p;
        for (int k = 0; k < 3; ++k) p[k] = order[k] == 1 ? s : order[k] == 2 ? 2 * t : 0;
        points.push_back(p.cwiseProduct(Point(0x1p565, 1, 0x1p-565)));
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  const PointSet set(points);
  const HullOutcome hull = convex_hull(set);
  const FastDual dual = FastDual::of(std::get<Hull>(hull), set);
  for (HalfspaceId i(0); i.value < 14; i = HalfspaceId(i.value + 1)) {
    for (const double size : dual.normal_sizes(i)) CHECK((size >= 0 && size <= 1));
  }
  // Eight hexagons that cost the same; stretching changes no order of volumes.
  const FastResult result = simplify_filtered(dual, {.faces = 8});
  REQUIRE(result.steps.size() == 6);
  for (std::size_t step = 0; step < 6; ++step) CHECK(result.steps[step].tied == 6 - step);
}

TEST_CASE("simplify_filtered: facets coplanar but for rounding, and alike, need few exact costs") {
  const PointSet set(shapes::rounded_box({3, 2, 1}, 0.5, 6));
  const HullOutcome hull = convex_hull(set);
  const FastDual dual = FastDual::of(std::get<Hull>(hull), set);
  const FastResult result = simplify_filtered(dual, {.faces = 18});
  CHECK(result.steps.size() > 500);
  CHECK(result.counts.doubtful > result.steps.size());  // doubles enclose few of these caps
  CHECK(result.counts.exact < result.steps.size() / 20);
  CHECK(result.counts.extended < result.steps.size() / 2);
}
