// SPDX-License-Identifier: MIT
// Only the stages that a scene needs run: for each stage there are a request that needs it and one
// that does not, and the test counts how often the stage began.
#include <doctest/doctest.h>

#include <atomic>
#include <functional>
#include <map>

#include "convexact/hull.hpp"
#include "convexact/measure.hpp"
#include "convexact/simplify.hpp"
#include "convexact/verify.hpp"
#include "fast/engines.hpp"
#include "shapes/makers.hpp"
#include "solid/solid.hpp"

using namespace convexact;

namespace {

/// How often each stage began.
class Counter {
 public:
  StageWatch watch() {
    return {.begins = [this](const std::string& name) { ++begun_[name]; }};
  }
  std::size_t operator[](const std::string& name) const {
    const auto found = begun_.find(name);
    return found == begun_.end() ? 0 : found->second;
  }

 private:
  std::map<std::string, std::size_t> begun_;
};

std::string reason_to_skip(const std::vector<Stage>& stages, const std::string& name) {
  for (const Stage& stage : stages) {
    if (stage.name == name) return stage.skipped;
  }
  return {};
}

/// What a run needed.
struct Plan {
  Counter counter;
  std::vector<Stage> stages = {};
};

const PointSet& ball() {
  static const PointSet points(shapes::in_ball(60, 5));
  return points;
}

SimplifyRequest request_for(Engine engine) {
  SimplifyRequest request;
  request.faces = 10;
  request.engine = engine;
  return request;
}

void simplify_in(Plan& plan, const Shape& shape, SimplifyRequest request) {
  request.watch = plan.counter.watch();
  const SimplifyOutcome outcome = simplify(shape, request);
  REQUIRE(std::holds_alternative<SimplifyResult>(outcome));
  plan.stages = std::get<SimplifyResult>(outcome).stages;
}

std::vector<Halfspace> halfspaces_of_ball() {
  StageLog log;
  return std::get<Solid>(make_solid(ball(), {.check = false}, log)).dual.halfspaces;
}

/// The stage began with one plan, and did not with the other, which says why.
void check_only(const std::string& stage, const Plan& needs, const Plan& needs_not) {
  CAPTURE(stage);
  CHECK(needs.counter[stage] > 0);
  CHECK(needs_not.counter[stage] == 0);
  CHECK_FALSE(reason_to_skip(needs_not.stages, stage).empty());
}

}  // namespace

TEST_CASE("plan: simplify skips what neither the engine nor the input needs") {
  Plan lean, reference, planes, centered;
  simplify_in(lean, ball(), request_for(Engine::Filtered));
  simplify_in(reference, ball(), request_for(Engine::Exact));
  simplify_in(planes, halfspaces_of_ball(), request_for(Engine::Filtered));
  SimplifyRequest request = request_for(Engine::Exact);
  request.center = RationalPoint(0, 0, 0);
  simplify_in(centered, ball(), request);

  check_only("Chebyshev center", reference, lean);
  check_only("Chebyshev center", reference, planes);
  check_only("Chebyshev center", reference, centered);
  check_only("hull certificate", reference, lean);
  for (const CostMeasure cost : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    Plan other;
    request = request_for(Engine::Filtered);
    request.cost = cost;
    simplify_in(other, ball(), request);
    check_only("Chebyshev center", reference, other);
    check_only("hull certificate", reference, other);
    CHECK_FALSE(reason_to_skip(other.stages, "exact planes").empty());
  }
  Plan kept;
  request.cost = CostMeasure::Volume;
  request.keep = {{KeepIds{{HalfspaceId(0)}}, "the first"}};
  simplify_in(kept, ball(), request);
  check_only("Chebyshev center", reference, kept);
  check_only("hull", lean, planes);
  check_only("empty, flat, bounded", planes, lean);
  check_only("hull of dual points", planes, lean);
  CHECK(lean.counter["simplify"] == 1);
  CHECK(lean.counter["hull"] == 1);
}

TEST_CASE("plan: simplify skips what was not requested") {
  Plan bare, rich;
  SimplifyRequest request = request_for(Engine::Filtered);
  request.verify = VerifyLevel::None;
  simplify_in(bare, ball(), request);
  request.verify = VerifyLevel::Local;
  request.store = {.planes = Precision::Binary64, .mesh = Precision::Binary64};
  simplify_in(rich, ball(), request);
  check_only("containment", rich, bare);
  check_only("store planes", rich, bare);
  check_only("store mesh", rich, bare);

  Plan hull;
  REQUIRE(
      std::holds_alternative<HullResult>(measure_hull(ball(), {.watch = hull.counter.watch()})));
  CHECK(hull.counter["area"] == 1);
  CHECK(hull.counter["mean width"] == 1);
  CHECK(bare.counter["area"] + bare.counter["mean width"] == 0);
  CHECK_FALSE(reason_to_skip(bare.stages, "area and mean width").empty());
  CHECK(hull.counter["simplify"] + hull.counter["dual"] <= 1);
}

