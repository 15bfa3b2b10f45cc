// SPDX-License-Identifier: MIT
// What must not change an answer, on inputs that shrink: the order of points, repeats, inner
// points, seed and center, translations, powers of two, and (up to the first tie, whose order is
// canonical) reflections and exchanges of axes. For the hull, both exact ways to simplify, and the
// oracle.
#include <algorithm>
#include <cmath>
#include <set>

#include "convexact/dual/dual_hull.hpp"
#include "convexact/fast/filtered_engine.hpp"
#include "convexact/number/random.hpp"
#include "convexact/oracle/verify.hpp"
#include "convexact/simplify/exact_engine.hpp"
#include "property.hpp"

using namespace convexact;

namespace {

using Points = std::vector<Point>;
using Coordinates = std::vector<std::array<std::int8_t, 3>>;

// Few values, so that coplanar points, repeats and ties are common.
Points small_points(const Coordinates& raw) {
  Points points;
  for (const auto& p : raw) points.emplace_back(p[0] % 4, p[1] % 4, p[2] % 4);
  return points;
}

// x -> 2^exponent (s_k x_{axis k} + by_k), exactly for small integers.
struct Motion {
  std::array<int, 3> axis{0, 1, 2}, sign{1, 1, 1};
  Point by = Point::Zero();
  int exponent = 0;

  static Motion translation_and_scale(const std::array<std::int32_t, 3>& by, std::int8_t e) {
    return {{0, 1, 2}, {1, 1, 1}, Point(by[0], by[1], by[2]), 2 * e};
  }
  // One of the 48 symmetries of the axes.
  static Motion symmetry(unsigned m) {
    Motion motion;
    for (unsigned k = 0; k < m / 8 % 6; ++k) {
      std::next_permutation(motion.axis.begin(), motion.axis.end());
    }
    for (unsigned k = 0; k < 3; ++k) motion.sign[k] = m >> k & 1 ? -1 : 1;
    return motion;
  }
  Point operator()(const Point& p) const {
    Point q;
    for (int k = 0; k < 3; ++k) q[k] = std::ldexp(sign[k] * p[axis[k]] + by[k], exponent);
    return q;
  }
  Points operator()(const Points& points) const {
    Points moved;
    for (const Point& p : points) moved.push_back((*this)(p));
    return moved;
  }
  Halfspace operator()(const Halfspace& h) const {
    RationalVector3 normal;
    for (int k = 0; k < 3; ++k) normal[k] = Rational(h.normal()[axis[k]] * sign[k]);
    const Rational offset = Rational(h.offset()) - normal.dot(to_rational(by));
    return {normal, scale_by_power_of_two(offset, exponent)};
  }
};

// The same points in another order, some again, and some means of two, which are inside or on the
// boundary.
Points with_irrelevant(Points points, std::uint64_t seed) {
  Random random(seed);
  const std::size_t n = points.size();
  for (std::size_t k = 0; n > 0 && k < 5; ++k) {
    const Point p = points[uniform_below(random, n)], q = points[uniform_below(random, n)];
    points.push_back(k < 2 ? p : Point((p + q) / 2));
  }
  shuffle(std::span(points), random);
  return points;
}

std::optional<Hull> hull_of(const Points& points, std::uint64_t seed = 1) {
  HullOutcome outcome = convex_hull(PointSet(points), {.seed = seed});
  if (!std::holds_alternative<Hull>(outcome)) return {};
  return std::get<Hull>(std::move(outcome));
}

std::set<Halfspace> planes_of(const Points& points, std::uint64_t seed = 1) {
  const auto hull = hull_of(points, seed);
  if (!hull) return {};
  const std::vector<Halfspace> planes = facet_halfspaces(*hull, PointSet(points));
  return {planes.begin(), planes.end()};
}

using Engine = Simplification (*)(const DualHull&, const RationalPoint&, const SimplifyOptions&);

// Of points that span a volume. @param weight  Of the first vertex in the center.
std::optional<Trace> trace_of(Engine engine, const Points& points, std::uint64_t seed = 1,
                              unsigned weight = 1) {
  const auto hull = hull_of(points, seed);
  if (!hull) return {};
  const DualHull solid = dual_of(*hull, PointSet(points));
  RationalPoint center = solid.vertices.front() * Rational(weight - 1);
  for (const RationalPoint& v : solid.vertices) center += v;
  center /= Rational(solid.vertices.size() + weight - 1);
  return engine(solid, center, {.seed = seed}).trace;
}

// The same halfspaces at 2^exponent times the costs, in the same order.
bool same_steps(const std::optional<Trace>& a, const std::optional<Trace>& b, long exponent = 0) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->stop == b->stop &&
         std::equal(a->steps.begin(), a->steps.end(), b->steps.begin(), b->steps.end(),
                    [&](const Step& s, const Step& t) {
                      return s.removed == t.removed && s.tie == t.tie && s.left == t.left &&
                             scale_by_power_of_two(s.cost, exponent) == t.cost;
                    });
}

