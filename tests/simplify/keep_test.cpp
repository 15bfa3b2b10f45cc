// SPDX-License-Identifier: MIT
// Kept facets: what selectors select, in closed form, and runs that must not remove some, against
// the definition and against the cut cube of docs/construction.md, whose costs are closed forms.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "convexact/dual.hpp"
#include "convexact/run.hpp"
#include "convexact/simplify.hpp"
#include "definitional_greedy.hpp"
#include "expect_error.hpp"
#include "fast/engines.hpp"
#include "integer_halfspace.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

constexpr CostMeasure kMeasures[] = {CostMeasure::Volume, CostMeasure::Area,
                                     CostMeasure::MeanWidth};

using Ids = std::vector<HalfspaceId>;

Ids ids(std::initializer_list<std::size_t> positions) {
  Ids list;
  for (const std::size_t i : positions) list.emplace_back(i);
  return list;
}

// In canonical order: -x, -y, -z, then z, y, x, and last x + y + z <= 5/2.
const std::vector<Halfspace> kCutCube = {
    halfspace(-1, 0, 0, 0), halfspace(0, -1, 0, 0), halfspace(0, 0, -1, 0), halfspace(0, 0, 1, -1),
    halfspace(0, 1, 0, -1), halfspace(1, 0, 0, -1), halfspace(2, 2, 2, -5)};

DualHull cut_cube() { return dual_of(kCutCube, RationalPoint::Constant(Rational(1, 2))).dual; }

template <class Facets>
Ids selected(const Facets& facets, const std::vector<Halfspace>& halfspaces = kCutCube,
             const PointSet& points = {}) {
  const std::vector<KeepSelector> selectors{{facets, "the selector"}};
  return select_facets(halfspaces, points, selectors);
}

template <class Facets>
std::string refusal(const Facets& facets, const PointSet& points = {}) {
  const Error error = error_of([&] { return selected(facets, kCutCube, points); });
  CHECK(error.code() == ErrorCode::InvalidArgument);
  CHECK(std::string(error.what()).starts_with("the selector: "));
  return error.what();
}

KeepNormal normal(int x, int y, int z, std::optional<double> degrees = {}) {
  return {RationalVector3(x, y, z), degrees};
}

// Some facets of n, any number from 1 to half of them.
Ids some_of(std::size_t n, std::uint64_t seed) {
  Ids all;
  for (std::size_t i = 0; i < n; ++i) all.emplace_back(i);
  Random random(seed);
  shuffle(std::span(all), random);
  all.resize(1 + uniform_below(random, n / 2));
  std::sort(all.begin(), all.end());
  return all;
}

bool removes_any(const Run& run, const Ids& kept) {
  return std::any_of(run.steps.begin(), run.steps.end(), [&](const Step& step) {
    const bool is_tied = std::any_of(step.tie.begin(), step.tie.end(), [&](HalfspaceId i) {
      return std::binary_search(kept.begin(), kept.end(), i);
    });
    return is_tied || std::binary_search(kept.begin(), kept.end(), step.removed);
  });
}

}  // namespace

TEST_CASE("keep: ids, each once and in order") {
  CHECK(selected(KeepIds{ids({5, 2, 5})}) == ids({2, 5}));
  CHECK(refusal(KeepIds{ids({7})}).find("ids below 7") != std::string::npos);
  CHECK(refusal(KeepIds{}).find("no facet") != std::string::npos);
}

TEST_CASE("keep: a plane up to a positive factor") {
  CHECK(selected(KeepPlane{{1, 1, 1}, Rational(-5, 2)}) == ids({6}));
  CHECK(selected(KeepPlane{{0, 0, Rational(1, 3)}, Rational(-1, 3)}) == ids({3}));
  refusal(KeepPlane{{-2, -2, -2}, 5});
  refusal(KeepPlane{{2, 2, 2}, -4});
  CHECK(refusal(KeepPlane{{0, 0, 0}, 1}).find("zero") != std::string::npos);
}

