// SPDX-License-Identifier: MIT
// The checkers of linear programs reject certificates that prove nothing. All by hand.
#include <doctest/doctest.h>

#include "linear_programs.hpp"
#include "lp_certificates.hpp"

using namespace convexact;
using data::linear_program;

namespace {
RationalVector plane_vector(Rational x, Rational y) {
  RationalVector v(2);
  v << x, y;
  return v;
}
}  // namespace

TEST_CASE("check: an optimum, and what is close to one") {
  // The unit square; maximise x + 2y: (1, 1), with factors 1 and 2.
  const LinearProgram lp =
      linear_program({1, 2}, {{1, 0, -1}, {0, 1, -1}, {-1, 0, 0}, {0, -1, 0}, {1, 1, -2}});
  const Optimal good{plane_vector(1, 1), {{0, 1}, {1, 2}}};
  CHECK(check(lp, good));
  CHECK(check(lp, Optimal{plane_vector(1, 1), {{1, 1}, {4, 1}}}));  // another proof of it
  Optimal bad = good;
  bad.x = plane_vector(Rational(1, 2), 1);  // row 0 is not tight
  CHECK_FALSE(check(lp, bad));
  bad.x = plane_vector(1, 2);  // infeasible
  CHECK_FALSE(check(lp, bad));
  bad.x = RationalVector::Zero(3);
  CHECK_FALSE(check(lp, bad));
  CHECK_FALSE(check(lp, Optimal{plane_vector(1, 1), {{0, 1}, {1, 1}}}));
  CHECK_FALSE(check(lp, Optimal{plane_vector(1, 1), {{0, 1}}}));
  CHECK_FALSE(check(lp, Optimal{plane_vector(1, 1), {}}));
  CHECK_FALSE(check(lp, Optimal{plane_vector(1, 1), {{0, -1}, {4, 2}}}));  // sums up, but negative
  CHECK_FALSE(check(lp, Optimal{plane_vector(1, 1), {{0, 1}, {5, 2}}}));   // no such row
  // (0, 1) with multipliers that sum to c, yet row 0 is not tight there.
  CHECK_FALSE(check(lp, Optimal{plane_vector(0, 1), {{0, 1}, {1, 2}}}));
}

TEST_CASE("check: Farkas multipliers, and what is close to them") {
  // x <= 0, x >= 1, y <= 0
  const LinearProgram lp = linear_program({1, 0}, {{1, 0, 0}, {-1, 0, 1}, {0, 1, 0}});
  CHECK(check(lp, Infeasible{{{0, 1}, {1, 1}}}));
  CHECK(check(lp, Infeasible{{{1, Rational(1, 9)}, {0, Rational(1, 9)}}}));
  CHECK_FALSE(check(lp, Infeasible{{}}));
  CHECK_FALSE(check(lp, Infeasible{{{0, 1}, {1, 2}}}));
  CHECK_FALSE(check(lp, Infeasible{{{0, 1}, {1, 1}, {2, 1}}}));
  CHECK_FALSE(check(lp, Infeasible{{{0, -1}, {1, -1}}}));
  CHECK_FALSE(check(lp, Infeasible{{{0, 1}, {3, 1}}}));
  // x <= 0, x >= 0: y'N = 0 but y'd = 0 only.
  CHECK_FALSE(check(linear_program({1}, {{1, 0}, {-1, 0}}), Infeasible{{{0, 1}, {1, 1}}}));
}

TEST_CASE("check: a ray, and what is close to one") {
  // x >= 1, y >= 0, y <= x; maximise y
  const LinearProgram lp = linear_program({0, 1}, {{-1, 0, 1}, {0, -1, 0}, {-1, 1, 0}});
  CHECK(check(lp, Unbounded{plane_vector(1, 0), plane_vector(1, 1)}));
  CHECK(check(lp, Unbounded{plane_vector(2, 1), plane_vector(3, Rational(1, 5))}));
  CHECK_FALSE(check(lp, Unbounded{plane_vector(0, 0), plane_vector(1, 1)}));  // start outside
  CHECK_FALSE(check(lp, Unbounded{plane_vector(1, 0), plane_vector(1, 2)}));  // leaves y <= x
  CHECK_FALSE(check(lp, Unbounded{plane_vector(1, 0), plane_vector(1, 0)}));  // does not improve
  CHECK_FALSE(check(lp, Unbounded{plane_vector(1, 0), RationalVector::Zero(3)}));
  CHECK_FALSE(check(lp, Unbounded{RationalVector::Zero(1), plane_vector(1, 1)}));
}