std::set<Halfspace> tied_planes(const Trace& trace, const Step& step) {
  std::set<Halfspace> planes;
  for (const HalfspaceId id : step.tie) planes.insert(trace.halfspaces[id.index()]);
  return planes;
}

// The same costs and mirrored ties, up to the first tie of several.
bool mirrored(const Trace& original, const Trace& image, const Motion& motion) {
  for (std::size_t s = 0; s < original.steps.size(); ++s) {
    if (s >= image.steps.size() || original.steps[s].cost != image.steps[s].cost) return false;
    std::set<Halfspace> expected;
    for (const Halfspace& h : tied_planes(original, original.steps[s])) expected.insert(motion(h));
    if (tied_planes(image, image.steps[s]) != expected) return false;
    if (expected.size() > 1) return true;
  }
  return original.steps.size() == image.steps.size() && original.stop == image.stop;
}

// The candidate is the hull of some of the input's points, as halfspaces and as points.
std::vector<Candidate> candidates(const Points& points, const Motion& motion = {}) {
  const Points some(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(
                                                         points.size() - points.size() / 4));
  HalfspaceList list;
  for (const Halfspace& h : planes_of(some)) {
    const Halfspace moved = motion(h);
    list.add(moved.normal().cast<Rational>(), Rational(moved.offset()));
  }
  Mesh mesh;
  mesh.points = PointSet(motion(some));
  return {list, mesh};
}

std::optional<Verdict> verdict_of(const Points& points, const Candidate& candidate,
                                  std::uint64_t seed = 1) {
  VerifyRequest request;
  request.tightness = false;
  request.seed = seed;
  StageLog log;
  VerifyOutcome outcome = verify(PointSet(points), candidate, request, log);
  if (!std::holds_alternative<Verdict>(outcome)) return {};
  return std::get<Verdict>(std::move(outcome));
}

bool same_verdicts(const std::optional<Verdict>& a, const std::optional<Verdict>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const bool same_claims =
      std::all_of(std::begin(kAllClaims), std::end(kAllClaims),
                  [&](ClaimCode code) { return (*a)[code].status == (*b)[code].status; });
  if (!same_claims || a->outside.has_value() != b->outside.has_value()) return false;
  return !a->outside ||
         a->outside->relative_squared_distance == b->outside->relative_squared_distance;
}

constexpr Engine kEngines[] = {simplify_exact, simplify_filtered};

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
    for (const Engine engine : kEngines) {
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
                   for (const Engine engine : kEngines) {
                     RC_ASSERT(same_steps(trace_of(engine, points),
                                          trace_of(engine, motion(points)), 3 * motion.exponent));
                   }
                 });
}

TEST_CASE("metamorphic: reflections and exchanges of axes mirror the steps and the first tie") {
  check_property("mirrored", [](const Coordinates& raw, std::uint8_t m) {
    const Points points = small_points(raw);
    const Motion motion = Motion::symmetry(m);
    for (const Engine engine : kEngines) {
      const auto original = trace_of(engine, points), image = trace_of(engine, motion(points));
      RC_ASSERT(original.has_value() == image.has_value());
      if (original) RC_ASSERT(mirrored(*original, *image, motion));
    }
  });
}

TEST_CASE("metamorphic: a verdict is that on the points in another order, moved or repeated") {
  check_property("same verdicts", [](const Coordinates& raw, std::uint8_t m, std::uint32_t seed,
                                     const std::array<std::int32_t, 3>& by, std::int8_t e) {
    const Points points = small_points(raw);
    const std::vector<Candidate> original = candidates(points);
    for (std::size_t c = 0; c < original.size(); ++c) {
      const auto verdict = verdict_of(points, original[c]);
      for (const Motion& motion : {Motion::symmetry(m), Motion::translation_and_scale(by, e)}) {
        const Points moved = with_irrelevant(motion(points), seed);
        const auto again = verdict_of(moved, candidates(points, motion)[c], seed);
        RC_ASSERT(same_verdicts(verdict, again));
      }
    }
  });
}
