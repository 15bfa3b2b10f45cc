// SPDX-License-Identifier: MIT
// chebyshev_center.hpp - the center of the largest ball in an intersection of halfspaces.
#pragma once
#include <span>
#include <variant>
#include <vector>

#include "convexact/lp/feasibility.hpp"

namespace convexact {

/// Rationals with lower <= |n| <= upper. Equal if |n| is a rational of at most 64 bits; else they
/// are 64-bit integers times a power of two and differ in the last bit.
struct NormEnclosure {
  Rational lower;
  Rational upper;
};

/// The Euclidean norm of an integer vector.
[[nodiscard]] NormEnclosure enclose_norm(const IntegerVector3& n);

/// A ball that is almost the largest one. Let r* be the largest radius of a Euclidean ball in the
/// (not necessarily bounded) intersection P of the halfspaces. What is proven, exactly:
/// - the ball of radius `radius_low` about `center` lies in P, and so does the ball of radius
///   `optimum_radius` about `optimum`;
/// - optimum_radius <= r* <= radius_high <= (1 + 2^-63) optimum_radius, all equal if
///   the norms of the normals named in `touching` are rationals of at most 64 bits;
/// - 0 < 0.9 optimum_radius < radius_low.
/// The largest ball need not be unique, so `center` need not be near any other one's center.
struct ChebyshevCenter {
  RationalPoint center;     ///< Dyadic: `optimum` on a grid of spacing at most optimum_radius / 16.
  Rational radius_low;      ///< The least -(n_i.center + d_i) / U_i, where U_i >= |n_i|.
  Rational radius_high;     ///< optimum_radius / sum of y_i L_i, where L_i <= |n_i|.
  RationalPoint optimum;    ///< Maximises r subject to n_i.x + d_i + U_i r <= 0.
  Rational optimum_radius;  ///< That maximum.
  /// y >= 0, y'N = 0, at most 4: a ball of radius r in P has y'd + r sum of y_i |n_i| <= 0. In the
  /// halfspaces named, n_i.optimum + d_i + U_i optimum_radius = 0.
  std::vector<Multiplier> touching;
};

/// Balls of any size fit: n_i.direction < 0 for every halfspace (0 serves if there is none).
struct UnboundedRadius {
  RationalVector3 direction;
};

using ChebyshevOutcome = std::variant<ChebyshevCenter, UnboundedRadius, FlatProof, EmptyProof>;

/// The Chebyshev center. P may be unbounded and still have one: |x| <= 1, |y| <= 1 has r* = 1.
/// @par Cost    One LP in 4 variables, so expected O(m).
/// @par Source  [BoydVandenberghe2004, sec. 8.5.1], made rational: docs/design/lp.md
[[nodiscard]] ChebyshevOutcome chebyshev_center(std::span<const Halfspace> halfspaces,
                                                const LpOptions& options = {});

/// Whether the two balls lie in P and none is larger than radius_high, from the definition; shares
/// nothing with the solver.
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const ChebyshevCenter& claim);
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const UnboundedRadius& claim);

}  // namespace convexact
