// SPDX-License-Identifier: MIT
// Caps that a symmetry of the axes carries to each other, expected from the definition: the plane
// of one facet is the other's image.
#include "fast/congruence.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "convexact/hull.hpp"
#include "fast/cap.hpp"
#include "fast/engines.hpp"
#include "fast/signs.hpp"
#include "geometry/plane_determinants.hpp"
#include "number/random.hpp"
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
  FastDual dual;
  std::vector<Halfspace> planes;
  std::vector<FacetOutline> outlines;
  std::vector<std::optional<Rational>> costs;

  // What the dual was made of must outlive the object.
  Caps(FastDual made, const RationalPoint& center) : dual(std::move(made)) {
    for (std::size_t i = 0; i < dual.size(); ++i) planes.push_back(dual.exact(HalfspaceId(i)));
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
      const HullOutcome outcome = convex_hull(set);
      const Hull* hull = std::get_if<Hull>(&outcome);
      if (hull == nullptr) continue;
      const DualHull solid = dual_of(*hull, set);
      const RationalPoint center = mean(solid.vertices);
      // By planes, and by corners.
      const std::array<Caps, 2> both{Caps(FastDual::of(solid, center), center),
                                     Caps(FastDual::of(*hull, set), center)};
      for (const Caps& caps : both) {
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
  }
  CHECK(mirrored > 1000);
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
    const Caps caps(FastDual::of(solid, center), center);
    std::size_t result = 0;
    for (const FacetOutline& a : caps.outlines) {
      for (const FacetOutline& b : caps.outlines) result += are_congruent(caps.dual, a, b);
    }
    return result;
  };
  CHECK(count(box(5)) == 6 + 4);  // each with itself, and two pairs of walls
  CHECK(count(box(6)) == 6);
}

// A bar along y, with a bevel of the same depth at both lower edges, and others at the upper ones;
// at the right one a corner may be cut off. Whether bevels, wall, front and floor on the left
// correspond to those on the right. (These are no outlines of caps: bevels become neighbours only
// when the walls between them are removed.)
bool are_bevels_congruent(long left, long right, bool is_cut) {
  std::vector<Halfspace> planes{
      {IntegerVector3(-1, 0, 0), 0},        {IntegerVector3(1, 0, 0), -10},
      {IntegerVector3(0, -1, 0), 0},        {IntegerVector3(0, 1, 0), -4},
      {IntegerVector3(0, 0, -1), 0},        {IntegerVector3(0, 0, 1), -6},
      {IntegerVector3(-1, 0, -1), 1},       {IntegerVector3(1, 0, -1), -9},
      {IntegerVector3(-1, 0, 1), left - 6}, {IntegerVector3(1, 0, 1), right - 16}};
  if (is_cut) planes.emplace_back(IntegerVector3(1, -1, 1), right - 15);
  const PointSet set(dual_of(planes, RationalPoint(5, 2, 3)).dual.vertices);
  const Hull hull = std::get<Hull>(convex_hull(set));
  const FastDual dual = FastDual::of(hull, set);
  const auto facet = [&](int x, int y, int z) {
    HalfspaceId i(0);
    while (dual.exact(i).normal() != IntegerVector3(x, y, z)) i = HalfspaceId(i.value + 1);
    return i;
  };
  const HalfspaceId front = facet(0, -1, 0), floor = facet(0, 0, -1);
  return are_congruent(dual, {facet(-1, 0, -1), {facet(-1, 0, 0), front, facet(-1, 0, 1), floor}},
                       {facet(1, 0, -1), {facet(1, 0, 0), floor, facet(1, 0, 1), front}});
}

TEST_CASE("are_congruent: a neighbour whose corners do not correspond, by its plane") {
  CHECK(are_bevels_congruent(1, 1, false));
  CHECK(are_bevels_congruent(1, 1, true));
  CHECK_FALSE(are_bevels_congruent(1, 2, false));
  CHECK_FALSE(are_bevels_congruent(2, 1, true));
}

