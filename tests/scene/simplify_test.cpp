// SPDX-License-Identifier: MIT
// The facade: requests that it refuses, stages that it skips, and one answer by every way through
// it. Expected volumes are closed forms of boxes; the engines are judged in their own rooms.
#include "convexact/simplify.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "convexact/error.hpp"
#include "convexact/shapes.hpp"
#include "expect_error.hpp"
#include "fast/engines.hpp"
#include "halfspace_arrangement.hpp"
#include "scene/run_stages.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

SimplifyRequest request_for(std::size_t faces, Engine engine) {
  SimplifyRequest request;
  request.faces = faces;
  request.engine = engine;
  return request;
}

SimplifyResult run(const Shape& shape, const SimplifyRequest& request) {
  SimplifyOutcome outcome = simplify(shape, request);
  REQUIRE(std::holds_alternative<SimplifyResult>(outcome));
  return std::get<SimplifyResult>(std::move(outcome));
}

template <class Reason>
void check_not_solid(const Shape& shape) {
  const SimplifyOutcome outcome = simplify(shape, request_for(4, Engine::Filtered));
  REQUIRE(std::holds_alternative<NotSolid>(outcome));
  const NotSolid& reason = std::get<NotSolid>(outcome);
  CHECK(std::holds_alternative<Reason>(reason));
  CHECK_FALSE(describe(reason).empty());
}

Halfspace halfspace(int a, int b, int c, int d) { return {IntegerVector3(a, b, c), Integer(d)}; }

std::string skipped(const SimplifyResult& result, const std::string& name) {
  for (const Stage& stage : result.stages) {
    if (stage.name == name) return stage.skipped;
  }
  return "no such stage";
}

bool has_run(const SimplifyResult& result, const std::string& name) {
  return skipped(result, name).empty();
}

}  // namespace

TEST_CASE("simplify: requests that make no sense are refused") {
  const Shape cube = PointSet(shapes::box({1, 1, 1}));
  SimplifyRequest nothing;
  CHECK_THROWS_AS((void)simplify(cube, nothing), Error);
  CHECK_THROWS_AS((void)simplify(cube, request_for(3, Engine::Filtered)), Error);
  SimplifyRequest negative;
  negative.max_growth = Rational(-1);
  CHECK_THROWS_AS((void)simplify(cube, negative), Error);
  SimplifyRequest outside = request_for(4, Engine::Exact);
  outside.center = RationalPoint(Rational(1), Rational(0), Rational(0));  // on the boundary
  CHECK_THROWS_AS((void)simplify(cube, outside), Error);
  SimplifyRequest traced = request_for(4, Engine::Float);
  traced.trace = true;
  CHECK_THROWS_AS((void)simplify(cube, traced), Error);
}

TEST_CASE("simplify: inputs without a bounded volume come back with their proof") {
  check_not_solid<FlatInput>(PointSet());
  check_not_solid<FlatInput>(PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  check_not_solid<EmptyProof>(std::vector{halfspace(1, 0, 0, 1), halfspace(-1, 0, 0, 1)});
  check_not_solid<FlatProof>(std::vector{halfspace(1, 0, 0, 0), halfspace(-1, 0, 0, 0),
                                         halfspace(0, 1, 0, -1), halfspace(0, -1, 0, -1),
                                         halfspace(0, 0, 1, -1), halfspace(0, 0, -1, -1)});
  check_not_solid<RecessionRay>(std::vector{halfspace(1, 0, 0, -1), halfspace(-1, 0, 0, -1)});
  check_not_solid<RecessionRay>(std::vector<Halfspace>());
}

TEST_CASE("simplify: a box keeps its sides, with each engine, and its volume is exact") {
  const Shape box = PointSet(shapes::box({1, 2, 3}));
  for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
    SimplifyRequest request = request_for(4, engine);
    request.exact_volumes = true;
    const SimplifyResult result = run(box, request);
    CHECK(result.stop == StopReason::AllUnbounded);
    CHECK(result.solid.exact.planes.size() == 6);
    CHECK(result.input_volume.exact == Rational(48));
    CHECK(result.output_volume.exact == Rational(48));
    CHECK(result.output_volume.bounds.contains(48));
  }
}

