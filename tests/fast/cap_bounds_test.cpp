// SPDX-License-Identifier: MIT
// The enclosures of caps at the worst dual points that a search finds: never broken, by the formula
// in rationals, and so close to it that one of a sixteenth of their size would be.
#include <doctest/doctest.h>

#include "fast/cap_volume.hpp"
#include "hill_climb.hpp"

using namespace convexact;

namespace {

constexpr double kUnit = Roundoff<double>::kUnit;

template <class Number>
Triple<Number> corner(const std::vector<Number>& x, std::size_t p) {
  return {x[3 * p], x[3 * p + 1], x[3 * p + 2]};
}
template <class Number>
Number det(const Triple<Number>& a, const Triple<Number>& b, const Triple<Number>& c) {
  return dot(cross(a, b), c);
}

// A dual point near (1, 1, 1), where roundoff is largest, and a ring of three or four around it.
struct Site {
  double size;
  double play;                          // of the offsets
  std::vector<Triple<double>> offsets;  // of the ring from the dual point, in sizes

  std::size_t valence() const { return offsets.size(); }
  std::size_t numbers() const { return 3 * (valence() + 1); }
  std::vector<RingTriangle> triangles() const {
    if (valence() == 3) return {{0, 1, 2, kNone}};
    return {{0, 2, 3, kNone}, {0, 1, 2, 0}};
  }
  // Coordinates from numbers in [-1, 1].
  std::vector<double> coordinates(const std::vector<double>& x) const {
    std::vector<double> points = {0.875 + 0.125 * x[0], 0.875 + 0.125 * x[1], 0.875 + 0.125 * x[2]};
    for (std::size_t m = 0, k = 3; m < valence(); ++m) {
      for (const double offset : {offsets[m].x, offsets[m].y, offsets[m].z}) {
        points.push_back(points[k % 3] + size * (offset + play * x[k]));
        ++k;
      }
    }
    return points;
  }

  // Six times the cap, the sum of H^3 / (D D D D) over the triangles.
  template <class Number>
  Number cap(const std::vector<Number>& x) const {
    const Triple<Number> i = corner(x, 0);
    Number sum = 0;
    for (const RingTriangle& t : triangles()) {
      const auto a = corner(x, 1 + t.low), b = corner(x, 1 + t.middle), c = corner(x, 1 + t.high);
      const Number height = dot(cross(b - a, c - a), i - a);
      sum += height * height * height / (det(a, b, c) * det(i, a, b) * det(i, b, c) * det(i, c, a));
    }
    return sum;
  }

