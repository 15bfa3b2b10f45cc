// SPDX-License-Identifier: MIT
// The error bounds are (E1), (E2), (E3), (E6) and (E7) of MetricCost with the unit of
// double-doubles: what they assume is the error of an operation, at most u, and that of a
// coordinate, at most 2 u.
#include "fast/long_metric.hpp"

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

DoubleDouble not_negative(const DoubleDouble& x) { return is_positive(x) ? x : 0.0; }

void add(const Interval<DoubleDouble>& term, Interval<DoubleDouble>& sum) {
  sum.lower += term.lower;
  sum.upper += term.upper;
}

}  // namespace

LongMetric::Normal LongMetric::normal(HalfspaceId i) const {
  Triple<DoubleDouble> p = dual_.long_point_in_callers_frame(i);
  const double largest = std::max({std::abs(p.x.hi()), std::abs(p.y.hi()), std::abs(p.z.hi())});
  if (!(largest > 0) || std::ilogb(largest) < DualNormals::kLeastExponent) return {false, {}, {}};
  const int exponent = std::ilogb(largest);
  for (int k = 0; k < 3; ++k) p[k] = scaled(p[k], -exponent);
  const DoubleDouble length = root(dot(p, p));
  return {true, {p.x / length, p.y / length, p.z / length}, scaled(length, exponent)};
}

// @return  Whether all directions are known.
bool LongMetric::load(HalfspaceId i, std::span<const HalfspaceId> ring) {
  const Normal center = normal(i);
  ring_.clear();
  for (const HalfspaceId q : ring) {
    const Normal side = normal(q);
    if (!center.is_known || !side.is_known) return false;
    ring_.push_back({side, side.direction - center.direction});
  }
  return true;
}

LongMetric::Number LongMetric::area(std::span<const RingTriangle> triangles,
                                    Determinants& determinants) {
  sides_.assign(ring_.size(), {0.0, 0.0});
  for_each_side_part(roof_, static_cast<std::uint32_t>(ring_.size()), triangles, determinants,
                     [&](std::uint32_t side, const Number& part) { add(part, sides_[side]); });
  Number sum{0.0, 0.0};
  for (std::size_t m = 0; m < ring_.size(); ++m) {
    const auto& [normal, from_i] = ring_[m];
    const DoubleDouble squared = dot(from_i, from_i), versine = squared * DoubleDouble(0.5);
    const DoubleDouble error = versine_error(std::sqrt(squared.hi()), kLongUnit);
    const DoubleDouble least = versine - error;
    add(sides_[m] * Number{normal.length * not_negative(least), normal.length * (versine + error)},
        sum);
  }
  return sum;
}

LongMetric::Number LongMetric::mean_width(std::span<const RingTriangle> triangles,
                                          Determinants& determinants) {
  Number sum{0.0, 0.0};
  roof_.for_each_edge(static_cast<std::uint32_t>(ring_.size()), triangles, determinants,
                      [&](std::uint32_t x, std::uint32_t y, const Number& lambda) {
                        const Side &p = ring_[x], &q = ring_[y];
                        const DoubleDouble lengths = p.normal.length * q.normal.length;
                        const Number excess = angular_excess(
                            p.from_i, q.from_i, q.normal.direction - p.normal.direction);
                        add(lambda * Number{lengths * excess.lower, lengths * excess.upper}, sum);
                      });
  return sum;
}

CostBounds<DoubleDouble> LongMetric::bounds(const RingGeometry<DoubleDouble>& geometry,
                                            HalfspaceId i, std::span<const HalfspaceId> ring,
                                            std::span<const RingTriangle> triangles) {
  if (!load(i, ring)) return CostBounds<DoubleDouble>::doubtful();
  Determinants determinants(geometry, kLongUnit);
  const Number sum = measure_ == CostMeasure::Area ? area(triangles, determinants)
                                                   : mean_width(triangles, determinants);
  if (!determinants.is_certain() || !std::isfinite(sum.upper.hi())) {
    return CostBounds<DoubleDouble>::doubtful();
  }
  static_assert(ExponentRange<DoubleDouble>::kVolumeUnderflow ==
                ExponentRange<double>::kVolumeUnderflow);
  const double tiny = ExponentRange<DoubleDouble>::kVolumeUnderflow;
  // Of the terms, and of their sum: for each ring plane a side, or less than two roof edges.
  const std::size_t k = ring.size();
  const double slop = sum_slop(kOfTerm + k, kLongUnit) + sum_slop(2 * k, kLongUnit);
  const DoubleDouble lower = sum.lower * (DoubleDouble(1.0) - slop) - tiny;
  return {Boundedness::Bounded, not_negative(lower), sum.upper * (DoubleDouble(1.0) + slop) + tiny};
}

}  // namespace convexact
