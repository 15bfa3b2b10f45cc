// SPDX-License-Identifier: MIT
// Empty, flat, bounded: by hand, against Fourier-Motzkin elimination (the definition), and by the
// certificates; and that the checkers refuse what proves nothing.
#include <doctest/doctest.h>

#include "convexact/linear_program.hpp"
#include "fourier_motzkin.hpp"
#include "halfspaces.hpp"

using namespace convexact;
using data::halfspaces;
using oracle::LpKind;

namespace {

// The one expected outcome of find_interior(), checked.
template <class Claim>
Claim interior(const std::vector<Halfspace>& list) {
  for (const std::uint64_t seed : {2u, 3u, 4u}) {
    CHECK(std::holds_alternative<Claim>(find_interior(list, {.seed = seed})));
  }
  Claim claim = std::get<Claim>(find_interior(list));
  CHECK(check(list, claim));
  return claim;
}

template <class Claim>
Claim recession(const std::vector<Halfspace>& list) {
  for (const std::uint64_t seed : {2u, 3u, 4u}) {
    CHECK(std::holds_alternative<Claim>(find_recession(list, {.seed = seed})));
  }
  Claim claim = std::get<Claim>(find_recession(list));
  CHECK(check(list, claim));
  return claim;
}

// N x + weight t + d <= 0, weight in {0, 1}; maximise dot(objective, (x, t)).
LinearProgram as_program(const std::vector<Halfspace>& list, int weight, bool with_offsets) {
  LinearProgram lp;
  const auto count = static_cast<Eigen::Index>(list.size());
  lp.normals = RationalMatrix::Zero(count, 4);
  lp.offsets = RationalVector::Zero(count);
  lp.objective = RationalVector::Zero(4);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) lp.normals(i, k) = list[i].normal()[k];
    lp.normals(i, 3) = weight;
    if (with_offsets) lp.offsets[i] = list[i].offset();
  }
  return lp;
}

