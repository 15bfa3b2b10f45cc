// SPDX-License-Identifier: MIT
// Residues modulo a random prime in [2^60, 2^61), on machines of any word.
#include "simplify/modular_volume.hpp"

#include <doctest/doctest.h>

#include "number/arithmetic.hpp"

using namespace convexact;

TEST_CASE("ModularVolume: what is below 2^60 is its own residue") {
  Random random(3);
  const ModularVolume modular({}, random);
  for (int bits = 0; bits < 60; ++bits) {
    const std::uint64_t least = std::uint64_t{1} << bits, x = least + random() % least;
    CHECK(modular.residue(Rational(Integer(x))) == x);
  }
}

TEST_CASE("ModularVolume: residues of sums and products are sums and products of residues") {
  Random random(5);
  const ModularVolume modular({}, random);
  const auto number = [&] {
    Integer x = 0;
    for (int word = 0; word < 4; ++word) x = (x << 64) + Integer(random());
    return Rational(random() % 2 == 0 ? x : Integer(-x), Integer(1 + (random() >> 4)));
  };
  for (int k = 0; k < 100; ++k) {
    const Rational a = number(), b = number();
    const std::uint64_t p = modular.residue(a), q = modular.residue(b);
    CHECK(p < std::uint64_t{1} << 61);
    CHECK(modular.sum(p, q) == modular.residue(Rational(a + b)));
    CHECK(modular.product(p, q) == modular.residue(Rational(a * b)));
    CHECK(modular.sum(p, modular.residue(Rational(-a))) == 0);
  }
}
