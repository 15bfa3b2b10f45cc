// SPDX-License-Identifier: MIT
// orient3d_stages.hpp - the values that the stages of orient3d() compute, and how far they may be
// from the truth. The error bounds are our own, a little wider than in [Shewchuk1997] and shorter
// to derive.
#pragma once
#include <cmath>

#include "convexact/geometry.hpp"
#include "number/expansion.hpp"

namespace convexact {

/// The stage that decided a sign: A doubles; B the rounded differences, exactly; C these and a
/// correction; D all terms exactly; Rationals if a coordinate is outside [2^-306, 2^338].
enum class Orient3dStage { A, B, C, D, Rationals };
struct StagedSign {
  Sign sign;
  Orient3dStage stage;
};

/// orient3d() with the stage that was reached, for tests and measurements.
[[nodiscard]] StagedSign orient3d_staged(const Point& a, const Point& b, const Point& c,
                                         const Point& d);

namespace orient3d_stages {

inline constexpr double u = kUnitRoundoff;

// The determinant of rows x, y, z is the sum of six monomials. Written as `determinant` below, a
// monomial takes part in 5 roundings: its product, the difference of two, the product with a z,
// and two sums.
inline double determinant(const Point& x, const Point& y, const Point& z) {
  return x.z() * (y.x() * z.y() - z.x() * y.y()) + y.z() * (z.x() * x.y() - x.x() * z.y()) +
         z.z() * (x.x() * y.y() - y.x() * x.y());
}

// The sum of the monomials' magnitudes, with the same roundings.
inline double permanent(const Point& x, const Point& y, const Point& z) {
  const Point a = x.cwiseAbs(), b = y.cwiseAbs(), c = z.cwiseAbs();
  return a.z() * (b.x() * c.y() + c.x() * b.y()) + b.z() * (c.x() * a.y() + a.x() * c.y()) +
         c.z() * (a.x() * b.y() + b.x() * a.y());
}

// Let T be the true determinant, P its true permanent, Q the computed permanent. With the rounding
// of the three differences each monomial has 8 factors (1 + e), |e| <= u, so Q >= (1-u)^8 P.
//
// Stage A: |det - T| <= ((1+u)^8 - 1) P <= (8u + 28u^2 + ...) / (1-u)^8 Q < (8 + 100u) u Q; the
// rest up to 128u covers the rounding of the bound itself.
inline constexpr double kBoundA = (8 + 128 * u) * u;
static_assert(kBoundA / u - 8 == 128 * u);

// Stage B: the determinant B of the rounded differences, exactly, has three of these factors:
// |B - T| <= (3u + 4u^2) P < (3 + 40u) u Q. Its estimate e is off by 16u|B|, so that
// |e| > (3 + 128u) u Q implies |B| > |e|(1 - 17u) > (3 + 70u) u Q > |B - T|.
inline constexpr double kBoundB = (3 + 128 * u) * u;
static_assert(kBoundB / u - 3 == 128 * u);

// Stage C: T = B + L + R, L linear in the roundoffs of the differences, R the rest. A roundoff is
// at most u times its difference (and 1 + u times that for the rounded one), so L has at most
// 3u(1+u)^3 P and R at most 3u^2(1+u)^4 P. L is computed by three calls of determinant(), each with
// one column of roundoffs: 5 factors, and 2 for their sum; that costs 3u * 7u P (1 + small). The
// sum e + L rounds once. So |det - T| < (3 + 21) u^2 P (1 + 20u) + 16u|B| + u|det|, where
// |B| <= |e|(1 + 17u) and |e| <= |det|(1 + 2u) + |L|, |L| < 4u P: 16u|B| < 17u|det| + 65u^2 P.
// Together less than 90u^2 P + 18u|det|; the rest up to 96 and 20 covers Q in place of P and the
// rounding of the bound.
inline constexpr double kBoundC = 96 * u * u;
inline constexpr double kRelativeC = 20 * u;
static_assert(kBoundC >= (24 + 65 + 1) * u * u && kRelativeC >= 18 * u);
inline double bound_c(double magnitude, double corrected) {
  return kBoundC * magnitude + kRelativeC * std::abs(corrected);
}

// Differences and their roundoffs: p - d = rounded + rest, exactly.
struct Difference {
  Point rounded, rest;
};
inline Difference subtract(const Point& p, const Point& d) {
  Difference result;
  for (int k = 0; k < 3; ++k) {
    const TwoTerms t = two_sum(p[k], -d[k]);
    result.rounded[k] = t.high;
    result.rest[k] = t.low;
  }
  return result;
}

// x1 y2 - x2 y1, exactly.
inline Expansion<4> minor(double x1, double y2, double x2, double y1) {
  return sum(to_expansion(two_product(x1, y2)), to_expansion(two_product(-x2, y1)));
}

inline Expansion<24> exact_determinant(const Point& x, const Point& y, const Point& z) {
  const auto yz = scale(minor(y.x(), z.y(), z.x(), y.y()), x.z());
  const auto zx = scale(minor(z.x(), x.y(), x.x(), z.y()), y.z());
  const auto xy = scale(minor(x.x(), y.y(), y.x(), x.y()), z.z());
  return sum(sum(yz, zx), xy);
}

// L of stage C: one column at a time is replaced by its roundoffs.
inline double linear_correction(const Difference& x, const Difference& y, const Difference& z) {
  double total = 0;
  for (int k = 0; k < 3; ++k) {
    Point a = x.rounded, b = y.rounded, c = z.rounded;
    a[k] = x.rest[k];
    b[k] = y.rest[k];
    c[k] = z.rest[k];
    total += determinant(a, b, c);
  }
  return total;
}

}  // namespace orient3d_stages
}  // namespace convexact
