// SPDX-License-Identifier: MIT
// Determinants of planes: against their expansion along rows, in rationals.
#include "geometry/plane_determinants.hpp"

#include <doctest/doctest.h>

#include "exact_determinant.hpp"
#include "integer_halfspace.hpp"
#include "number/random.hpp"

using namespace convexact;

namespace {

Rational by_definition(std::span<const Halfspace> planes) {
  std::vector<std::vector<Rational>> rows;
  for (const Halfspace& h : planes) {
    rows.push_back({h.normal()[0], h.normal()[1], h.normal()[2]});
    if (planes.size() == 4) rows.back().push_back(h.offset());
  }
  return exact_determinant(rows);
}

Integer random_integer(Random& random, unsigned bits) {
  Integer value = 0;
  for (unsigned k = 0; k < bits; k += 32) value = (value << 32) + (random() >> 32);
  value >>= (bits + 31) / 32 * 32 - bits;
  return random() % 2 == 0 ? value : Integer(-value);
}

// The last plane is a combination of the others, up to `noise` in one entry: H and D are 0 or tiny.
std::array<Halfspace, 4> nearly_dependent(Random& random, unsigned bits, int noise) {
  std::vector<std::array<Integer, 4>> rows(4);
  for (int i = 0; i < 3; ++i)
    for (Integer& x : rows[i]) x = random_integer(random, bits) * 2 + 1;
  for (int k = 0; k < 4; ++k) rows[3][k] = rows[0][k] * 3 - rows[1][k] * 5 + rows[2][k] * 7;
  rows[3][0] += noise;
  const auto plane = [&](int i) {
    return Halfspace(IntegerVector3(rows[i][0], rows[i][1], rows[i][2]), rows[i][3]);
  };
  return {plane(0), plane(1), plane(2), plane(3)};
}

// Counts how often doubles decide, and compares every sign with the definition.
int certain_count(const std::array<Halfspace, 4>& h) {
  const auto& [a, b, c, p] = h;
  const Sign plane = sign_of(by_definition(h));
  const Sign normal = sign_of(by_definition(std::span(h).first(3)));
  CHECK(plane_sign(a, b, c, p) == plane);
  CHECK(normal_sign(a, b, c) == normal);
  CHECK(Rational(plane_determinant(a, b, c, p)) == by_definition(h));
  CHECK(Rational(normal_determinant(a, b, c)) == by_definition(std::span(h).first(3)));
  const auto fast = certain_plane_sign(plane_row(a), plane_row(b), plane_row(c), plane_row(p));
  const auto fast_normal = certain_normal_sign(plane_row(a), plane_row(b), plane_row(c));
  if (fast) CHECK(*fast == plane);
  if (fast_normal) CHECK(*fast_normal == normal);
  return (fast ? 1 : 0) + (fast_normal ? 1 : 0);
}

}  // namespace

TEST_CASE("plane determinants: the documented examples") {
  const Halfspace x = halfspace(1, 0, 0, 0), y = halfspace(0, 1, 0, 0), z = halfspace(0, 0, 1, 0);
  const Halfspace p = halfspace(-1, -1, -1, -1);
  CHECK(normal_determinant(x, y, z) == 1);
  CHECK(plane_determinant(x, y, z, p) == -1);
  CHECK(is_bounded(x, y, z));
  CHECK_FALSE(is_bounded(x, z, y));
  CHECK_FALSE(is_bounded(x, y, halfspace(1, 1, 0, 5)));
}

TEST_CASE(
    "plane determinants: a halfspace that cuts off the vertex lies beyond its dual triangle") {
  // The corner (1, 1, 1) of the cube |x| <= 1, about the origin.
  const Halfspace a = halfspace(1, 0, 0, -1), b = halfspace(0, 1, 0, -1),
                  c = halfspace(0, 0, 1, -1);
  CHECK(is_beyond(a, b, c, halfspace(1, 1, 1, -2)));
  CHECK_FALSE(is_beyond(a, b, c, halfspace(1, 1, 1, -3)));  // touches it
  CHECK_FALSE(is_beyond(a, b, c, halfspace(1, 1, 1, -4)));
}

TEST_CASE("plane determinants: random planes are decided by doubles, dependent ones by integers") {
  Random random(1);
  int random_certain = 0, dependent_certain = 0;
  for (int i = 0; i < 300; ++i) {
    const auto plane = [&](unsigned bits) {
      return Halfspace(IntegerVector3(random_integer(random, bits), random_integer(random, bits),
                                      random_integer(random, bits) * 2 + 1),
                       random_integer(random, 2 * bits));
    };
    const unsigned bits = 4 + static_cast<unsigned>(i);
    random_certain += certain_count({plane(bits), plane(bits), plane(bits), plane(bits)});
    dependent_certain += certain_count(nearly_dependent(random, 60 + bits, i % 3 - 1));
  }
  CHECK(random_certain > 590);
  // D of the first three is certain, H never is.
  CHECK(dependent_certain > 290);
  CHECK(dependent_certain <= 300);
}

// D near zero is what its bound must hold for: where doubles are certain, they are right, and a
// bound a sixteenth as wide would not be enough.
TEST_CASE("plane determinants: the bound of D holds for normals that are nearly dependent") {
  Random random(2);
  const Integer one = 1;
  double highest = 0;
  for (int i = 0; i < 4000; ++i) {
    std::array<IntegerVector3, 3> n;
    for (int k = 0; k < 3; ++k) {
      n[0][k] = random_integer(random, 62);
      n[1][k] = random_integer(random, 62);
      n[2][k] = n[0][k] * 3 - n[1][k] * 5;
    }
    n[2][0] += (one << (i % 40)) * (i % 2 == 0 ? 1 : -1);
    const Halfspace a(n[0], one), b(n[1], one), c(n[2], one);
    const Sign truth = sign_of(by_definition(std::array{a, b, c}));
    const PlaneRow x = plane_row(a), y = plane_row(b), z = plane_row(c);
    if (const auto sign = certain_normal_sign(x, y, z)) CHECK(*sign == truth);
    CHECK(normal_sign(a, b, c) == truth);
    // The same sum of doubles as its sign is taken from, and its magnitude.
    double value = 0, magnitude = 0;
    for (const auto& [p, q, r] : {std::array{1, 2, 0}, {2, 0, 1}, {0, 1, 2}}) {
      value += (x[p] * y[q] - x[q] * y[p]) * z[r];
      magnitude += (std::abs(x[p] * y[q]) + std::abs(x[q] * y[p])) * std::abs(z[r]);
    }
    if (sign_of(value) == truth) continue;
    highest = std::max(highest, std::abs(value) / magnitude);
  }
  MESSAGE("wrong signs up to " << highest * 0x1p53 << " u of the magnitude");
  CHECK(highest > 0.75 * 0x1p-53);  // a sixteenth of the bound, 12 u
}

TEST_CASE("plane determinants: entries of very different size") {
  const Integer huge = Integer(1) << 5000;
  const Halfspace a(IntegerVector3(1, huge, 0), 1), b(IntegerVector3(0, 1, huge), 1);
  const Halfspace c(IntegerVector3(huge, 0, 1), 1), d(IntegerVector3(1, 1, 1), huge);
  certain_count({a, b, c, d});
  certain_count({a, a, b, c});
  certain_count({a, b, d, d});
}
