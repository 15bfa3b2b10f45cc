// SPDX-License-Identifier: MIT
// How a run stops, and changes of the input that must not change its answer. The expected values
// come from the input's own symmetry: the run on the transformed input must be the transformed run.
#include "simplify/exact_engine.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "convexact/error.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"

using namespace convexact;

namespace {

// Solids with many ties and planes that share points, and some without.
std::vector<std::vector<Point>> samples() {
  return {shapes::cut_cube(5, 0.25),
          shapes::chamfered_box({1, 2, 3}, 0.25),
          shapes::octahedron(),
          shapes::icosahedron(),
          shapes::lattice(16, 3, 1),
          shapes::lattice(24, 2, 2),
          shapes::centrally_symmetric(6, 1),
          shapes::in_ball(16, 1)};
}

// Counts what the verification asks after each choice.
struct CountedChecks : RunObserver {
  void started(const DualTriangle&) override {}
  void inserted(HalfspaceId, std::span<const DualTriangle>,
                std::span<const DualTriangle>) override {}
  void evaluated(std::size_t, const Removal&) override {}
  void chosen(const Step&) override { after_choice.push_back(0); }
  void checked(const TestedCondition&, bool) override { ++after_choice.back(); }

  std::vector<std::size_t> after_choice;
};

// The same removals with the same ties, at costs scaled by `factor`.
void check_same(const Run& a, const Run& b, const Rational& factor = 1) {
  REQUIRE(a.steps.size() == b.steps.size());
  CHECK(a.stop == b.stop);
  for (std::size_t s = 0; s < a.steps.size(); ++s) {
    CAPTURE(s);
    CHECK(a.steps[s].removed == b.steps[s].removed);
    CHECK(a.steps[s].tie == b.steps[s].tie);
    CHECK(Cost(a.steps[s].cost->rational() * factor) == b.steps[s].cost);
  }
}

}  // namespace

TEST_CASE("simplify_exact: permuted, duplicated, with interior points") {
  for (const std::vector<Point>& points : samples()) {
    const Run trace = simplify_points(points);
    std::vector<Point> other = points;
    other.insert(other.end(), points.begin(), points.end());
    Point mean(0, 0, 0);
    for (const Point& p : points) mean += p / static_cast<double>(points.size());
    for (const Point& p : points) other.push_back(0.5 * mean + 0.5 * p);
    Random random(3);
    shuffle(std::span(other), random);
    const Run again = simplify_points(other);
    CHECK(again.halfspaces == trace.halfspaces);
    check_same(trace, again);
  }
}

TEST_CASE("simplify_exact: scaled by powers of two") {
  for (const std::vector<Point>& points : samples()) {
    const Run trace = simplify_points(points);
    for (const int exponent : {-300, -1, 300}) {
      std::vector<Point> scaled = points;
      for (Point& p : scaled) p *= std::ldexp(1.0, exponent);
      check_same(trace, simplify_points(scaled), scale_by_power_of_two(Rational(1), 3 * exponent));
    }
  }
}

TEST_CASE("simplify_exact: translated on the lattice") {
  for (const std::vector<Point>& points :
       {shapes::lattice(16, 3, 1), shapes::lattice(24, 2, 2), shapes::cut_cube(5, 0.25)}) {
    std::vector<Point> moved = points;
    for (Point& p : moved) p += Point(1000, -7, 0x1p30);
    check_same(simplify_points(points), simplify_points(moved));
  }
}

TEST_CASE("simplify_exact: another seed, another center") {
  for (const std::vector<Point>& points : samples()) {
    const DualHull solid = dual_of_doubles(points);
    const RationalPoint center = center_of(solid);
    const Run trace = simplify_exact(solid, center);
    for (const std::uint64_t seed : {2u, 3u}) {
      const RationalPoint other =
          center + (solid.vertices[seed] - center) * Rational(static_cast<int>(seed), 4);
      const Run again = simplify_exact(solid, other, {.seed = seed, .verify = VerifyLevel::Full});
      check_same(trace, again);
    }
  }
}