TEST_CASE("keep: normals, exactly at 0, 60, 90, 120 and 180 degrees") {
  CHECK(selected(normal(0, 0, 7, 0)) == ids({3}));
  CHECK(selected(normal(3, 3, 3, 0)) == ids({6}));
  refusal(normal(3, 3, 4, 0));
  CHECK(selected(normal(3, 3, 4, 8.05)) == ids({6}));  // acos(10/sqrt(102)) is 8.0495 degrees
  refusal(normal(3, 3, 4, 8.04));
  CHECK(selected(normal(0, 0, 1, 90)) == ids({0, 1, 3, 4, 5, 6}));
  CHECK(selected(normal(0, 0, 1, 89.99999999999999)) == ids({3, 6}));
  CHECK(selected(normal(0, 0, 1, 180)).size() == 7);
  // The rhombic dodecahedron's normals (1,1,0), ...: cosines 0, 1/2, 1 and their negatives.
  std::vector<Halfspace> rhombic;
  for (const int a : {-1, 1}) {
    for (const int b : {-1, 1}) {
      rhombic.insert(rhombic.end(),
                     {halfspace(a, b, 0, -1), halfspace(a, 0, b, -1), halfspace(0, a, b, -1)});
    }
  }
  std::sort(rhombic.begin(), rhombic.end());
  const auto count = [&](double degrees) {
    return selected(normal(1, 1, 0, degrees), rhombic).size();
  };
  // At just 45 degrees: the cosine is no double.
  CHECK(selected(normal(1, 1, 0, 45)) == ids({4, 5, 6}));
  CHECK(count(0) == 1);
  CHECK(count(59.99999) == 1);
  CHECK(count(60) == 5);
  CHECK(count(90) == 7);
  CHECK(count(119.99999) == 7);
  CHECK(count(120) == 11);
  CHECK(count(180) == 12);
}

TEST_CASE("keep: the nearest normals, all of an exact tie") {
  CHECK(selected(normal(1, 2, 3)) == ids({6}));
  CHECK(selected(normal(-1, -1, -1)) == ids({0, 1, 2}));
  CHECK(selected(normal(-1, -2, -2)) == ids({1, 2}));
  CHECK(refusal(normal(0, 0, 0)).find("zero") != std::string::npos);
}

