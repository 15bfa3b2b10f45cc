// SPDX-License-Identifier: MIT
// Chebyshev centers: closed forms (named in each case), metamorphic properties, and the checker.
#include <doctest/doctest.h>

#include "convexact/linear_program.hpp"
#include "halfspaces.hpp"
#include "lp/interior_point.hpp"
#include "property.hpp"

using namespace convexact;
using data::halfspaces;

namespace {

ChebyshevCenter center_of(const std::vector<Halfspace>& list) {
  const ChebyshevOutcome outcome = chebyshev_center(list);
  REQUIRE(std::holds_alternative<ChebyshevCenter>(outcome));
  ChebyshevCenter center = std::get<ChebyshevCenter>(outcome);
  CHECK(check(list, center));
  CHECK(center.radius_low <= center.radius_high);
  CHECK(center.radius_low > center.optimum_radius * Rational(9, 10));
  const Rational gap = scale_by_power_of_two(Rational(1), -63);
  CHECK(center.radius_high <= center.optimum_radius * (1 + gap));
  return center;
}

template <class Claim>
void check_outcome(const std::vector<Halfspace>& list) {
  const ChebyshevOutcome outcome = chebyshev_center(list);
  REQUIRE(std::holds_alternative<Claim>(outcome));
  CHECK(check(list, std::get<Claim>(outcome)));
}

std::vector<Halfspace> tetrahedron() {
  return halfspaces({{1, 1, 1, -1}, {1, -1, -1, -1}, {-1, 1, -1, -1}, {-1, -1, 1, -1}});
}

// x -> 2^exponent x + shift
std::vector<Halfspace> moved(const std::vector<Halfspace>& list, long exponent,
                             const RationalPoint& shift) {
  std::vector<Halfspace> result;
  for (const Halfspace& h : list) {
    const RationalVector3 n = h.normal().cast<Rational>();
    const Rational d = scale_by_power_of_two(Rational(h.offset()), exponent) - n.dot(shift);
    result.emplace_back(n, d);
  }
  return result;
}

}  // namespace

TEST_CASE("enclose_norm: exact where the norm is a short integer") {
  for (const auto& [n, norm] : {std::pair(IntegerVector3(0, 0, 1), Integer(1)),
                                std::pair(IntegerVector3(0, -3, 4), Integer(5)),
                                std::pair(IntegerVector3(2, 3, 6), Integer(7)),
                                std::pair(IntegerVector3(Integer(3) << 200, Integer(4) << 200, 0),
                                          Integer(Integer(5) << 200))}) {
    CHECK(enclose_norm(n).lower == norm);
    CHECK(enclose_norm(n).upper == norm);
  }
}

TEST_CASE("enclose_norm: encloses, 64 bits wide, at any length") {
  check_property("lower^2 <= n.n <= upper^2",
                 [](std::int64_t a, std::int64_t b, std::int64_t c, std::uint16_t shift) {
                   const unsigned bits = shift % 300;
                   const IntegerVector3 n(Integer(a) << bits, Integer(b) >> bits % 50, Integer(c));
                   RC_PRE(!n.isZero(0));
                   const Rational square = n.squaredNorm();
                   const auto [lower, upper] = enclose_norm(n);
                   RC_ASSERT(lower > 0);
                   RC_ASSERT(lower * lower <= square && square <= upper * upper);
                   RC_ASSERT(upper - lower <= scale_by_power_of_two(lower, -63));
                   if (lower != upper) RC_ASSERT(lower * lower < square && square < upper * upper);
                   Integer mantissa = numerator(upper);
                   while (mantissa % 2 == 0) mantissa /= 2;
                   RC_ASSERT(bit_length(mantissa) <= 64u);
                 });
}

TEST_CASE("chebyshev_center: the cube |x| <= 1 has the unit ball") {
  const ChebyshevCenter ball = center_of(data::centered_box(1, 1, 1));
  CHECK(ball.center.isZero(0));
  CHECK(ball.radius_low == 1);
  CHECK(ball.radius_high == 1);
}

TEST_CASE("chebyshev_center: a box has half its shortest side") {
  const ChebyshevCenter ball = center_of(data::centered_box(5, 2, 3));
  CHECK(ball.center[1] == 0);
  CHECK(ball.radius_low == 2);
  CHECK(ball.radius_high == 2);
}

TEST_CASE("chebyshev_center: the regular tetrahedron n.x <= 1, n in {+-1}^3, has r = 1/sqrt(3)") {
  const ChebyshevCenter ball = center_of(tetrahedron());
  CHECK(ball.center.isZero(0));
  CHECK(ball.radius_low * ball.radius_low < Rational(1, 3));
  CHECK(ball.radius_high * ball.radius_high > Rational(1, 3));
}

TEST_CASE("chebyshev_center: x, y, z >= 0, x + y + z <= 1 has r = 1/(3 + sqrt(3))") {
  const ChebyshevCenter ball =
      center_of(halfspaces({{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}, {1, 1, 1, -1}}));
  const Rational low = 1 / ball.optimum_radius - 3, high = 1 / ball.radius_high - 3;
  CHECK(low * low > 3);
  CHECK(high * high < 3);
  CHECK(ball.optimum ==
        RationalPoint(ball.optimum_radius, ball.optimum_radius, ball.optimum_radius));
}

TEST_CASE("chebyshev_center: |x|, |y| <= 1 has r = 1 and is not bounded") {
  auto tube = data::centered_box(1, 1, 1);
  tube.erase(tube.begin() + 4, tube.end());
  const ChebyshevCenter ball = center_of(tube);
  CHECK(ball.radius_low == 1);
  CHECK(ball.radius_high == 1);
  CHECK(std::holds_alternative<RecessionRay>(find_recession(tube)));
  const ChebyshevCenter slab = center_of(halfspaces({{3, 4, 0, -10}, {-3, -4, 0, 0}}));
  CHECK(slab.radius_low > Rational(9, 10));  // width 2
  CHECK(slab.radius_high == 1);
}