TEST_CASE("simplify_exact: reflected, the least cost and the mirrored ties at every step") {
  // The canonical order is not mirrored, so on a tie the mirrored run may go elsewhere. Until then
  // its choices are the mirrored ones.
  for (const std::vector<Point>& points : samples()) {
    std::vector<Point> mirrored = points;
    for (Point& p : mirrored) p[0] = -p[0];
    const Run a = simplify_points(points), b = simplify_points(mirrored);
    const auto mirror = [&](HalfspaceId i) {
      IntegerVector3 n = a.halfspaces[i.index()].normal();
      n[0] = -n[0];
      const Halfspace image(n, a.halfspaces[i.index()].offset());
      const auto place = std::lower_bound(b.halfspaces.begin(), b.halfspaces.end(), image);
      REQUIRE(place != b.halfspaces.end());
      CHECK(*place == image);
      return HalfspaceId(place - b.halfspaces.begin());
    };
    for (std::size_t s = 0; s < std::min(a.steps.size(), b.steps.size()); ++s) {
      CAPTURE(s);
      CHECK(a.steps[s].cost == b.steps[s].cost);
      std::vector<HalfspaceId> ties;
      for (const HalfspaceId i : a.steps[s].tie) ties.push_back(mirror(i));
      std::sort(ties.begin(), ties.end());
      CHECK(ties == b.steps[s].tie);
      if (mirror(a.steps[s].removed) != b.steps[s].removed) break;
    }
  }
}

TEST_CASE("simplify_exact: as many faces as there are changes nothing") {
  for (const std::size_t faces : {20u, 21u, 1000u}) {
    const Run run = simplify_points(shapes::icosahedron(), {.faces = faces});
    CHECK(run.steps.empty());
    CHECK(run.stop == StopReason::Reached);
    CHECK(run.triangles.size() == 36);
  }
}

TEST_CASE("simplify_exact: stops at the wanted number, with a prefix of the longer run") {
  const Run full = simplify_points(shapes::in_ball(16, 1));
  const Run run = simplify_points(shapes::in_ball(16, 1), {.faces = 9});
  CHECK(run.stop == StopReason::Reached);
  CHECK(survivors(run).size() == 9);
  CHECK(run.triangles.size() == 14);
  for (std::size_t s = 0; s < run.steps.size(); ++s) {
    CHECK(run.steps[s].removed == full.steps[s].removed);
  }
  CHECK(survivors(run) == survivors(full, run.steps.size()));
}

TEST_CASE("simplify_exact: the longest prefix within the growth") {
  // A cube with three corners cut off at depth 1/4: V0 = 1 - 3/384, each step costs 1/384.
  const std::vector<Point> points = shapes::cut_cube(3, 0.25);
  const Rational step(1, 384), volume = 1 - 3 * step;
  const auto steps_within = [&](const Rational& growth) {
    const Run trace = simplify_points(points, {.max_growth = growth});
    CHECK(trace.stop ==
          (trace.steps.size() < 3 ? StopReason::GrowthLimit : StopReason::AllUnbounded));
    return trace.steps.size();
  };
  const Rational little = scale_by_power_of_two(Rational(1), -500);  // enclosures cannot tell
  CHECK(steps_within(0) == 0);
  CHECK(steps_within(step / volume) == 1);
  CHECK(steps_within(Rational(2 * step / volume - little)) == 1);
  CHECK(steps_within(Rational(2 * step / volume)) == 2);
  CHECK(steps_within(Rational(2 * step / volume + little)) == 2);
  CHECK(steps_within(1) == 3);
  CHECK_THROWS_AS((void)steps_within(-little), Error);
}

TEST_CASE("simplify_exact: stops when told to") {
  std::atomic<bool> stop = true;
  try {
    (void)simplify_points(shapes::icosahedron(), {.watch = &stop});
    FAIL("went on");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::Stopped);
  }
  // Also in the middle, from the progress report.
  stop = false;
  std::size_t reports = 0;
  const SimplifyOptions options{.watch = {&stop, [&](std::size_t done, std::size_t total) {
                                            CHECK(total == 16);  // of the 20, four stay
                                            stop = ++reports == 3;
                                            CHECK(done == reports);
                                          }}};
  CHECK_THROWS_AS((void)simplify_points(shapes::icosahedron(), options), Error);
  CHECK(reports == 3);
}

