// SPDX-License-Identifier: MIT
// angle_sum.hpp - sums of square roots times angles, and their order.
#pragma once
#include <vector>

#include "convexact/number.hpp"
#include "convexact/root_sum.hpp"
#include "convexact/watch.hpp"

namespace convexact {

/// factor * sqrt(squared_length) * angle, with the angle in [0, pi] between the x axis and the
/// point (dot, sqrt(squared_cross)), in radians. For an edge between two facets with the outward
/// normals m and n this is its length times its exterior dihedral angle.
struct AngleTerm {
  Rational factor;
  Rational squared_length;  ///< >= 0
  Integer squared_cross;    ///< |m x n|^2 >= 0
  Integer dot;              ///< m.n; not both are zero.
};

/// A sum of such terms, kept exactly. The mean width of a polytope is one, divided by 4 pi.
class AngleSum {
 public:
  /// Zero.
  AngleSum() = default;
  /// The sum of all terms, in any order.
  /// @throws Error InvalidArgument if a squared length or cross product is negative, or if there is
  ///         no angle.
  explicit AngleSum(std::vector<AngleTerm> terms);
  /// factor * pi.
  [[nodiscard]] static AngleSum pi(const Rational& factor);

  AngleSum& operator+=(const AngleSum& other);
  AngleSum& operator-=(const AngleSum& other) { return *this += -other; }
  AngleSum& operator*=(const Rational& factor);
  AngleSum operator-() const;
  friend AngleSum operator+(AngleSum a, const AngleSum& b) { return a += b; }
  friend AngleSum operator-(AngleSum a, const AngleSum& b) { return a -= b; }

  /// Ascending by squared length, squared cross product, dot product; each such triple once, and no
  /// term that is zero. Equal sums may have different terms.
  const std::vector<AngleTerm>& terms() const { return terms_; }

  /// An interval around the sum from operations of `precision` bits. For n terms its width is about
  /// (n + 7) 2^(2 - precision) times the sum of their sizes: where terms of both signs cancel, it
  /// has fewer certain digits than bits.
  /// @throws Error Stopped when the watch ends the call.
  [[nodiscard]] Enclosure enclose(long precision, const Watch& watch = {}) const;

 private:
  std::vector<AngleTerm> terms_;
};

/// How far the comparison of two angle sums goes.
struct CompareLimits {
  /// Bits of the finest enclosures of two sums that may be equal; >= 1. Sums that are proven to be
  /// different are enclosed as finely as their order needs.
  long bits = 4096;
  /// Whether the basis of all angles is used, which leaves almost nothing undecided.
  bool angle_basis = true;
};

/// The order of two sums, by the first of these that decides it.
/// (1) Enclosures of 128 bits. (2) The normal form: every angle reduced to (0, pi/4], multiples of
/// pi apart; rational factors collected for each square class of lengths and each tan^2. If all are
/// 0, it is a tie. Congruent solids have the same normal form. (3) Enclosures of 256 bits. (4) The
/// angle basis, see below. (5) Enclosures of 512, 1024, ... bits up to the limit, or without limit
/// once (4) has shown that the sums differ. Otherwise the order is Undecided.
///
/// (4) proves equality as well as its contrary. Logarithms of algebraic numbers that are linearly
/// independent over the rationals are also linearly independent over the algebraic numbers
/// [Baker1966], so a sum is zero only if the rational relation between its angles holds in each
/// square class of lengths. Angles with rational tan^2 have a known basis over the rationals
/// [ConwayRadinSadun1999]: for each imaginary quadratic field, one angle for each prime that splits
/// there. Instead of primes, coprime factors of the norms serve [BachDriscollShallit1993], which
/// need no factoring. (4) gives up only if a common divisor of a radicand and an angle's real part
/// has no known square.
///
/// @return  A tie has the proof NormalForm or AngleBasis. "Not separated" is not transitive, so an
///          ordered container must not be sorted by this function.
/// @throws Error InvalidArgument if limits.bits < 1; Stopped when the watch ends the call.
[[nodiscard]] Ordering compare(const AngleSum& a, const AngleSum& b,
                               const CompareLimits& limits = {}, const Watch& watch = {});

}  // namespace convexact
