// SPDX-License-Identifier: MIT
// root_sum.hpp - sums of square roots, their exact order, and the answer of a comparison.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "convexact/number.hpp"
#include "convexact/watch.hpp"

namespace convexact {

// ---- Comparisons

/// The order of two real numbers, as far as it is known.
enum class Order { Less, Equal, Greater, Undecided };

/// Why two numbers count as equal.
enum class TieProof {
  EqualRationals,  ///< Both are rational, and the same.
  Congruent,       ///< They measure congruent solids. Known only to a caller that has the solids.
  SquareClasses,   ///< Their roots are the same multiples of one root in each square class.
  NormalForm,      ///< Their angles are the same after reduction to [0, pi/4].
  AngleBasis,      ///< Their angles are the same in a basis of all angles.
  Undecided,       ///< No proof: their enclosures overlap at the highest precision allowed.
};

/// The answer to a comparison, and what it rests on.
struct Ordering {
  Order order = Order::Equal;
  std::optional<TieProof> tie_proof = {};  ///< If the order is Equal or Undecided.
  long bits = 0;  ///< Of the finest enclosures that were compared: 53 are doubles; 0 for none.
};

// ---- Sums of roots

/// factor * sqrt(radicand), radicand > 0.
struct RootTerm {
  Rational factor;
  Integer radicand;
};

/// A sum of square roots of positive integers with rational factors, kept exactly. Areas of
/// polytopes with rational planes are such sums.
class RootSum {
 public:
  /// Zero.
  RootSum() = default;
  RootSum(const Rational& x);  // NOLINT: a rational is a sum of roots
  /// The sum of all terms, in any order. @throws Error InvalidArgument if a radicand is not > 0.
  explicit RootSum(std::vector<RootTerm> terms);

  /// Adds factor * sqrt(radicand); sqrt(a/b) is sqrt(ab)/b.
  /// @throws Error InvalidArgument if the radicand is negative.
  /// @par Cost  Linear in the number of terms; use the constructor for many terms at once.
  void add(const Rational& factor, const Rational& radicand);
  RootSum& operator+=(const RootSum& other);
  RootSum& operator-=(const RootSum& other) { return *this += -other; }
  RootSum& operator*=(const Rational& factor);
  RootSum operator-() const;
  friend RootSum operator+(RootSum a, const RootSum& b) { return a += b; }
  friend RootSum operator-(RootSum a, const RootSum& b) { return a -= b; }

  /// Ascending radicands, each once, and no factor 0. Radicands need not be squarefree, so equal
  /// sums may have different terms; equal normalized() sums with the same radicands have the same
  /// terms.
  const std::vector<RootTerm>& terms() const { return terms_; }

  /// The same number with one term for each square class, that is, no product of two radicands is a
  /// square; the radicand of rational numbers is 1. Zero, and only zero, has no terms left.
  /// @par Cost    A gcd for each pair of radicands whose residues modulo 32 primes fit together.
  /// @par Source  [Besicovitch1940]: roots of different square classes are linearly independent.
  [[nodiscard]] RootSum normalized(const Watch& watch = {}) const;

  /// An interval around the sum from operations of `precision` bits. For n terms its width is about
  /// (n + 3) 2^(2 - precision) times the sum of their sizes: where terms of both signs cancel, it
  /// has fewer certain digits than bits.
  /// @throws Error Stopped when the watch ends the call.
  [[nodiscard]] Enclosure enclose(long precision, const Watch& watch = {}) const;

 private:
  std::vector<RootTerm> terms_;
};

/// The exact order of two sums: always decided, by the first of these steps that can decide it.
/// (1) Doubles with a proven bound of their error. (2) Enclosures of 128 bits. (3) The proof that
/// the difference is zero: its normalized() sum has no terms. (4) Enclosures of 256, 512, ... bits.
/// These end, because the difference is not zero.
/// @return  A tie has the proof EqualRationals or SquareClasses.
/// @throws Error Stopped when the watch ends the call.
/// @par Source  [Besicovitch1940]
[[nodiscard]] Ordering compare(const RootSum& a, const RootSum& b, const Watch& watch = {});

/// The sum rounded to `digits` >= 1 significant digits, all of them certain; "0" for zero.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] std::string to_decimal(const RootSum& x, int digits, const Watch& watch = {});

}  // namespace convexact
