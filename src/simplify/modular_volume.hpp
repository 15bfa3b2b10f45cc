// SPDX-License-Identifier: MIT
// modular_volume.hpp - six times the volume of a solid modulo a random prime.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "convexact/geometry.hpp"
#include "number/random.hpp"
#include "simplify/plain_surface.hpp"

namespace convexact {

/// Everything is reduced first: Cramer's rule, the inverse and the sum take 64-bit numbers only.
/// Two unequal rationals of b bits differ by a fraction whose numerator has at most 2 b + 1 bits,
/// hence at most b / 30 prime divisors above 2^60; there are more than 2^54 primes between 2^60 and
/// 2^61. So they agree modulo a random prime with probability below b / 2^58, and modulo two with
/// at most the square of that.
class ModularVolume {
 public:
  ModularVolume(std::span<const Halfspace> halfspaces, Random& random);

  /// Of the solid whose dual is `surface`.
  /// @throws Error Internal if a denominator is a multiple of the prime (as unlikely as above).
  [[nodiscard]] std::uint64_t six_volume(const PlainSurface& surface) const;
  [[nodiscard]] std::uint64_t residue(const Rational& x) const;
  [[nodiscard]] std::uint64_t sum(std::uint64_t a, std::uint64_t b) const;
  [[nodiscard]] std::uint64_t product(std::uint64_t a, std::uint64_t b) const;

 private:
  using Point = std::array<std::uint64_t, 3>;
  std::uint64_t residue(const Integer& x) const;
  std::uint64_t difference(std::uint64_t a, std::uint64_t b) const;
  std::uint64_t inverse(std::uint64_t a) const;
  Point cross(const Point& a, const Point& b) const;
  std::uint64_t dot(const Point& a, const Point& b) const;
  Point vertex(const DualTriangle& triangle) const;

  std::uint64_t prime_;
  std::vector<Point> normals_;
  std::vector<std::uint64_t> offsets_;
};

}  // namespace convexact