  // Whether the solid around the origin is convex with the dual point and without.
  bool is_convex(const std::vector<Rational>& x) const {
    const Triple<Rational> i = corner(x, 0);
    const auto ring = [&](std::size_t m) { return corner(x, 1 + m % valence()); };
    for (std::size_t m = 0; m < valence(); ++m) {
      const auto a = ring(m), b = ring(m + 1);
      if (det(i, a, b) <= 0) return false;
      for (std::size_t q = m + 2; q < m + valence(); ++q) {
        if (dot(cross(a - i, b - i), ring(q) - i) >= 0) return false;
      }
    }
    for (const RingTriangle& t : triangles()) {
      const auto a = ring(t.low), b = ring(t.middle), c = ring(t.high);
      if (det(a, b, c) <= 0 || dot(cross(b - a, c - a), i - a) <= 0) return false;
      for (std::size_t q = 0; q < valence(); ++q) {
        if (dot(cross(b - a, c - a), ring(q) - a) > 0) return false;
      }
    }
    return true;
  }
};

// The true points that fit rounded ones worst: with the least cap, and with the largest.
std::array<std::vector<Rational>, 2> worst_points(const Site& site, const std::vector<double>& x) {
  const Rational error = to_rational(2 * kUnit);
  const std::vector<long double> at(x.begin(), x.end());
  std::array<std::vector<Rational>, 2> ends;
  for (std::size_t k = 0; k < x.size(); ++k) {
    std::vector<long double> moved = at;
    moved[k] *= 1 + 0x1p-36L;
    const int slope = site.cap(moved) < site.cap(at) ? -1 : 1;
    ends[0].push_back(to_rational(x[k]) * (1 - slope * error));
    ends[1].push_back(to_rational(x[k]) * (1 + slope * error));
  }
  return ends;
}

// How far the worst caps are from the middle of the enclosure, in its half widths.
double reached(const Site& site, const std::vector<double>& x, const CostBounds<double>& bounds) {
  if (bounds.kind != Boundedness::Bounded || bounds.lower <= 0) return 0;
  const auto [least, most] = worst_points(site, x);
  if (!site.is_convex(least) || !site.is_convex(most)) return 0;
  const Rational lower = to_rational(bounds.lower), upper = to_rational(bounds.upper);
  const Rational middle = (lower + upper) / 2;
  const Rational farthest =
      std::max(Rational(middle - site.cap(least)), Rational(site.cap(most) - middle));
  return Rational(farthest / ((upper - lower) / 2)).convert_to<double>();
}

RingGeometry<double> geometry_of(const Site& site, const std::vector<double>& x) {
  std::vector<std::size_t> ring;
  for (std::size_t m = 1; m <= site.valence(); ++m) ring.push_back(m);
  RingGeometry<double> geometry;
  geometry.load(std::size_t{0}, ring, [&](std::size_t p) { return corner(x, p); });
  return geometry;
}

CostBounds<double> by_signed_sum(const RingGeometry<double>& ring, const Site& site) {
  return LawrenceSum<double>().run(ring, site.triangles(), kUnit);
}
CostBounds<double> by_products(const RingGeometry<double>& ring, const Site& site) {
  IntervalDeterminants<double> determinants(ring, kUnit);
  CapVolume<IntervalDeterminants<double>> volume;
  const auto k = static_cast<std::uint32_t>(site.valence());
  return determinants.widened(volume.six_times(k, site.triangles(), determinants));
}

template <class Enclose>
double highest(const Site& site, int climbs, int tries, Enclose&& enclose) {
  return hill_climb::highest(site.numbers(), climbs, tries, 1, [&](const std::vector<double>& x) {
    const std::vector<double> points = site.coordinates(x);
    return reached(site, points, enclose(geometry_of(site, points), site));
  });
}

// A dual point that is hardly above its ring: heights are uncertain.
const Site kFlat{0x1p-13, 0.25, {{0.75, -1.25, -0.25}, {-0.25, 0.75, -1.25}, {-1.25, -0.25, 0.75}}};
// Two of the triangles at the dual point are seen nearly edge-on from the origin: determinants are.
const Site kSteep{
    0x1p-13,
    0x1p-10,
    {{0.75, -1.25, 0.5}, {-1 + 0x1p-9, -1 + 0x1p-9, -1 - 0x1p-8}, {-1.25, 0.75, 0.5}}};
// A quadrilateral that is folded along a diagonal, by a little.
const Site kFolded{
    0x1p-13,
    0.25,
    {{0.75, -1.25, -0.25}, {0.125, 0.125, -1.375}, {-1.25, 0.75, -0.25}, {-0.875, -0.875, 0.625}}};

}  // namespace

TEST_CASE("LawrenceSum: the bound holds for the worst dual points found, and is not vacuous") {
  const double flat = highest(kFlat, 4, 200, by_signed_sum),
               steep = highest(kSteep, 4, 100, by_signed_sum),
               folded = highest(kFolded, 4, 100, by_signed_sum);
  MESSAGE("of the bound is reached: flat " << flat << ", steep " << steep << ", folded " << folded);
  CHECK(flat > 1.0 / 16);
  for (const double reached : {flat, steep, folded}) CHECK(reached <= 1);
}

TEST_CASE(
    "IntervalDeterminants: the bounds hold for the worst dual points found, and are not vacuous") {
  const double flat = highest(kFlat, 4, 200, by_products),
               steep = highest(kSteep, 4, 200, by_products),
               folded = highest(kFolded, 4, 200, by_products);
  MESSAGE("of the bound is reached: flat " << flat << ", steep " << steep << ", folded " << folded);
  CHECK(flat > 1.0 / 16);
  CHECK(steep > 1.0 / 16);
  for (const double reached : {flat, steep, folded}) CHECK(reached <= 1);
}