// A unit cube has the area 6 and the mean width 3/2.
TEST_CASE("simplify: a cube with one corner cut, by area and by mean width") {
  const Shape cube = PointSet(shapes::cut_cube(1, 0.5));
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    for (const CostMeasure measure : {CostMeasure::Area, CostMeasure::MeanWidth}) {
      SimplifyRequest request = request_for(6, engine);
      request.cost = measure;
      const SimplifyResult result = run(cube, request);
      CHECK(result.steps == 1);
      CHECK(result.cost == measure);
      const Enclosure after = result.measure.value()[1];
      CHECK(after.contains(measure == CostMeasure::Area ? Rational(6) : Rational(3, 2)));
      CHECK(result.ties.steps == TieTally().steps);
      request.record = request.trace = true;
      const SimplifyResult recorded = run(cube, request);
      CHECK(recorded.start.has_value());
      CHECK(recorded.run.value().measure == measure);
      CHECK(recorded.run->is_greedy);
      CHECK(recorded.run->steps[0].cost->measure() == measure);
      CHECK(recorded.run->evaluations.empty() == (measure == CostMeasure::MeanWidth));
    }
  }
}

TEST_CASE("simplify: mean widths are compared with 128 to 2^20 bits") {
  const Shape cube = PointSet(shapes::cut_cube(1, 0.5));
  SimplifyRequest request = request_for(6, Engine::Filtered);
  request.cost = CostMeasure::MeanWidth;
  for (const long bits : {0L, 127L, (1L << 20) + 1}) {
    request.compare.bits = bits;
    CHECK(error_of([&] { return run(cube, request); }).code() == ErrorCode::InvalidArgument);
  }
}

TEST_CASE("simplify: a cube with one corner cut grows by the corner") {
  // The cut tetrahedron has legs 1/2: volume 1/48.
  const Shape cube = PointSet(shapes::cut_cube(1, 0.5));
  for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
    SimplifyRequest request = request_for(6, engine);
    request.exact_volumes = true;
    const SimplifyResult result = run(cube, request);
    CHECK(result.steps == 1);
    CHECK(result.input_volume.exact == Rational(47, 48));
    CHECK(result.output_volume.exact == Rational(1));
    // Growth is 1/47: just allowed, and just not.
    request.faces.reset();
    request.max_growth = Rational(1, 47);
    if (engine != Engine::Float) CHECK(run(cube, request).steps == 1);
    request.max_growth = Rational(1, 48);
    CHECK(run(cube, request).steps == 0);
  }
}

TEST_CASE("simplify: with or without a record, from points or halfspaces: the same planes") {
  const std::vector<Point> points = shapes::on_sphere(60, 5);
  const SimplifyResult exact = run(PointSet(points), request_for(12, Engine::Exact));
  REQUIRE(exact.run.has_value());
  const std::vector<Halfspace>& planes = exact.solid.exact.planes;
  CHECK(planes.size() == 12);
  SimplifyRequest filtered = request_for(12, Engine::Filtered);
  CHECK(run(PointSet(points), filtered).solid.exact.planes == planes);
  CHECK(run(exact.run->halfspaces, filtered).solid.exact.planes == planes);
  filtered.trace = true;
  const SimplifyResult traced = run(PointSet(points), filtered);
  CHECK(traced.solid.exact.planes == planes);
  REQUIRE(traced.run.has_value());
  for (std::size_t k = 0; k < traced.run->steps.size(); ++k) {
    CHECK(traced.run->steps[k].removed == exact.run->steps[k].removed);
    CHECK(traced.run->steps[k].cost == exact.run->steps[k].cost);
  }
  filtered.center = RationalPoint(Rational(1, 8), Rational(-1, 5), Rational(1, 9));
  CHECK(run(PointSet(points), filtered).solid.exact.planes == planes);
}

TEST_CASE("simplify: full verification proves the steps of the filtered engine a second time" *
          sweep) {
  const std::vector<Point> points = shapes::on_sphere(40, 5);
  for (const CostMeasure measure :
       {CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth}) {
    SimplifyRequest request = request_for(12, Engine::Filtered);
    request.cost = measure;
    const SimplifyResult local = run(PointSet(points), request);
    CHECK_FALSE(has_run(local, "steps again"));
    request.verify = VerifyLevel::Full;
    const SimplifyResult full = run(PointSet(points), request);
    CHECK(has_run(full, "steps again"));
    CHECK(full.solid.exact.planes == local.solid.exact.planes);
    request.search = {.kind = SearchKind::Walk};
    CHECK(has_run(run(PointSet(points), request), "steps again"));
  }
}

