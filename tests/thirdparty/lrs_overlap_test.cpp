// SPDX-License-Identifier: MIT
// Overlap of two solids against lrs [Avis2000], third-party truth: whether the halfspaces of both
// have a vertex.
#include <doctest/doctest.h>

#include "convexact/query.hpp"
#include "lrs.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"
using namespace convexact;

namespace {

Polytope hull_of(std::vector<Point> points, const Point& by) {
  for (Point& p : points) p += by;
  return std::get<Polytope>(queried_solid(PointSet(std::move(points))));
}

struct Seen {
  int apart = 0, overlapping = 0;
};

void compare(const Lrs& lrs, const Polytope& a, const Polytope& b, Seen& seen) {
  std::vector<Halfspace> both = a.planes;
  both.insert(both.end(), b.planes.begin(), b.planes.end());
  const Overlap answer = find_overlap(a, b);
  const bool overlaps = std::holds_alternative<CommonPoint>(answer);
  CHECK(check(a, b, answer));
  CHECK(overlaps == !lrs.is_empty(both));
  ++(overlaps ? seen.overlapping : seen.apart);
}

}  // namespace

TEST_CASE("overlap: on grids, where solids touch often, as lrs says") {
  const Lrs lrs("overlap_grid");
  Random random(17);
  const auto away = [&] { return static_cast<double>(uniform_below(random, 9)) - 4; };
  Seen seen;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    const Polytope a = hull_of(shapes::lattice(12, 2, seed), {0, 0, 0});
    const Polytope b = hull_of(shapes::lattice(12, 2, seed + 100), {away(), away(), away()});
    compare(lrs, a, b, seen);
  }
  CHECK(seen.apart > 10);
  CHECK(seen.overlapping > 10);
}

TEST_CASE("overlap: spheres, boxes and needles at distances near that of touching, as lrs says") {
  const Lrs lrs("overlap_near");
  Seen seen;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const double distance : {1.6, 1.85, 1.9, 1.95, 2.0, 2.0 + 0x1p-50}) {
      CAPTURE(seed);
      CAPTURE(distance);
      const Polytope sphere = hull_of(shapes::on_sphere(30, seed), {0, 0, 0});
      compare(lrs, sphere, hull_of(shapes::on_sphere(30, seed + 50), {distance, 0, 0}), seen);
      compare(lrs, hull_of(shapes::cube(), {0, 0, 0}), hull_of(shapes::cube(), {distance, 0.5, 0}),
              seen);
      compare(lrs, sphere, hull_of(shapes::needle(10, 1e6, seed), {0, distance - 1, 0}), seen);
    }
  }
  CHECK(seen.apart > 10);
  CHECK(seen.overlapping > 10);
}
