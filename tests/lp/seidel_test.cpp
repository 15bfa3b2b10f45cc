// SPDX-License-Identifier: MIT
// Linear programs: by hand, against Fourier-Motzkin elimination (the definition), and by the
// certificates that come with each outcome.
#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "fourier_motzkin.hpp"
#include "linear_programs.hpp"
#include "lp_certificates.hpp"
#include "property.hpp"
#include "sweep.hpp"

using namespace convexact;
using data::linear_program;
using oracle::LpKind;

namespace {

// The outcome, checked, for a few orders of the rows.
LpOutcome solve(const LinearProgram& lp) {
  LpOutcome outcome = maximise(lp);
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const LpOutcome other = maximise(lp, {.seed = seed});
    CHECK(other.index() == outcome.index());
    CHECK(check(lp, other));
  }
  return outcome;
}

RationalVector vector(std::initializer_list<Rational> entries) {
  RationalVector x(static_cast<Eigen::Index>(entries.size()));
  Eigen::Index k = 0;
  for (const Rational& entry : entries) x[k++] = entry;
  return x;
}

}  // namespace

TEST_CASE("maximise: no rows") {
  CHECK(std::get<Optimal>(solve(linear_program({0, 0}, {}))).tight.empty());
  const auto unbounded = std::get<Unbounded>(solve(linear_program({0, -3}, {})));
  CHECK(unbounded.ray[1] < 0);
}

TEST_CASE("maximise: no coordinates") {
  CHECK(std::holds_alternative<Optimal>(solve(linear_program({}, {{-1}, {0}}))));
  CHECK(std::holds_alternative<Infeasible>(solve(linear_program({}, {{-1}, {1}}))));
}

TEST_CASE("maximise: a segment and a half-line") {
  // 1 <= x <= 5/2
  const auto best = std::get<Optimal>(solve(linear_program({2}, {{-1, 1}, {2, -5}, {0, -1}})));
  CHECK(best.x == vector({Rational(5, 2)}));
  REQUIRE(best.tight.size() == 1);
  CHECK(best.tight[0].row == 1);
  CHECK(best.tight[0].value == 1);
  const auto unbounded = std::get<Unbounded>(solve(linear_program({1}, {{-1, 1}})));
  CHECK(unbounded.ray == vector({1}));
}

TEST_CASE("maximise: rows of zeros") {
  CHECK(std::holds_alternative<Unbounded>(solve(linear_program({1, 0}, {{0, 0, 0}, {0, 0, -7}}))));
  const auto infeasible =
      std::get<Infeasible>(solve(linear_program({1, 0}, {{1, 0, 0}, {0, 0, 2}})));
  REQUIRE(infeasible.farkas.size() == 1);
  CHECK(infeasible.farkas[0].row == 1);
}

TEST_CASE("maximise: a corner of a triangle") {
  // x, y >= 0, x + 2y <= 4; maximise x + y.
  const LinearProgram lp = linear_program({1, 1}, {{-1, 0, 0}, {0, -1, 0}, {1, 2, -4}});
  const auto best = std::get<Optimal>(solve(lp));
  CHECK(best.x == vector({4, 0}));
}

TEST_CASE("maximise: a whole edge is optimal; the lexicographic maximum is taken") {
  // The square [0, 1]^2 with objective y: any (x, 1).
  const LinearProgram lp =
      linear_program({0, 1}, {{-1, 0, 0}, {1, 0, -1}, {0, -1, 0}, {0, 1, -1}, {0, 2, -2}});
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CHECK(std::get<Optimal>(maximise(lp, {.seed = seed})).x == vector({1, 1}));
  }
}

TEST_CASE("maximise: the optimal face is unbounded, the optimum is not") {
  const auto best = std::get<Optimal>(solve(linear_program({0, 1}, {{0, 1, -3}, {-1, 1, 5}})));
  CHECK(best.x[1] == 3);
  const auto line = std::get<Optimal>(solve(linear_program({1, -1}, {{1, -1, -2}})));
  CHECK(line.x[0] - line.x[1] == 2);
}

TEST_CASE("maximise: parallel, opposite and repeated rows") {
  // x + y <= 1 thrice, x + y >= 1: the set is a line.
  const LinearProgram on_line =
      linear_program({2, 2}, {{1, 1, -1}, {2, 2, -2}, {1, 1, -1}, {-3, -3, 3}});
  const auto best = std::get<Optimal>(solve(on_line));
  CHECK(best.x[0] + best.x[1] == 1);
  CHECK(
      std::holds_alternative<Unbounded>(solve(linear_program({1, -1}, {{1, 1, -1}, {-1, -1, 1}}))));
  const auto empty = std::get<Infeasible>(solve(linear_program({0, 0}, {{1, 1, 0}, {-2, -2, 1}})));
  CHECK(empty.farkas.size() == 2);
}

