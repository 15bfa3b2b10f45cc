// SPDX-License-Identifier: MIT
#include "simplify/modular_volume.hpp"

#include "convexact/error.hpp"
#include "number/arithmetic.hpp"
#ifndef __SIZEOF_INT128__
#include <boost/multiprecision/cpp_int.hpp>
#endif

namespace convexact {
namespace {

// Of two numbers of 64 bits. Compilers for 32-bit machines lack a type for it.
#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 Product;
#else
using Product = boost::multiprecision::uint128_t;
#endif

// A random prime in [2^60, 2^61).
std::uint64_t random_prime(Random& random) {
  constexpr std::uint64_t kLow = std::uint64_t{1} << 60;
  constexpr int kRounds = 40;  // of Miller and Rabin; GMP's first test is already certain below
                               // 2^64
  for (;;) {
    const std::uint64_t candidate = (kLow + uniform_below(random, kLow)) | 1;
    if (mpz_probab_prime_p(Integer(candidate).backend().data(), kRounds) != 0) return candidate;
  }
}

}  // namespace

ModularVolume::ModularVolume(std::span<const Halfspace> halfspaces, Random& random)
    : prime_(random_prime(random)) {
  for (const Halfspace& h : halfspaces) {
    normals_.push_back({residue(h.normal()[0]), residue(h.normal()[1]), residue(h.normal()[2])});
    offsets_.push_back(residue(h.offset()));
  }
}

std::uint64_t ModularVolume::residue(const Integer& x) const {
  // GMP divides by one word fast, but where its word has 32 bits the prime does not fit.
  if constexpr (sizeof(unsigned long) >= sizeof prime_) {
    return mpz_fdiv_ui(raw(x), static_cast<unsigned long>(prime_));
  }
  const Integer prime(prime_);
  Integer rest;
  mpz_fdiv_r(raw(rest), raw(x), raw(prime));
  return rest.convert_to<std::uint64_t>();
}
std::uint64_t ModularVolume::residue(const Rational& x) const {
  return product(residue(numerator(x)), inverse(residue(denominator(x))));
}
std::uint64_t ModularVolume::sum(std::uint64_t a, std::uint64_t b) const {
  return (a + b) % prime_;
}
std::uint64_t ModularVolume::difference(std::uint64_t a, std::uint64_t b) const {
  return (a + prime_ - b) % prime_;
}
std::uint64_t ModularVolume::product(std::uint64_t a, std::uint64_t b) const {
  return static_cast<std::uint64_t>(Product{a} * b % prime_);
}

std::uint64_t ModularVolume::inverse(std::uint64_t a) const {
  if (a == 0) {
    throw Error(ErrorCode::Internal,
                "volume check: a denominator is a multiple of the random prime; try another seed");
  }
  // Fermat: a^(p - 2).
  std::uint64_t power = 1;
  for (std::uint64_t exponent = prime_ - 2; exponent != 0; exponent >>= 1) {
    if (exponent & 1) power = product(power, a);
    a = product(a, a);
  }
  return power;
}

ModularVolume::Point ModularVolume::cross(const Point& a, const Point& b) const {
  const auto minor = [&](int i, int j) {
    return difference(product(a[i], b[j]), product(a[j], b[i]));
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

std::uint64_t ModularVolume::dot(const Point& a, const Point& b) const {
  return sum(sum(product(a[0], b[0]), product(a[1], b[1])), product(a[2], b[2]));
}

ModularVolume::Point ModularVolume::vertex(const DualTriangle& triangle) const {
  const std::size_t a = triangle[0].index(), b = triangle[1].index(), c = triangle[2].index();
  const Point bc = cross(normals_[b], normals_[c]), ca = cross(normals_[c], normals_[a]);
  const Point ab = cross(normals_[a], normals_[b]);
  const std::uint64_t scale = inverse(dot(normals_[a], bc));
  Point x;
  for (int k = 0; k < 3; ++k) {
    const std::uint64_t top = sum(sum(product(offsets_[a], bc[k]), product(offsets_[b], ca[k])),
                                  product(offsets_[c], ab[k]));
    x[k] = difference(0, product(top, scale));
  }
  return x;
}

std::uint64_t ModularVolume::six_volume(const PlainSurface& surface) const {
  // Pyramids over the facets, from the origin: a signed sum, so the origin may be anywhere.
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const std::vector<HalfspaceId> ring = surface.ring(HalfspaceId(i));
    std::vector<Point> corners;
    for (std::size_t t = 0; t < ring.size(); ++t) {
      corners.push_back(vertex({HalfspaceId(i), ring[t], ring[(t + 1) % ring.size()]}));
    }
    for (std::size_t t = 2; t < corners.size(); ++t) {
      total = sum(total, dot(corners[0], cross(corners[t - 1], corners[t])));
    }
  }
  return total;
}

}  // namespace convexact
