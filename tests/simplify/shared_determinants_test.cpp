// SPDX-License-Identifier: MIT
// Engines share determinants of planes; the verification of steps has its own. These cases expect
// nothing but that it accepts what engines do: a wrong sign in a shared determinant shows here, by
// the verification alone (tests/reliability/fault_list.py).
#include <doctest/doctest.h>

#include "fast/engines.hpp"
#include "shapes/makers.hpp"
#include "simplify/step_verification.hpp"
#include "simplify_points.hpp"

using namespace convexact;

namespace {

std::vector<DualHull> solids() {
  std::vector<DualHull> solids;
  for (const auto& points : {shapes::cut_cube(5, 0.25), shapes::icosahedron(),
                             shapes::lattice(24, 2, 2), shapes::in_ball(16, 1)}) {
    solids.push_back(dual_of_doubles(points));
  }
  return solids;
}

}  // namespace

TEST_CASE("shared determinants: the verification accepts every step of the exact engine") {
  for (const DualHull& solid : solids()) {
    CHECK_NOTHROW((void)simplify_exact(solid, center_of(solid), {.verify = VerifyLevel::Full}));
  }
}

TEST_CASE("shared determinants: the verification accepts every step of the filtered engine") {
  for (const DualHull& solid : solids()) {
    const auto run = simplify_filtered(solid, center_of(solid), {.verify = VerifyLevel::None});
    StepVerification verification(solid, VerifyLevel::Full);
    for (const Step& step : run.steps) CHECK_NOTHROW(verification.check(step));
    CHECK_NOTHROW(verification.finish());
  }
}
