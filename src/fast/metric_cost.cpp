// SPDX-License-Identifier: MIT
#include "fast/metric_cost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// (E2) The chord |m - n| between two directions, at most 2. The directions are off by 8u each;
// their differences are rounded by u relative, squares and sums by 3u, halved by the root, which
// adds u: 16u + 3.5u * 2.
constexpr double kOfChord = 2 * DualNormals::kDirectionError + 3.5 * 2;
static_assert(kOfChord < kChordError);

}  // namespace

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
    const double length = std::sqrt(dot(q, q));
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
    const double squared = dot(from_i, from_i);
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
  if (!is_certain) return {Boundedness::Doubtful, lower, std::numeric_limits<double>::infinity()};
  return {Boundedness::Bounded, lower,
          sum.upper * (1 + of_terms + sum_slop(terms_.size(), kUnitRoundoff)) + kTiny};
}

}  // namespace convexact
