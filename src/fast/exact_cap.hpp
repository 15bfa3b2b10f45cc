// SPDX-License-Identifier: MIT
// exact_cap.hpp - the determinants of a cap as rationals, from the integer planes themselves.
#pragma once
#include <span>
#include <vector>

#include "fast/dual_signs.hpp"
#include "fast/fast_dual.hpp"

namespace convexact {

/// For CapVolume. The integer rows (n, d) stand for the dual points: a factor of a row appears as
/// often above as below in every term, so the volume is that of the cap in the caller's units.
class ExactCapSource {
 public:
  using Number = Rational;
  /// Adds in pairs of equal depth: the denominators differ, so partial sums grow.
  class Sum {
   public:
    void add(const Rational& x) { terms_.push_back(x); }
    Rational scaled_down(const Rational& divisor) { return Rational(total() / divisor); }
    Rational total();

   private:
    std::vector<Rational> terms_;
  };

  ExactCapSource(const FastDual& dual, HalfspaceId i, std::span<const HalfspaceId> ring)
      : dual_(dual), center_(i), ring_(ring) {}

  Rational base(std::uint32_t m) const;
  Rational slack(std::uint32_t m) const;
  Rational leg(std::uint32_t m, std::uint32_t q) const;
  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    low_ = ring_[low], middle_ = ring_[middle], high_ = ring_[high];
  }
  Rational vertex() const;
  Rational to_center() const;
  Rational to(std::uint32_t q) const;

 private:
  HalfspaceId after(std::uint32_t m) const { return ring_[m + 1 == ring_.size() ? 0 : m + 1]; }
  Rational height(HalfspaceId a, HalfspaceId b, HalfspaceId c, HalfspaceId p) const;

  const FastDual& dual_;
  HalfspaceId center_;
  std::span<const HalfspaceId> ring_;
  HalfspaceId low_, middle_, high_;
};

}  // namespace convexact
