// SPDX-License-Identifier: MIT
// convex_piece.hpp - convex pieces of a triangle's plane, or of a segment's line: cut by planes,
// measured, and points inside them.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "convexact/error.hpp"
#include "number/arithmetic.hpp"
#include "overlay/arrangement.hpp"

namespace convexact {

/// A convex polygon with an area, counter-clockwise in the frame, no three corners in line (N = 3);
/// or the ends of a segment with a length (N = 2).
template <std::size_t N>
struct ConvexPiece {
  struct Corner {
    typename Arrangement<N>::VertexId at;
    typename Arrangement<N>::RowId side;  ///< The row of the side to the next corner, if N = 3.
  };
  std::vector<Corner> corners;
};

/// The triangle, or the segment, of the frame itself.
template <std::size_t N>
[[nodiscard]] ConvexPiece<N> whole_frame() {
  ConvexPiece<N> piece;
  for (std::uint32_t k = 0; k < N; ++k) {
    piece.corners.push_back({k, static_cast<std::uint32_t>((k + 2) % N)});
  }
  return piece;
}

enum class Position {
  Inside,   ///< No corner is beyond the row.
  Beyond,   ///< No corner is inside the row: the common part has no area.
  Crossed,  ///< Both halves have an area.
  On,       ///< The row is zero.
};

template <std::size_t N>
[[nodiscard]] Position position(Arrangement<N>& arrangement, const ConvexPiece<N>& piece,
                                typename Arrangement<N>::RowId row) {
  bool is_inside = false, is_beyond = false;
  for (const auto& corner : piece.corners) {
    const Sign s = arrangement.side(corner.at, row);
    is_inside = is_inside || s == Sign::Negative;
    is_beyond = is_beyond || s == Sign::Positive;
    if (is_inside && is_beyond) return Position::Crossed;
  }
  return is_inside ? Position::Inside : is_beyond ? Position::Beyond : Position::On;
}

template <std::size_t N>
struct Halves {
  ConvexPiece<N> inside, beyond;
};

/// Both halves of a piece that the row crosses. In both, the new side belongs to the row.
template <std::size_t N>
[[nodiscard]] Halves<N> split(Arrangement<N>& arrangement, const ConvexPiece<N>& piece,
                              typename Arrangement<N>::RowId row) {
  Halves<N> halves;
  if constexpr (N == 2) {
    const auto x = arrangement.meet({row});
    const auto& ends = piece.corners;
    ConvexPiece<N> first{{ends[0], {x, row}}}, second{{{x, row}, ends[1]}};
    if (arrangement.side(ends[0].at, row) == Sign::Negative) {
      return {std::move(first), std::move(second)};
    }
    return {std::move(second), std::move(first)};
  } else {
    const std::size_t m = piece.corners.size();
    std::vector<Sign> side(m);
    for (std::size_t i = 0; i < m; ++i) side[i] = arrangement.side(piece.corners[i].at, row);
    for (std::size_t i = 0; i < m; ++i) {
      const auto& corner = piece.corners[i];
      const Sign here = side[i], next = side[(i + 1) % m];
      // A corner on the row belongs to both halves. Where a half ends there, its next side runs
      // along the row.
      if (here != Sign::Positive) {
        const bool leaves = here == Sign::Zero && next == Sign::Positive;
        halves.inside.corners.push_back({corner.at, leaves ? row : corner.side});
      }
      if (here != Sign::Negative) {
        const bool leaves = here == Sign::Zero && next == Sign::Negative;
        halves.beyond.corners.push_back({corner.at, leaves ? row : corner.side});
      }
      if (here * next == Sign::Negative) {
        const auto x = arrangement.meet({corner.side, row});
        halves.inside.corners.push_back({x, here == Sign::Negative ? row : corner.side});
        halves.beyond.corners.push_back({x, here == Sign::Positive ? row : corner.side});
      }
    }
    return halves;
  }
}

/// Subtracts a convex set, the common part of the rows' inner sides, from the pieces. Pieces that
/// do not meet it with an area stay whole; from the others the part beyond the first row stays,
/// then the part of the remainder beyond the second row, and so on. Returns the parts in the set.
template <std::size_t N>
std::vector<ConvexPiece<N>> subtract(Arrangement<N>& arrangement,
                                     std::vector<ConvexPiece<N>>& pieces,
                                     std::span<const typename Arrangement<N>::RowId> rows) {
  std::vector<ConvexPiece<N>> rest, taken;
  std::vector<typename Arrangement<N>::RowId> crossing;
  for (ConvexPiece<N>& piece : pieces) {
    // (1) Rows with all of the piece inside, or beyond.
    crossing.clear();
    bool meets = true;
    for (const auto row : rows) {
      const Position where = position(arrangement, piece, row);
      if (where == Position::Beyond) {
        meets = false;
        break;
      }
      if (where == Position::Crossed) crossing.push_back(row);
    }
    if (!meets) {
      rest.push_back(std::move(piece));
      continue;
    }
    // (2) Cut. If the remainder ends up beyond a row, the set meets the piece in no area.
    const std::size_t before = rest.size();
    ConvexPiece<N> inside = piece;
    for (const auto row : crossing) {
      const Position where = position(arrangement, inside, row);
      if (where == Position::Inside) continue;
      if (where == Position::Beyond) {
        meets = false;
        break;
      }
      Halves<N> halves = split(arrangement, inside, row);
      rest.push_back(std::move(halves.beyond));
      inside = std::move(halves.inside);
    }
    if (meets) {
      taken.push_back(std::move(inside));
    } else {
      rest.resize(before);
      rest.push_back(std::move(piece));
    }
  }
  pieces = std::move(rest);
  return taken;
}

// ---- Measures and points of a piece

/// The piece's share of the area, or length, of the frame's triangle, or segment.
template <std::size_t N>
[[nodiscard]] Rational share_of(Arrangement<N>& arrangement, const ConvexPiece<N>& piece) {
  const auto& corners = piece.corners;
  Integer weights = 1;  // of the frame
  for (const HomogeneousPoint& p : arrangement.frame()) weights *= p.w;
  if constexpr (N == 2) {
    const IntegerRow<N>&a = arrangement.exact(corners[0].at), &b = arrangement.exact(corners[1].at);
    Integer determinant = a[0] * b[1];
    subtract_product(determinant, a[1], b[0]);
    return Rational(Integer(abs(determinant) * weights),
                    Integer(arrangement.weight(a) * arrangement.weight(b)));
  } else {
    // The determinant of the shares (b_k W_k) / (b.W) of three corners is the share of their
    // triangle.
    std::vector<Rational> terms;
    const IntegerRow<N> a = arrangement.exact(corners[0].at);
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const IntegerRow<N> b = arrangement.exact(corners[i - 1].at);
      const IntegerRow<N>& c = arrangement.exact(corners[i].at);
      Integer determinant = 0, minor;
      for (std::size_t k = 0; k < 3; ++k) {
        minor = b[(k + 1) % 3] * c[(k + 2) % 3];
        subtract_product(minor, b[(k + 2) % 3], c[(k + 1) % 3]);
        add_product(determinant, a[k], minor);
      }
      terms.push_back(
          Rational(Integer(determinant * weights),
                   Integer(arrangement.weight(a) * arrangement.weight(b) * arrangement.weight(c))));
    }
    return balanced_sum(std::move(terms));
  }
}

