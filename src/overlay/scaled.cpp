// SPDX-License-Identifier: MIT
#include "overlay/scaled.hpp"

#include <algorithm>
#include <cmath>

#include "task/parallel.hpp"

namespace convexact {

Halfspace wall(const HomogeneousPoint& p, const HomogeneousPoint& q, const IntegerVector3& normal) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (abs(normal[k]) > abs(normal[axis])) axis = k;
  }
  // (e x axis).c = -(e x c).axis, so with the normal along the axis the left side is inside.
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  IntegerVector3 outward = IntegerVector3::Zero();
  outward[u] = q.n[v] * p.w - p.n[v] * q.w;
  outward[v] = p.n[u] * q.w - q.n[u] * p.w;
  if (normal[axis] < 0) outward = -outward;
  return {IntegerVector3(outward * p.w), Integer(-dot(outward, p.n))};
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

// x 2^-exponent, off by a relative 5 u to first order: numerator and denominator by 2 u each, as
// they are cut off, and their quotient by u. A number that underflows is off by 2^-1074.
double scaled(const Rational& x, long exponent) {
  const auto* q = x.backend().data();
  if (mpq_sgn(q) == 0) return 0;
  long top = 0, bottom = 0;
  const double n = mpz_get_d_2exp(&top, mpq_numref(q)), d = mpz_get_d_2exp(&bottom, mpq_denref(q));
  return std::ldexp(n / d, static_cast<int>(std::max(top - bottom - exponent, -3000L)));
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
    const double error = 8 * kUnitRoundoff * std::abs(near_[i][k]) + 0x1p-1070;
    box.low[k] = near_[i][k] - error;  // the roundings here need less than the rest of 8 u
    box.high[k] = near_[i][k] + error;
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
  // To first order a product is off by 8 u of itself (2 u from n, 5 u from x, u from rounding), d
  // by 2 u, and the sums by 3 u of all: 11 u. What underflows loses less than 2^-1073 each, as
  // other factors are at most 1. An infinite d makes the bound infinite.
  const Point& x = points.near(i);
  const double a = near_[0] * x[0], b = near_[1] * x[1], c = near_[2] * x[2], d = near_[3];
  const double value = ((a + b) + c) + d;
  const double bound =
      16 * kUnitRoundoff * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d)) + 0x1p-990;
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

Holders::Holders(const ScaledPoints& points, std::span<const LaidPart> parts, const BoxTree& tree,
                 const Watch& watch, std::size_t jobs)
    : holders_(points.size()) {
  const auto find = [&](std::size_t i, std::vector<std::uint32_t>& near) {
    tree.find(points.box(i), near);
    for (const std::uint32_t p : near) {
      bool is_held = true;
      for (std::size_t h = 0; h < parts[p].planes.size() && is_held; ++h) {
        is_held = parts[p].side(h, points, i) != Sign::Positive;
      }
      if (is_held) holders_[i].push_back(p);
    }
  };
  constexpr std::size_t kTogether = 256;
  for_each_in_parallel((points.size() + kTogether - 1) / kTogether, jobs, [&](std::size_t block) {
    watch.ask();
    std::vector<std::uint32_t> near;
    const std::size_t end = std::min(points.size(), (block + 1) * kTogether);
    for (std::size_t i = block * kTogether; i < end; ++i) find(i, near);
  });
}

bool Holders::any_holds(const std::array<std::uint32_t, 3>& ids) const {
  const auto holds = [&](std::uint32_t point, std::uint32_t part) {
    return std::binary_search(holders_[point].begin(), holders_[point].end(), part);
  };
  return std::any_of(holders_[ids[0]].begin(), holders_[ids[0]].end(), [&](std::uint32_t part) {
    return holds(ids[1], part) && holds(ids[2], part);
  });
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
