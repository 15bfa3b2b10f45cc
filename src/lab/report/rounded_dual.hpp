// SPDX-License-Identifier: MIT
// rounded_dual.hpp - the float loop on numbers of a chosen length, with a record of its numbers.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "fast/engines.hpp"

namespace convexact {

/// Numbers that the float loop can run on.
enum class Numbers {
  Engine,        ///< The float engine itself: doubles, and DoubleDouble where they are in doubt.
  CFloat,        ///< C's float, binary32.
  CDouble,       ///< C's double, binary64.
  MpfrBinary32,  ///< MPFR with the 24 bits and the exponents of binary32.
  MpfrBinary64,  ///< MPFR with the 53 bits and the exponents of binary64.
  Mpfr64,        ///< MPFR with 64 bits and its own exponents; likewise:
  Mpfr113,
  Mpfr256,
  Mpfr1024,
};

/// The bits of one of these numbers; of the float engine 53.
[[nodiscard]] long bits_of(Numbers numbers);

/// A dual hull whose dual points are rounded to numbers of one kind, and the float loop on it.
///
/// Each coordinate is the exact one, n_k / -(n.c + d), scaled by a power of two per axis and
/// rounded to nearest: the best that such numbers can hold. (The float engine's own doubles may be
/// off by FastDual::kNearError instead.)
class RoundedDual {
 public:
  /// @param dual  Must outlive the object.
  static std::unique_ptr<RoundedDual> of(const FastDual& dual, Numbers numbers);
  virtual ~RoundedDual() = default;

  /// The removals that these numbers find cheapest; for Numbers::Engine this is simplify_float().
  virtual FastResult run(const SimplifyOptions& options) = 0;

  /// Of the latest run: the cost of each removal as it was computed, in cubed length units, not
  /// rounded any further. Infinity is never among them.
  virtual std::vector<Rational> costs() const = 0;
  /// The volume of the result of the latest run, as these numbers compute it: cones over its
  /// facets, from the center. None where they divide by zero.
  virtual std::optional<Rational> volume() const = 0;
  /// The halfspace as these numbers hold it, P.(x - c) <= 1 with the dual point P.
  virtual RationalVector3 point(HalfspaceId i) const = 0;
  /// P exactly, before it was rounded.
  virtual RationalVector3 exact_point(HalfspaceId i) const = 0;
};

}  // namespace convexact