/// Whether a point with these coordinates, of any weight, lies strictly inside the piece.
template <std::size_t N>
[[nodiscard]] bool is_inside_piece(Arrangement<N>& arrangement, const ConvexPiece<N>& piece,
                                   const IntegerRow<N>& b) {
  const auto& corners = piece.corners;
  if (arrangement.weight(b) <= 0) return false;
  if constexpr (N == 3) {
    // On the same side of each row as the piece, that is, as the corner after the next.
    const std::size_t m = corners.size();
    for (std::size_t i = 0; i < m; ++i) {
      const Sign own = arrangement.side(corners[(i + 2) % m].at, corners[i].side);
      if (own == Sign::Zero || arrangement.side(b, corners[i].side) != own) return false;
    }
    return true;
  } else {
    // Between the ends: the determinants with both have one sign.
    const IntegerRow<N>&u = arrangement.exact(corners[0].at), &v = arrangement.exact(corners[1].at);
    const Sign s = sign_of(Integer(u[0] * b[1] - u[1] * b[0])),
               t = sign_of(Integer(b[0] * v[1] - b[1] * v[0]));
    return s * t == Sign::Positive;
  }
}

// The weights of the corners in their mean. With c the corners and a the attempt, the mean lies on
// a line L = 0 if the sum of all L(c) + a L(c_1) + a^2 L(c_2) = 0. That holds for every a only if
// the line holds c_1 and c_2, that is, a side; but then the sum is not 0. So a line holds at most
// two means.
inline unsigned long corner_weight(std::size_t corner, unsigned long attempt) {
  return corner == 1 ? 1 + attempt : corner == 2 ? 1 + attempt * attempt : 1;
}