TEST_CASE("simplify_exact: what cannot be asked for") {
  CHECK_THROWS_AS((void)simplify_points(shapes::icosahedron(), {.faces = 3}), Error);
  const DualHull solid = dual_of_doubles(shapes::cube());
  CHECK_THROWS_AS((void)simplify_exact(solid, solid.vertices[0]), Error);
}

TEST_CASE("simplify_exact: a lid of valence 1,000 is evaluated at every step") {
  // The frustum between a polygon at z = 0 and its half at z = 1. Without the lid the sides meet in
  // the tip, up to the rounding of the polygon; that cap has volume pi/12, the one of a side next
  // to nothing.
  constexpr std::uint32_t kValence = 1000;
  std::vector<Point> points;
  for (std::uint32_t t = 0; t < kValence; ++t) {
    const shapes::CirclePoint c = shapes::on_circle(t, kValence);
    points.emplace_back(c.cosine, c.sine, 0);
    points.emplace_back(c.cosine / 2, c.sine / 2, 1);
  }
  const PointSet set(points);
  const DualHull solid = dual_of(std::get<Hull>(convex_hull(set)), set);
  REQUIRE(solid.halfspaces.size() == kValence + 2);
  const RationalPoint center(Rational(0), Rational(0), Rational(1, 2));
  const Run run = simplify_exact(solid, center, {.faces = kValence - 1});
  CHECK(run.steps.size() == 3);
  for (const Step& step : run.steps) CHECK(step.cost < Rational(1, 1000000));
}

// The eight corners that are cut off a cube are equal: each removal but the last is tied.
TEST_CASE("simplify_exact: of a tie the first in canonical order is removed, and all are listed") {
  const Run trace = simplify_points(shapes::cut_cube(8, 0.25), {.faces = 6});
  REQUIRE(trace.steps.size() == 8);
  for (std::size_t s = 0; s < 8; ++s) {
    const Step& step = trace.steps[s];
    CHECK(step.tie.size() == 8 - s);
    CHECK(step.removed == step.tie.front());
    CHECK(std::is_sorted(step.tie.begin(), step.tie.end()));
    if (s > 0) CHECK(trace.steps[s - 1].removed < step.removed);
  }
}

TEST_CASE("simplify_exact: each step is verified as it is made, and the survivors at the end") {
  const DualHull solid = dual_of_doubles(shapes::in_ball(16, 1));
  const RationalPoint center = center_of(solid);
  CountedChecks checks;
  const Run run = simplify_exact(solid, center, {}, &checks);
  REQUIRE(run.steps.size() > 1);
  CHECK(checks.after_choice.size() == run.steps.size());
  CHECK(std::ranges::count(checks.after_choice, 0) == 0);
  // A vertex that is none and a witness that does not touch its plane change nothing about the run:
  // only verification asks them.
  DualHull outside = solid;
  outside.vertices.push_back(RationalPoint(Rational(9), Rational(9), Rational(9)));
  CHECK_THROWS_WITH_AS((void)simplify_exact(outside, center, {.verify = VerifyLevel::Full}),
                       doctest::Contains("every survivor holds every hull vertex at the end"),
                       Error);
  CHECK_NOTHROW((void)simplify_exact(outside, center));
  DualHull wrong = solid;
  for (std::uint32_t v = 0; v < solid.vertices.size(); ++v) {
    if (solid.halfspaces[0](solid.vertices[v]) != 0) wrong.witness[0] = v;
  }
  CHECK_THROWS_WITH_AS((void)simplify_exact(wrong, center, {.faces = solid.halfspaces.size()}),
                       doctest::Contains("touches its support witness at the end"), Error);
  CHECK_NOTHROW((void)simplify_exact(wrong, center, {.verify = VerifyLevel::None}));
}