bool is_bounded_cone(const std::vector<Halfspace>& list) {
  LinearProgram lp = as_program(list, 0, false);
  for (int k = 0; k < 3; ++k) {
    for (const int direction : {1, -1}) {
      lp.objective = RationalVector::Zero(4);
      lp.objective[k] = direction;
      if (oracle::supremum(lp).kind == LpKind::Unbounded) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("find_interior: no halfspace, one, two") {
  CHECK(interior<InteriorPoint>({}).point.isZero(0));
  interior<InteriorPoint>(halfspaces({{1, 2, 3, 40}}));
  interior<InteriorPoint>(halfspaces({{0, 0, 1, -1}, {0, 0, -1, 0}}));  // slab
  interior<InteriorPoint>(halfspaces({{1, 1, 1, 7}, {1, 1, 1, -7}, {2, 2, 2, 14}}));
}

TEST_CASE("find_interior: solids") {
  CHECK(interior<InteriorPoint>(data::centered_box(1, 2, 3)).point.isZero(0));
  // The simplex of x, y, z >= 0, x + y + z <= 1: multiples of 1/4 suffice.
  const auto list = halfspaces({{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}, {1, 1, 1, -1}});
  const RationalPoint x = interior<InteriorPoint>(list).point;
  for (int k = 0; k < 3; ++k) CHECK(denominator(x[k]) == 4);
}

TEST_CASE("find_interior: flat in each dimension") {
  const auto plane = interior<FlatProof>(halfspaces({{1, 1, 0, -1}, {-1, -1, 0, 1}}));
  CHECK(plane.multipliers.size() == 2);
  const auto square = interior<FlatProof>(data::centered_box(1, 1, 0));
  CHECK(square.point[2] == 0);
  interior<FlatProof>(data::centered_box(0, 1, 0));  // segment
  CHECK(interior<FlatProof>(data::centered_box(0, 0, 0)).point.isZero(0));
  // A point without any pair of opposite halfspaces: four through the origin.
  const auto point = interior<FlatProof>(
      halfspaces({{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}, {1, 1, 1, 0}, {1, 0, 0, -9}}));
  CHECK(point.multipliers.size() == 4);
}

TEST_CASE("find_interior: empty") {
  CHECK(interior<EmptyProof>(halfspaces({{1, 0, 0, 0}, {-1, 0, 0, 1}})).farkas.size() == 2);
  CHECK(
      interior<EmptyProof>(halfspaces({{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}, {1, 1, 1, 1}}))
          .farkas.size() == 4);
  interior<EmptyProof>(data::centered_box(1, -1, 1));
}

TEST_CASE("find_interior: an ulp of room, far from the origin") {
  // 2^60 <= x <= 2^60 + 2^-60, |y|, |z| <= 1
  auto list = data::centered_box(1, 1, 1);
  const Integer big = Integer(1) << 60, square = Integer(1) << 120;
  list[0] = Halfspace(IntegerVector3(big, 0, 0), Integer(-square - 1));
  list[1] = Halfspace(IntegerVector3(-1, 0, 0), big);
  CHECK(interior<InteriorPoint>(list).point[0] ==
        Rational(big) + scale_by_power_of_two(Rational(1), -61));
}

TEST_CASE("find_recession: bounded") {
  const auto box = recession<BoundedProof>(data::centered_box(1, 2, 3));
  CHECK(box.multipliers.size() == 6);
  recession<BoundedProof>(halfspaces({{-1, 0, 0, 5}, {0, -1, 0, 5}, {0, 0, -1, 5}, {1, 1, 1, 5}}));
  recession<BoundedProof>(data::centered_box(0, 0, 0));
}

TEST_CASE("find_recession: unbounded along a line, a ray, in a cone") {
  recession<RecessionRay>({});
  recession<RecessionRay>(halfspaces({{0, 3, 4, 1}}));
  recession<RecessionRay>(halfspaces({{0, 0, 3, 1}, {0, 0, -2, 1}}));
  const auto tube = recession<RecessionRay>(
      halfspaces({{1, 0, 0, -1}, {-1, 0, 0, -1}, {0, 1, 0, -1}, {0, -1, 0, -1}}));
  CHECK(tube.direction[0] == 0);
  CHECK(tube.direction[1] == 0);
  auto open_box = data::centered_box(1, 1, 1);
  open_box.pop_back();  // z has no lower bound
  const RationalVector3 down = recession<RecessionRay>(open_box).direction;
  CHECK(down[2] < 0);
  CHECK(down[0] == 0);
  CHECK(down[1] == 0);
  recession<RecessionRay>(halfspaces({{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}}));  // octant
}

TEST_CASE("feasibility: outcomes are those of Fourier-Motzkin elimination") {
  Random random(3);
  std::size_t kinds[3] = {}, bounded = 0;
  for (int repeat = 0; repeat < 700; ++repeat) {
    CAPTURE(repeat);
    const auto list = data::random_halfspaces(random, 1 + uniform_below(random, 7), 1 + repeat % 2);
    const InteriorOutcome outcome = find_interior(list, {.seed = random()});
    REQUIRE(std::visit([&](const auto& claim) { return check(list, claim); }, outcome));
    const bool is_empty = oracle::supremum(as_program(list, 0, true)).kind == LpKind::Infeasible;
    LinearProgram inflation = as_program(list, 1, true);
    inflation.objective[3] = 1;
    const oracle::Supremum room = oracle::supremum(inflation);
    const bool has_interior = room.kind == LpKind::Unbounded || room.value > 0;
    REQUIRE(std::holds_alternative<EmptyProof>(outcome) == is_empty);
    REQUIRE(std::holds_alternative<InteriorPoint>(outcome) == has_interior);
    ++kinds[outcome.index()];

    const BoundedOutcome cone = find_recession(list, {.seed = random()});
    REQUIRE(std::visit([&](const auto& claim) { return check(list, claim); }, cone));
    REQUIRE(std::holds_alternative<BoundedProof>(cone) == is_bounded_cone(list));
    bounded += std::holds_alternative<BoundedProof>(cone);
  }
  for (const std::size_t count : kinds) CHECK(count > 10);
  CHECK(bounded > 10);
}

TEST_CASE("check: an empty set is not proven by less") {
  const auto list = halfspaces({{1, 0, 0, 0}, {-1, 0, 0, 1}, {0, 1, 0, 0}, {-1, 0, 0, 0}});
  CHECK(check(list, EmptyProof{{{0, 2}, {1, 2}}}));
  CHECK_FALSE(check(list, EmptyProof{{}}));
  CHECK_FALSE(check(list, EmptyProof{{{0, 1}, {1, 2}}}));
  CHECK_FALSE(check(list, EmptyProof{{{0, 1}, {1, 1}, {2, 1}}}));
  CHECK_FALSE(check(list, EmptyProof{{{0, -1}, {1, -1}}}));
  CHECK_FALSE(check(list, EmptyProof{{{0, 1}, {9, 1}}}));
  CHECK_FALSE(check(list, EmptyProof{{{0, 1}, {3, 1}}}));  // y'd = 0: flat, not empty
}

TEST_CASE("check: a flat set is not proven by less") {
  const auto list = halfspaces({{1, 0, 0, 0}, {-1, 0, 0, 0}, {0, 1, 0, 0}, {-1, 0, 0, -1}});
  const FlatProof good{RationalPoint(0, -1, 0), {{0, 1}, {1, 1}}};
  CHECK(check(list, good));
  CHECK_FALSE(check(list, FlatProof{RationalPoint(0, 1, 0), good.multipliers}));  // outside
  CHECK_FALSE(check(list, FlatProof{good.point, {}}));
  CHECK_FALSE(check(list, FlatProof{good.point, {{0, 1}, {1, 2}}}));
  CHECK_FALSE(check(list, FlatProof{good.point, {{0, 0}, {1, 0}}}));
  CHECK_FALSE(check(list, FlatProof{good.point, {{0, 1}, {3, 1}}}));  // y'd < 0: a slab of width 1
}

TEST_CASE("check: a bounded set is not proven by less") {
  const auto box = data::centered_box(1, 1, 1);
  const BoundedProof good{{1, 1, 2, 2, 3, 3}, {0, 2, 4}};
  CHECK(check(box, good));
  CHECK_FALSE(check(box, BoundedProof{{1, 1, 2, 2, 3}, {0, 2, 4}}));
  CHECK_FALSE(check(box, BoundedProof{{1, 1, 2, 2, 3, 3, 1}, {0, 2, 4}}));
  CHECK_FALSE(check(box, BoundedProof{{1, 1, 2, 1, 3, 3}, {0, 2, 4}}));
  CHECK_FALSE(check(box, BoundedProof{{1, 1, 2, 2, 0, 0}, {0, 2, 4}}));
  CHECK_FALSE(check(box, BoundedProof{{-1, -1, -1, -1, -1, -1}, {0, 2, 4}}));
  CHECK_FALSE(check(box, BoundedProof{good.multipliers, {0, 2, 3}}));
  CHECK_FALSE(check(box, BoundedProof{good.multipliers, {0, 2, 6}}));
  // No such rows, and far from those there are.
  for (const std::array<std::size_t, 3>& rows : std::vector<std::array<std::size_t, 3>>{
           {1u << 30, 2, 4}, {0, 1u << 30, 4}, {0, 2, 1u << 30}}) {
    CHECK_FALSE(check(box, BoundedProof{good.multipliers, rows}));
  }
  const auto slab = halfspaces({{1, 0, 0, -1}, {-1, 0, 0, -1}});
  CHECK_FALSE(check(slab, BoundedProof{{1, 1}, {0, 1, 1}}));
}

TEST_CASE("check: a ray and an interior point are not just any") {
  const auto octant = halfspaces({{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}});
  CHECK(check(octant, RecessionRay{RationalVector3(1, 0, 0)}));
  CHECK_FALSE(check(octant, RecessionRay{RationalVector3(0, 0, 0)}));
  CHECK_FALSE(check(octant, RecessionRay{RationalVector3(1, -1, 0)}));
  CHECK(check(octant, InteriorPoint{RationalPoint(1, 1, 1)}));
  CHECK_FALSE(check(octant, InteriorPoint{RationalPoint(1, 1, 0)}));
  CHECK_FALSE(check(octant, InteriorPoint{RationalPoint(1, 1, -1)}));
}
