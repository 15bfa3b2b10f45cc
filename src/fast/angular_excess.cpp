// SPDX-License-Identifier: MIT
#include "fast/angular_excess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fast/metric_cost.hpp"

namespace convexact {
namespace {

constexpr double kNoUpperEnd = std::numeric_limits<double>::infinity();

// The coefficients of psi(a) = alpha / sin alpha - 1 = sum of c_n a^n in a = 1 - cos alpha, for
// n >= 1: c_n = product of k / (2k + 1) for k <= n. All series here have a <= 1/8 and coefficients
// that fall by more than half each: what is cut off of g or q after n terms is below (a / 2)^n a.
// g(a) = 1 - alpha cot alpha = a - psi(a) (1 - a): coefficient c_(n-1) - c_n, all positive.
// q(c) = c + c psi(c) - 2 psi(c): coefficient c_(n-1) / (2n + 1), all positive.
template <class Scalar, int kTerms>
struct Coefficients {
  std::array<Scalar, kTerms + 1> psi{}, g{}, q{};
  constexpr Coefficients() {
    psi[0] = 1.0;
    for (int n = 1; n <= kTerms; ++n) {
      psi[n] = psi[n - 1] * Scalar(n) / Scalar(2 * n + 1);
      g[n] = psi[n - 1] - psi[n];
      q[n] = psi[n - 1] / Scalar(2 * n + 1);
    }
  }
};

// Enough terms for the longest chord, of a = 1/8, and for short ones: what is cut off is less than
// an eighth of the unit.
template <class Scalar>
struct Series;

template <>
struct Series<double> {
  static constexpr int kTerms = 14;
  static constexpr Coefficients<double, kTerms> kCoefficients{};
  static int terms_for(double a) { return a <= 0x1p-13 ? 4 : a <= 0x1p-6 ? 8 : kTerms; }
};
static_assert(4 * 14 >= 56 && 8 * 7 >= 56 && Series<double>::kTerms * 4 >= 56);

template <>
struct Series<DoubleDouble> {
  static constexpr int kTerms = 23;
  static constexpr Coefficients<DoubleDouble, kTerms> kCoefficients{};
  static int terms_for(double a) { return a <= 0x1p-13 ? 7 : a <= 0x1p-6 ? 13 : kTerms; }
};
static_assert(Roundoff<double>::kUnit == 0x1p-53 && Roundoff<DoubleDouble>::kUnit == 0x1p-86);
static_assert(7 * 14 >= 89 && 13 * 7 >= 89 && Series<DoubleDouble>::kTerms * 4 >= 89);

template <class Scalar, std::size_t kSize>
Scalar without_constant(const std::array<Scalar, kSize>& coefficients, int terms, const Scalar& a) {
  Scalar sum = coefficients[terms];
  for (int n = terms - 1; n >= 1; --n) sum = sum * a + coefficients[n];
  return sum * a;
}

// (psi(a) - psi(b)) / (a - b): sum of c_n h_(n-1)(a, b), h_m the sum of all a^j b^(m-j).
template <class Scalar>
Scalar divided_psi(int terms, const Scalar& a, const Scalar& b) {
  const auto& psi = Series<Scalar>::kCoefficients.psi;
  Scalar sum = psi[1], homogeneous = 1.0, power = 1.0;
  for (int n = 2; n <= terms; ++n) {
    power = power * b;
    homogeneous = homogeneous * a + power;
    sum += psi[n] * homogeneous;
  }
  return sum;
}

// (E6) Versines a = 1 - cos theta_ix, b of theta_iy, c of theta_xy, rho the longest chord, <= 1/2,
// u the unit. With alpha cos A = (alpha / sin alpha) (cos beta - cos alpha cos theta) / sin theta,
//   sin theta f = c (g(a) + g(b)) - c q(c) - psi[a, b] (a - b)^2,
// and a - b = -(y - x).(to_x + to_y) / 2 is never formed as a difference. Let d be the chord of x
// and y, and write e for 16u, the error of a difference of two directions.
// - From the directions: a is off by e rho and c by e d, g' <= 0.7 and g <= 0.7 a: the first term
//   changes by (d^2 / 2) 0.7 * 2 e rho + e d * 0.7 rho^2 <= 1.4 e d rho^2 (d <= 2 rho, d^2 rho
//   / 2 * 1.4 <= 0.7 d rho^2 as d <= rho); q' <= 0.4, q <= 0.2 c: the second by
//   (e d)(0.1 d^2) + (d^2 / 2)(0.4 e d) <= 0.3 e d rho^2; a - b by e rho from the first factor and
//   e d from the second, |a - b| <= d rho, psi[a, b] <= 0.38, its change below 0.2 e rho:
//   0.38 * 2 d rho (e rho + e d) + ... <= 1.6 e d rho^2. Together 3.3 e d rho^2 < 53u d rho^2.
// - From rounding: differences by u, so a, b, c by 5u, series by 3u more, products by 4u: 12u of
//   terms of at most 0.35 d^2 rho^2, 0.05 d^4, and of |a - b| 6u d rho: less than
//   (0.5 * 12 + 0.38 * 2 * 6 + ...) u d rho^2 / 1 <= 10u d rho^2.
// - From what is cut off: of g and q u / 8 of the terms; of psi[a, b], whose terms have a factor n
//   more, less than u / 4; together below u d rho^2.
constexpr double kFromDirections = 53, kFromRounding = 10, kFromSeries = 1, kNearExcessError = 72;
static_assert(kFromDirections + kFromRounding + kFromSeries < kNearExcessError);
static_assert(DualNormals::kDirectionError <= 8);
constexpr double kNear = 0.5;

template <class Scalar>
Scalar near_excess(const Scalar& a, const Scalar& b, const Scalar& c, const Triple<Scalar>& to_x,
                   const Triple<Scalar>& to_y, const Triple<Scalar>& across) {
  const auto& series = Series<Scalar>::kCoefficients;
  const int terms = Series<Scalar>::terms_for(std::max({leading(a), leading(b), leading(c)}));
  const Triple<Scalar> twice_mean{to_x.x + to_y.x, to_x.y + to_y.y, to_x.z + to_y.z};
  const Scalar difference = dot(across, twice_mean) * Scalar(0.5);
  return c * (without_constant(series.g, terms, a) + without_constant(series.g, terms, b) -
              without_constant(series.q, terms, c)) -
         divided_psi(terms, a, b) * difference * difference;
}

// The chords themselves have errors, too, which hardly widen the bound.
double near_excess_error(double squared_chord, double largest, double unit) {
  const double chord = std::sqrt(squared_chord) + kChordError * unit;
  return kNearExcessError * unit * chord * (2 * largest + kChordError * unit);
}

// Assumption on the C library: asin is off by at most this many units in the last place, of 2u.
constexpr double kArcSine = 4;

// The same for larger angles, up to 120 degrees, from chords s: alpha = 2 asin(s / 2), sin alpha =
// s sqrt(1 - s^2 / 4), cos alpha = 1 - s^2 / 2, with s <= sqrt(3). A chord is off by 24u, so a
// cosine by 42u, an angle by 48u, and alpha / sin alpha <= 2.42, which grows by at most 5.1 per
// unit of s, by 123u; asin and four operations add a relative (2 kArcSine + 4)u to either. Each
// product (alpha / sin alpha) (cos - cos cos), whose second factor is at most 1.5, is off by
// 155u * 1.5 + 2.42 (42u * 3 + 4u) < 550u; theta sin theta, theta <= 2.1, by
// (48u + 26u) + 2.1 * 52u < 200u.
constexpr double kOfFar = 2 * 550 + 200, kFarExcessError = 1344;
static_assert(kOfFar < kFarExcessError);
static_assert(123 + 2.42 * (2 * kArcSine + 4) < 155 && 2.1 * (2 * kArcSine + 4) < 26);

// The same up to 176 degrees. Let h = cos(alpha / 2) of the widest angle, so that sin alpha = s h
// and s <= 2. A chord is off by 24u, a cosine by 56u, an angle by 65u / h; alpha / sin alpha, at
// most pi / h, grows by at most pi / h^3 per unit of s, and is off by 24 pi u / h^3 and its
// rounding, 40u / h. The second factors are at most 2, off by 3 * 56u + 4u; theta sin theta is off
// by 65u / h + pi 28u / h.
constexpr double kPi = 3.15;  // not less
constexpr double kOfWide = 2 * (2 * (24 * kPi + 40) + kPi * (3 * 56 + 4)) + 65 + 28 * kPi;
constexpr double kWideExcessError = 1728, kLeastSquaredHalf = 0x1p-10;
static_assert(kOfWide < kWideExcessError);

double far_excess(double a, double b, double c) {
  const auto angle = [](double versine) { return 2 * std::asin(std::sqrt(versine / 2)); };
  const auto sine = [](double versine) { return std::sqrt(versine * (2 - versine)); };
  const auto per_sine = [&](double versine) {
    return versine < 0x1p-60 ? 1 : angle(versine) / sine(versine);
  };
  const double cos_a = 1 - a, cos_b = 1 - b, cos_c = 1 - c;
  return angle(c) * sine(c) - per_sine(a) * (cos_b - cos_a * cos_c) -
         per_sine(b) * (cos_a - cos_b * cos_c);
}

struct Excess {
  double value, error;
};

// The error is infinite where two normals are too close to opposite for a bound.
Excess excess_of(const Triple<double>& to_x, const Triple<double>& to_y,
                 const Triple<double>& across) {
  constexpr double kWidest = 1.5;  // a versine of 120 degrees
  const double a = dot(to_x, to_x) / 2, b = dot(to_y, to_y) / 2;
  const double squared = dot(across, across), c = squared / 2;
  const double largest = std::max({a, b, c});
  if (!(2 * largest <= kNear * kNear)) {
    const double excess = far_excess(a, b, c), squared_half = 1 - largest / 2;
    if (largest <= kWidest) return {excess, kFarExcessError * kUnitRoundoff};
    if (!(squared_half >= kLeastSquaredHalf)) return {excess, kNoUpperEnd};
    return {excess, kWideExcessError * kUnitRoundoff / (squared_half * std::sqrt(squared_half))};
  }
  return {near_excess(a, b, c, to_x, to_y, across),
          near_excess_error(squared, largest, kUnitRoundoff)};
}

}  // namespace

Interval<double> angular_excess(const Triple<double>& to_x, const Triple<double>& to_y,
                                const Triple<double>& across) {
  const auto [excess, error] = excess_of(to_x, to_y, across);
  if (!(error < kNoUpperEnd)) return {0, kNoUpperEnd};
  return {std::max(excess - error, 0.0), std::max(excess, 0.0) + error};
}

Interval<DoubleDouble> angular_excess(const Triple<DoubleDouble>& to_x,
                                      const Triple<DoubleDouble>& to_y,
                                      const Triple<DoubleDouble>& across) {
  const DoubleDouble half = 0.5, squared = dot(across, across);
  const DoubleDouble a = dot(to_x, to_x) * half, b = dot(to_y, to_y) * half, c = squared * half;
  const double largest = std::max({a.hi(), b.hi(), c.hi()});
  if (!(2 * largest <= kNear * kNear)) return {0.0, kNoUpperEnd};
  const DoubleDouble excess = near_excess(a, b, c, to_x, to_y, across);
  const double error = near_excess_error(squared.hi(), largest, Roundoff<DoubleDouble>::kUnit);
  const DoubleDouble lower = excess - error;
  return {is_positive(lower) ? lower : 0.0, (is_positive(excess) ? excess : 0.0) + error};
}

double rounded_angular_excess(const Triple<double>& to_x, const Triple<double>& to_y,
                              const Triple<double>& across) {
  return excess_of(to_x, to_y, across).value;
}

}  // namespace convexact
