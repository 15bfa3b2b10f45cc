// SPDX-License-Identifier: MIT
// Changes that must not change a verdict, on inputs that shrink: the order of points, repeats,
// inner points, the seed, and any motion of input and candidate together.
#include "convexact/verify.hpp"
#include "motion.hpp"
#include "property.hpp"

using namespace motion;

namespace {

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
  VerifyOutcome outcome = verify(PointSet(points), candidate, request);
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

}  // namespace

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
