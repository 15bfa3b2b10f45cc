// SPDX-License-Identifier: MIT
// What the float engine proves of its own errors: true everywhere, and worth something where costs
// are clear.
#include <doctest/doctest.h>

#include <set>
#include <variant>

#include "check_float_bound.hpp"
#include "convexact/io.hpp"
#include "convexact/shapes.hpp"
#include "fast/float_loop.hpp"
#include "shipped_meshes.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

FloatBound checked_bound(const PointSet& points, CostMeasure measure = CostMeasure::Volume,
                         std::size_t faces = 4) {
  const Hull hull = std::get<Hull>(convex_hull(points));
  const FastDual dual = FastDual::of(hull, points);
  const FastResult result = simplify_float(dual, {.faces = faces, .cost = measure});
  check_float_bound(dual, result, measure);
  return *result.bound;
}

constexpr CostMeasure kAreaAndWidth[] = {CostMeasure::Area, CostMeasure::MeanWidth};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE(
    "FloatErrors: regret is the upper bound of a cost over the least lower bound of the others") {
  FloatErrors errors(3);
  errors.enclose(HalfspaceId(0), 4096, 4097);
  errors.enclose(HalfspaceId(1), 4096, 5000);
  errors.enclose(HalfspaceId(2), 8000, 9000);
  errors.remove(HalfspaceId(0), 4096.5);
  CHECK(errors.bound(false).regret >= 1.0 / 4096);
  CHECK(errors.bound(false).regret <= 1.0 / 4096 + 0x1p-40);
  CHECK(errors.bound(false).cost >= 0.5 / 4096);
  CHECK(errors.bound(false).cost <= 0.5 / 4096 + 0x1p-40);
  CHECK(errors.bound(false).least_next <= 4096.0 / 6);
  CHECK(errors.bound(false).is_vouched());
  CHECK_FALSE(errors.bound(true).is_vouched());  // bounded removals are left
  // An old lower bound is not forgotten, a better one not made worse.
  errors.enclose(HalfspaceId(2), 0, kInfinity);
  errors.enclose(HalfspaceId(1), kInfinity, kInfinity);
  CHECK(errors.bound(false).least_next > 8000.0 / 6.001);
  errors.enclose(HalfspaceId(2), kInfinity, kInfinity);
  CHECK(errors.bound(true).is_vouched());
}

TEST_CASE("FloatErrors: a step is doubtful if its cost or another's is open") {
  FloatErrors open_upper(2), open_other(2), wide(2), zero(2);
  open_upper.enclose(HalfspaceId(0), 1, kInfinity);
  open_upper.enclose(HalfspaceId(1), 2, 2);
  open_other.enclose(HalfspaceId(0), 1, 1);
  wide.enclose(HalfspaceId(0), 1, 1 + 2 * FloatBound::kMost);
  wide.enclose(HalfspaceId(1), 2, 2);
  zero.enclose(HalfspaceId(0), 0, 0);
  zero.enclose(HalfspaceId(1), 0, 0);
  for (FloatErrors* errors : {&open_upper, &open_other, &wide, &zero}) {
    errors->remove(HalfspaceId(0), errors == &zero ? 0 : 1);
    CHECK(errors->bound(false).doubtful == 1);
  }
}

TEST_CASE("FloatBound: holds on every family of shapes, and vouches for all but the vaguest") {
  // Facets that are coplanar but for the rounding of their vertices, or tiny beside others: their
  // dual points are a few roundings apart.
  const std::set<std::string_view> vague{"rounded-box", "rounded-dodecahedron", "nearly-coplanar",
                                         "mixed-scales", "mixture"};
  for (const shapes::Family& family : shapes::families()) {
    CAPTURE(family.name);
    if (family.dimension < 3) continue;
    const PointSet points(shapes::generate(family, shapes::usual_values(family), 1));
    CHECK(checked_bound(points).is_vouched() == !vague.contains(family.name));
  }
}

TEST_CASE("FloatErrors: of bounds from before a removal only what lasts is left") {
  FloatErrors errors(3, CostMeasure::Area);
  errors.enclose(HalfspaceId(0), 10, 10);
  errors.enclose(HalfspaceId(1), 20, 20);
  errors.enclose(HalfspaceId(2), kInfinity, kInfinity);
  errors.lower(HalfspaceId(1), 5);
  errors.lower(HalfspaceId(2), 5);  // unbounded for ever
  CHECK(errors.bound(false).least_next <= 5.0 / 2);
  errors.lower(HalfspaceId(1), 7);  // nothing is proven anew
  errors.remove(HalfspaceId(0), 10);
  CHECK(errors.bound(false).doubtful == 1);  // twice what the other may cost
  CHECK(errors.bound(false).least_next <= 5.0 / 2);
  errors.enclose(HalfspaceId(1), 20, 20);
  errors.remove(HalfspaceId(1), 20);
  CHECK(errors.bound(true).is_end_proven);
}

TEST_CASE("FloatBound: holds by area and by mean width on every family of shapes" * sweep) {
  for (const CostMeasure measure : kAreaAndWidth) {
    std::size_t vouched = 0;
    for (const shapes::Family& family : shapes::families()) {
      CAPTURE(family.name);
      CAPTURE(static_cast<int>(measure));
      if (family.dimension < 3) continue;
      const PointSet points(shapes::generate(family, shapes::usual_values(family), 1));
      vouched += checked_bound(points, measure).is_vouched();
    }
    CHECK(vouched >= 15);
  }
}

// In these a cost falls after another removal; bounds that are not lowered choose wrongly.
TEST_CASE("FloatBound: holds by area and by mean width where costs fall") {
  const std::vector<Point> by_area{{-2, 3, 0}, {1, 3, -1},  {-4, 1, 0},  {1, 0, 0},
                                   {1, 4, -1}, {-3, -1, 2}, {-3, -2, 4}, {-4, 3, -3}};
  const std::vector<Point> by_width{{4, -2, -3}, {-1, -2, 2}, {-2, -4, -2}, {3, -4, 0},
                                    {-4, 3, -2}, {0, 1, 1},   {1, -2, 0}};
  for (std::size_t faces = 4; faces <= 14; ++faces) {  // each end says what a further one costs
    CAPTURE(faces);
    CHECK(checked_bound(PointSet(by_area), CostMeasure::Area, faces).is_vouched());
    CHECK(checked_bound(PointSet(by_width), CostMeasure::MeanWidth, faces).is_vouched());
  }
}

TEST_CASE("FloatBound: by area and by mean width on the shipped meshes" * sweep) {
  for (const std::string& path : shipped_meshes()) {
    for (const CostMeasure measure : kAreaAndWidth) {
      CAPTURE(path);
      CAPTURE(static_cast<int>(measure));
      const FloatBound bound = checked_bound(read_mesh(path).points, measure);
      MESSAGE(bound.doubtful << " doubtful, cost " << bound.cost << ", regret " << bound.regret);
      CHECK(bound.is_vouched());
    }
  }
}

TEST_CASE("FloatBound: vouches for whole runs on the shipped meshes") {
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    const FloatBound bound = checked_bound(read_mesh(path).points);
    CHECK(bound.is_vouched());
  }
}