TEST_CASE("maximise: many planes through the optimum") {
  // n.(x - p) <= 0 for all n in {0, 1, 2}^3: the optimum of (1, 1, 1) is p.
  const RationalVector p = vector({Rational(1, 3), Rational(-5, 7), 2});
  LinearProgram lp;
  lp.normals.resize(27, 3);
  lp.offsets.resize(27);
  lp.objective = vector({1, 1, 1});
  for (int i = 0; i < 27; ++i) {
    const RationalVector n = vector({i % 3, i / 3 % 3, i / 9});
    lp.normals.row(i) = n.transpose();
    lp.offsets[i] = -(n[0] * p[0] + n[1] * p[1] + n[2] * p[2]);
  }
  CHECK(std::get<Optimal>(solve(lp)).x == p);
}

TEST_CASE("maximise: the kind and the value are those of Fourier-Motzkin elimination") {
  struct Family {
    Eigen::Index size, rows;
    int reach, count;
  };
  std::size_t seen[3] = {};
  Random random(7);
  for (const Family& family :
       {Family{1, 5, 2, 500}, Family{2, 6, 1, 500}, Family{2, 9, 3, 500}, Family{3, 6, 1, 500},
        Family{3, 8, 3, 300}, Family{4, 6, 1, 200}, Family{4, 7, 2, 100}}) {
    for (int repeat = 0; repeat < family.count; ++repeat) {
      const LinearProgram lp =
          data::random_linear_program(random, family.size, family.rows, family.reach);
      const oracle::Supremum expected = oracle::supremum(lp);
      const LpOutcome outcome = maximise(lp, {.seed = random()});
      REQUIRE(check(lp, outcome));
      REQUIRE(outcome.index() == static_cast<std::size_t>(expected.kind));
      ++seen[outcome.index()];
      if (const auto* best = std::get_if<Optimal>(&outcome)) {
        REQUIRE(Rational(lp.objective.dot(best->x)) == expected.value);
      }
    }
  }
  for (const std::size_t count : seen) CHECK(count > 300);
}

TEST_CASE("maximise: many rows, dimensions 1 to 5, certified; every seed gives the same points" *
          sweep) {
  Random random(11);
  for (int repeat = 0; repeat < 4000; ++repeat) {
    const auto size = static_cast<Eigen::Index>(1 + uniform_below(random, 5));
    const auto rows = static_cast<Eigen::Index>(uniform_below(random, 30));
    LinearProgram lp = data::random_linear_program(random, size, rows, 1 + repeat % 4);
    // Two of three are made feasible at the origin, else infeasible ones prevail.
    if (repeat % 3 != 0) lp.offsets = -lp.offsets.cwiseAbs();
    CAPTURE(repeat);
    const LpOutcome one = maximise(lp, {.seed = 1}), two = maximise(lp, {.seed = 2});
    REQUIRE(check(lp, one));
    REQUIRE(check(lp, two));
    REQUIRE(one.index() == two.index());
    if (const auto* best = std::get_if<Optimal>(&one)) {
      REQUIRE(best->x == std::get<Optimal>(two).x);
    } else if (const auto* unbounded = std::get_if<Unbounded>(&one)) {
      REQUIRE(unbounded->start == std::get<Unbounded>(two).start);
      REQUIRE(unbounded->ray == std::get<Unbounded>(two).ray);
    }
  }
}

TEST_CASE("maximise: scaling rows and objective by positive rationals changes nothing") {
  check_property("same kind, same point", [](std::uint64_t seed) {
    Random random(seed);
    LinearProgram lp = data::random_linear_program(random, 3, 8, 2);
    const LpOutcome before = maximise(lp);
    for (Eigen::Index i = 0; i < lp.normals.rows(); ++i) {
      const Rational scale(1 + uniform_below(random, 9), 1 + uniform_below(random, 9));
      lp.normals.row(i) *= scale;
      lp.offsets[i] *= scale;
    }
    lp.objective *= Rational(3, 7);
    const LpOutcome after = maximise(lp);
    RC_ASSERT(check(lp, after));
    RC_ASSERT(before.index() == after.index());
    if (const auto* best = std::get_if<Optimal>(&before)) {
      RC_ASSERT(std::get<Optimal>(after).x == best->x);
    }
  });
}

TEST_CASE("maximise: shapes that do not fit are refused") {
  LinearProgram lp = linear_program({1, 0}, {{1, 0, -1}});
  lp.objective = vector({1, 0, 0});
  CHECK_THROWS_AS((void)maximise(lp), Error);
  lp.objective = vector({1, 0});
  lp.offsets = vector({1, 2});
  CHECK_THROWS_AS((void)maximise(lp), Error);
}