TEST_CASE("keep: no angle but 0 to 180 degrees") {
  for (const double wrong :
       {-1e-300, -1.0, 180.00000000000003, 1e300, std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(refusal(normal(0, 0, 1, wrong)).find("0 to 180 degrees") != std::string::npos);
  }
}

TEST_CASE("keep: planes that hold all corners of a face") {
  const PointSet points(std::vector<Point>{
      {0, 0, 1}, {1, 0, 1}, {0, 0.5, 1}, {0.25, 0.25, 1}, {1, 1, 0.5}, {0, 0, 0}});
  CHECK(selected(KeepFaces{{{0, 1, 2}}}, kCutCube, points) == ids({3}));
  CHECK(selected(KeepFaces{{{0, 3, 2}, {5, 0, 1}}}, kCutCube, points) == ids({1, 3}));
  CHECK(selected(KeepFaces{{{4}}}, kCutCube, points) == ids({4, 5, 6}));  // a corner of the cut
  refusal(KeepFaces{{{0, 1, 4}, {}}}, points);
  refusal(KeepFaces{{{0, 1, 6}}}, points);
  refusal(KeepFaces{{{0, 1, 2}}});  // halfspaces have no points
  const PointSet rationals(std::vector<RationalPoint>{{0, Rational(1, 3), 1}, {0, 0, 0}});
  CHECK(selected(KeepFaces{{{0}}}, kCutCube, rationals) == ids({0, 3}));
}

// Every facet of a hull holds its corners, at any scale; the tip of a spike an ulp long lies on
// none of the others.
TEST_CASE("keep: faces of huge, tiny and nearly coplanar points") {
  for (const int exponent : {0, 970, -970, -1060, 1015}) {
    CAPTURE(exponent);
    std::vector<Point> points;
    for (const Point& p : shapes::lattice(20, 3, 5)) {
      points.push_back(p.unaryExpr([&](double x) { return std::ldexp(x, exponent); }));
    }
    const PointSet set(points);
    const Hull hull = std::get<Hull>(convex_hull(set));
    std::vector<Halfspace> halfspaces = facet_halfspaces(hull, set);
    for (std::size_t f = 0; f < halfspaces.size(); ++f) {
      std::vector<std::uint32_t> corners;
      for (const PointId p : hull.facets[f]) corners.push_back(p.value);
      CHECK(selected(KeepFaces{{corners}}, halfspaces, set) == ids({f}));
    }
    // By the definition: all facets whose planes hold a point.
    for (std::uint32_t p = 0; p < points.size(); ++p) {
      Ids expected;
      for (std::size_t f = 0; f < halfspaces.size(); ++f) {
        if (halfspaces[f](set[PointId(p)]) == 0) expected.emplace_back(f);
      }
      if (expected.empty()) continue;
      CHECK(selected(KeepFaces{{{p}}}, halfspaces, set) == expected);
    }
  }
  const double next = std::nextafter(1.0, 2.0);
  const PointSet spike(std::vector<Point>{{1, 0.25, 0.25}, {next, 0.25, 0.25}, {1, 0.5, 0.25}});
  CHECK(selected(KeepFaces{{{0, 2}}}, kCutCube, spike) == ids({5}));
  CHECK_THROWS(selected(KeepFaces{{{1}}}, kCutCube, spike));
}

TEST_CASE("keep: more than may be kept") {
  const std::vector<KeepSelector> selectors{{KeepIds{ids({0, 1, 2})}, "a"},
                                            {KeepIds{ids({2, 3, 4})}, "b"}};
  CHECK(select_facets(kCutCube, {}, selectors, 5).size() == 5);
  const Error error = error_of([&] { return select_facets(kCutCube, {}, selectors, 4); });
  CHECK(error.code() == ErrorCode::InvalidArgument);
  CHECK(std::string(error.what()).find("5 facets") != std::string::npos);
}

// Without x + y + z <= 5/2 a side leaves a cube open; with it, the side at 1 can go: the cut's
// plane closes a pyramid of legs 3/2 below (1, 1, 1), less the corner of legs 1/2 on each side.
TEST_CASE("keep: the cut of a cut cube kept, one side goes at 25/48") {
  const RationalPoint center = RationalPoint::Constant(Rational(1, 2));
  const SimplifyOptions options{.faces = 6, .keep = ids({6}), .verify = VerifyLevel::Full};
  const Run exact = simplify_exact(cut_cube(), center, options);
  const Run filtered = simplify_filtered(cut_cube(), center, options);
  for (const Run* run : {&exact, &filtered}) {
    REQUIRE(run->steps.size() == 1);
    CHECK(run->steps[0].removed == HalfspaceId(3));
    CHECK(run->steps[0].cost == Rational(25, 48));
    CHECK(run->steps[0].tie == ids({3, 4, 5}));
    CHECK(run->stop == StopReason::Reached);
    CHECK(run->kept == options.keep);
  }
  const DualHull solid = cut_cube();
  const FastResult doubles = simplify_float(FastDual::of(solid, center), options);
  REQUIRE(doubles.steps.size() == 1);
  CHECK(doubles.steps[0].removed == HalfspaceId(3));
  CHECK(doubles.bound->is_vouched());
}

TEST_CASE("keep: all that may go are kept") {
  const RationalPoint center = RationalPoint::Constant(Rational(1, 2));
  const SimplifyOptions options{.keep = ids({6, 3, 4, 5})};
  const DualHull solid = cut_cube();
  const FastDual fast = FastDual::of(solid, center);
  CHECK(simplify_exact(cut_cube(), center, options).stop == StopReason::AllKeptOrUnbounded);
  CHECK(simplify_filtered(fast, options).stop == StopReason::AllKeptOrUnbounded);
  const FastResult doubles = simplify_float(fast, options);
  CHECK(doubles.stop == StopReason::AllKeptOrUnbounded);
  CHECK(doubles.bound->is_end_proven);
  CHECK(doubles.survivors.size() == 7);
  Ids all = ids({0, 1, 2, 3, 4, 5, 6});
  CHECK(simplify_float(fast, {.keep = all}).stop == StopReason::AllKeptOrUnbounded);
  CHECK(simplify_filtered(fast, {.keep = all}).steps.empty());
}

TEST_CASE("keep: every step is the cheapest of those that are not kept" * sweep) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const DualHull solid = dual_of_doubles(
        seed % 3 == 0 ? shapes::cut_cube(8, 0.3)
                      : shapes::lattice(8 + static_cast<std::uint32_t>(seed), 1 + seed % 3, seed));
    const Ids keep = some_of(solid.halfspaces.size(), seed);
    for (const CostMeasure measure : kMeasures) {
      CAPTURE(seed);
      CAPTURE(static_cast<int>(measure));
      const SimplifyOptions options{
          .keep = keep, .cost = measure, .verify = VerifyLevel::Full, .keep_evaluations = true};
      const Run exact = simplify_exact(solid, center_of(solid), options);
      definition::check_against_definition(exact, measure);
      CHECK_FALSE(removes_any(exact, keep));
      const Run filtered = simplify_filtered(solid, center_of(solid), options);
      definition::check_against_definition(filtered, measure);
      CHECK(removed_in(filtered) == removed_in(exact));
      CHECK(filtered.stop == exact.stop);
      for (const Evaluation& each : filtered.evaluations) {
        CHECK_FALSE(std::binary_search(keep.begin(), keep.end(), each.halfspace));
      }
    }
  }
}

