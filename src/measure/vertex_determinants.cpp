// SPDX-License-Identifier: MIT
#include "measure/vertex_determinants.hpp"

#include <algorithm>
#include <cmath>

#include "convexact/geometry.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// Sets the integers of one axis and returns its unit.
Rational scale_axis(const PointSet& points, int axis, std::vector<IntegerVector3>& integers) {
  std::vector<Rational> values;
  std::vector<Integer> multiples(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    values.push_back(points[PointId(i)][axis]);
  }
  const Integer denominator = clear_denominators(values, multiples);
  for (std::size_t i = 0; i < points.size(); ++i) integers[i][axis] = std::move(multiples[i]);
  return Rational(1) / Rational(denominator);
}

// The same for doubles: one power of two, found without fractions.
Rational scale_doubles(std::span<const Point> points, int axis,
                       std::vector<IntegerVector3>& integers) {
  constexpr int kAllZero = 5000;
  int lowest = kAllZero;
  for (const Point& p : points) {
    if (p[axis] != 0) lowest = std::min(lowest, unit_exponent(p[axis]));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i][axis];
    if (x == 0) continue;
    const int own = unit_exponent(x);
    Integer& integer = integers[i][axis];
    mpz_set_d(raw(integer), std::ldexp(x, -own));  // below 2^53
    mpz_mul_2exp(raw(integer), raw(integer), static_cast<mp_bitcnt_t>(own - lowest));
  }
  return scale_by_power_of_two(Rational(1), lowest == kAllZero ? 0 : lowest);
}

}  // namespace

VertexDeterminants::VertexDeterminants(const PointSet& points)
    : points_(points), integers_(points.size(), IntegerVector3(0, 0, 0)) {
  for (int axis = 0; axis < 3; ++axis) {
    unit_ *= points.is_binary() ? scale_doubles(points.doubles(), axis, integers_)
                                : scale_axis(points, axis, integers_);
  }
}

Integer VertexDeterminants::height(std::size_t a, std::size_t b, std::size_t c,
                                   std::size_t p) const {
  const IntegerVector3 &o = integers_[a], &s = integers_[b], &t = integers_[c], &q = integers_[p];
  Integer f[3], g[3], sum = 0, minor, h;
  for (int k = 0; k < 3; ++k) {
    mpz_sub(raw(f[k]), raw(s[k]), raw(o[k]));
    mpz_sub(raw(g[k]), raw(t[k]), raw(o[k]));
  }
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    mpz_mul(raw(minor), raw(f[l]), raw(g[m]));
    subtract_product(minor, f[m], g[l]);
    mpz_sub(raw(h), raw(q[k]), raw(o[k]));
    add_product(sum, minor, h);
  }
  return sum;
}

Sign VertexDeterminants::side(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const {
  if (!points_.is_binary()) return sign_of(height(a, b, c, p));
  const auto x = points_.doubles();
  return -orient3d(x[a], x[b], x[c], x[p]);
}

Integer VertexDeterminants::six_volumes(std::span<const DualTriangle> triangles) const {
  Integer sum = 0;
  for (const DualTriangle& t : triangles) {
    // Tetrahedra from vertex 0, which may be any point.
    sum -= height(t[0].index(), t[1].index(), t[2].index(), 0);
  }
  return sum;
}

}  // namespace convexact