// Between the engine and the proof, the record of one step is changed.
TEST_CASE("simplify: full verification refuses a wrong step of the filtered engine") {
  const Shape shape = PointSet(shapes::on_sphere(20, 5));
  SimplifyRequest request = request_for(12, Engine::Filtered);
  request.verify = VerifyLevel::Full;
  const auto finish = [&](const std::function<void(Step&)>& change) {
    StageLog log;
    const auto prepared = prepare_run(shape, request, log);
    RunInput& input = *std::get<std::unique_ptr<RunInput>>(prepared);
    Run made = simplify_filtered(input.solid->dual, input.center, options_of(request, input));
    change(made.steps.at(3));
    InputMeasures before = measure_input(input, request, log);
    return finish_run(input, std::move(before), end_of(std::move(made), log), request, log);
  };
  CHECK(finish([](Step&) {}).steps == 24);
  for (const auto& change : std::vector<std::function<void(Step&)>>{
           [](Step& step) { step.cost = Cost(step.cost.value().rational() * 2); },
           [](Step& step) { step.ring.pop_back(); },
           [](Step& step) { std::swap(step.triangles[0][0], step.triangles[0][1]); }}) {
    CHECK(error_of([&] { return finish(change); }).code() == ErrorCode::Internal);
  }
}

TEST_CASE("simplify: what a scene does not need is skipped, with a reason") {
  const std::vector<Point> points = shapes::on_sphere(60, 5);
  const SimplifyResult lean = run(PointSet(points), request_for(12, Engine::Filtered));
  CHECK_FALSE(skipped(lean, "Chebyshev center").empty());
  CHECK_FALSE(skipped(lean, "hull of dual points").empty());
  CHECK_FALSE(skipped(lean, "store mesh").empty());
  CHECK(skipped(lean, "simplify").empty());
  const SimplifyResult reference = run(PointSet(points), request_for(12, Engine::Exact));
  CHECK(skipped(reference, "Chebyshev center").empty());
  CHECK(skipped(reference, "hull certificate").empty());
  const SimplifyResult planes = run(lean.solid.exact.planes, request_for(8, Engine::Filtered));
  CHECK_FALSE(skipped(planes, "hull").empty());
  CHECK(skipped(planes, "hull of dual points").empty());
}

// Closed forms: the corner of legs 1/2 adds (3 - sqrt 3) / 8 to the area of the unit cube, and
// 0.0262336615512144 to the mean width.
TEST_CASE("simplify: the float engine's growth limit by area and by mean width") {
  const double area = (3 - std::sqrt(3.0)) / 8, width = 0.0262336615512144;
  const PointSet cut(shapes::cut_cube(1, 0.5));
  for (const CostMeasure measure : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    const double growth = measure == CostMeasure::Area ? area / (6 - area) : width / (1.5 - width);
    for (const double share : {growth * (1 - 1e-9), growth * (1 + 1e-9)}) {
      SimplifyRequest request = request_for(4, Engine::Float);
      request.cost = measure;
      request.max_growth = to_rational(share);
      const SimplifyResult result = run(cut, request);
      CHECK(result.float_bound.value().is_vouched());
      CHECK(result.steps == (share > growth ? 1 : 0));
    }
  }
}

TEST_CASE("simplify: the float engine's end at a growth limit is judged by exact volumes") {
  // A cube with a corner cut off at 1/2 lacks 1/48 of its volume, and grows by 1/47 to get it back.
  const PointSet cut(shapes::cut_cube(1, 0.5));
  SimplifyRequest request = request_for(4, Engine::Float);
  for (const Rational& growth : {Rational(1, 47) - Rational(1, 1000), Rational(1, 40)}) {
    CAPTURE(to_string(growth));
    request.max_growth = growth;
    const SimplifyResult result = run(cut, request);
    REQUIRE(result.float_bound.has_value());
    CHECK(result.float_bound->is_vouched());
    CHECK(result.steps == (growth > Rational(1, 47) ? 1 : 0));
  }
  // Exactly met: doubles cannot tell, so nothing is vouched for, whatever they did.
  request.max_growth = Rational(1, 47);
  CHECK_FALSE(run(cut, request).float_bound->is_end_proven);
  request.engine = Engine::Filtered;
  CHECK_FALSE(run(cut, request).float_bound.has_value());
}

