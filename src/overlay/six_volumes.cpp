// SPDX-License-Identifier: MIT
#include "overlay/six_volumes.hpp"

#include <algorithm>

namespace convexact {
namespace {

// The share of a piece in units of 2^(-2 bits): the shoelace sum of the corners' second and third
// shares x, y rounded down to multiples of 2^-bits. Differences from the first corner are off by
// less than 1. Where none is larger than L, a product is off by less than (L + 1)^2 - L^2, and
// each triangle has two.
void add_share(Arrangement<3>& arrangement, const ConvexPiece<3>& piece, long bits, Integer& share,
               Integer& error) {
  struct Shares {
    Integer x, y;
  };
  std::vector<Shares> corners;
  Integer largest = 0;
  for (const auto& corner : piece.corners) {
    const IntegerRow<3>& b = arrangement.exact(corner.at);
    const Integer weight = arrangement.weight(b);
    const auto rounded = [&](std::size_t k) {
      Integer scaled = b[k] * arrangement.frame()[k].w;
      mpz_mul_2exp(raw(scaled), raw(scaled), static_cast<mp_bitcnt_t>(bits));
      mpz_fdiv_q(raw(scaled), raw(scaled), raw(weight));
      return scaled;
    };
    Shares& s = corners.emplace_back(Shares{rounded(1), rounded(2)});
    if (corners.size() > 1) {
      s.x -= corners[0].x;
      s.y -= corners[0].y;
      largest = std::max({largest, Integer(abs(s.x)), Integer(abs(s.y))});
    }
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    add_product(share, corners[i - 1].x, corners[i].y);
    subtract_product(share, corners[i - 1].y, corners[i].x);
  }
  error += (corners.size() - 2) * (4 * largest + 2);
}

}  // namespace

Rational SixVolumes::cone(const std::array<RationalPoint, 3>& triangle, bool looks_out) const {
  const RationalVector3 a = triangle[0] - origin_, b = triangle[1] - origin_,
                        c = triangle[2] - origin_;
  const Rational outward = a.dot(b.cross(c));
  return looks_out ? outward : Rational(-outward);
}

SixVolumes::Term SixVolumes::term(Arrangement<3>& arrangement,
                                  std::span<const ConvexPiece<3>> pieces, bool looks_out) const {
  Term found{Enclosure(bits_), {}};
  std::array<RationalPoint, 3> triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    const HomogeneousPoint& p = arrangement.frame()[k];
    for (int i = 0; i < 3; ++i) triangle[k][i] = Rational(p.n[i], p.w);
  }
  const Rational whole = cone(triangle, looks_out);
  if (whole == 0) return found;
  if (exact_) {
    for (const ConvexPiece<3>& piece : pieces) {
      found.exact.push_back(whole * share_of(arrangement, piece));
    }
    return found;
  }
  Integer share = 0, error = 0;
  for (const ConvexPiece<3>& piece : pieces) add_share(arrangement, piece, bits_, share, error);
  const auto end = [&](const Integer& x) { return scale_by_power_of_two(Rational(x), -2 * bits_); };
  found.bounds = Enclosure(whole, bits_) * Enclosure(end(share - error), end(share + error), bits_);
  return found;
}

SixVolumes::Term SixVolumes::term(const std::array<RationalPoint, 3>& triangle,
                                  bool looks_out) const {
  Rational whole = cone(triangle, looks_out);
  if (exact_) return {Enclosure(bits_), {std::move(whole)}};
  return {Enclosure(whole, bits_), {}};
}

void SixVolumes::add(Term term) {
  is_empty_ = false;
  if (!exact_) sum_ += term.bounds;
  for (Rational& summand : term.exact) terms_.push_back(std::move(summand));
}

Measured measure_inside(const RationalPoint& origin, long precision, bool exact,
                        const std::function<void(SixVolumes&)>& add_boundary) {
  if (exact) {
    SixVolumes sum(origin, precision, true);
    add_boundary(sum);
    const Rational volume = sum.exact() / 6;
    return {Enclosure(volume, precision), volume};
  }
  constexpr long kSpareBits = 64, kMostBits = 1L << 22;
  for (long bits = precision + kSpareBits; bits <= kMostBits; bits *= 2) {
    SixVolumes sum(origin, bits, false);
    add_boundary(sum);
    if (sum.is_empty()) return {Enclosure(precision), std::nullopt};
    const Rational low = sum.bounds().low() / 6, high = sum.bounds().high() / 6;
    if (low > 0 && scale_by_power_of_two(Rational(high - low), precision) <= low) {
      return {Enclosure(low, high, precision), std::nullopt};
    }
  }
  throw Error(ErrorCode::Internal, "a volume does not come out of its enclosures");
}

}  // namespace convexact
