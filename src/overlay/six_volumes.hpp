// SPDX-License-Identifier: MIT
// six_volumes.hpp - volumes as sums over a boundary: of a piece of the plane through a, b, c, the
// cone from a point o has det(a - o, b - o, c - o) / 6 times the piece's share of the triangle.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "convexact/measure.hpp"
#include "overlay/convex_piece.hpp"

namespace convexact {

/// Six times a volume, as an enclosure of `bits` bits, or exactly.
class SixVolumes {
 public:
  SixVolumes(RationalPoint origin, long bits, bool exact)
      : origin_(std::move(origin)), bits_(bits), exact_(exact), sum_(bits) {}

  /// What a piece of the boundary adds.
  struct Term {
    Enclosure bounds;
    std::vector<Rational> exact;  ///< Summands; none if enclosures are wanted.
  };
  /// Of pieces of the boundary, which faces the same way as the frame's triangle, or the opposite
  /// way. Several threads may call this at the same time.
  Term term(Arrangement<3>& arrangement, std::span<const ConvexPiece<3>> pieces,
            bool looks_out) const;
  /// Of a whole triangle, likewise.
  Term term(const std::array<RationalPoint, 3>& triangle, bool looks_out) const;

  /// Enclosures are rounded: their order matters.
  void add(Term term);

  bool is_empty() const { return is_empty_; }
  const Enclosure& bounds() const { return sum_; }
  Rational exact() { return balanced_sum(std::move(terms_)); }

 private:
  Rational cone(const std::array<RationalPoint, 3>& triangle, bool looks_out) const;

  RationalPoint origin_;
  long bits_;
  bool exact_;
  bool is_empty_ = true;
  Enclosure sum_;
  std::vector<Rational> terms_;
};

/// The volume inside a boundary, none or positive. The boundary is added once, and again with more
/// bits if terms of both signs cancel too many bits.
[[nodiscard]] Measured measure_inside(const RationalPoint& origin, long precision, bool exact,
                                      const std::function<void(SixVolumes&)>& add_boundary);

}  // namespace convexact
