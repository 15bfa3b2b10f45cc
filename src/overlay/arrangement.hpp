// SPDX-License-Identifier: MIT
// arrangement.hpp - where planes of space meet in a triangle's plane, or on a segment's line. Every
// corner is where given lines meet, so no number grows with the cuts.
//
// A point of the plane through three points with homogeneous coordinates (X, W), W > 0, is a sum
// b_1 (X_1, W_1) + b_2 (X_2, W_2) + b_3 (X_3, W_3) and has the coordinates b there. A plane of
// space h is the row r = (h(X_1, W_1), h(X_2, W_2), h(X_3, W_3)) of integers: r.b is positive
// beyond it. Two rows meet in their cross product. On a line there are two coordinates, and one
// row is a point. docs/design/overlay.md explains the rest.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"
#include "number/roundoff.hpp"

namespace convexact {

template <std::size_t N>
using IntegerRow = std::array<Integer, N>;

template <std::size_t N>
[[nodiscard]] Integer dot(const IntegerRow<N>& a, const IntegerRow<N>& b) {
  Integer sum = a[0] * b[0];
  for (std::size_t k = 1; k < N; ++k) add_product(sum, a[k], b[k]);
  return sum;
}

/// Doubles in proportion to integers, the largest in [1/2, 1): each off by a relative 2 u, or by
/// kFlushed if it is smaller than that. Zeros for zeros.
inline constexpr double kFlushed = 0x1p-1000;
template <std::size_t N>
[[nodiscard]] std::array<double, N> near_row(const IntegerRow<N>& row) {
  std::array<double, N> near{};
  std::array<long, N> exponent{};
  long top = std::numeric_limits<long>::min();
  for (std::size_t k = 0; k < N; ++k) {
    if (row[k].is_zero()) continue;
    near[k] = mpz_get_d_2exp(&exponent[k], raw(row[k]));  // cut off, not rounded: 2 u
    top = std::max(top, exponent[k]);
  }
  for (std::size_t k = 0; k < N; ++k) {
    if (near[k] == 0) continue;
    near[k] =
        exponent[k] - top < -1000 ? 0 : std::ldexp(near[k], static_cast<int>(exponent[k] - top));
  }
  return near;
}

/// Rows and points in a frame of N points: three that span a plane (N = 3), or two that span a line
/// (N = 2). Signs are exact.
template <std::size_t N>
class Arrangement {
  static_assert(N == 2 || N == 3);

 public:
  using RowId = std::uint32_t;
  using VertexId = std::uint32_t;

  /// Starts with rows 0 to N - 1, where coordinate k is negative beyond row k, and with vertices 0
  /// to N - 1, the points of the frame.
  explicit Arrangement(const std::array<HomogeneousPoint, N>& frame) : frame_(frame) {
    for (std::size_t k = 0; k < N; ++k) weights_.exact[k] = frame_[k].w;
    weights_.near = near_row(weights_.exact);
    for (std::size_t k = 0; k < N; ++k) {
      IntegerRow<N> side{}, corner{};
      side[k] = -1;
      corner[k] = 1;
      add(std::move(side));
      Vertex& v = vertices_.emplace_back();
      std::size_t own = 0;
      for (std::size_t j = 0; j < N; ++j) {
        if (j != k) v.rows[own++] = static_cast<RowId>(j);
      }
      v.near[k] = 1;
      v.exact = std::move(corner);
      v.is_settled = true;
    }
  }

  const std::array<HomogeneousPoint, N>& frame() const { return frame_; }

  RowId add(const Halfspace& plane) {
    IntegerRow<N> row;
    for (std::size_t k = 0; k < N; ++k) row[k] = plane_value(plane, frame_[k]);
    return add(std::move(row));
  }

  RowId add(IntegerRow<N> row) {
    strip_powers_of_two(row);
    Row& added = rows_.emplace_back();
    added.near = near_row(row);
    added.exact = std::move(row);
    return static_cast<RowId>(rows_.size() - 1);
  }

  /// Whether the whole plane or line lies on the row's plane.
  bool is_zero(RowId row) const {
    for (const Integer& x : rows_[row].exact) {
      if (!x.is_zero()) return false;
    }
    return true;
  }

  /// Where N - 1 rows meet. Precondition: in one point, at a finite place.
  VertexId meet(const std::array<RowId, N - 1>& rows);

  /// Positive beyond the row.
  Sign side(VertexId vertex, RowId row);

  /// The coordinates b, with the weight b.W > 0.
  const IntegerRow<N>& exact(VertexId vertex) {
    if (!vertices_[vertex].is_settled) settle(vertices_[vertex]);
    return vertices_[vertex].exact;
  }
  Integer weight(const IntegerRow<N>& b) const { return dot(b, weights_.exact); }

  /// In proportion to b_k W_k, the shares of the frame's points in the vertex; sum 1 up to
  /// rounding.
  std::array<double, N> near_shares(VertexId vertex) const {
    std::array<double, N> shares;
    double sum = 0;
    for (std::size_t k = 0; k < N; ++k) {
      sum += shares[k] = vertices_[vertex].near[k] * weights_.near[k];
    }
    for (double& s : shares) s /= sum;
    return shares;
  }

  Sign side(const IntegerRow<N>& b, RowId row) const { return sign_of(dot(b, rows_[row].exact)); }

