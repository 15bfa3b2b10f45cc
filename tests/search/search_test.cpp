// SPDX-License-Identifier: MIT
// Searches with known ends, and what must not change them.
#include "convexact/search.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "convexact/measure.hpp"
#include "convexact/simplify.hpp"
#include "expect_error.hpp"
#include "motion.hpp"
#include "searched.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

SimplifyRequest request_for(std::size_t faces, SearchKind kind = SearchKind::None,
                            std::size_t kicks = 200) {
  SimplifyRequest request;
  request.faces = faces;
  request.search = {kind, kicks};
  return request;
}

SimplifyResult simplified(const std::vector<Point>& points, const SimplifyRequest& request) {
  return std::get<SimplifyResult>(simplify(Shape(PointSet(points)), request));
}

std::set<Halfspace> planes_of(const SimplifyResult& result) {
  return {result.solid.exact.planes.begin(), result.solid.exact.planes.end()};
}

// The mean of points that span a volume.
RationalPoint interior_of(const std::vector<Point>& points) {
  RationalPoint sum = RationalPoint::Zero();
  for (const Point& p : points) sum += to_rational(p);
  return sum / Rational(points.size());
}

double ratio(const SimplifyResult& result) {
  return (result.output_volume.bounds / result.input_volume.bounds).high_double();
}

}  // namespace

// The largest ball in the icosahedron with edges a has the radius (3 + sqrt 5) a / (4 sqrt 3), and
// the regular tetrahedron around a ball of radius r the volume 8 sqrt 3 r^3. Over the volume
// 5 (3 + sqrt 5) a^3 / 12 that is (3 + sqrt 5)^2 / 10 = (7 + 3 sqrt 5) / 5 = 2.7416...
TEST_CASE("search: the regular tetrahedron around an icosahedron") {
  const double expected = (7 + 3 * std::sqrt(5.0)) / 5;
  for (const Engine engine : {Engine::Filtered, Engine::Exact}) {
    SimplifyRequest request = request_for(4);
    request.engine = engine;
    CHECK(ratio(simplified(shapes::icosahedron(), request)) > 5);
    request.search.kind = SearchKind::Local;
    CHECK(ratio(simplified(shapes::icosahedron(), request)) == doctest::Approx(expected));
  }
}

TEST_CASE("search: every measure is smaller after a search, and the report says by how much") {
  for (const CostMeasure measure : kMeasures) {
    CAPTURE(static_cast<int>(measure));
    SimplifyRequest request = request_for(8);
    request.cost = measure;
    request.verify = VerifyLevel::Full;
    const std::vector<Point> points = shapes::in_ball(60, 3);
    const SimplifyResult greedy = simplified(points, request);
    request.search.kind = SearchKind::Local;
    request.trace = true;
    const SimplifyResult found = simplified(points, request);
    CHECK(found.solid.exact.planes.size() == 8);
    const auto same = [&](const Enclosure& x, const Polytope& polytope) {
      return to_decimal(x, 12) == to_decimal(enclose_measure(polytope, measure, 100), 12);
    };
    REQUIRE(found.search.has_value());
    CHECK(same(found.search->greedy, greedy.solid.exact));
    CHECK(same(found.search->now, found.solid.exact));
    const std::vector<Move>& moves = found.run->moves;
    REQUIRE(moves.size() >= 1);
    REQUIRE(found.search->best.has_value());
    const auto& best = *found.search->best;
    Enclosure before = found.search->greedy;
    for (std::size_t k = 0; k < moves.size(); ++k) {
      const Enclosure after = moves[k].measure->enclose(100);
      CHECK(after.high() < before.low());
      CHECK((before - after).low_double() <= 1.00001 * (best.before - best.after).high_double());
      before = after;
    }
  }
}

