// SPDX-License-Identifier: MIT
// The filtered engine on moved shapes: a translation or a scaling changes no removal and no tie; a
// reflection or an exchange of axes, which changes the canonical order, mirrors every step up to
// the first tie, and that tie as a set.
#include <doctest/doctest.h>

#include <algorithm>
#include <optional>

#include "perturb.hpp"
#include "same_run.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

std::optional<Run> run(const std::vector<Point>& points) {
  const PointSet set(points);
  const HullOutcome outcome = convex_hull(set);
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return {};
  const DualHull solid = dual_of(*hull, set);
  return simplify_filtered(solid, mean_of_vertices(solid));
}

// Sums of few bits, so that shifts by integers are exact.
std::vector<Point> coarse(std::uint64_t seed) {
  switch (seed % 3) {
    case 0:
      return shapes::lattice(12, 2, seed);
    case 1:
      return perturb::with_opposites(shapes::lattice(8, 5, seed));
    default:
      return shapes::lattice(20, 1 << 20, seed);
  }
}

// x -> (s_0 x_a, s_1 x_b, s_2 x_c) for the m-th of the 48 symmetries of the axes.
struct Symmetry {
  std::array<int, 3> axis{0, 1, 2}, sign{1, 1, 1};

  explicit Symmetry(unsigned m) {
    for (unsigned k = 0; k < m / 8; ++k) std::next_permutation(axis.begin(), axis.end());
    for (unsigned k = 0; k < 3; ++k) sign[k] = m >> k & 1 ? -1 : 1;
  }
  Point operator()(const Point& p) const {
    return {sign[0] * p[axis[0]], sign[1] * p[axis[1]], sign[2] * p[axis[2]]};
  }
  Halfspace operator()(const Halfspace& h) const {
    IntegerVector3 normal;
    for (int k = 0; k < 3; ++k) normal[k] = h.normal()[axis[k]] * sign[k];
    return {normal, h.offset()};
  }
};

std::vector<Halfspace> planes_of(const Run& trace, const std::vector<HalfspaceId>& ids) {
  std::vector<Halfspace> planes;
  for (const HalfspaceId id : ids) planes.push_back(trace.halfspaces[id.index()]);
  return planes;
}

void check_mirrored(const Run& original, const Run& image, const Symmetry& symmetry) {
  for (std::size_t s = 0; s < original.steps.size(); ++s) {
    CAPTURE(s);
    REQUIRE(s < image.steps.size());
    const Step &a = original.steps[s], &b = image.steps[s];
    REQUIRE(a.cost == b.cost);
    std::vector<Halfspace> expected;
    for (const Halfspace& h : planes_of(original, a.tie)) expected.push_back(symmetry(h));
    std::sort(expected.begin(), expected.end());
    REQUIRE(planes_of(image, b.tie) == expected);
    if (a.tie.size() > 1) return;  // from here on they may go different ways
  }
  CHECK(original.stop == image.stop);
  CHECK(original.steps.size() == image.steps.size());
}

}  // namespace

TEST_CASE("simplify_filtered: translations and scalings change nothing but the costs") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const auto original = run(coarse(seed));
    if (!original) continue;
    const int e = seed % 2 == 0 ? 250 : -200;
    const std::vector<Point> moved = perturb::stretched(
        perturb::shifted(coarse(seed), {1e6 + 3, -7, double(seed) * 1e5}), {e, e, e});
    const auto image = run(moved);
    REQUIRE(image.has_value());
    REQUIRE(image->halfspaces.size() == original->halfspaces.size());
    CHECK(image->stop == original->stop);
    REQUIRE(image->steps.size() == original->steps.size());
    for (std::size_t s = 0; s < original->steps.size(); ++s) {
      CAPTURE(s);
      REQUIRE(image->steps[s].removed == original->steps[s].removed);
      REQUIRE(image->steps[s].tie == original->steps[s].tie);
      REQUIRE(image->steps[s].cost ==
              scale_by_power_of_two(original->steps[s].cost->rational(), 3 * e));
    }
  }
}

TEST_CASE(
    "simplify_filtered: reflections and exchanges of axes mirror the steps and the first tie") {
  for (std::uint64_t seed = 0; seed < 48; ++seed) {
    CAPTURE(seed);
    const std::vector<Point> points = seed % 4 == 3 ? shapes::in_ball(20, seed) : coarse(seed);
    const auto original = run(points);
    if (!original) continue;
    const Symmetry symmetry(static_cast<unsigned>(seed * 11 % 48));
    std::vector<Point> mirrored;
    for (const Point& p : points) mirrored.push_back(symmetry(p));
    check_mirrored(*original, run(mirrored).value(), symmetry);
  }
}