  RationalPoint point(const IntegerRow<N>& b) const {
    const Integer w = weight(b);
    RationalPoint p;
    for (int i = 0; i < 3; ++i) {
      Integer sum = b[0] * frame_[0].n[i];
      for (std::size_t k = 1; k < N; ++k) add_product(sum, b[k], frame_[k].n[i]);
      p[i] = Rational(sum, w);
    }
    return p;
  }
  RationalPoint point(VertexId vertex) { return point(exact(vertex)); }

 private:
  struct Row {
    IntegerRow<N> exact;
    std::array<double, N> near{};  // near_row()
  };
  struct Vertex {
    std::array<RowId, N - 1> rows{};
    std::array<double, N> near{};  // a positive multiple of the coordinates, at most 1 in size
    double error = 0;              // each component is off by at most this
    bool is_settled = false;       // `exact` is known
    IntegerRow<N> exact;
  };

  // The sum of products of a row and a vertex, and a bound of its error. To first order a
  // product is off by 2 u of itself from the row, by u from rounding and by |row| error from the
  // vertex, a sum of three by 2 u of all; 8 u covers the higher orders. Flushed and underflowing
  // entries lose less than 3 (2^-1000 + 2^-1074), as the other factor is at most 1.
  static NearValue near_value(const Row& row, const std::array<double, N>& x, double error) {
    double sum = 0, size = 0, length = 0;
    for (std::size_t k = 0; k < N; ++k) {
      const double term = row.near[k] * x[k];
      sum += term;
      size += std::abs(term);
      length += std::abs(row.near[k]);
    }
    return {sum, 8 * kUnitRoundoff * size + 1.0001 * length * error + 0x1p-990};
  }

  static void strip_powers_of_two(IntegerRow<N>& row) {
    mp_bitcnt_t common = std::numeric_limits<mp_bitcnt_t>::max();
    for (const Integer& x : row) {
      if (!x.is_zero()) common = std::min(common, mpz_scan1(raw(x), 0));
    }
    if (common == 0 || common == std::numeric_limits<mp_bitcnt_t>::max()) return;
    for (Integer& x : row) mpz_tdiv_q_2exp(raw(x), raw(x), common);
  }

  void settle(Vertex& v);

  std::array<HomogeneousPoint, N> frame_;
  Row weights_;  // a point at a finite place has b.W != 0; the sign of b is chosen so that b.W > 0
  std::vector<Row> rows_;
  std::vector<Vertex> vertices_;
};

template <std::size_t N>
void Arrangement<N>::settle(Vertex& v) {
  const IntegerRow<N>& a = rows_[v.rows[0]].exact;
  if constexpr (N == 2) {
    v.exact[0] = -a[1];
    v.exact[1] = a[0];
  } else {
    const IntegerRow<N>& b = rows_[v.rows[1]].exact;
    for (std::size_t k = 0; k < 3; ++k) {
      v.exact[k] = a[(k + 1) % 3] * b[(k + 2) % 3];
      subtract_product(v.exact[k], a[(k + 2) % 3], b[(k + 1) % 3]);
    }
  }
  strip_powers_of_two(v.exact);
  const Integer w = weight(v.exact);
  CONVEXACT_ASSERT(!w.is_zero());
  if (w < 0) {
    for (Integer& x : v.exact) x = -x;
  }
  v.near = near_row(v.exact);
  v.error = 2 * kUnitRoundoff;
  v.is_settled = true;
}

template <std::size_t N>
typename Arrangement<N>::VertexId Arrangement<N>::meet(const std::array<RowId, N - 1>& rows) {
  Vertex& v = vertices_.emplace_back();
  v.rows = rows;
  const auto id = static_cast<VertexId>(vertices_.size() - 1);
  const std::array<double, N>& a = rows_[rows[0]].near;
  if constexpr (N == 2) {
    v.near = {-a[1], a[0]};
    v.error = 2 * kUnitRoundoff;
  } else {
    // To first order a product is off by 5 u of itself, from its factors and its rounding, and the
    // difference by u of both; 8 u covers the higher orders. Flushing costs less than 2^-998.
    const std::array<double, N>& b = rows_[rows[1]].near;
    double top = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double p = a[(k + 1) % 3] * b[(k + 2) % 3], q = a[(k + 2) % 3] * b[(k + 1) % 3];
      v.near[k] = p - q;
      top = std::max(top, std::abs(v.near[k]));
      size = std::max(size, std::abs(p) + std::abs(q));
    }
    v.error = 8 * kUnitRoundoff * size + 0x1p-990;
    if (!(top > 0x1p20 * v.error)) {  // too near to parallel
      settle(v);
      return id;
    }
    const int exponent = exponent_of(top);  // a power of two: exact, except for underflow
    for (double& x : v.near) x = std::ldexp(x, -exponent);
    v.error = std::ldexp(v.error, -exponent) + 0x1p-990;
  }
  const NearValue w = near_value(weights_, v.near, v.error);
  if (!w.surely_not_zero()) {
    settle(v);
  } else if (w.value < 0) {
    for (double& x : v.near) x = -x;
  }
  return id;
}

template <std::size_t N>
Sign Arrangement<N>::side(VertexId vertex, RowId row) {
  for (const RowId own : vertices_[vertex].rows) {
    if (own == row) return Sign::Zero;
  }
  const NearValue s = near_value(rows_[row], vertices_[vertex].near, vertices_[vertex].error);
  if (s.surely_positive()) return Sign::Positive;
  if (s.surely_negative()) return Sign::Negative;
  return sign_of(dot(exact(vertex), rows_[row].exact));
}

}  // namespace convexact
