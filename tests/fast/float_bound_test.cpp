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
    "FloatWatch: regret is the upper end of what goes over the least lower end of the others") {
  FloatWatch watch(3);
  watch.note(HalfspaceId(0), 4096, 4097);
  watch.note(HalfspaceId(1), 4096, 5000);
  watch.note(HalfspaceId(2), 8000, 9000);
  watch.remove(HalfspaceId(0), 4096.5);
  CHECK(watch.finish(false).regret >= 1.0 / 4096);
  CHECK(watch.finish(false).regret <= 1.0 / 4096 + 0x1p-40);
  CHECK(watch.finish(false).cost >= 0.5 / 4096);
  CHECK(watch.finish(false).cost <= 0.5 / 4096 + 0x1p-40);
  CHECK(watch.finish(false).least_next <= 4096.0 / 6);
  CHECK(watch.finish(false).is_vouched());
  CHECK_FALSE(watch.finish(true).is_vouched());  // bounded removals are left
  // An old lower end is not forgotten, a better one not made worse.
  watch.note(HalfspaceId(2), 0, kInfinity);
  watch.note(HalfspaceId(1), kInfinity, kInfinity);
  CHECK(watch.finish(false).least_next > 8000.0 / 6.001);
  watch.note(HalfspaceId(2), kInfinity, kInfinity);
  CHECK(watch.finish(true).is_vouched());
}

TEST_CASE("FloatWatch: a step is doubtful if its cost or another's is open") {
  FloatWatch open_upper(2), open_other(2), wide(2), zero(2);
  open_upper.note(HalfspaceId(0), 1, kInfinity);
  open_upper.note(HalfspaceId(1), 2, 2);
  open_other.note(HalfspaceId(0), 1, 1);
  wide.note(HalfspaceId(0), 1, 1 + 2 * FloatBound::kMost);
  wide.note(HalfspaceId(1), 2, 2);
  zero.note(HalfspaceId(0), 0, 0);
  zero.note(HalfspaceId(1), 0, 0);
  for (FloatWatch* watch : {&open_upper, &open_other, &wide, &zero}) {
    watch->remove(HalfspaceId(0), watch == &zero ? 0 : 1);
    CHECK(watch->finish(false).doubtful == 1);
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
