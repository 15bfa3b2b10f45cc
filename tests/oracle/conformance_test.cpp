// SPDX-License-Identifier: MIT
// Judging a run: how many planes a rounded mesh has, which ends count as which failure, and that a
// solid of which nothing can go is no failure. Expected counts are closed forms.
#include "convexact/oracle/conformance.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <set>
#include <string>

#include "convexact/shapes/solids.hpp"
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
  return judge_run(vector, run, limits, output, {}).outcome;
}

const ProgramRun kDone = ended(ProgramEnd::Exited, 0, 0);

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
  flat.question = RefuseQuestion{ErrorCode::NoInterior, 2};
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
  CHECK(judged(octahedron, kDone, planes) == Outcome::Passed);
  planes.add({1, 0, 0}, Rational(-5, 4));
  CHECK(judged(octahedron, kDone, planes) == Outcome::TooManyFacets);
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
  const auto tightness = [&] { return judge_run(cube, kDone, {}, output, {}).tightness; };
  CHECK_FALSE(tightness().has_value());
  std::get<SimplifyQuestion>(cube.question).volume = 10;
  std::get<SimplifyQuestion>(cube.question).costs = {Rational(1, 2), Rational(3, 2)};
  CHECK(tightness() == 6.4);
}

TEST_CASE("outcomes have names of their own") {
  std::set<std::string> names;
  for (const Outcome outcome : kAllOutcomes) names.insert(name_of(outcome));
  CHECK(names.size() == kAllOutcomes.size());
  CHECK(names.contains("not-enclosing"));
}