TEST_CASE(
    "simplify: where doubles get the float engine's surface wrong, its planes still bound it") {
  // Balls of sizes 1, 2^-500 and 2^-1000 in one shape: doubles see the small ones as points, so the
  // triangles that the loop ends with are no hull. Volumes are by the definition.
  const shapes::Family& family = shapes::family("mixed-scales");
  for (const std::uint64_t seed : {1u, 2u}) {
    CAPTURE(seed);
    const PointSet points(shapes::generate(family, shapes::usual_values(family), seed));
    SimplifyRequest request = request_for(6, Engine::Float);
    request.exact_volumes = true;
    const SimplifyResult result = run(points, request);
    const std::vector<Halfspace>& planes = result.solid.exact.planes;
    CHECK(planes.size() < result.input_halfspaces);
    const definition::HalfspaceArrangement arrangement(planes);
    CHECK(result.output_volume.exact == arrangement.volume(arrangement.all()));
    for (const RationalPoint& vertex : result.solid.exact.vertices) {
      for (const Halfspace& plane : planes) CHECK(plane(vertex) <= 0);
    }
    CHECK_FALSE(result.float_bound->is_vouched());
  }
}

TEST_CASE("planes: doubles that hold every point, in the order of the exact planes") {
  // Sevenths are no doubles, so that rounding has to give way; the definition judges: n.p + d <= 0.
  std::vector<RationalPoint> points;
  for (const int x : {1, 9})
    for (const int y : {-3, 5})
      for (const int z : {2, 11})
        points.emplace_back(Rational(x, 7), Rational(y, 7), Rational(z, 7));
  points.emplace_back(Rational(10, 7), Rational(1, 7), Rational(6, 7));
  const SimplifyResult result = run(PointSet(points), request_for(6, Engine::Filtered));
  const auto planes = result.planes();
  REQUIRE(planes.size() == result.solid.exact.planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto& [a, b, c, d] = planes[i];
    const RationalVector3 n(to_rational(a), to_rational(b), to_rational(c));
    for (const RationalPoint& p : points) CHECK(n.dot(p) + to_rational(d) <= 0);
    const auto& exact = result.solid.exact.planes[i].normal();
    CHECK(n.dot(RationalVector3(exact.x(), exact.y(), exact.z())) > 0);
  }
  // Asked for beforehand, they are stored and the same.
  SimplifyRequest request = request_for(6, Engine::Filtered);
  request.store.planes = Precision::Binary64;
  CHECK(run(PointSet(points), request).planes() == planes);
}

TEST_CASE("planes: an offset beyond the largest double is an error") {
  // The fourth facet is x + y + z <= 2.9 m, and normals are at least a half: d <= -1.45 m.
  const double m = 1.7e308, less = 1.53e308;
  const std::vector<Point> points = {{0, 0, 0}, {m, m, less}, {m, less, m}, {less, m, m}};
  const SimplifyResult result = run(PointSet(points), request_for(4, Engine::Exact));
  CHECK(error_of([&] { (void)result.planes(); }).code() == ErrorCode::Unrepresentable);
}

TEST_CASE("require_solid: the result, or the proof as an error") {
  const auto hull_of = [](std::vector<Point> points) {
    return require_solid(measure_hull(PointSet(std::move(points))));
  };
  CHECK(hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).edges == 6);
  const Error error = error_of([&] { return hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).edges; });
  CHECK(error.code() == ErrorCode::NoInterior);
  CHECK(std::string(error.what()).ends_with("they lie in one plane; every one satisfies z = 0"));
}

TEST_CASE("measure_hull: a box, by closed form, with as many digits as asked for") {
  const PointSet box(shapes::box({1, 2, 3}));
  HullRequest request;
  request.digits = 40;
  request.exact_volume = true;
  const HullReport report = measure_hull(box, request);
  const auto& result = std::get<HullResult>(report);
  CHECK(result.edges == 12);
  REQUIRE((result.volume && result.area && result.mean_width));
  CHECK(result.volume->exact == Rational(48));
  CHECK(result.area->bounds.contains(88));       // 2 (2*4 + 4*6 + 6*2)
  CHECK(result.mean_width->bounds.contains(6));  // (2 + 4 + 6) / 2
  CHECK(result.box.squared_diameter() == 56);
  request.digits = 0;
  CHECK_THROWS_AS((void)measure_hull(box, request), Error);
}

