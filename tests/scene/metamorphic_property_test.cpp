// SPDX-License-Identifier: MIT
// Changes that must not change an answer, on inputs that shrink: the order of points, repeats,
// inner points, seed and center, translations, powers of two, and (up to the first tie, whose order
// is canonical) reflections and exchanges of axes. For the hull, both exact ways to simplify, and
// the oracle.
#include "convexact/dual.hpp"
#include "fast/engines.hpp"
#include "motion.hpp"
#include "property.hpp"
#include "simplify/exact_engine.hpp"

using namespace motion;

namespace {

using EngineFunction = Run (*)(const DualHull&, const RationalPoint&, const SimplifyOptions&);

// Of points that span a volume. @param weight  Of the first vertex in the center.
std::optional<Run> trace_of(EngineFunction engine, const Points& points, std::uint64_t seed = 1,
                            unsigned weight = 1) {
  const auto hull = hull_of(points, seed);
  if (!hull) return {};
  const DualHull solid = dual_of(*hull, PointSet(points));
  RationalPoint center = solid.vertices.front() * Rational(weight - 1);
  for (const RationalPoint& v : solid.vertices) center += v;
  center /= Rational(solid.vertices.size() + weight - 1);
  return engine(solid, center, {.seed = seed});
}

// The same halfspaces at 2^exponent times the costs, in the same order.
bool same_steps(const std::optional<Run>& a, const std::optional<Run>& b, long exponent = 0) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->stop == b->stop &&
         std::equal(a->steps.begin(), a->steps.end(), b->steps.begin(), b->steps.end(),
                    [&](const Step& s, const Step& t) {
                      return s.removed == t.removed && s.tie == t.tie && s.left == t.left &&
                             scale_by_power_of_two(s.cost->rational(), exponent) == t.cost;
                    });
}

std::set<Halfspace> tied_planes(const Run& trace, const Step& step) {
  std::set<Halfspace> planes;
  for (const HalfspaceId id : step.tie) planes.insert(trace.halfspaces[id.index()]);
  return planes;
}

// The same costs and mirrored ties, up to the first tie of several.
bool mirrored(const Run& original, const Run& image, const Motion& motion) {
  for (std::size_t s = 0; s < original.steps.size(); ++s) {
    if (s >= image.steps.size() || original.steps[s].cost != image.steps[s].cost) return false;
    std::set<Halfspace> expected;
    for (const Halfspace& h : tied_planes(original, original.steps[s])) expected.insert(motion(h));
    if (tied_planes(image, image.steps[s]) != expected) return false;
    if (expected.size() > 1) return true;
  }
  return original.steps.size() == image.steps.size() && original.stop == image.stop;
}

constexpr EngineFunction kEngines[] = {simplify_exact, simplify_filtered};

}  // namespace

TEST_CASE("metamorphic: the hull moves with its points") {
  check_property("planes move", [](const Coordinates& raw, std::uint8_t m,
                                   const std::array<std::int32_t, 3>& by, std::int8_t e) {
    const Points points = small_points(raw);
    for (Motion motion : {Motion::symmetry(m), Motion::translation_and_scale(by, e)}) {
      std::set<Halfspace> expected;
      for (const Halfspace& h : planes_of(points)) expected.insert(motion(h));
      RC_ASSERT(planes_of(motion(points)) == expected);
    }
  });
}

TEST_CASE("metamorphic: order, repeats, inner points and seed leave the hull as it is") {
  check_property("same planes", [](const Coordinates& raw, std::uint32_t seed) {
    const Points points = small_points(raw);
    RC_ASSERT(planes_of(with_irrelevant(points, seed), seed) == planes_of(points));
  });
}

TEST_CASE("metamorphic: order, repeats, inner points, seed and center leave every step as it is") {
  check_property("same steps", [](const Coordinates& raw, std::uint32_t seed, std::uint8_t weight) {
    const Points points = small_points(raw);
    for (const EngineFunction engine : kEngines) {
      RC_ASSERT(same_steps(trace_of(engine, points),
                           trace_of(engine, with_irrelevant(points, seed), seed, 1 + weight)));
    }
  });
}

TEST_CASE("metamorphic: translations and powers of two change only the costs, by that power") {
  check_property("same steps",
                 [](const Coordinates& raw, const std::array<std::int32_t, 3>& by, std::int8_t e) {
                   const Points points = small_points(raw);
                   const Motion motion = Motion::translation_and_scale(by, e);
                   for (const EngineFunction engine : kEngines) {
                     RC_ASSERT(same_steps(trace_of(engine, points),
                                          trace_of(engine, motion(points)), 3 * motion.exponent));
                   }
                 });
}

TEST_CASE("metamorphic: reflections and exchanges of axes mirror the steps and the first tie") {
  check_property("mirrored", [](const Coordinates& raw, std::uint8_t m) {
    const Points points = small_points(raw);
    const Motion motion = Motion::symmetry(m);
    for (const EngineFunction engine : kEngines) {
      const auto original = trace_of(engine, points), image = trace_of(engine, motion(points));
      RC_ASSERT(original.has_value() == image.has_value());
      if (original) RC_ASSERT(mirrored(*original, *image, motion));
    }
  });
}
