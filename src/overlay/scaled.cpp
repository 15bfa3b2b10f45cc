// SPDX-License-Identifier: MIT
#include "overlay/scaled.hpp"

#include <algorithm>
#include <cmath>

namespace convexact {

HomogeneousPoint homogeneous(const RationalPoint& p) {
  IntegerFraction cleared = clear_denominators(p);
  return {std::move(cleared.x), std::move(cleared.d)};
}

long common_exponent(std::span<const BoundingBox> boxes) {
  std::optional<long> largest;
  for (const BoundingBox& box : boxes) {
    const Rational x = box.largest_coordinate();
    if (x != 0) largest = std::max(largest.value_or(exponent_of(x)), exponent_of(x));
  }
  return largest.value_or(0);
}

namespace {

// x 2^-exponent rounded to nearest.
double scaled(const Rational& x, long exponent) {
  return to_double(scale_by_power_of_two(x, -exponent), Rounding::Nearest);
}

Point scaled(const RationalPoint& p, long exponent) {
  return {scaled(p[0], exponent), scaled(p[1], exponent), scaled(p[2], exponent)};
}

}  // namespace

ScaledPoints::ScaledPoints(const PointSet& points, long exponent)
    : set_(&points), near_(points.size()), exact_(points.size()) {
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (!points.is_binary()) {
      near_[i] = scaled(points[PointId(i)], exponent);
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      near_[i][k] = std::ldexp(points.doubles()[i][k], static_cast<int>(-exponent));
    }
  }
}

ScaledPoints::ScaledPoints(std::span<const RationalPoint> points, long exponent)
    : list_(points), near_(points.size()), exact_(points.size()) {
  for (std::size_t i = 0; i < near_.size(); ++i) near_[i] = scaled(points[i], exponent);
}

NearBox ScaledPoints::box(std::size_t i) const {
  NearBox box;
  for (int k = 0; k < 3; ++k) {
    box.low[k] = std::nextafter(near_[i][k], -2.0);
    box.high[k] = std::nextafter(near_[i][k], 2.0);
  }
  return box;
}

ScaledPlane::ScaledPlane(const Halfspace& plane, long exponent) {
  const IntegerVector3& n = plane.normal();
  std::array<double, 4> part{};
  std::array<long, 4> power{};
  long top = std::numeric_limits<long>::min();
  for (int k = 0; k < 3; ++k) {
    if (n[k].is_zero()) continue;
    part[k] = mpz_get_d_2exp(&power[k], raw(n[k]));
    top = std::max(top, power[k]);
  }
  part[3] = mpz_get_d_2exp(&power[3], raw(plane.offset()));
  power[3] -= exponent;
  for (std::size_t k = 0; k < 4; ++k) {
    const long p = std::clamp(power[k] - top, -2000L, 2000L);  // to zero or infinity at the ends
    near_[k] = part[k] == 0 ? 0 : std::ldexp(part[k], static_cast<int>(p));
  }
}

Sign ScaledPlane::side(const Halfspace& plane, const ScaledPoints& points, std::size_t i) const {
  // To first order a product is off by 4 u of itself (2 u from n, u from x, u from rounding), d by
  // 2 u, and the sums by 3 u of all. What underflows loses less than 2^-1073 each, as other
  // factors are at most 1. An infinite d makes the bound infinite.
  const Point& x = points.near(i);
  const double a = near_[0] * x[0], b = near_[1] * x[1], c = near_[2] * x[2], d = near_[3];
  const double value = ((a + b) + c) + d;
  const double bound =
      10 * kUnitRoundoff * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d)) + 0x1p-990;
  if (value > bound) return Sign::Positive;
  if (value < -bound) return Sign::Negative;
  return sign_of(plane_value(plane, points.exact(i)));
}

LaidPart::LaidPart(const ConvexPart& convex, long exponent)
    : part(&convex), vertices(std::span(convex.vertices), exponent) {
  planes.reserve(convex.halfspaces.size());
  for (const Halfspace& h : convex.halfspaces) planes.emplace_back(h, exponent);
  for (std::size_t i = 0; i < vertices.size(); ++i) box.include(vertices.box(i));
}

Meeting meeting(const LaidPart& part, const ScaledPoints& points,
                std::span<const std::uint32_t> corners) {
  Meeting result;
  for (std::size_t h = 0; h < part.planes.size(); ++h) {
    bool is_inside = false, is_beyond = false;
    for (const std::uint32_t corner : corners) {
      const Sign s = part.side(h, points, corner);
      is_inside = is_inside || s == Sign::Negative;
      is_beyond = is_beyond || s == Sign::Positive;
      if (is_inside && is_beyond) break;
    }
    if (is_beyond && !is_inside) {
      result.kind = Meeting::Apart;
      return result;
    }
    if (is_beyond) result.planes.push_back(h);
    if (!is_beyond && !is_inside && !result.coplanar) result.coplanar = h;
  }
  result.kind = result.planes.empty() ? Meeting::Holds : Meeting::Crossing;
  return result;
}

}  // namespace convexact
