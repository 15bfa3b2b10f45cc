// SPDX-License-Identifier: MIT
// close_determinants.hpp - determinants of dual points some of which nearly coincide.
#pragma once
#include <cstdint>
#include <span>

#include "fast/ring.hpp"
#include "fast/ring_determinants.hpp"
#include "fast/signs.hpp"
#include "number/double_double.hpp"

namespace convexact {

/// A number and a bound of its error.
struct Approximate {
  DoubleDouble value;
  double error;
};

/// H and D of DualSigns, each with a bound of its own. PlaneFilter bounds a determinant by the
/// longest differences in it, as if all were as long. Facets that are coplanar but for the rounding
/// of their vertices have dual points some 2^-50 apart, and where two such pairs meet, H is of the
/// size of both distances multiplied. So H is computed here from the shortest differences that join
/// its four points: a step from a point to the next changes det(b - a, c - a, p - a) by multiples
/// of other rows only.
[[nodiscard]] Approximate close_height(const Triple<DoubleDouble>& a, const Triple<DoubleDouble>& b,
                                       const Triple<DoubleDouble>& c,
                                       const Triple<DoubleDouble>& p);
[[nodiscard]] Approximate close_determinant(const Triple<DoubleDouble>& a,
                                            const Triple<DoubleDouble>& b,
                                            const Triple<DoubleDouble>& c);

/// Determinants of a ring, as of ring_determinants.hpp, by these two; heights that DualSigns knows
/// to be zero are zero. Slower than IntervalDeterminants, which subtract and multiply once for all
/// that have two rows in common.
class CloseDeterminants : public CapRanges<DoubleDouble> {
 public:
  /// @param ids  Of the ring.
  CloseDeterminants(const RingGeometry<DoubleDouble>& ring, HalfspaceId center,
                    std::span<const HalfspaceId> ids, const DualSigns& signs)
      : CapRanges(ring.size, Roundoff<DoubleDouble>::kUnit),
        ring_(ring),
        center_(center),
        ids_(ids),
        signs_(signs) {}

  Number base(std::uint32_t m) { return determinant(kCenter, m, after(m)); }
  Number slack(std::uint32_t m) const {
    return m < 2 ? Number{0.0, 0.0} : height(kCenter, 0, 1, m);
  }
  Number leg(std::uint32_t m, std::uint32_t q) const { return height(kCenter, m, after(m), q); }
  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    low_ = low, middle_ = middle, high_ = high;
  }
  Number vertex() { return determinant(low_, middle_, high_); }
  Number to_center() const { return height(low_, middle_, high_, kCenter); }
  Number to(std::uint32_t q) const { return height(low_, middle_, high_, q); }

 private:
  static constexpr std::uint32_t kCenter = kNone;  // beside positions in the ring

  const Triple<DoubleDouble>& point(std::uint32_t m) const {
    return m == kCenter ? ring_.center : ring_.point[m];
  }
  HalfspaceId id(std::uint32_t m) const { return m == kCenter ? center_ : ids_[m]; }
  std::uint32_t after(std::uint32_t m) const { return m + 1 == ids_.size() ? 0 : m + 1; }
  Number determinant(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto [value, error] = close_determinant(point(a), point(b), point(c));
    return positive(value, error);
  }
  Number height(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t p) const {
    const auto [value, error] = close_height(point(a), point(b), point(c), point(p));
    const Number range = lift(abs(value), error);
    const bool is_zero =
        !is_positive(range.lower) && signs_.is_known_zero(id(a), id(b), id(c), id(p));
    return is_zero ? Number{0.0, 0.0} : range;
  }

  const RingGeometry<DoubleDouble>& ring_;
  HalfspaceId center_;
  std::span<const HalfspaceId> ids_;
  const DualSigns& signs_;
  std::uint32_t low_ = 0, middle_ = 0, high_ = 0;
};

}  // namespace convexact
