// SPDX-License-Identifier: MIT
// cost.hpp - exact costs: volumes, sums of roots (areas), sums of roots times angles (mean widths),
// and their order.
#pragma once
#include <compare>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

// ---- Sums of square roots, their exact order, and the answer of a comparison.

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

// ---- Sums of square roots times angles, and their order.

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

// ---- The amount that a removal adds to the measure that a run keeps small.

/// The measure that a run keeps small.
enum class CostMeasure {
  Volume,     ///< In cubed length units; costs are rationals.
  Area,       ///< Of the surface, in squared length units; costs are sums of roots.
  MeanWidth,  ///< In length units; 4 pi times a cost is a sum of roots times angles.
};

/// The exact cost of one removal: the measure after it minus the measure before it. Copies of areas
/// and mean widths share their terms.
class Cost {
 public:
  Cost(Rational volume) : value_(std::move(volume)) {}  // NOLINT: a rational is a cost
  explicit Cost(RootSum area);
  /// @param angles  4 pi times the mean width: the sum of length times exterior angle over edges.
  explicit Cost(AngleSum angles);

  CostMeasure measure() const { return static_cast<CostMeasure>(value_.index()); }

  /// The number itself. @throws Error InvalidArgument unless the measure is as the name says.
  const Rational& rational() const;
  const RootSum& area() const;
  const AngleSum& angles() const;  ///< 4 pi times the mean width.

  Cost& operator*=(const Rational& factor);

  /// An interval around the cost itself (without the factor 4 pi). For a volume: the narrowest one
  /// of `precision` bits. For other measures: one of at least that many bits, whose width is at
  /// most 2^-precision times the number, as far as computing with 2^16 bits achieves that.
  /// @throws Error Stopped when the watch ends the call.
  Enclosure enclose(long precision, const Watch& watch = {}) const;

  /// An interval around the number that is compared, rational(), area() or angles(), from
  /// operations of 128 bits. It is computed in advance, unless the measure is the volume.
  Enclosure bounds() const;
  /// Doubles that are certainly not above, and not below, that number; likewise in advance.
  double low_double() const;
  double high_double() const;

  /// The cost itself with `digits` >= 1 significant digits, all certain; "0" for zero.
  /// @throws Error Unrepresentable if a sum of angles is proven neither to be 0 nor to differ from
  ///         0.
  std::string decimal(int digits) const;

  /// The total order of volumes and that of areas, exact for all sizes.
  /// @throws Error InvalidArgument for mean widths, which have compare() only, and for costs of
  ///         different measures.
  friend bool operator==(const Cost& a, const Cost& b) {
    const Rational *x = std::get_if<Rational>(&a.value_), *y = std::get_if<Rational>(&b.value_);
    return x != nullptr && y != nullptr ? *x == *y : order_of_areas(a, b) == 0;
  }
  friend std::strong_ordering operator<=>(const Cost& a, const Cost& b) {
    const Rational *x = std::get_if<Rational>(&a.value_), *y = std::get_if<Rational>(&b.value_);
    return x != nullptr && y != nullptr ? x->compare(*y) <=> 0 : order_of_areas(a, b);
  }

  /// The order of two costs of one measure, and what it rests on.
  /// @param limits  For the comparison of two mean widths.
  /// @throws Error  InvalidArgument for costs of different measures, or if limits.bits < 1;
  ///                Stopped when the watch ends the call.
  friend Ordering compare(const Cost& a, const Cost& b, const CompareLimits& limits,
                          const Watch& watch);

 private:
  // With bounds of the sum; those in doubles decide most comparisons.
  template <class Sum>
  struct Bounded {
    explicit Bounded(Sum x);
    Sum sum;
    Enclosure bounds;
    double low, high;
  };

  static std::strong_ordering order_of_areas(const Cost& a, const Cost& b);

  // In the order of CostMeasure. Pointers keep volumes, which most runs have, small.
  std::variant<Rational, std::shared_ptr<const Bounded<RootSum>>,
               std::shared_ptr<const Bounded<AngleSum>>>
      value_;
};

[[nodiscard]] Ordering compare(const Cost& a, const Cost& b, const CompareLimits& limits = {},
                               const Watch& watch = {});

/// The exact sum of n >= 1 costs of one measure.
/// @throws Error InvalidArgument if there are none, or of different measures.
[[nodiscard]] Cost sum_of(std::span<const Cost> costs);

/// a - b. @throws Error InvalidArgument for costs of different measures.
[[nodiscard]] Cost difference(const Cost& a, const Cost& b);

}  // namespace convexact
