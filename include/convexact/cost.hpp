// SPDX-License-Identifier: MIT
// cost.hpp - the amount that a removal adds to the measure that a run keeps small.
#pragma once
#include <compare>
#include <utility>

#include "convexact/number.hpp"

namespace convexact {

/// The exact cost of one removal. The only measure so far is the volume, in cubed length units, so
/// a cost is a rational. Costs of other measures are other kinds of numbers, and this type is the
/// one place that will know them; the order of two costs and their enclosures do not depend on it.
class Cost {
 public:
  Cost(Rational volume) : value_(std::move(volume)) {}  // NOLINT: a rational is a cost

  /// The number itself.
  const Rational& rational() const { return value_; }
  /// The narrowest interval of that many bits around it.
  Enclosure enclose(long precision) const { return {value_, precision}; }

  /// Exact for all sizes.
  friend bool operator==(const Cost& a, const Cost& b) { return a.value_ == b.value_; }
  friend std::strong_ordering operator<=>(const Cost& a, const Cost& b) {
    return a.value_.compare(b.value_) <=> 0;
  }

 private:
  Rational value_;
};

}  // namespace convexact
