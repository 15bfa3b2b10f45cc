// SPDX-License-Identifier: MIT
// dual_signs.hpp - exact signs of determinants of dual points, four stages from cheap to sure.
#pragma once
#include <cstdint>

#include "convexact/number.hpp"
#include "fast/fast_dual.hpp"
#include "fast/plane_filter.hpp"

namespace convexact {

/// How far signs had to go.
struct SignCounts {
  std::uint64_t filtered = 0;  ///< Decided by doubles.
  std::uint64_t incident = 0;  ///< Zero: the planes share a vertex of the input, or a direction.
  std::uint64_t extended = 0;  ///< Decided by DoubleDouble.
  std::uint64_t exact = 0;     ///< Decided by integers.
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

  /// The same where doubles have failed already.
  [[nodiscard]] Sign height_beyond_doubles(HalfspaceId a, HalfspaceId b, HalfspaceId c,
                                           HalfspaceId p) const;
  [[nodiscard]] Sign determinant_beyond_doubles(HalfspaceId a, HalfspaceId b, HalfspaceId c) const;

  /// Notes a sign that the caller has decided by doubles itself.
  void count_filtered() const { ++counts_.filtered; }
  const SignCounts& counts() const { return counts_; }

 private:
  const FastDual* dual_;
  mutable SignCounts counts_;
};

/// The determinants themselves, of the integer rows; for costs, which are ratios of them.
[[nodiscard]] Integer exact_height(const Halfspace& a, const Halfspace& b, const Halfspace& c,
                                   const Halfspace& p);
[[nodiscard]] Integer exact_determinant(const Halfspace& a, const Halfspace& b, const Halfspace& c);

}  // namespace convexact