// The shares of the mean of the corners, in doubles.
template <std::size_t N>
std::array<double, N> near_mean(Arrangement<N>& arrangement, const ConvexPiece<N>& piece,
                                unsigned attempt) {
  std::array<double, N> mean{};
  double total = 0;
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const auto shares = arrangement.near_shares(piece.corners[i].at);
    const auto weight = static_cast<double>(corner_weight(i, attempt));
    for (std::size_t k = 0; k < N; ++k) mean[k] += weight * shares[k];
    total += weight;
  }
  for (double& x : mean) x /= total;
  return mean;
}

// The coordinates of the point whose shares are these, rounded to so many bits; none if they are
// not finite, or far from the frame.
template <std::size_t N>
std::optional<IntegerRow<N>> on_grid(const Arrangement<N>& arrangement,
                                     const std::array<double, N>& shares, int bits) {
  IntegerRow<N> b;
  Integer last = Integer(1) << static_cast<unsigned>(bits);
  for (std::size_t k = 0; k < N; ++k) {
    const double scaled = std::ldexp(shares[k], bits);
    if (!(std::abs(scaled) < 0x1p62)) return {};
    b[k] = k + 1 < N ? Integer(static_cast<long long>(std::nearbyint(scaled))) : last;
    last -= b[k];
  }
  for (std::size_t k = 0; k < N; ++k) {
    for (std::size_t j = 0; j < N; ++j) {
      if (j != k) b[k] *= arrangement.frame()[j].w;
    }
  }
  return b;
}

// The mean of the corners: the sum of weight b / (b.W).
template <std::size_t N>
IntegerRow<N> exact_mean(Arrangement<N>& arrangement, const ConvexPiece<N>& piece,
                         unsigned attempt) {
  Integer product = 1;
  for (const auto& corner : piece.corners) {
    product *= arrangement.weight(arrangement.exact(corner.at));
  }
  IntegerRow<N> sum{};
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const IntegerRow<N>& b = arrangement.exact(piece.corners[i].at);
    const Integer scale = product / arrangement.weight(b) * corner_weight(i, attempt);
    for (std::size_t k = 0; k < N; ++k) add_product(sum[k], scale, b[k]);
  }
  return sum;
}

/// Coordinates of a point strictly inside the piece: on a coarse grid if there is one near the
/// weighted mean of the corners. Points of different attempts differ.
template <std::size_t N>
[[nodiscard]] IntegerRow<N> interior_of(Arrangement<N>& arrangement, const ConvexPiece<N>& piece,
                                        unsigned attempt = 0) {
  const std::array<double, N> mean = near_mean(arrangement, piece, attempt);
  for (const int bits : {8, 16, 32, 48}) {
    if (attempt > 0 && bits < 32) continue;
    const auto b = on_grid(arrangement, mean, bits);
    if (!b) break;
    if (is_inside_piece(arrangement, piece, *b)) return *b;
  }
  IntegerRow<N> b = exact_mean(arrangement, piece, attempt);
  CONVEXACT_ASSERT(is_inside_piece(arrangement, piece, b));
  return b;
}

}  // namespace convexact
