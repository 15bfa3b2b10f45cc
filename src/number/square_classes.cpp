// SPDX-License-Identifier: MIT
#include "number/square_classes.hpp"

#include <array>
#include <cstdint>

#include "number/arithmetic.hpp"

namespace convexact {
namespace {

constexpr std::array<unsigned, 32> kOddPrimes{3,  5,  7,   11,  13,  17,  19,  23,  29,  31, 37,
                                              41, 43, 47,  53,  59,  61,  67,  71,  73,  79, 83,
                                              89, 97, 101, 103, 107, 109, 113, 127, 131, 137};

// The Legendre symbols of a number modulo kOddPrimes, a bit for each prime.
struct Residues {
  std::uint32_t is_coprime = 0;  // a prime that divides the number tells nothing about its class:
  std::uint32_t is_nonresidue = 0;  // 3 and 3 * 7^2 are in one class
};

Residues residues_of(const Integer& n) {
  Residues residues;
  for (std::size_t k = 0; k < kOddPrimes.size(); ++k) {
    const int symbol = mpz_kronecker_ui(raw(n), kOddPrimes[k]);
    if (symbol != 0) residues.is_coprime |= std::uint32_t{1} << k;
    if (symbol < 0) residues.is_nonresidue |= std::uint32_t{1} << k;
  }
  return residues;
}

// The symbols of two numbers of one class are equal wherever both are known, because their product
// is a square.
bool may_be_one_class(const Residues& a, const Residues& b) {
  return (a.is_coprime & b.is_coprime & (a.is_nonresidue ^ b.is_nonresidue)) == 0;
}

struct Class {
  Integer representative;
  Residues residues;  // of a member
};

// With g = gcd(n, r), n r is a square if and only if n / g and r / g are, as these are coprime.
// Then n = g a^2, so g is in the class, too.
bool join(Class& c, const Integer& n) {
  const Integer common = gcd(n, c.representative), a = n / common, b = c.representative / common;
  if (mpz_perfect_square_p(raw(a)) == 0 || mpz_perfect_square_p(raw(b)) == 0) return false;
  c.representative = common;
  return true;
}

}  // namespace

SquareClasses square_classes(std::span<const Integer> numbers, const Watch& watch) {
  std::vector<Class> classes{{Integer(1), residues_of(Integer(1))}};
  SquareClasses result;
  for (const Integer& n : numbers) {
    watch.ask();
    const Residues residues = residues_of(n);
    std::size_t index = 0;
    while (index < classes.size() &&
           !(may_be_one_class(classes[index].residues, residues) && join(classes[index], n))) {
      ++index;
    }
    if (index == classes.size()) classes.push_back({n, residues});
    result.members.push_back({index, 0});
  }
  for (const Class& c : classes) result.representatives.push_back(c.representative);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    SquareClasses::Member& member = result.members[i];
    member.multiple = sqrt(Integer(numbers[i] / result.representatives[member.index]));
  }
  return result;
}

}  // namespace convexact
