// SPDX-License-Identifier: MIT
// Inner runs: the filtered engine removes what the exact one does, at the same costs, with the same
// ties; and what must not change a run does not.
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "convexact/io.hpp"
#include "convexact/shapes.hpp"
#include "inner_runs.hpp"
#include "number/random.hpp"
#include "perturb.hpp"
#include "shapes/makers.hpp"
#include "shipped_meshes.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

using Removed = std::vector<std::pair<RationalPoint, Rational>>;

// The removed points and their costs.
Removed removed_by(const std::vector<Point>& points, std::uint64_t seed = 1) {
  const VertexHull start = inner_runs::start_of(PointSet(points), seed).value();
  Removed removed;
  for (const Step& step : inner_runs::filtered_run(start, {.seed = seed}).steps) {
    removed.emplace_back(start.points[PointId(step.removed.index())], step.cost.value().rational());
  }
  return removed;
}

}  // namespace

TEST_CASE("simplify_inner_filtered: every family, small") {
  for (const shapes::Family& family : shapes::families()) {
    CAPTURE(family.name);
    if (family.dimension < 3) continue;
    std::vector<double> values = shapes::usual_values(family);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const shapes::Parameter& p = family.parameters[k];
      if (p.whole && values[k] > 40) values[k] = std::max(p.least, 40.0);
    }
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      CAPTURE(seed);
      const std::vector<Point> points = shapes::generate(family, values, seed);
      if (points.size() > 500) continue;
      inner_runs::check_same_inner_run(points);
    }
  }
}

TEST_CASE("simplify_inner_filtered: hard doubles" * sweep) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const std::vector<Point> lattice =
        shapes::lattice(10 + static_cast<std::uint32_t>(seed), 1 + seed % 4, seed);
    inner_runs::check_same_inner_run(lattice);
    inner_runs::check_same_inner_run(perturb::nudged(lattice, seed));
    inner_runs::check_same_inner_run(perturb::nudged(lattice, seed, 0x1p-1074));
    inner_runs::check_same_inner_run(perturb::turned(lattice));
    inner_runs::check_same_inner_run(perturb::with_opposites(lattice));
    inner_runs::check_same_inner_run(perturb::stretched(lattice, {-300, 0, 300}));
    inner_runs::check_same_inner_run(perturb::shifted(lattice, {1e9, -1e12, 1e15}));
    inner_runs::check_same_inner_run(shapes::nearly_cospherical(30, 9, 2, seed));
    inner_runs::check_same_inner_run(shapes::nearly_coplanar(30, seed));
    inner_runs::check_same_inner_run(shapes::wide_exponents(20, 300, seed));
    inner_runs::check_same_inner_run(shapes::subnormal(20, 5, seed));
    inner_runs::check_same_inner_run(shapes::huge(20, seed));
    inner_runs::check_same_inner_run(shapes::needle(40, 1e9, seed));
    inner_runs::check_same_inner_run(shapes::slab(40, 1e9, seed));
  }
}

TEST_CASE("simplify_inner_filtered: long rings") {
  for (const std::uint32_t k : {17u, 40u, 100u}) {
    CAPTURE(k);
    inner_runs::check_same_inner_run(shapes::cone(k, 1));
    inner_runs::check_same_inner_run(shapes::bipyramid(k));
    inner_runs::check_same_inner_run(shapes::pyramid(k));
    inner_runs::check_same_inner_run(shapes::prism(k));
  }
}

TEST_CASE("simplify_inner_filtered: shipped meshes, to the end") {
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    inner_runs::check_same_inner_steps(
        simplify_inner_exact(inner_runs::start_of(read_mesh(path).points).value()),
        inner_runs::filtered_run(inner_runs::start_of(read_mesh(path).points).value()));
  }
}

TEST_CASE("simplify_inner_filtered: order, repeats, inner points and seeds change nothing") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    std::vector<Point> points =
        seed % 2 == 0 ? shapes::cube_symmetric(2, 3, seed) : shapes::lattice(30, 2, seed);
    const Removed expected = removed_by(points);
    CHECK(removed_by(points, seed + 7) == expected);
    points.insert(points.end(), points.begin(), points.end());
    points.push_back(std::accumulate(points.begin(), points.end(), Point(0, 0, 0)) /
                     static_cast<double>(points.size()));
    Random random(seed);
    shuffle(std::span(points), random);
    CHECK(removed_by(points, seed) == expected);
  }
}

TEST_CASE("simplify_inner_filtered: powers of two scale the costs, and integers shift nothing") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const std::vector<Point> points = shapes::lattice(30, 1 + seed, seed);
    const Removed expected = removed_by(points);
    const Removed scaled = removed_by(perturb::stretched(points, {5, -3, 200}));
    const Removed shifted = removed_by(perturb::shifted(points, {1024, -7, 3}));
    REQUIRE(scaled.size() == expected.size());
    REQUIRE(shifted.size() == expected.size());
    for (std::size_t s = 0; s < expected.size(); ++s) {
      CHECK(scaled[s].second == scale_by_power_of_two(expected[s].second, 202));
      CHECK(shifted[s].second == expected[s].second);
      CHECK(shifted[s].first == expected[s].first + RationalPoint(1024, -7, 3));
    }
  }
}

TEST_CASE("VolumeFilter bounds the determinants of near vertices") {
  // Differences of every size, with determinants that nearly vanish: against integers.
  Random random(26);
  std::size_t close = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<Point> points;
    const double spread = std::ldexp(1.0, -static_cast<int>(uniform_below(random, 40)));
    for (int k = 0; k < 4; ++k) {
      points.push_back(Point(uniform_unit(random), uniform_unit(random), uniform_unit(random)) *
                           spread +
                       Point(0.75, -0.5, 0.625));
    }
    // The last one near the plane of the others.
    const double s = uniform_unit(random), t = uniform_unit(random);
    points[3] = points[0] + s * (points[1] - points[0]) + t * (points[2] - points[0]);
    const PointSet set(points);
    const NearVertices near(set);
    Extent extent;
    const Triple<double> f = near[VertexId(1)] - near[VertexId(0)],
                         g = near[VertexId(2)] - near[VertexId(0)],
                         h = near[VertexId(3)] - near[VertexId(0)];
    for (const Triple<double>& d : {f, g, h}) extent.include(d);
    const double value = dot(cross(f, g), h), bound = near.bound(extent.size);
    const Interval<double> truth = near.scaled(near.exact().height(0, 1, 2, 3));
    REQUIRE(truth.lower - bound <= value);
    REQUIRE(value <= truth.upper + bound);
    close += std::abs(value - truth.lower) > bound / 64;
  }
  CHECK(close > 0);  // the bound is not empty words
}
