// SPDX-License-Identifier: MIT
// Property of rays: any bytes are read as rays with directions that are not zero, rounded or as
// spelled, or refused with an Error of exit code 3; rays written as fractions are the same when
// read back, and the answer for each ray against a cube is accepted by its check. Property of
// query: for two small solids on grids, the answer to overlap is accepted by its check, and so is
// that of a ray on the grid against each; and probes hit according to the definitions in rationals.
#include <algorithm>

#include "convexact/query.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "query/probed_solid.hpp"
#include "unless_refused.hpp"

using namespace convexact;

namespace {

Polytope unit_cube() {
  std::vector<Point> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back({k & 1 ? 1. : -1., k & 2 ? 1. : -1., k & 4 ? 1. : -1.});
  return std::get<Polytope>(queried_solid(PointSet(corners)));
}

void hold_rays(FuzzInput& in) {
  static const Polytope cube = unit_cube();
  const std::string_view bytes = in.rest();
  for (const Decimal decimal : {Decimal::Nearest, Decimal::Exact}) {
    const auto rays = unless_refused([&] { return read_rays_bytes(bytes, decimal); });
    if (!rays) continue;
    FUZZ_CHECK(!rays->empty());
    std::string written;
    for (const Ray& ray : *rays) {
      FUZZ_CHECK(!ray.direction.isZero(0));
      FUZZ_CHECK(check(cube, ray, cast_ray(cube, ray)));
      for (const Rational& x : ray.origin) written += to_string(x) + " ";
      for (const Rational& x : ray.direction) written += to_string(x) + " ";
      written += "\n";
    }
    const std::vector<Ray> back = read_rays_bytes(written);
    FUZZ_CHECK(back.size() == rays->size());
    for (std::size_t i = 0; i < back.size(); ++i) {
      FUZZ_CHECK(back[i].origin == (*rays)[i].origin);
      FUZZ_CHECK(back[i].direction == (*rays)[i].direction);
    }
  }
}

Point grid_point(FuzzInput& in, int reach) {
  Point point;
  for (double& x : point) {
    x = static_cast<int>(in.below(static_cast<std::size_t>(2 * reach + 1))) - reach;
  }
  return point;
}

// In units of 1/16, so that the frame of probes is the identity.
std::optional<Polytope> grid_solid(FuzzInput& in) {
  const Point by = grid_point(in, 2);
  std::vector<Point> points = in.grid_points(8, 3);
  for (Point& p : points) p = (p + by) / 16;
  auto solid = queried_solid(PointSet(std::move(points)));
  if (std::holds_alternative<NotSolid>(solid)) return {};
  return std::get<Polytope>(std::move(solid));
}

bool holds(const Polytope& solid, const RationalPoint& x) {
  return std::all_of(solid.planes.begin(), solid.planes.end(),
                     [&](const Halfspace& plane) { return plane(x) <= 0; });
}

// A line in a bounded solid crosses planes at its ends.
bool meets_line(const Polytope& solid, const RationalPoint& p, const RationalPoint& q) {
  const RationalVector3 u = q - p;
  for (const Halfspace& plane : solid.planes) {
    const Rational here = plane(p), slope = plane(q) - here;
    if (slope != 0 && holds(solid, p - here / slope * u)) return true;
  }
  return false;
}

void check_probes(const Polytope& solid, FuzzInput& in) {
  const ProbedSolid probed(solid, ProbeFrame{});
  const Point p = grid_point(in, 8) / 16, q = grid_point(in, 8) / 16;
  const RationalPoint exact_p = to_rational(p), exact_q = to_rational(q);
  FUZZ_CHECK(probed.is_hit(p) == holds(solid, exact_p));
  if (p != q) FUZZ_CHECK(probed.is_hit(ProbeLine{p, q}) == meets_line(solid, exact_p, exact_q));
  const double offset = (static_cast<double>(in.below(17)) - 8) / 16;
  bool above = false, below = false;
  for (const RationalPoint& v : solid.vertices) {
    const Rational value = exact_q.dot(v) - to_rational(offset);
    above = above || value >= 0;
    below = below || value <= 0;
  }
  FUZZ_CHECK(probed.is_hit(ProbePlane{q, offset}) == (above && below));
}

void hold_query(FuzzInput& in) {
  const auto a = grid_solid(in), b = grid_solid(in);
  if (!a || !b) return;
  FUZZ_CHECK(check(*a, *b, find_overlap(*a, *b, in.byte())));
  for (const Polytope* solid : {&*a, &*b}) {
    const Ray ray{to_rational(Point(grid_point(in, 8) / 16)), to_rational(grid_point(in, 3))};
    if (!ray.direction.isZero(0)) FUZZ_CHECK(check(*solid, ray, cast_ray(*solid, ray)));
    check_probes(*solid, in);
  }
}

const FuzzTarget kRays("rays", hold_rays);
const FuzzTarget kQuery("query", hold_query);

}  // namespace
