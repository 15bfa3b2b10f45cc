// SPDX-License-Identifier: MIT
// signs.hpp - signs of determinants of dual points: bounds for the roundings, and stages from
// cheap to exact.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "convexact/number.hpp"
#include "fast/dual.hpp"
#include "number/roundoff.hpp"

namespace convexact {

/// How the fast engines bound underflow, and how they avoid overflow, in a Scalar with the
/// exponents of double, or more.
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

/// The same for binary32. A product loses 2^-150, and at most a factor of 48 follows it in a
/// determinant. Three sizes over four D are below 48^3 2^72 < 2^89. At most 2^89 times the loss of
/// an underflowing product enters a sum, so less than 2^-57 per operation; 16 operations make a
/// term, and memory does not hold a ring of 2^32.
template <>
struct ExponentRange<float> {
  static constexpr double kUnderflow = 0x1p-140;
  static constexpr double kSmallestDeterminant = 0x1p-18;
  static constexpr double kVolumeUnderflow = 0x1p-20;
};

/// The rounding that an arithmetic works with: every operation is off by at most a relative kUnit,
/// every coordinate of a dual point by 2 kUnit.
template <class Scalar>
struct Roundoff;

template <>
struct Roundoff<double> {
  static constexpr double kUnit = kUnitRoundoff;
  static_assert(FastDual::kNearError <= 2 * kUnit);
};

template <>
struct Roundoff<DoubleDouble> {
  // The coordinates limit this stage, not the operations.
  static constexpr double kUnit = 0x1p-86;
  static_assert(FastDual::kLongError <= 2 * kUnit && DoubleDouble::kUnit <= kUnit);
};

/// The nearest double.
inline double leading(double x) { return x; }
inline double leading(const DoubleDouble& x) { return x.hi(); }
template <class Scalar>
inline bool is_positive(const Scalar& x) {
  return x > Scalar(0.0);
}

/// Bounds for determinants of a handful of dual points whose differences, as computed, have
/// components of at most E = (extent.x, extent.y, extent.z).
///
/// Let u be the unit of Roundoff; coordinates are at most 1 in size and off by 2u, so E <= 2. First
/// order in u:
/// - A difference f = b - a is off by 2u + 2u from its ends and by u |f| <= 2u from rounding: 6u.
/// - A component of N = f x g, such as f.y g.z - f.z g.y, is at most 2 E.y E.z; it is off by
///   2 (6u E.z + 6u E.y) from its factors and by 4u E.y E.z <= 4u (E.y + E.z) from rounding
///   (E.y E.z <= (E.y + E.z)^2 / 4 <= E.y + E.z): 16u (E.y + E.z).
/// - height = N.h, h a difference: with A = E.y E.z + E.z E.x + E.x E.y, off by
///   16u 2A from N, by 6u 2A from h, and by 3u 6 E.x E.y E.z <= 3u 4A from rounding
///   (E.x E.y E.z <= 2A/3): 56u A.
/// - determinant = N.p, p a point: with B = E.x + E.y + E.z, off by 16u 2B from N, by
///   2u 2A + 3u 2A from p and rounding, where A <= 2B (E.y E.z <= E.y + E.z): 52u B.
/// Higher orders are below 2^-40 of these, in binary32 2^-15. Nothing overflows, all sizes being at
/// most 48. Underflow of a product loses 2^-1075, and at most a factor of 48 follows it; an
/// underflowing coordinate loses as much. ExponentRange covers both, and what the bound itself
/// loses.
struct PlaneFilter {
  static constexpr double kDifference = 2 + 2 + 2;
  static constexpr double kNormal = 2 * kDifference + 4;
  static constexpr double kHeight = 2 * kNormal + 2 * kDifference + 12;
  static constexpr double kDeterminant = 2 * kNormal + 2 * (2 * 2 + 3 * 2);
  static constexpr double kHeightFactor = 64, kDeterminantFactor = 64;
  static_assert(kHeight < kHeightFactor - 1 && kDeterminant < kDeterminantFactor - 1);