// Solids with mirror images in planes across and along the axes, and in a point, some elsewhere
// than at the origin, some nearly symmetric, and one with facets coplanar but for rounding.
std::vector<std::vector<Point>> symmetric_points() {
  std::vector<std::vector<Point>> all{shapes::cube_symmetric(1, 100, 1),
                                      shapes::centrally_symmetric(12, 1),
                                      shapes::rounded_box({3, 2, 1}, 0.5, 2), shapes::grid(3)};
  // A half turn about x carries the plane 2x + 2^-59 y = z to 2x - 2^-59 y = -z: the entries that
  // decide the order are too close for doubles, and later ones would decide otherwise.
  all.push_back({{0, 0, 0},
                 {-1, 0, -2},
                 {-0x1p-60, 1, 0},
                 {-1, 0, 2},
                 {-0x1p-60, -1, 0},
                 {-5, 3, 3},
                 {-5, 3, -3},
                 {-5, -3, 3},
                 {-5, -3, -3}});
  for (const Isometry& isometry : isometries(Point(12, 5, -7))) {
    if (isometry.sign[0] < 0) continue;
    std::vector<Point> points = shapes::lattice(7, 9, all.size());
    for (std::size_t i = 0; i < 7; ++i) points.push_back(isometry(points[i]));
    all.push_back(points);
    // A translation that is not exact in doubles, and a corner without an image.
    for (Point& p : points) p = p * 0.1 + Point(0.3, 1e5, 0);
    points.push_back(points[0] + Point(0, 0, 1));
    all.push_back(points);
  }
  return all;
}

TEST_CASE("FastDual: halfspaces of symmetric solids in canonical order, heights with their signs") {
  std::size_t ordered = 0, mirror_pairs = 0;
  Random random(1);
  for (const std::vector<Point>& points : symmetric_points()) {
    const PointSet set(points);
    const HullOutcome outcome = convex_hull(set);
    const Hull* hull = std::get_if<Hull>(&outcome);
    if (hull == nullptr) continue;
    const FastDual dual = FastDual::of(*hull, set);
    const DualSigns signs(dual);
    const auto count = static_cast<std::uint32_t>(dual.size());
    for (HalfspaceId i(0); i.value < count; i = HalfspaceId(i.value + 1)) {
      for (HalfspaceId j(0); j.value < count; j = HalfspaceId(j.value + 1)) {
        if (i == j) continue;
        const bool is_first = dual.exact(i) < dual.exact(j);
        CHECK(dual.precedes(i, j) == is_first);
        const std::optional<bool> by_image = precedes_image(dual, i, j);
        if (!by_image) continue;
        CHECK(*by_image == is_first);
        ++ordered;
      }
    }
    for (int k = 0; k < 3000; ++k) {
      std::array<HalfspaceId, 4> planes;
      for (HalfspaceId& plane : planes) plane = HalfspaceId(uniform_below(random, count));
      const auto [a, b, c, p] = planes;
      if (a == b || a == c || a == p || b == c || b == p || c == p) continue;
      const Sign sign =
          sign_of(plane_determinant(dual.exact(a), dual.exact(b), dual.exact(c), dual.exact(p)));
      CHECK(signs.height(a, b, c, p) == sign);
      CHECK(signs.height_beyond_doubles(a, b, c, p) == sign);
      if (!are_mirror_pairs(dual, planes)) continue;
      CHECK(sign == Sign::Zero);
      ++mirror_pairs;
    }
  }
  CHECK(ordered > 1000);
  CHECK(mirror_pairs > 100);
}

TEST_CASE("are_mirror_pairs: not by a reflection that glides, nor by a half turn") {
  // Tetrahedra with one corner cut, and their images: two facets and those of the images.
  const std::vector<Point> corners{{1, 2, 3}, {2, 9, 4}, {4, 3, 8}, {9, 5, 5}};
  const auto pairs_by = [&](const Isometry& isometry) {
    std::vector<Point> points = corners;
    for (const Point& p : corners) points.push_back(isometry(p));
    const PointSet set(points);
    const Hull hull = std::get<Hull>(convex_hull(set));
    const FastDual dual = FastDual::of(hull, set);
    std::size_t found = 0;
    const auto count = static_cast<std::uint32_t>(dual.size());
    for (std::uint32_t a = 0; a < count; ++a) {
      for (std::uint32_t b = a + 1; b < count; ++b) {
        for (std::uint32_t c = b + 1; c < count; ++c) {
          for (std::uint32_t p = c + 1; p < count; ++p) {
            found += are_mirror_pairs(
                dual, {HalfspaceId(a), HalfspaceId(b), HalfspaceId(c), HalfspaceId(p)});
          }
        }
      }
    }
    return found;
  };
  CHECK(pairs_by({{0, 1, 2}, {-1, 1, 1}, {0, 0, 0}}) > 0);
  CHECK(pairs_by({{1, 0, 2}, {1, 1, 1}, {20, -20, 0}}) > 0);
  CHECK(pairs_by({{0, 1, 2}, {-1, -1, -1}, {0.5, 0, 7}}) > 0);
  CHECK(pairs_by({{0, 1, 2}, {-1, 1, 1}, {0, 1, 0}}) == 0);
  CHECK(pairs_by({{1, 0, 2}, {1, 1, 1}, {20, -20, 1}}) == 0);
  CHECK(pairs_by({{0, 1, 2}, {-1, -1, 1}, {0, 0, 0}}) == 0);
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