// The caps of an antiprism's sides are congruent but for the rounding of its corners: the one move
// gains less than doubles can tell, and its change comes out above 0 in them.
TEST_CASE("search: the best move is told where only exact numbers know that it helps") {
  const SimplifyResult result =
      simplified(shapes::antiprism(11), request_for(21, SearchKind::Local));
  REQUIRE(result.search.has_value());
  REQUIRE(result.search->moves.size() >= 1);
  REQUIRE(result.search->best.has_value());
  CHECK(result.search->best->move < result.search->moves.size());
  CHECK(result.search->now.high() < result.search->greedy.low());
}

// Symmetric lattice points, whose caps tie: some of the changes are known by bounds, others
// exactly. They are told in one unit, whatever that of the points is.
TEST_CASE("search: the best move is the same in both engines, for points of every scale") {
  const std::vector<Point> orbits{{-4, -1, 0}, {-4, -1, 1},  {-4, 0, 1},  {-3, -2, 1}, {-3, -1, -2},
                                  {-3, -1, 2}, {-2, -3, -2}, {-2, -1, 3}, {-1, -4, 1}, {-1, -3, 2},
                                  {-1, -2, 3}, {0, -3, -3},  {0, -1, 4}};
  for (const double scale : {1.0, 0x1p6, 0x1p-6, 0x1p300, 0x1p-300}) {
    CAPTURE(scale);
    std::vector<Point> points;
    for (const Point& p : orbits) {
      for (const Point& signs :
           {Point(1, 1, 1), Point(-1, 1, 1), Point(1, -1, 1), Point(-1, -1, 1)}) {
        points.push_back(scale * p.cwiseProduct(signs));
      }
    }
    SimplifyRequest request = request_for(9, SearchKind::Local, 25);
    request.trace = true;
    for (const Engine engine : {Engine::Filtered, Engine::Exact}) {
      request.engine = engine;
      const SimplifyResult traced = simplified(points, request);
      const auto& best = *traced.search->best;
      // By the definition: no other move makes the volume fall by more.
      Enclosure before = traced.search->greedy;
      for (const Move& move : traced.run->moves) {
        const Enclosure after = move.measure->enclose(100);
        CHECK((before - after).low() <= (best.before - best.after).high());
        before = after;
      }
    }
    request.trace = false;
    request.engine = Engine::Filtered;
    const SimplifyResult lean = simplified(points, request);
    request.engine = Engine::Exact;
    CHECK(lean.search->best->move == simplified(points, request).search->best->move);
  }
}

TEST_CASE("search: with all facets kept, or none to take their place, nothing is exchanged") {
  SimplifyRequest request = request_for(100, SearchKind::Local, 20);
  const SimplifyResult all = simplified(shapes::cube(), request);
  CHECK(all.steps == 0);
  CHECK(all.search->moves.empty());
  CHECK_FALSE(all.search->best.has_value());
  request.faces = 4;
  CHECK(simplified(shapes::tetrahedron(), request).search->tried == 0);
}

TEST_CASE("search: the same seed gives the same moves, and no kicks are a walk" * sweep) {
  const Greedy greedy(shapes::in_ball(80, 2), 7, CostMeasure::Volume);
  const SearchOptions local{.request = {SearchKind::Local, 50}, .seed = 3};
  CHECK(same_moves(greedy.search(local), greedy.search(local)));
  CHECK(same_moves(greedy.search({.request = {SearchKind::Local, 0}}), greedy.search({})));
  CHECK(greedy.search({.request = {SearchKind::None}}).tried == 0);
}

TEST_CASE("search: the order of points, points inside, motions and scales change nothing") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    const std::vector<Point> points = shapes::lattice(40, 9, seed);
    const SimplifyRequest request = request_for(6, SearchKind::Local, 30);
    const std::set<Halfspace> expected = planes_of(simplified(points, request));
    CHECK(planes_of(simplified(motion::with_irrelevant(points, seed), request)) == expected);
    // These keep the directions of normals, and so the canonical order.
    for (const auto& moved : {motion::Motion::translation_and_scale({5, -7, 11}, 3),
                              motion::Motion::translation_and_scale({0, 0, 0}, -40)}) {
      std::set<Halfspace> carried;
      for (const Halfspace& plane : expected) carried.insert(moved(plane));
      CHECK(planes_of(simplified(moved(points), request)) == carried);
    }
  }
}