  double height = 0;       ///< Of |((b - a) x (c - a)).(p - q)|, q one of a, b, c.
  double determinant = 0;  ///< Of |((b - a) x (c - a)).a|, that is of |det(a, b, c)|.

  static PlaneFilter within(const Triple<double>& extent, double unit,
                            double underflow = ExponentRange<double>::kUnderflow) {
    const double sum = extent.x + extent.y + extent.z;
    const double area = extent.y * extent.z + extent.x * (extent.y + extent.z);
    return {kHeightFactor * unit * area + underflow, kDeterminantFactor * unit * sum + underflow};
  }
};

/// The largest components of some differences.
struct Extent {
  Triple<double> size{0, 0, 0};

  template <class Scalar>
  void include(const Triple<Scalar>& difference) {
    size = {std::max(size.x, std::abs(leading(difference.x))),
            std::max(size.y, std::abs(leading(difference.y))),
            std::max(size.z, std::abs(leading(difference.z)))};
  }
  /// Of the differences of these differences.
  Triple<double> doubled() const { return {2 * size.x, 2 * size.y, 2 * size.z}; }
};

/// Bounds in the arithmetic of Scalar for determinants within that extent.
template <class Scalar>
inline PlaneFilter filter_for(const Triple<double>& extent, double unit) {
  return PlaneFilter::within(extent, unit, ExponentRange<Scalar>::kUnderflow);
}

/// How many signs each stage decided.
struct SignCounts {
  std::uint64_t filtered = 0;  ///< Decided by doubles.
  std::uint64_t incident =
      0;  ///< Zero: a shared vertex of the input or direction, or mirror pairs.
  std::uint64_t extended = 0;  ///< Decided by DoubleDouble.
  std::uint64_t exact = 0;     ///< Decided by integers.

  SignCounts& operator+=(const SignCounts& other) {
    filtered += other.filtered;
    incident += other.incident;
    extended += other.extended;
    exact += other.exact;
    return *this;
  }
};

/// A sign that `value`, off by at most `bound`, proves; NaN proves nothing.
enum class FilterSign : signed char { Negative = -1, Unknown = 0, Positive = 1 };
[[nodiscard]] inline FilterSign filter_sign(double value, double bound) {
  return value > bound    ? FilterSign::Positive
         : value < -bound ? FilterSign::Negative
                          : FilterSign::Unknown;
}

/// The two predicates of the dual hull on halfspaces of a FastDual. Always exact.
class DualSigns {
 public:
  explicit DualSigns(const FastDual& dual) : dual_(&dual) {}

  /// Sign of H(a, b, c, p), the determinant of the rows (n, d): Positive iff dual point p lies
  /// strictly beyond triangle abc, counter-clockwise from outside. For the planes x = 1, y = 1,
  /// z = 1 of a cube, p = x + y + z <= 2 gives Positive: it cuts the corner off.
  [[nodiscard]] Sign height(HalfspaceId a, HalfspaceId b, HalfspaceId c, HalfspaceId p) const;
  /// Sign of det(n_a, n_b, n_c): Positive iff the three planes of a dual triangle meet in a vertex.
  [[nodiscard]] Sign determinant(HalfspaceId a, HalfspaceId b, HalfspaceId c) const;

  /// Whether that height is zero because the planes share a vertex of the input or a direction;
  /// false proves nothing.
  [[nodiscard]] bool is_known_zero(HalfspaceId a, HalfspaceId b, HalfspaceId c,
                                   HalfspaceId p) const;

  /// The same signs where doubles have failed already.
  [[nodiscard]] Sign height_beyond_doubles(HalfspaceId a, HalfspaceId b, HalfspaceId c,
                                           HalfspaceId p) const;
  [[nodiscard]] Sign determinant_beyond_doubles(HalfspaceId a, HalfspaceId b, HalfspaceId c) const;

  /// Counts a sign that the caller has decided in doubles.
  void count_filtered() const { ++counts_.filtered; }
  const SignCounts& counts() const { return counts_; }

 private:
  std::optional<Sign> height_by_vertex(const std::array<HalfspaceId, 4>& planes) const;

  const FastDual* dual_;
  mutable SignCounts counts_;
};

}  // namespace convexact
