// SPDX-License-Identifier: MIT
// Judging a run: how many planes a rounded mesh has, which ends count as which failure, and that a
// solid from which no facet can be removed is no failure. Expected counts are closed forms.
#include <doctest/doctest.h>

#include <cmath>
#include <csignal>
#include <map>
#include <set>
#include <string>

#include "conform/conformance_judge.hpp"
#include "convexact/conform.hpp"
#include "shapes/makers.hpp"
using namespace convexact;

namespace {

Mesh points_as_mesh(const std::vector<Point>& points) {
  Mesh mesh;
  mesh.points = PointSet(points);
  return mesh;
}

TestVector simplify_vector(const std::vector<Point>& points, std::size_t faces) {
  TestVector vector;
  vector.input = PointSet(points);
  vector.question = SimplifyQuestion{faces, faces, true, std::nullopt, {}, {}};
  return vector;
}

ProgramRun ended(ProgramEnd end, int exit_code, int signal) {
  ProgramRun run;
  run.end = end;
  run.exit_code = exit_code;
  run.signal = signal;
  return run;
}

Outcome judged(const TestVector& vector, const ProgramRun& run,
               const std::optional<Candidate>& output = {}) {
  ProgramLimits limits;
  limits.memory = 1000;
  return judge_run(vector, {}, run, limits, output).outcome();
}

const ProgramRun kDone = ended(ProgramEnd::Exited, 0, 0);

Conformance judged_as(const Promise& promise, const TestVector& vector, const Candidate& output) {
  return judge_run(vector, promise, kDone, {}, output);
}

Promise asking(Asks asks) {
  Promise promise;
  promise.asks = asks;
  return promise;
}

std::vector<Outcome> outcomes_of(const Conformance& result) {
  std::vector<Outcome> outcomes;
  for (const Failure& failure : result.failures) outcomes.push_back(failure.outcome);
  return outcomes;
}

// The box [-a, a] x [-b, b] x [-c, c] as a closed mesh of six faces, the points numbered by the
// bits of their index.
Mesh box_mesh(double a, double b, double c) {
  Mesh mesh;
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1 ? a : -a, i & 2 ? b : -b, i & 4 ? c : -c);
  mesh.points = PointSet(points);
  mesh.polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

void move_point(Mesh& mesh, std::size_t index, const Point& to) {
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  points[index] = to;
  mesh.points = PointSet(points);
}

HalfspaceList rows(std::initializer_list<std::array<int, 4>> list) {
  HalfspaceList halfspaces;
  for (const auto& [a, b, c, d] : list) {
    halfspaces.add({Rational(a), Rational(b), Rational(c)}, Rational(d));
  }
  return halfspaces;
}

}  // namespace

TEST_CASE("judge_run: ways to end") {
  const TestVector solid = simplify_vector(shapes::cube(), 6);
  TestVector flat;
  flat.question = RefuseQuestion{ErrorCode::NoInterior, 2, {}};
  CHECK(judged(solid, ended(ProgramEnd::NotStarted, 0, 0)) == Outcome::NotStarted);
  CHECK(judged(solid, ended(ProgramEnd::TimedOut, 0, 0)) == Outcome::TimedOut);
  CHECK(judged(solid, ended(ProgramEnd::Crashed, 0, SIGSEGV)) == Outcome::Crashed);
  CHECK(judged(solid, ended(ProgramEnd::Crashed, 0, SIGKILL)) == Outcome::OutOfMemory);
  CHECK(judged(solid, ended(ProgramEnd::Exited, 3, 0)) == Outcome::WrongExit);
  CHECK(judged(solid, kDone) == Outcome::MissingOutput);
  CHECK(judged(flat, ended(ProgramEnd::Exited, 3, 0)) == Outcome::Passed);
  CHECK(judged(flat, ended(ProgramEnd::Crashed, 0, SIGABRT)) == Outcome::Crashed);
  CHECK(judged(flat, kDone) == Outcome::AcceptedUnusable);
  ProgramRun greedy = ended(ProgramEnd::Exited, 1, 0);
  greedy.peak_memory = 800;
  CHECK(judged(solid, greedy) == Outcome::OutOfMemory);
  greedy.peak_memory = 100;
  CHECK(judged(solid, greedy) == Outcome::WrongExit);
  greedy.printed = "what():  std::bad_alloc";
  CHECK(judged(solid, greedy) == Outcome::OutOfMemory);
}

