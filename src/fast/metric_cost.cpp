// SPDX-License-Identifier: MIT
#include "fast/metric_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "number/arithmetic.hpp"

namespace convexact {
namespace {

constexpr double kNoUpperEnd = std::numeric_limits<double>::infinity();

// (E2) The chord |m - n| between two directions, at most 2. The directions are off by 8u each;
// their differences are rounded by u relative, squares and sums by 3u, halved by the root, which
// adds u: 16u + 3.5u * 2.
constexpr double kOfChord = 2 * DualNormals::kDirectionError + 3.5 * 2;
static_assert(kOfChord < kChordError);

double dot_of(const Triple<double>& a, const Triple<double>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// The coefficients of psi(a) = alpha / sin alpha - 1 = sum of c_n a^n in a = 1 - cos alpha, for
// n = 1 to kTerms: c_n = product of k / (2k + 1) for k <= n. All series here have a_max <= 1/8 and
// coefficients that fall by more than half each: what is cut off is less than (1/16)^kTerms a,
// below 2^-55 a.
constexpr int kTerms = 14;
constexpr std::array<double, kTerms + 1> psi_coefficients() {
  std::array<double, kTerms + 1> c{1};
  for (int n = 1; n <= kTerms; ++n) c[n] = c[n - 1] * n / (2 * n + 1);
  return c;
}
constexpr std::array<double, kTerms + 1> kPsi = psi_coefficients();

// How many terms suffice for versines of at most `a`, with the same remainder.
int terms_for(double a) { return a <= 0x1p-13 ? 4 : a <= 0x1p-6 ? 8 : kTerms; }

// g(a) = 1 - alpha cot alpha = a - psi(a) (1 - a): coefficient c_(n-1) - c_n, all positive.
// q(c) = c + c psi(c) - 2 psi(c): coefficient c_(n-1) / (2n + 1), all positive.
struct Coefficients {
  std::array<double, kTerms + 1> g{}, q{};
  constexpr Coefficients() {
    for (int n = 1; n <= kTerms; ++n) {
      g[n] = kPsi[n - 1] - kPsi[n];
      q[n] = kPsi[n - 1] / (2 * n + 1);
    }
  }
};
constexpr Coefficients kSeries;

double without_constant(const std::array<double, kTerms + 1>& coefficients, int terms, double a) {
  double sum = coefficients[terms];
  for (int n = terms - 1; n >= 1; --n) sum = sum * a + coefficients[n];
  return sum * a;
}

// (psi(a) - psi(b)) / (a - b): sum of c_n h_(n-1)(a, b), h_m the sum of all a^j b^(m-j).
double divided_psi(int terms, double a, double b) {
  double sum = kPsi[1], homogeneous = 1, power = 1;
  for (int n = 2; n <= terms; ++n) {
    power *= b;
    homogeneous = homogeneous * a + power;
    sum += kPsi[n] * homogeneous;
  }
  return sum;
}

// (E6) Versines a = 1 - cos theta_ix, b of theta_iy, c of theta_xy, rho the longest chord, <= 1/2.
// With alpha cos A = (alpha / sin alpha) (cos beta - cos alpha cos theta) / sin theta,
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
// - From what is cut off: 2^-55 of the terms, below u d rho^2.
constexpr double kFromDirections = 53, kFromRounding = 10, kFromSeries = 1, kNearExcessError = 72;
static_assert(kFromDirections + kFromRounding + kFromSeries < kNearExcessError);
constexpr double kNear = 0.5;

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

double near_excess(double a, double b, double c, const Triple<double>& to_x,
                   const Triple<double>& to_y, const Triple<double>& across) {
  const int terms = terms_for(std::max({a, b, c}));
  const Triple<double> twice_mean{to_x.x + to_y.x, to_x.y + to_y.y, to_x.z + to_y.z};
  const double difference = dot_of(across, twice_mean) / 2;
  return c * (without_constant(kSeries.g, terms, a) + without_constant(kSeries.g, terms, b) -
              without_constant(kSeries.q, terms, c)) -
         divided_psi(terms, a, b) * difference * difference;
}

struct Excess {
  double value, error;
};

// The error is infinite where two normals are too close to opposite for a bound.
Excess excess_of(const Triple<double>& to_x, const Triple<double>& to_y,
                 const Triple<double>& across) {
  constexpr double kWidest = 1.5;  // a versine of 120 degrees
  const double a = dot_of(to_x, to_x) / 2, b = dot_of(to_y, to_y) / 2;
  const double squared = dot_of(across, across), c = squared / 2;
  const double largest = std::max({a, b, c});
  if (!(2 * largest <= kNear * kNear)) {
    const double excess = far_excess(a, b, c), squared_half = 1 - largest / 2;
    if (largest <= kWidest) return {excess, kFarExcessError * kUnitRoundoff};
    if (!(squared_half >= kLeastSquaredHalf)) return {excess, kNoUpperEnd};
    return {excess, kWideExcessError * kUnitRoundoff / (squared_half * std::sqrt(squared_half))};
  }
  // The chords themselves have errors, too, which hardly widen the bound.
  const double chord = std::sqrt(squared) + kChordError * kUnitRoundoff;
  return {near_excess(a, b, c, to_x, to_y, across),
          kNearExcessError * kUnitRoundoff * chord * (2 * largest + kChordError * kUnitRoundoff)};
}

}  // namespace

Interval<double> angular_excess(const Triple<double>& to_x, const Triple<double>& to_y,
                                const Triple<double>& across) {
  const auto [excess, error] = excess_of(to_x, to_y, across);
  if (!(error < kNoUpperEnd)) return {0, kNoUpperEnd};
  return {std::max(excess - error, 0.0), std::max(excess, 0.0) + error};
}

double rounded_angular_excess(const Triple<double>& to_x, const Triple<double>& to_y,
                              const Triple<double>& across) {
  return excess_of(to_x, to_y, across).value;
}

DualNormals::DualNormals(const FastDual& dual) {
  normals_.reserve(dual.size());
  for (std::size_t i = 0; i < dual.size(); ++i) {
    const Triple<double> p = dual.in_callers_frame(HalfspaceId(i));
    const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const int exponent = std::ilogb(largest);
    if (!(largest > 0) || exponent < kLeastExponent) {
      constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
      normals_.push_back({{kNaN, kNaN, kNaN}, kNaN});
      continue;
    }
    const auto scaled = [&](double x) { return std::ldexp(x, -exponent); };
    const Triple<double> q{scaled(p.x), scaled(p.y), scaled(p.z)};
    const double length = std::sqrt(dot_of(q, q));
    normals_.push_back({{q.x / length, q.y / length, q.z / length}, std::ldexp(length, exponent)});
  }
}

void MetricCost::load(HalfspaceId i, std::span<const HalfspaceId> ring) {
  const Triple<double>& normal = normals_[i].direction;
  ids_ = ring;
  ring_.clear();
  terms_.clear();
  for (const HalfspaceId q : ring) {
    const Triple<double> from_i = normals_[q].direction - normal;
    const double squared = dot_of(from_i, from_i);
    ring_.push_back({from_i, squared / 2, std::sqrt(squared), normals_[q].length});
  }
}

// |P_q| (1 - cos theta_iq), by which a side's sum counts for twice the area.
Interval<double> MetricCost::weight(const Direction& q) const {
  const double error = versine_error(q.chord, kUnitRoundoff);
  return {q.length * std::max(q.versine - error, 0.0), q.length * (q.versine + error)};
}

namespace {

constexpr double kTiny = ExponentRange<double>::kVolumeUnderflow;

}  // namespace

double MetricCost::lower_bound(std::span<const LastingTerm> terms) {
  double sum = 0;
  for (const LastingTerm& term : terms) sum += term.lower;
  return std::max(sum * (1 - sum_slop(terms.size(), kUnitRoundoff)) - kTiny, 0.0);
}

double forget_terms_of(HalfspaceId removed, std::vector<LastingTerm>& terms) {
  std::erase_if(terms, [&](const LastingTerm& t) { return t.x == removed || t.y == removed; });
  return MetricCost::lower_bound(terms);
}

// The rounding errors of the terms and of their sum.
CostBounds<double> MetricCost::widened(const Interval<double>& sum, bool is_certain) {
  // A direction that underflowed makes everything NaN.
  if (!(sum.lower >= 0)) {
    terms_.clear();
    return CostBounds<double>::doubtful();
  }
  const double of_terms = sum_slop(kOfTerm + ring_.size(), kUnitRoundoff);
  for (LastingTerm& term : terms_) term.lower *= 1 - of_terms;
  const double lower = lower_bound(terms_);
  if (!is_certain) return {Boundedness::Doubtful, lower, kNoUpperEnd};
  return {Boundedness::Bounded, lower,
          sum.upper * (1 + of_terms + sum_slop(terms_.size(), kUnitRoundoff)) + kTiny};
}

}  // namespace convexact
