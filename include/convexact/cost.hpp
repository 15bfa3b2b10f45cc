// SPDX-License-Identifier: MIT
// cost.hpp - the amount that a removal adds to the measure that a run keeps small.
#pragma once
#include <compare>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "convexact/angle_sum.hpp"
#include "convexact/number.hpp"
#include "convexact/root_sum.hpp"
#include "convexact/watch.hpp"

namespace convexact {

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