TEST_CASE("judge_run: an output with a vertex beyond the largest double is judged like any other") {
  // A tetrahedron with the apex (0, 0, 10^400), and a fifth plane that cuts off one of its corners.
  const Rational slope = parse_rational("1e-400"), half(1, 2), quarter(1, 4);
  HalfspaceList planes;
  planes.add({0, 0, -1}, -1);
  planes.add({half, 0, slope}, -1);
  planes.add({Rational(-quarter), half, slope}, -1);
  planes.add({Rational(-quarter), Rational(-half), slope}, -1);
  const TestVector octahedron = simplify_vector(shapes::octahedron(), 4);
  CHECK(outcomes_of(judged_as({}, octahedron, planes)) == std::vector{Outcome::TooLoose});
  planes.add({1, 0, 0}, Rational(-5, 4));
  CHECK(outcomes_of(judged_as({}, octahedron, planes)) ==
        std::vector{Outcome::TooLoose, Outcome::TooManyFacets});
}

TEST_CASE("judge_run: too many facets, unless none of them can go") {
  const TestVector octahedron = simplify_vector(shapes::octahedron(), 4);
  CHECK(judged(octahedron, kDone, points_as_mesh(shapes::octahedron())) == Outcome::TooManyFacets);
  // Every second of its pairs of opposite facets gone: a parallelepiped.
  CHECK(judged(octahedron, kDone,
               rows({{1, 1, 1, -1},
                     {-1, -1, -1, -1},
                     {1, 1, -1, -1},
                     {-1, -1, 1, -1},
                     {1, -1, 1, -1},
                     {-1, 1, -1, -1}})) == Outcome::Passed);
  // A facet of this one can go, and then it is a tetrahedron.
  CHECK(
      judged(
          octahedron, kDone,
          rows(
              {{1, 1, 1, -1}, {1, -1, -1, -1}, {-1, 1, -1, -1}, {-1, -1, 1, -1}, {1, 1, 0, -1}})) ==
      Outcome::TooManyFacets);
  CHECK(judged(octahedron, kDone,
               rows({{1, 1, 1, -1}, {1, -1, -1, -1}, {-1, 1, -1, -1}, {-1, -1, 1, -1}})) ==
        Outcome::Passed);
  // No side of the bounding box can go, but removals leave no planes that the input has not.
  CHECK(judged(octahedron, kDone, box_mesh(1, 1, 1)) == Outcome::TooManyFacets);
  CHECK(judged(simplify_vector(shapes::cube(), 4), kDone, box_mesh(1, 1, 1)) == Outcome::Passed);
  CHECK(judged(octahedron, kDone, rows({{1, 1, 1, -1}})) == Outcome::NoSolid);
  CHECK(judged(octahedron, kDone,
               rows({{4, 4, 4, -3}, {1, -1, -1, -1}, {-1, 1, -1, -1}, {-1, -1, 1, -1}})) ==
        Outcome::NotEnclosing);
}

TEST_CASE("judge_run: tightness is that of the exact greedy result, where the vector knows it") {
  // The cube [-1, 1]^3 (8), by greed enclosed in 10, and by the output in [-2, 2]^3 (64).
  TestVector cube = simplify_vector(shapes::cube(), 6);
  const Candidate output = rows({{1, 0, 0, -2},
                                 {-1, 0, 0, -2},
                                 {0, 1, 0, -2},
                                 {0, -1, 0, -2},
                                 {0, 0, 1, -2},
                                 {0, 0, -1, -2}});
  const auto tightness = [&] { return judged_as({}, cube, output).tightness; };
  CHECK_FALSE(tightness().has_value());
  std::get<SimplifyQuestion>(cube.question).volume = 10;
  CHECK(tightness() == Rational(32, 5));
  CHECK(judged_as(asking(Asks::Enclosure), cube, output).tightness == 8);  // against the hull
}