TEST_CASE("keep: the survivors of a free run, kept, survive the same run again" * sweep) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const DualHull solid = dual_of_doubles(shapes::on_sphere(60, seed));
    const RationalPoint center = center_of(solid);
    for (const CostMeasure measure : kMeasures) {
      const Run free = simplify_filtered(solid, center, {.faces = 12, .cost = measure});
      const SimplifyOptions again{.faces = 12, .keep = survivors(free), .cost = measure};
      CHECK(removed_in(simplify_filtered(solid, center, again)) == removed_in(free));
      CHECK(survivors(simplify_exact(solid, center, again)) == survivors(free));
      const FastResult doubles = simplify_float(FastDual::of(solid, center), again);
      CHECK(doubles.survivors == survivors(free));
      CHECK(doubles.bound->is_vouched());
      // And the first one removed, kept, makes it another run.
      const SimplifyOptions other{.faces = 12, .keep = {free.steps[0].removed}, .cost = measure};
      const Run changed = simplify_filtered(solid, center, other);
      CHECK(changed.steps[0].removed != free.steps[0].removed);
      CHECK_FALSE(removes_any(changed, other.keep));
      CHECK(changed.steps.size() == free.steps.size());
    }
  }
}

TEST_CASE("keep: simplify() selects, keeps and tells where") {
  const PointSet points(shapes::on_sphere(60, 3));
  SimplifyRequest request;
  request.faces = 8;
  request.keep = {{normal(0, 0, -1), "the floor"}, {normal(1, 0, 0), "the front"}};
  std::optional<std::vector<Halfspace>> planes;
  for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
    request.engine = engine;
    const auto result = std::get<SimplifyResult>(simplify(points, request));
    REQUIRE(result.kept.size() == 2);
    CHECK(result.kept[0].id < result.kept[1].id);
    for (const auto& kept : result.kept) {
      const IntegerVector3& n = result.solid.exact.planes[kept.plane].normal();
      CHECK((n[2] < 0 || n[0] > 0));
    }
    CHECK(result.solid.exact.planes.size() == 8);
    if (!planes) planes = result.solid.exact.planes;
    CHECK(*planes == result.solid.exact.planes);
  }
  request.faces = 4;
  request.keep = {{KeepIds{ids({0, 1, 2, 3, 4})}, "five"}};
  CHECK(error_of([&] { return simplify(points, request); }).code() == ErrorCode::InvalidArgument);
}
