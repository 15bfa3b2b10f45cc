// SPDX-License-Identifier: MIT
// The error bounds are (E1), (E2), (E3) and (E7) of MetricCost with the unit of double-doubles:
// what they assume is the error of an operation, at most u, and that of a coordinate, at most 2 u.
#include "fast/long_area.hpp"

#include <algorithm>
#include <cmath>

namespace convexact {
namespace {

constexpr double kLongUnit = Roundoff<DoubleDouble>::kUnit;

// One step of Newton's method from s = sqrt(x) (1 + e), |e| <= 2^-52: s + (x - s^2) / (2 s) is
// sqrt(x) (1 + e^2 / (2 + 2 e)), off by less than 2^-104. The second term, at most 2^-52 sqrt(x),
// is computed in doubles, off by 2^-51 of itself.
DoubleDouble root(const DoubleDouble& x) {
  const double s = std::sqrt(x.hi());
  if (!(s > 0)) return 0.0;
  const DoubleDouble rest = x - DoubleDouble::product(s, s);
  return fast_two_sum(s, rest.hi() / (2 * s));
}
static_assert(0x1p-104 + 0x1p-103 <= kLongUnit);

DoubleDouble scaled(const DoubleDouble& x, int exponent) {
  return {std::ldexp(x.hi(), exponent), std::ldexp(x.lo(), exponent)};
}

}  // namespace

LongArea::Normal LongArea::normal(HalfspaceId i) const {
  Triple<DoubleDouble> p = dual_.long_point_in_callers_frame(i);
  const double largest = std::max({std::abs(p.x.hi()), std::abs(p.y.hi()), std::abs(p.z.hi())});
  if (!(largest > 0) || std::ilogb(largest) < DualNormals::kLeastExponent) return {false, {}, {}};
  const int exponent = std::ilogb(largest);
  for (int k = 0; k < 3; ++k) p[k] = scaled(p[k], -exponent);
  const DoubleDouble length = root(dot(p, p));
  return {true, {p.x / length, p.y / length, p.z / length}, scaled(length, exponent)};
}

CostBounds<DoubleDouble> LongArea::bounds(const RingGeometry<DoubleDouble>& geometry, HalfspaceId i,
                                          std::span<const HalfspaceId> ring,
                                          std::span<const RingTriangle> triangles) {
  using Number = Interval<DoubleDouble>;
  const std::size_t k = ring.size();
  IntervalDeterminants<DoubleDouble> determinants(geometry, kLongUnit);
  sides_.assign(k, {0.0, 0.0});
  for_each_side_part(roof_, static_cast<std::uint32_t>(k), triangles, determinants,
                     [&](std::uint32_t side, const Number& part) {
                       sides_[side].lower += part.lower;
                       sides_[side].upper += part.upper;
                     });
  const Normal center = normal(i);
  bool is_certain = determinants.is_certain() && center.is_known;
  Number sum{0.0, 0.0};
  for (std::size_t m = 0; m < k && is_certain; ++m) {
    const Normal side = normal(ring[m]);
    is_certain = side.is_known;
    const Triple<DoubleDouble> across = side.direction - center.direction;
    const DoubleDouble squared = dot(across, across), versine = squared * DoubleDouble(0.5);
    const DoubleDouble error = versine_error(std::sqrt(squared.hi()), kLongUnit);
    const DoubleDouble least = versine - error;
    const Number weight{side.length * (is_positive(least) ? least : DoubleDouble(0.0)),
                        side.length * (versine + error)};
    const Number term = sides_[m] * weight;
    sum.lower += term.lower;
    sum.upper += term.upper;
  }
  if (!is_certain) return CostBounds<DoubleDouble>::doubtful();
  static_assert(ExponentRange<DoubleDouble>::kVolumeUnderflow ==
                ExponentRange<double>::kVolumeUnderflow);
  const double tiny = ExponentRange<DoubleDouble>::kVolumeUnderflow;
  const double slop = sum_slop(kOfTerm + k, kLongUnit) + sum_slop(k, kLongUnit);
  const DoubleDouble lower = sum.lower * (DoubleDouble(1.0) - slop) - tiny;
  return {Boundedness::Bounded, is_positive(lower) ? lower : DoubleDouble(0.0),
          sum.upper * (DoubleDouble(1.0) + slop) + tiny};
}

}  // namespace convexact