TEST_CASE("plan: only the float engine's proof replays its removals") {
  Plan replayed, recorded;
  SimplifyRequest request = request_for(Engine::Float);
  request.record = true;
  simplify_in(replayed, ball(), request);
  request.engine = Engine::Filtered;
  simplify_in(recorded, ball(), request);
  CHECK(replayed.counter["replay"] == 1);
  CHECK(recorded.counter["replay"] == 0);
}

TEST_CASE("plan: verify skips what its claims do not ask for") {
  const Candidate candidate = [] {
    HalfspaceList list;
    for (const Halfspace& h : halfspaces_of_ball()) {
      list.add(h.normal().cast<Rational>(), Rational(h.offset()));
    }
    return list;
  }();
  Plan all, one;
  VerifyRequest request;
  const auto verify_in = [&](Plan& plan) {
    request.watch = plan.counter.watch();
    const VerifyOutcome outcome = verify(ball(), candidate, request);
    plan.stages = std::get<Verdict>(outcome).stages;
  };
  verify_in(all);
  request.claims = {ClaimCode::ContainsInput};
  request.tightness = false;
  verify_in(one);
  check_only("tightness", all, one);
  check_only("candidate's vertices", all, one);
  CHECK(one.counter["containment"] == 1);
}

TEST_CASE("plan: caps and exact planes are looked at as they are needed") {
  const Hull hull = std::get<Hull>(convex_hull(ball()));
  const FastDual idle = FastDual::of(hull, ball());
  // As many halfspaces as there are: nothing to choose from.
  CHECK(simplify_filtered(idle, {.faces = idle.size()}).counts.evaluations == 0);
  CHECK(simplify_float(idle, {.faces = idle.size()}).counts.evaluations == 0);
  CHECK(idle.formed() == 0);
  // Costs of points in a ball differ clearly: doubles are enough.
  const FastResult result = simplify_filtered(idle, {.faces = 10});
  CHECK(result.counts.exact == 0);
  CHECK(idle.formed() == 0);
  // Equal costs are not, but the corners of facets prove them: eight equal corners.
  const auto formed_by = [](const PointSet& points) {
    const Hull tied_hull = std::get<Hull>(convex_hull(points));
    const FastDual tied = FastDual::of(tied_hull, points);
    const FastResult run = simplify_filtered(tied, {.faces = 6});
    CHECK(run.counts.congruent > 0);
    return tied.formed();
  };
  const std::vector<Point> cut = shapes::cut_cube(8, 0.25);
  CHECK(formed_by(PointSet(cut)) == 0);
  // Unless they are no doubles.
  std::vector<RationalPoint> thirds;
  for (const Point& p : cut) thirds.push_back(to_rational(p) / Rational(3));
  CHECK(formed_by(PointSet(thirds)) > 0);
}

TEST_CASE("watch: every measure with roots can be stopped (#13)") {
  const PointSet points = ball();
  const auto hull = std::get<Hull>(convex_hull(points));
  const Polytope polytope = to_polytope(hull, points);
  const std::atomic<bool> stop = true;
  const Watch watch(&stop);
  const std::vector<std::function<void()>> loops = {
      [&] { (void)surface_area(polytope, 64, watch); },
      [&] { (void)mean_width(polytope, 64, watch); }};
  for (std::size_t k = 0; k < loops.size(); ++k) {
    CAPTURE(k);
    try {
      loops[k]();
      FAIL_CHECK("it has not stopped");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::Stopped);
    }
  }
}

TEST_CASE("watch: progress of a measure goes up to the whole (#13)") {
  const PointSet points(shapes::fibonacci_sphere(2000));
  std::size_t last = 0, whole = 0, calls = 0;
  const Watch::Progress progress = [&](std::size_t done, std::size_t total) {
    CHECK(done >= last);
    CHECK(done <= total);
    CHECK((whole == 0 || whole == total));
    last = done;
    whole = total;
    ++calls;
  };
  const auto begin = [&] { last = whole = calls = 0; };
  const auto check_end = [&] {
    CHECK(calls >= 2);
    CHECK(last + 512 >= whole);
  };
  const Watch watch(nullptr, progress);
  const auto hull = std::get<Hull>(convex_hull(points));
  const Polytope polytope = to_polytope(hull, points);
  begin();
  (void)surface_area(polytope, 64, watch);
  check_end();
  begin();
  (void)mean_width(polytope, 64, watch);
  check_end();
}
