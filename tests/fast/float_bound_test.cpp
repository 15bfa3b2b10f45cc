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

using namespace convexact;

namespace {

FloatBound checked_bound(const PointSet& points) {
  const Hull hull = std::get<Hull>(convex_hull(points));
  const FastDual dual = FastDual::of(hull, points);
  const FastResult result = simplify_float(dual);
  check_float_bound(dual, result);
  return *result.bound;
}

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

TEST_CASE("FloatBound: vouches for whole runs on the shipped meshes") {
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    const FloatBound bound = checked_bound(read_mesh(path).points);
    CHECK(bound.is_vouched());
  }
}