TEST_CASE("judge_run: all claims of verify count, the faces too (#13)") {
  // The corners of the cube, and a small tetrahedron inside as faces.
  Mesh output = points_as_mesh(shapes::cube());
  std::vector<Point> points(output.points.doubles().begin(), output.points.doubles().end());
  for (const Point& p : {Point(0, 0, 0), Point(0.5, 0, 0), Point(0, 0.5, 0), Point(0, 0, 0.5)}) {
    points.push_back(p);
  }
  output.points = PointSet(points);
  output.polygons = {{8, 10, 9}, {8, 9, 11}, {9, 10, 11}, {10, 8, 11}};
  const TestVector cube = simplify_vector(shapes::cube(), 6);
  CHECK(outcomes_of(judged_as({}, cube, output)) == std::vector{Outcome::NotConvex});
  CHECK(judged_as({}, cube, points_as_mesh(shapes::cube())).failures.empty());
}

TEST_CASE("judge_run: faces bent by the rounding of their corners pass, gross ones fail (#13)") {
  const TestVector cube = simplify_vector(shapes::cube(), 9);
  // 16 units in the last place of 1 are 2^-48; a corner that is off by two of them bends faces.
  Mesh rounded = box_mesh(1, 1, 1);
  move_point(rounded, 7, Point(1, 1, 1 + 0x1p-51));
  const Conformance passed = judged_as({}, cube, rounded);
  CHECK(outcomes_of(passed) == std::vector<Outcome>{});
  CHECK_FALSE(passed.notes.empty());
  Mesh gross = box_mesh(1, 1, 1);
  move_point(gross, 7, Point(1, 1, 1 + 0x1p-30));
  const Conformance failed = judged_as({}, cube, gross);
  REQUIRE_FALSE(failed.failures.empty());
  CHECK(failed.outcome() == Outcome::NotConvex);
  Promise tolerant;
  tolerant.tolerance.value = Rational(1, 1 << 29);
  CHECK(outcomes_of(judged_as(tolerant, cube, gross)) == std::vector<Outcome>{});
}

TEST_CASE("judge_run: a covered hull is not one whose faces nearly cover it twice (#13)") {
  // Two copies of the surface of one box, with corners of their own that differ by a rounding.
  Mesh twice = box_mesh(1, 1, 1);
  std::vector<Point> points(twice.points.doubles().begin(), twice.points.doubles().end());
  for (std::size_t i = 0; i < 8; ++i) points.push_back(points[i] * (1 - 0x1p-53));
  const auto faces = twice.polygons;
  for (auto face : faces) {
    for (std::uint32_t& corner : face) corner += 8;
    twice.polygons.push_back(face);
  }
  twice.points = PointSet(points);
  CHECK(judged_as({}, simplify_vector(shapes::cube(), 6), twice).outcome() == Outcome::NotConvex);
}

TEST_CASE("judge_run: an enclosure has a largest acceptable volume (#13)") {
  // The cube [-1, 1]^3 has volume 8: a box of 2 x 2 x 4 twice that, of one ulp more too much.
  const TestVector cube = simplify_vector(shapes::cube(), 6);
  CHECK(outcomes_of(judged_as({}, cube, box_mesh(1, 1, 2))) == std::vector<Outcome>{});
  const double more = std::nextafter(2.0, 3.0);
  CHECK(outcomes_of(judged_as({}, cube, box_mesh(1, 1, more))) == std::vector{Outcome::TooLoose});
  // Nine times for 4 and 5 faces, and where any number of faces is allowed.
  const TestVector octahedron = simplify_vector(shapes::octahedron(), 5);
  CHECK(outcomes_of(judged_as({}, octahedron, box_mesh(1, 1, 9))) ==
        std::vector{Outcome::TooManyFacets});
  CHECK(judged_as({}, octahedron, box_mesh(1, 1, 9.5)).outcome() == Outcome::TooLoose);
  CHECK(judged_as(asking(Asks::Enclosure), cube, box_mesh(1, 1, 9)).failures.empty());
  CHECK(judged_as(asking(Asks::Enclosure), cube, box_mesh(1, 1, 9.5)).outcome() ==
        Outcome::TooLoose);
  // Twice the exact greedy result, where that is larger.
  TestVector greedy = cube;
  std::get<SimplifyQuestion>(greedy.question).volume = 20;
  CHECK(judged_as({}, greedy, box_mesh(1, 1, 5)).failures.empty());
  CHECK(judged_as({}, greedy, box_mesh(1, 1, 5.25)).outcome() == Outcome::TooLoose);
}

