// SPDX-License-Identifier: MIT
#include "geometry/plane_determinants.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/roundoff.hpp"

namespace convexact {
namespace {

using roundoff::u;

// Both determinants are sums of monomials; T is the sum, P that of their magnitudes, Q the computed
// P. Entries have two factors (1 + e), |e| <= u, against the true ones. All entries are at most 1,
// so underflows, of entries and on the way, cost far less than 2^-1000 altogether.
constexpr double kUnderflow = 0x1p-1000;

// D: three entries make 6 factors; product, difference, product and two sums are 5. So
// |det - T| <= ((1+u)^11 - 1) P < (11u + 56u^2) / (1-u)^11 Q, and the rest pays for the bound's
// own rounding.
constexpr double kNormalBound = 12 * u;
static_assert(kNormalBound > (3 * 2 + 5) * u);

// H: four entries make 8 factors; product, difference, the product of two minors and five sums 8.
constexpr double kPlaneBound = 17 * u;
static_assert(kPlaneBound > (4 * 2 + 8) * u);

// The terms of a determinant, as a value and as the magnitude of its monomials.
struct Term {
  double value, magnitude;
};
Term operator*(const Term& x, const Term& y) {
  return {x.value * y.value, x.magnitude * y.magnitude};
}
Term operator+(const Term& x, const Term& y) {
  return {x.value + y.value, x.magnitude + y.magnitude};
}
Term operator-(const Term& x, const Term& y) {
  return {x.value - y.value, x.magnitude + y.magnitude};
}
Term entry(double x) { return {x, std::abs(x)}; }

Term minor(const PlaneRow& a, const PlaneRow& b, int i, int j) {
  return entry(a[i]) * entry(b[j]) - entry(a[j]) * entry(b[i]);
}

std::optional<Sign> certain(const Term& determinant, double slope) {
  const double bound = slope * determinant.magnitude + kUnderflow;
  if (determinant.value > bound) return Sign::Positive;
  if (determinant.value < -bound) return Sign::Negative;
  return std::nullopt;
}

}  // namespace

Integer normal_determinant(const Halfspace& a, const Halfspace& b, const Halfspace& c) {
  const IntegerVector3 cross = a.normal().cross(b.normal());
  return cross.dot(c.normal());
}

Integer plane_determinant(const Halfspace& a, const Halfspace& b, const Halfspace& c,
                          const Halfspace& p) {
  // Laplace expansion by two rows: the 2x2 minors without and with the last column.
  const IntegerVector3 ab = a.normal().cross(b.normal()), cp = c.normal().cross(p.normal());
  const IntegerVector3 s = a.normal() * b.offset() - b.normal() * a.offset();
  const IntegerVector3 t = c.normal() * p.offset() - p.normal() * c.offset();
  return ab.dot(t) + cp.dot(s);
}

PlaneRow plane_row(const Halfspace& h) {
  const Integer* const entries[4] = {&h.normal()[0], &h.normal()[1], &h.normal()[2], &h.offset()};
  PlaneRow row;
  std::array<long, 4> exponents;
  long largest = 0;  // entries are integers: their exponents are not negative
  for (int k = 0; k < 4; ++k) {
    // Rounds towards zero, so off by less than 2^-52: two factors 1 + u.
    row[k] = mpz_get_d_2exp(&exponents[k], entries[k]->backend().data());
    largest = std::max(largest, exponents[k]);
  }
  for (int k = 0; k < 4; ++k) {
    const long shift = std::max(exponents[k] - largest, -5000L);  // far below any double
    row[k] = std::ldexp(row[k], static_cast<int>(shift));
  }
  return row;
}

std::optional<Sign> certain_normal_sign(const PlaneRow& a, const PlaneRow& b, const PlaneRow& c) {
  return certain(minor(a, b, 1, 2) * entry(c[0]) + minor(a, b, 2, 0) * entry(c[1]) +
                     minor(a, b, 0, 1) * entry(c[2]),
                 kNormalBound);
}

std::optional<Sign> certain_plane_sign(const PlaneRow& a, const PlaneRow& b, const PlaneRow& c,
                                       const PlaneRow& p) {
  return certain(minor(a, b, 1, 2) * minor(c, p, 0, 3) + minor(a, b, 2, 0) * minor(c, p, 1, 3) +
                     minor(a, b, 0, 1) * minor(c, p, 2, 3) + minor(a, b, 0, 3) * minor(c, p, 1, 2) +
                     minor(a, b, 1, 3) * minor(c, p, 2, 0) + minor(a, b, 2, 3) * minor(c, p, 0, 1),
                 kPlaneBound);
}

Sign normal_sign(const Halfspace& a, const Halfspace& b, const Halfspace& c) {
  if (const auto sign = certain_normal_sign(plane_row(a), plane_row(b), plane_row(c))) return *sign;
  return sign_of(normal_determinant(a, b, c));
}

Sign plane_sign(const Halfspace& a, const Halfspace& b, const Halfspace& c, const Halfspace& p) {
  if (const auto sign = certain_plane_sign(plane_row(a), plane_row(b), plane_row(c), plane_row(p)))
    return *sign;
  return sign_of(plane_determinant(a, b, c, p));
}

}  // namespace convexact
