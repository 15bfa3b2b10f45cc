// SPDX-License-Identifier: MIT
// Whether a triangle runs through what a part and a cell have in common, in the checker: closed
// forms about the unit cube.
#include "check/placed.hpp"

#include <doctest/doctest.h>

namespace {

check::PlacedPart unit_cube() {
  check::PlacedPart part;
  for (std::size_t k = 0; k < 3; ++k) {
    check::Row low{0, 0, 0, 0}, high{0, 0, 0, -1};
    low[k] = -1;
    high[k] = 1;
    part.planes.push_back(low);
    part.planes.push_back(high);
  }
  return part;
}

check::Cube cell(const check::Rational& center, const check::Rational& half) {
  return {{center, center, center}, half};
}

bool runs_through(const check::Vector& a, const check::Vector& b, const check::Vector& c,
                  const check::Cube& cube) {
  return unit_cube().may_run_through(check::PlacedTriangle({a, b, c}), cube);
}

}  // namespace

TEST_CASE("clear cells: a triangle that is cut at a part's planes") {
  using check::Rational;
  const check::Cube all = cell(Rational(1, 2), 2);
  const auto across = [&](const Rational& sum, const check::Cube& cube) {  // x + y + z = sum
    return runs_through({sum, 0, 0}, {0, sum, 0}, {0, 0, sum}, cube);
  };
  // It touches the corner (1, 1, 1), or cuts it off: no plane of the cube has it beyond.
  CHECK_FALSE(across(3, all));
  CHECK(across(Rational(2999, 1000), all));
  CHECK_FALSE(across(4, all));
  // Without a corner in the cube, through it and beside it.
  CHECK(runs_through({-5, 0, Rational(1, 2)}, {5, 0, Rational(1, 2)}, {0, 9, Rational(1, 2)}, all));
  CHECK_FALSE(runs_through({-5, 4, 0}, {5, -6, 0}, {0, -9, 5}, all));
  // Along an edge, and in a face.
  CHECK_FALSE(runs_through({0, 0, -1}, {0, 0, 2}, {-1, 1, 0}, all));
  CHECK_FALSE(runs_through({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, all));
  // Through the part, but beside the cell.
  CHECK_FALSE(across(1, cell(Rational(3, 4), Rational(1, 4))));
  CHECK(across(1, cell(Rational(1, 4), Rational(1, 4))));
  // Without an area: a segment, and a point, inside and outside.
  const check::Vector inside{Rational(1, 2), Rational(1, 2), Rational(1, 2)}, outside{2, 2, 2},
      far{3, 2, 2};
  CHECK(runs_through(inside, outside, outside, all));
  CHECK(runs_through(inside, inside, inside, all));
  CHECK_FALSE(runs_through(outside, outside, far, all));
}
