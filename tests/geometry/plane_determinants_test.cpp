// SPDX-License-Identifier: MIT
// Determinants of planes in the three places that compute them on their own: the fast engines', the
// dual's and the verifier's, each against the expansion along rows, in rationals.
#include "geometry/plane_determinants.hpp"

#include <doctest/doctest.h>

#include "convexact/dual.hpp"
#include "exact_determinant.hpp"
#include "integer_halfspace.hpp"
#include "number/random.hpp"
#include "simplify/plain_vertex.hpp"

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

// The dual point about the origin, wherever that lies.
DualPoint dual_point(const Halfspace& h) { return {h.normal(), Integer(-h.offset())}; }

void check_determinants(const std::array<Halfspace, 4>& planes) {
  const auto& [a, b, c, p] = planes;
  const Rational height = by_definition(planes),
                 normals = by_definition(std::span(planes).first(3));
  CHECK(Rational(plane_determinant(a, b, c, p)) == height);
  CHECK(Rational(normal_determinant(a, b, c)) == normals);
  // Of the dual: with all terms divided by one positive number.
  const DualPlane plane = plane_through(dual_point(a), dual_point(b), dual_point(c));
  const Integer above = convexact::height(plane, dual_point(p));
  CHECK(sign_of(above) == sign_of(height));
  CHECK(sign_of(plane.d) == sign_of(normals));
  CHECK(Rational(above) * normals == Rational(plane.d) * height);
  // Of the verifier.
  const PlainVertex vertex = plain_vertex(a, b, c);
  CHECK(Rational(vertex.d) == normals);
  CHECK(Rational(value_at(vertex, p)) == height);
}

}  // namespace

TEST_CASE("plane determinants: the documented examples") {
  const Halfspace x = halfspace(1, 0, 0, 0), y = halfspace(0, 1, 0, 0), z = halfspace(0, 0, 1, 0);
  const Halfspace p = halfspace(-1, -1, -1, -1);
  CHECK(normal_determinant(x, y, z) == 1);
  CHECK(normal_determinant(x, z, y) == -1);
  CHECK(normal_determinant(x, y, halfspace(1, 1, 0, 5)) == 0);
  CHECK(plane_determinant(x, y, z, p) == -1);
}

TEST_CASE(
    "plane determinants: a halfspace that cuts off the vertex lies beyond its dual triangle") {
  // The corner (1, 1, 1) of the cube |x| <= 1, about the origin.
  const Halfspace a = halfspace(1, 0, 0, -1), b = halfspace(0, 1, 0, -1),
                  c = halfspace(0, 0, 1, -1);
  CHECK(plane_determinant(a, b, c, halfspace(1, 1, 1, -2)) > 0);
  CHECK(plane_determinant(a, b, c, halfspace(1, 1, 1, -3)) == 0);  // touches it
  CHECK(plane_determinant(a, b, c, halfspace(1, 1, 1, -4)) < 0);
}

TEST_CASE("plane determinants: of random planes and of dependent ones") {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const auto plane = [&](unsigned bits) {
      return Halfspace(IntegerVector3(random_integer(random, bits), random_integer(random, bits),
                                      random_integer(random, bits) * 2 + 1),
                       random_integer(random, 2 * bits));
    };
    const unsigned bits = 4 + static_cast<unsigned>(i);
    check_determinants({plane(bits), plane(bits), plane(bits), plane(bits)});
    check_determinants(nearly_dependent(random, 60 + bits, i % 3 - 1));
  }
}

TEST_CASE("plane determinants: entries of very different size") {
  const Integer huge = Integer(1) << 5000;
  const Halfspace a(IntegerVector3(1, huge, 0), 1), b(IntegerVector3(0, 1, huge), 1);
  const Halfspace c(IntegerVector3(huge, 0, 1), 1), d(IntegerVector3(1, 1, 1), huge);
  check_determinants({a, b, c, d});
  check_determinants({b, c, a, d});
  check_determinants({a, b, d, d});
}