// The cube [-1, 1]^3 without a corner of legs 1, 1 and 2. All planes touch the unit ball, so the
// area is three times the volume, and both grow by (1/3) / (23/3) = 1/23 when the corner returns.
TEST_CASE("simplify: the limit of another measure is decided exactly") {
  const Shape cut = std::vector<Halfspace>{halfspace(1, 0, 0, -1), halfspace(-1, 0, 0, -1),
                                           halfspace(0, 1, 0, -1), halfspace(0, -1, 0, -1),
                                           halfspace(0, 0, 1, -1), halfspace(0, 0, -1, -1),
                                           halfspace(2, 2, 1, -3)};
  constexpr CostMeasure kAll[] = {CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth};
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    for (const CostMeasure cost : kAll) {
      for (const CostMeasure limited : {CostMeasure::Volume, CostMeasure::Area}) {
        CAPTURE(static_cast<int>(engine));
        CAPTURE(static_cast<int>(cost));
        CAPTURE(static_cast<int>(limited));
        SimplifyRequest request = request_for(6, engine);
        request.cost = cost;
        request.growth_of = limited;
        request.max_growth = Rational(1, 23);
        const SimplifyResult allowed = run(cut, request);
        CHECK(allowed.steps == 1);
        CHECK(allowed.growth_of == limited);
        CHECK(allowed.limited.has_value() == (limited != cost && limited == CostMeasure::Area));
        request.max_growth = Rational(1, 23) - scale_by_power_of_two(Rational(1), -200);
        const SimplifyResult refused = run(cut, request);
        CHECK(refused.steps == 0);
        CHECK(refused.stop == StopReason::GrowthLimit);
        CHECK(refused.growth_bits == 0);
      }
    }
  }
}

// The cube's mean width is 3/2. A basis of the angles proves that the limit is not met exactly, so
// ever finer enclosures decide.
TEST_CASE("simplify: a limit close to the growth of the mean width is decided, or told") {
  const PointSet cut(shapes::cut_cube(1, 0.5));
  const SimplifyResult all = run(cut, request_for(6, Engine::Exact));
  const std::vector<Halfspace>& halfspaces = all.run->halfspaces;
  const RationalPoint center = RationalPoint::Constant(Rational(1, 2));
  const Polytope solid = to_polytope(halfspaces, dual_of(halfspaces, center).dual.triangles);
  const Enclosure growth =
      Enclosure(Rational(3, 2), 400) / exact_measure(solid, CostMeasure::MeanWidth).enclose(400);
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    SimplifyRequest request = request_for(6, engine);
    request.growth_of = CostMeasure::MeanWidth;
    request.compare.bits = 128;
    request.max_growth = Rational(growth.high() - 1);
    const SimplifyResult allowed = run(cut, request);
    CHECK(allowed.steps == 1);
    CHECK(allowed.growth_of == CostMeasure::MeanWidth);
    CHECK(allowed.limited.has_value());
    // Without that proof, 128 bits do not tell: the step is not made, and the result says so.
    request.compare.angle_basis = false;
    const SimplifyResult undecided = run(cut, request);
    CHECK(undecided.steps == 0);
    CHECK(undecided.stop == StopReason::GrowthLimit);
    CHECK(undecided.growth_bits == 128);
    request.compare.angle_basis = true;
    request.max_growth = Rational(growth.low() - 1);
    const SimplifyResult refused = run(cut, request);
    CHECK(refused.steps == 0);
    CHECK(refused.stop == StopReason::GrowthLimit);
    CHECK(refused.growth_bits == 0);
  }
}

TEST_CASE("simplify: what limits no growth, or not that of its costs, is refused") {
  const Shape cube = PointSet(shapes::box({1, 1, 1}));
  SimplifyRequest request = request_for(4, Engine::Filtered);
  request.growth_of = CostMeasure::Area;
  CHECK_THROWS_AS((void)simplify(cube, request), Error);
  request.max_growth = Rational(1);
  CHECK_NOTHROW((void)simplify(cube, request));
  request.engine = Engine::Float;
  CHECK_THROWS_AS((void)simplify(cube, request), Error);
  request.cost = CostMeasure::Area;
  CHECK_NOTHROW((void)simplify(cube, request));
}
