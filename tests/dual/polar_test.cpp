// SPDX-License-Identifier: MIT
// The polar map. Expected values by hand; the determinants from their definition.
#include <doctest/doctest.h>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "integer_halfspace.hpp"
#include "property.hpp"

using namespace convexact;

namespace {

RationalPoint point(Rational x, Rational y, Rational z) { return {x, y, z}; }

// The determinant of the four rows (n, d), by cofactors of the last column.
Integer four_rows(const Halfspace& a, const Halfspace& b, const Halfspace& c, const Halfspace& p) {
  const auto det = [](const Halfspace& u, const Halfspace& v, const Halfspace& w) {
    return Integer(u.normal().dot(v.normal().cross(w.normal())));
  };
  return -a.offset() * det(b, c, p) + b.offset() * det(a, c, p) - c.offset() * det(a, b, p) +
         p.offset() * det(a, b, c);
}

}  // namespace

TEST_CASE("polar: x <= 1 about two centers") {
  const Halfspace h = halfspace(1, 0, 0, -1);
  const DualPoint origin = polar(h, point(0, 0, 0));
  CHECK(origin.n == IntegerVector3(1, 0, 0));
  CHECK(origin.w == 1);
  // Distance 1/3 to the plane: the dual point is 3 n, that is (3, 0, 0 : 1).
  const DualPoint nearer = polar(h, point(Rational(2, 3), 5, 5));
  CHECK(nearer.n == IntegerVector3(3, 0, 0));
  CHECK(nearer.w == 1);
}

TEST_CASE("polar: a center on the plane or beyond is refused") {
  CHECK_THROWS_AS((void)polar(halfspace(1, 0, 0, -1), point(1, 0, 0)), Error);
  CHECK_THROWS_AS((void)polar(halfspace(1, 0, 0, -1), point(2, 0, 0)), Error);
  CHECK_THROWS_AS((void)polar(point(1, 2, 3), point(1, 2, 3)), Error);
}

TEST_CASE("plane_through and height: the cube corner of the header") {
  const RationalPoint center = point(0, 0, 0);
  const DualPlane plane =
      plane_through(polar(halfspace(1, 0, 0, -1), center), polar(halfspace(0, 1, 0, -1), center),
                    polar(halfspace(0, 0, 1, -1), center));
  CHECK(plane.x == IntegerVector3(1, 1, 1));
  CHECK(plane.d == 1);
  CHECK(polar(plane, center) == point(1, 1, 1));
  const DualPoint cutting = polar(halfspace(1, 1, 1, -2), center);
  CHECK(height(plane, cutting) == 1);
  CHECK(is_beyond(cutting, plane));
  CHECK_FALSE(is_beyond(polar(halfspace(1, 1, 1, -3), center), plane));  // level
  CHECK_FALSE(is_beyond(polar(halfspace(1, 1, 1, -4), center), plane));
}

TEST_CASE("plane_through: parallel edges meet in no vertex") {
  const RationalPoint center = point(0, 0, 0);
  const DualPlane plane =
      plane_through(polar(halfspace(1, 0, 0, -1), center), polar(halfspace(0, 1, 0, -1), center),
                    polar(halfspace(-1, 0, 0, -1), center));
  CHECK(plane.d == 0);
}

TEST_CASE("polar: the polar of the polar is the identity") {
  check_property("halfspaces and vertices come back", [](std::array<std::int16_t, 7> raw) {
    const Rational third(1, 3);
    const RationalPoint center = point(raw[0] * third, raw[1] * third, raw[2] * third);
    RC_PRE(raw[3] != 0 || raw[4] != 0 || raw[5] != 0);
    const IntegerVector3 n(raw[3], raw[4], raw[5]);
    // An offset that leaves the center strictly inside by 1/(1 + |raw|).
    const Rational w(1, 1 + std::abs(raw[6]));
    const Halfspace h(RationalVector3(n.cast<Rational>()),
                      Rational(-n.cast<Rational>().dot(center) - w));
    RC_ASSERT(polar(polar(h, center), center) == h);
    const RationalPoint vertex = point(raw[3], raw[4], Rational(raw[5], 7));
    RC_PRE(vertex != center);
    RC_ASSERT(polar(polar(vertex, center), center) == vertex);
  });
}

TEST_CASE("height: the determinant of four rows, whatever the center") {
  check_property("same sign", [](std::array<std::int8_t, 12> raw, std::array<std::uint8_t, 4> gap,
                                 std::array<std::int8_t, 3> where) {
    std::array<std::optional<Halfspace>, 4> h;
    const RationalPoint inside = point(where[0], where[1], where[2]);
    for (int k = 0; k < 4; ++k) {
      const RationalVector3 n(raw[3 * k], raw[3 * k + 1], raw[3 * k + 2]);
      RC_PRE(n != RationalVector3::Zero());
      h[k].emplace(n, Rational(-n.dot(inside) - 1 - gap[k]));
    }
    for (const Rational& shift : {Rational(0), Rational(1, 1000)}) {
      const RationalPoint center = inside + RationalVector3::Constant(shift);
      const DualPoint a = polar(*h[0], center), b = polar(*h[1], center), c = polar(*h[2], center);
      const IntegerVector3 u = b.n * a.w - a.n * b.w, v = c.n * a.w - a.n * c.w;
      RC_PRE(IntegerVector3(u.cross(v)) != IntegerVector3::Zero());  // not collinear
      const Integer lifted = height(plane_through(a, b, c), polar(*h[3], center));
      RC_ASSERT(sign_of(lifted) == sign_of(four_rows(*h[0], *h[1], *h[2], *h[3])));
    }
  });
}