TEST_CASE("judge_run: every way to fail is said, the gravest first, roundings last (#13)") {
  // Leaks by an ulp, and is far too large.
  const TestVector cube = simplify_vector(shapes::cube(), 6);
  Mesh output = box_mesh(1, 1, 1e30);
  move_point(output, 7, Point(std::nextafter(1.0, 0.0), 1, 1e30));
  const Conformance result = judged_as({}, cube, output);
  REQUIRE(result.failures.size() >= 2);
  CHECK(result.outcome() == Outcome::TooLoose);
  CHECK_FALSE(result.failures.front().is_rounding);
  CHECK(result.failures.back().outcome == Outcome::NotEnclosing);
  CHECK(result.failures.back().is_rounding);
}

TEST_CASE("judge_run: a leak is told apart from a rounding, and counted by decades (#13)") {
  const TestVector cube = simplify_vector(shapes::cube(), 6);
  const auto leak_of = [&](double height) {
    const Conformance result = judged_as({}, cube, box_mesh(1, 1, height));
    REQUIRE(result.outcome() == Outcome::NotEnclosing);
    return result;
  };
  CHECK(leak_of(1 - 0x1p-52).failures.front().is_rounding);
  CHECK_FALSE(leak_of(1 - 0x1p-40).failures.front().is_rounding);
  // Off by 0.01 sqrt(12), the diameter, and by a little less and more.
  const double diameter = std::sqrt(12.0);
  using Decades = std::map<int, std::size_t>;
  CHECK(leak_of(1 - 0.0099 * diameter).outside_by_decade == Decades{{-2, 8}});
  CHECK(leak_of(1 - 0.0101 * diameter).outside_by_decade == Decades{{-1, 8}});
  const Conformance half = leak_of(0.5);
  CHECK(half.relative_squared_hausdorff == Rational(1, 48));
  CHECK(half.outside->points == 8);
}

TEST_CASE("judge_run: a promise of binary32 is granted roundings of binary32 (#13)") {
  const TestVector cube = simplify_vector(shapes::cube(), 6);
  Promise promise;
  promise.numbers = Precision::Binary32;
  // Not a number of binary32, so that nothing in the output itself tells.
  const Candidate leak = box_mesh(1, 1, 1 - 0x1p-24 - 0x1p-50);
  CHECK(judged_as(promise, cube, leak).failures.front().is_rounding);
  CHECK_FALSE(judged_as({}, cube, leak).failures.front().is_rounding);
}

TEST_CASE("judge_run: a hull by promise has corners of the input only (#13)") {
  TestVector cube;
  cube.input = PointSet(shapes::cube());
  cube.question = HullQuestion{6, 8, 8};
  Promise hull = asking(Asks::Hull);
  CHECK(judged_as(hull, cube, box_mesh(1, 1, 1)).failures.empty());
  CHECK(outcomes_of(judged_as(hull, cube, box_mesh(1, 1, 1.5))) ==
        std::vector{Outcome::NotTheHull});
  CHECK(judged_as(asking(Asks::Enclosure), cube, box_mesh(1, 1, 1.5)).failures.empty());
  hull.tolerance.value = Rational(1, 2);
  CHECK(judged_as(hull, cube, box_mesh(1, 1, 1.5)).failures.empty());
  hull.max_vertices = 7;
  CHECK(outcomes_of(judged_as(hull, cube, box_mesh(1, 1, 1))) ==
        std::vector{Outcome::TooManyVertices});
  CHECK(std::get<NotRun>(as_put(cube, hull)) == NotRun::BeyondTheProgram);
}

TEST_CASE("judge_run: an inner solid by promise lies in the input's hull, exactly (#13)") {
  const TestVector cube = simplify_vector(shapes::cube(), 6);
  const Promise inner = asking(Asks::Inner);
  CHECK(judged_as(inner, cube, box_mesh(1, 0.5, 1)).failures.empty());
  CHECK(judged_as(inner, cube, box_mesh(1, 1, 1)).failures.empty());
  CHECK(outcomes_of(judged_as(inner, cube, box_mesh(0.5, 0.5, std::nextafter(1.0, 2.0)))) ==
        std::vector{Outcome::NotInside});
}

