// SPDX-License-Identifier: MIT
// exponent_range.hpp - what the fast engines allow for underflow, and how they avoid overflow.
#pragma once

namespace convexact {

/// Of a Scalar with the exponents of double, or more.
template <class Scalar>
struct ExponentRange {
  /// More than a determinant of dual points loses to underflow (PlaneFilter).
  static constexpr double kUnderflow = 0x1p-1000;
  /// No D below this enters a quotient, so that nothing overflows: below any product stand at most
  /// four D, and sizes are at most 48.
  static constexpr double kSmallestDeterminant = 0x1p-150;
  /// More than a volume loses to underflow then, at 2^-1018 per operation: less than 2^-300 in a
  /// sum of 2^32 terms.
  static constexpr double kVolumeUnderflow = 0x1p-250;
};

/// Of binary32. A product loses 2^-150, and at most a factor of 48 follows it in a determinant.
/// Three sizes over four D are below 48^3 2^72 < 2^89. Of a product that underflowed, at most 2^89
/// times as much enters a sum, less than 2^-57 per operation; 16 operations make a term, and
/// memory does not hold a ring of 2^32.
template <>
struct ExponentRange<float> {
  static constexpr double kUnderflow = 0x1p-140;
  static constexpr double kSmallestDeterminant = 0x1p-18;
  static constexpr double kVolumeUnderflow = 0x1p-20;
};

}  // namespace convexact