TEST_CASE("chebyshev_center: redundant, repeated and many tight planes change nothing") {
  auto list = data::centered_box(1, 1, 1);
  const auto extra = halfspaces({{3, 4, 0, -5}, {2, 3, 6, -7}, {-3, 0, 4, -5}, {1, 1, 1, -9}});
  list.insert(list.end(), extra.begin(), extra.end());
  list.insert(list.end(), extra.begin(), extra.end());
  const ChebyshevCenter ball = center_of(list);
  CHECK(ball.optimum.isZero(0));
  CHECK(ball.radius_high == 1);
}

TEST_CASE("chebyshev_center: balls of any size") {
  check_outcome<UnboundedRadius>({});
  check_outcome<UnboundedRadius>(halfspaces({{1, -2, 2, 100}}));
  check_outcome<UnboundedRadius>(halfspaces({{-1, 0, 0, 5}, {0, -1, 0, 5}, {0, 0, -1, 5}}));
}

TEST_CASE("chebyshev_center: flat and empty") {
  check_outcome<FlatProof>(data::centered_box(1, 0, 1));
  check_outcome<FlatProof>(data::centered_box(0, 0, 0));
  check_outcome<EmptyProof>(data::centered_box(1, -1, 1));
  check_outcome<EmptyProof>(halfspaces({{1, 1, 1, 1}, {-1, -1, -1, 1}}));
}

TEST_CASE("chebyshev_center: certified, of the same kind as find_interior, whatever the seed") {
  Random random(17);
  std::size_t kinds[4] = {};
  for (int repeat = 0; repeat < 600; ++repeat) {
    CAPTURE(repeat);
    const auto list = data::random_halfspaces(random, uniform_below(random, 20), 1 + repeat % 9);
    const ChebyshevOutcome outcome = chebyshev_center(list, {.seed = 1});
    REQUIRE(std::visit([&](const auto& claim) { return check(list, claim); }, outcome));
    const InteriorOutcome interior = find_interior(list, {.seed = random()});
    REQUIRE(std::holds_alternative<FlatProof>(outcome) ==
            std::holds_alternative<FlatProof>(interior));
    REQUIRE(std::holds_alternative<EmptyProof>(outcome) ==
            std::holds_alternative<EmptyProof>(interior));
    const ChebyshevOutcome again = chebyshev_center(list, {.seed = random()});
    REQUIRE(again.index() == outcome.index());
    if (const auto* ball = std::get_if<ChebyshevCenter>(&outcome)) {
      REQUIRE(std::get<ChebyshevCenter>(again).optimum_radius == ball->optimum_radius);
    }
    ++kinds[outcome.index()];
  }
  for (const std::size_t count : kinds) CHECK(count > 10);
}

TEST_CASE("chebyshev_center: moves and grows with its halfspaces") {
  check_property("2^k P + v has 2^k r and 2^k c + v", [](std::uint64_t seed, std::int16_t a,
                                                         std::int16_t b) {
    Random random(seed);
    auto list = data::centered_box(7, 7, 7);
    for (const Halfspace& h : data::random_halfspaces(random, 6, 5)) {
      if (h.offset() < 0) list.push_back(h);
    }
    const long exponent = a % 300;
    const RationalPoint shift(Rational(b, 8), Rational(a), Rational(b - a, 32));
    const ChebyshevCenter here = center_of(list), there = center_of(moved(list, exponent, shift));
    RC_ASSERT(there.optimum_radius == scale_by_power_of_two(here.optimum_radius, exponent));
    for (int k = 0; k < 3; ++k) {
      RC_ASSERT(there.optimum[k] == scale_by_power_of_two(here.optimum[k], exponent) + shift[k]);
    }
  });
}

TEST_CASE("check: a center is not proven by less") {
  const auto list = tetrahedron();
  const ChebyshevCenter good = center_of(list);
  ChebyshevCenter bad = good;
  bad.radius_low = Rational(58, 100);  // 1/sqrt(3) = 0.577...
  CHECK_FALSE(check(list, bad));
  bad = good;
  bad.radius_low = -bad.radius_low;
  CHECK_FALSE(check(list, bad));
  bad = good;
  bad.radius_high = Rational(57, 100);
  CHECK_FALSE(check(list, bad));
  bad = good;
  bad.center = RationalPoint(1, 1, 1);
  CHECK_FALSE(check(list, bad));
  bad = good;
  bad.optimum[0] += scale_by_power_of_two(Rational(1), -20);
  CHECK_FALSE(check(list, bad));
  bad = good;
  bad.touching.pop_back();
  CHECK_FALSE(check(list, bad));
  bad = good;
  bad.touching[0].value *= -1;
  CHECK_FALSE(check(list, bad));
  bad = good;
  bad.touching.clear();
  CHECK_FALSE(check(list, bad));
  // Far outside, on the wrong side of a plane by more than the radius: the square alone would pass.
  bad = good;
  bad.center = RationalPoint(5, 5, 5);
  CHECK_FALSE(check(list, bad));
  CHECK_FALSE(check(list, UnboundedRadius{RationalVector3(1, 0, 0)}));
  CHECK(check(halfspaces({{1, 0, 0, 0}}), UnboundedRadius{RationalVector3(-1, 5, 0)}));
  CHECK_FALSE(check(halfspaces({{1, 0, 0, 0}}), UnboundedRadius{RationalVector3(0, 5, 0)}));
}