TEST_CASE("judge_run: flat inputs may be accepted by promise, other unusable ones not (#13)") {
  TestVector flat;
  flat.question = RefuseQuestion{ErrorCode::NoInterior, 2, {}};
  Promise promise;
  promise.allow_flat = true;
  CHECK(judge_run(flat, promise, kDone, {}, {}).failures.empty());
  flat.question = RefuseQuestion{ErrorCode::NoInterior, -1, {}};  // no points at all
  CHECK(judge_run(flat, promise, kDone, {}, {}).outcome() == Outcome::AcceptedUnusable);
  flat.question = RefuseQuestion{ErrorCode::Malformed, {}, {}};
  CHECK(judge_run(flat, promise, kDone, {}, {}).outcome() == Outcome::AcceptedUnusable);
}

TEST_CASE("judge_run: malformed faces are passed by an output that is right for the points (#13)") {
  TestVector vector;
  vector.question = RefuseQuestion{ErrorCode::Malformed, {}, PointSet(shapes::cube())};
  CHECK(judged(vector, kDone, box_mesh(1, 1, 1)) == Outcome::Passed);
  CHECK(judged(vector, kDone, box_mesh(1, 1, 0.5)) == Outcome::AcceptedUnusable);
  CHECK(judged(vector, kDone) == Outcome::AcceptedUnusable);
  CHECK(judged(vector, ended(ProgramEnd::Exited, 3, 0)) == Outcome::Passed);
}

TEST_CASE("as_put: binary32 rounds the input, and drops what is not there any more (#13)") {
  Promise promise = asking(Asks::Hull);
  promise.numbers = Precision::Binary32;
  const auto put = [&](std::vector<Point> points) {
    TestVector vector;
    vector.input = PointSet(std::move(points));
    vector.question = HullQuestion{4, 4, 1};
    return as_put(vector, promise);
  };
  const std::vector<Point> corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK(std::get<PointSet>(std::get<TestVector>(put(corner)).input).doubles()[3].z() == 1);
  std::vector<Point> changed = corner;
  changed[3].z() = 0.1;
  const TestVector rounded = std::get<TestVector>(put(changed));
  CHECK(std::get<PointSet>(rounded.input).doubles()[3].z() == 0.1f);
  changed[3].z() = 1e300;
  CHECK(std::get<NotRun>(put(changed)) == NotRun::OtherNumbers);
  changed[3].z() = 1e-300;  // flat in binary32
  CHECK(std::get<NotRun>(put(changed)) == NotRun::OtherNumbers);
  promise.asks = Asks::Simplify;
  CHECK(std::get<NotRun>(put(corner)) == NotRun::AsksOtherwise);
}

TEST_CASE("is_explained: moves of coordinates against determinants, by hand (#13)") {
  // A right triangle with legs of 1 and a point h above its plane: D = h. With slack s everywhere,
  // w = 2s: the bound is perm(|D| + w) - perm(|D|) = (1 + 2s)^2 (h + 2s) - h + smaller products.
  const std::vector<RationalPoint> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Rational s(1, 1000);
  CHECK(oracle::is_explained(corners, s, {0, 0, Rational(2, 1000)}, s));
  CHECK_FALSE(oracle::is_explained(corners, s, {0, 0, Rational(1, 100)}, s));
  CHECK(oracle::is_explained(corners, 0, {0, 0, 0}, 0));
  CHECK_FALSE(oracle::is_explained(corners, 0, {0, 0, Rational(1, 1000000)}, 0));
  // Of a sliver the plane means little.
  const std::vector<RationalPoint> sliver = {{0, 0, 0}, {1, 0, 0}, {0, Rational(1, 10000), 0}};
  CHECK(oracle::is_explained(sliver, s, {0, 0, 1}, s));
}

TEST_CASE("outcomes have names of their own") {
  std::set<std::string> names;
  for (const Outcome outcome : kAllOutcomes) names.insert(name_of(outcome));
  CHECK(names.size() == kAllOutcomes.size());
  CHECK(names.contains("not-enclosing"));
}
