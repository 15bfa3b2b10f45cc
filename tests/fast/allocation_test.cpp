// SPDX-License-Identifier: MIT
// Removals reuse the memory that the start took: fifteen times as many allocate hardly more often.
#include <doctest/doctest.h>

#include "allocation_watch.hpp"
#include "fast/engines.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

TEST_CASE("simplify_filtered, simplify_float: nothing is allocated per removal") {
  const PointSet set(shapes::on_sphere(2000, 7));
  const HullOutcome hull = convex_hull(set);
  const FastDual dual = FastDual::of(std::get<Hull>(hull), set);
  for (const auto simplify :
       {static_cast<FastResult (*)(const FastDual&, const SimplifyOptions&)>(simplify_filtered),
        simplify_float}) {
    const auto allocations = [&](std::size_t removals) {
      const std::size_t before = allocation_count;
      const FastResult result = simplify(dual, {.faces = dual.size() - removals});
      CHECK(result.steps.size() == removals);
      return allocation_count - before;
    };
    const std::size_t few = allocations(200), many = allocations(3000);
    // Lists that grow by doubling, rings longer than all before: a few dozen at most. And a node
    // for each cap that is enclosed in double-double, which is rare where costs are random.
    CHECK(many < few + 100);
  }
}