// Without a center the filtered engine reads its dual off the hull of the points; with one it makes
// it of exact planes, as the exact engine does.
TEST_CASE("search: the same moves with and without an exact dual of the input" * sweep) {
  const std::vector<std::vector<Point>> inputs{
      shapes::in_ball(60, 3), shapes::on_sphere(50, 2), shapes::lattice(60, 7, 4),
      shapes::antiprism(11),  shapes::icosahedron(),    shapes::cube_symmetric(3, 9, 2)};
  std::size_t moves = 0;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    for (const CostMeasure measure : kMeasures) {
      CAPTURE(k);
      CAPTURE(static_cast<int>(measure));
      SimplifyRequest request = request_for(6, SearchKind::Local, 8);
      request.cost = measure;
      request.verify = VerifyLevel::Local;
      const SimplifyResult lean = simplified(inputs[k], request);
      request.center = interior_of(inputs[k]);
      const SimplifyResult planned = simplified(inputs[k], request);
      request.engine = Engine::Exact;
      const SimplifyResult exact = simplified(inputs[k], request);
      for (const SimplifyResult* other : {&planned, &exact}) {
        CHECK(lean.solid.exact.planes == other->solid.exact.planes);
        CHECK(lean.search->tried == other->search->tried);
        REQUIRE(lean.search->best.has_value() == other->search->best.has_value());
        if (lean.search->best) CHECK(lean.search->best->move == other->search->best->move);
        REQUIRE(lean.search->moves.size() == other->search->moves.size());
        for (std::size_t m = 0; m < lean.search->moves.size(); ++m) {
          CHECK(lean.search->moves[m].removed == other->search->moves[m].removed);
          CHECK(lean.search->moves[m].inserted == other->search->moves[m].inserted);
        }
      }
      moves += lean.search->moves.size();
    }
  }
  CHECK(moves > 20);
}

TEST_CASE("search: what is kept on request is never exchanged") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const Greedy greedy(shapes::in_ball(20, seed), 8, CostMeasure::Volume);
    const std::vector<HalfspaceId> keep(greedy.left.begin(), greedy.left.begin() + 5);
    const SearchRun found = greedy.search(
        {.request = {SearchKind::Local, 40}, .keep = keep, .cost = CostMeasure::Volume});
    for (const Move& move : found.moves) {
      for (const HalfspaceId i : move.removed) {
        CHECK(std::find(keep.begin(), keep.end(), i) == keep.end());
      }
    }
    // With all of them kept there is nothing to exchange.
    const SearchRun none = greedy.search({.request = {SearchKind::Local, 40}, .keep = greedy.left});
    CHECK(none.tried == 0);
  }
}

TEST_CASE("search: requests that make no sense") {
  const SimplifyRequest walk = request_for(4, SearchKind::Walk);
  const auto is_refused = [](const SimplifyRequest& request, const std::string& why) {
    const Error error = error_of([&] { return simplified(shapes::cube(), request); });
    CHECK(error.code() == ErrorCode::InvalidArgument);
    CHECK(std::string(error.what()).find(why) != std::string::npos);
  };
  SimplifyRequest request = walk;
  request.engine = Engine::Float;
  is_refused(request, "engine");
  request = walk;
  request.faces.reset();
  request.max_growth = Rational(1);
  is_refused(request, "number of faces");
  request = walk;
  request.record = true;
  is_refused(request, "proof");
  SceneRequest scene;
  scene.each.search = {SearchKind::Walk};
  scene.total_faces = 8;
  const std::vector<Shape> parts(2, Shape(PointSet(shapes::cube())));
  CHECK(error_of([&] { return simplify_scene(parts, scene); }).code() ==
        ErrorCode::InvalidArgument);
  const Greedy greedy(shapes::cube(), 6, CostMeasure::Volume);
  CHECK(error_of([&] { return greedy.search({.engine = Engine::Float}); }).code() ==
        ErrorCode::InvalidArgument);
}
