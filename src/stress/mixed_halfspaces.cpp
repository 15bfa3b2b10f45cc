// SPDX-License-Identifier: MIT
#include <array>

#include "number/random.hpp"
#include "stress/input.hpp"

namespace convexact {
namespace {

// Halfspaces n.x <= reach with the origin strictly inside.
struct Bound {
  RationalVector3 normal;
  Rational reach;
};

int exponent(Random& random, std::span<const int> largest) {
  const int most = largest[uniform_below(random, largest.size())];
  return static_cast<int>(uniform_below(random, 2 * static_cast<std::uint64_t>(most) + 1)) - most;
}

// In [-1, 1], of 53 bits or of 300 digits.
Rational number(Random& random, bool is_long) {
  if (!is_long) return to_rational(2 * uniform_unit(random) - 1);
  Integer p = 0;
  for (int k = 0; k < 16; ++k) p = p * Integer(std::uint64_t(1) << 63) + Integer(random() >> 1);
  return 2 * Rational(p, Integer(1) << (16 * 63)) - 1;
}

RationalVector3 direction(Random& random, bool is_long) {
  for (;;) {
    const RationalVector3 n(number(random, is_long), number(random, is_long),
                            number(random, is_long));
    if (!n.isZero()) return n;
  }
}

Bound some_bound(Random& random, const std::vector<Bound>& others) {
  constexpr std::array kReach{0, 0, 0, 3, 60, 500};
  constexpr std::array kTilt{1, 20, 52, 53, 120, 300};
  const bool is_long = uniform_below(random, 8) == 0;
  const Bound& other = others[uniform_below(random, others.size())];
  switch (uniform_below(random, 6)) {
    case 0:
      return other;
    case 1: {  // tilted
      const int tilt = -kTilt[uniform_below(random, kTilt.size())];
      const RationalVector3 by = direction(random, is_long);
      Bound bound = other;
      for (int k = 0; k < 3; ++k) bound.normal[k] += scale_by_power_of_two(by[k], tilt);
      if (bound.normal.isZero()) bound.normal = by;
      return bound;
    }
    case 2: {  // moved in or out
      const int share = -kTilt[uniform_below(random, kTilt.size())];
      return {other.normal,
              other.reach * (1 + scale_by_power_of_two(number(random, is_long), share - 1))};
    }
    default: {
      const Rational size = 2 + number(random, is_long);
      return {direction(random, is_long), scale_by_power_of_two(size, exponent(random, kReach))};
    }
  }
}

std::vector<Bound> box(Random& random) {
  constexpr std::array kSize{0, 0, 3, 60, 500};
  std::vector<Bound> bounds;
  for (int k = 0; k < 3; ++k) {
    for (const int side : {-1, 1}) {
      RationalVector3 normal = RationalVector3::Zero();
      normal[k] = side;
      bounds.push_back({normal, scale_by_power_of_two(1, exponent(random, kSize))});
    }
  }
  return bounds;
}

}  // namespace

std::vector<Halfspace> mixed_halfspaces(std::uint32_t parts, std::uint64_t seed) {
  constexpr std::array kAway{0, 0, 30, 300};
  Random random(seed);
  std::vector<Bound> bounds = box(random);
  for (std::uint32_t k = 0; k < 8 * parts; ++k) bounds.push_back(some_bound(random, bounds));
  RationalVector3 away = RationalVector3::Zero();
  if (uniform_below(random, 2) == 0) {
    const RationalVector3 by = direction(random, uniform_below(random, 4) == 0);
    const int e = exponent(random, kAway);
    for (int k = 0; k < 3; ++k) away[k] = scale_by_power_of_two(by[k], e);
  }
  std::vector<Halfspace> halfspaces;
  for (const Bound& bound : bounds) {
    halfspaces.emplace_back(bound.normal, Rational(-bound.reach - bound.normal.dot(away)));
  }
  return halfspaces;
}

}  // namespace convexact
