// SPDX-License-Identifier: MIT
// linear_program.hpp - linear programs in rationals, each outcome with its certificate; and what
// they say about halfspaces: whether these are empty, flat or bounded, and where an almost largest
// ball is.
//
// Each question has one exact answer, and each answer is a certificate: a few numbers that prove
// it. check() judges a certificate by the definition, without the solver.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/number.hpp"

namespace convexact {

// ---- Linear programs

using RationalMatrix = Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic>;

/// Maximise dot(c, x) subject to N x + d <= 0, row by row. Rows of zeros are allowed.
struct LinearProgram {
  RationalMatrix normals;    ///< N: n >= 0 rows, as many columns as x has coordinates.
  RationalVector offsets;    ///< d: n entries.
  RationalVector objective;  ///< c: one entry per coordinate; may be zero.
};

/// A positive factor of one row in a linear combination of rows; rows not named have factor 0.
struct Multiplier {
  std::size_t row;  ///< 0-based.
  Rational value;   ///< > 0.
};

/// No feasible point is better than x: `tight` proves c = sum of y_i n_i with n_i.x + d_i = 0.
struct Optimal {
  RationalVector x;
  std::vector<Multiplier> tight;  ///< At most as many as x has coordinates; none if c = 0.
};

/// No point is feasible: y >= 0, y'N = 0 and y'd > 0 [Farkas1902].
struct Infeasible {
  std::vector<Multiplier> farkas;  ///< At most one more than there are coordinates.
};

/// dot(c, x) grows without bound along start + t ray, t >= 0, which stays feasible:
/// N start + d <= 0, N ray <= 0, c'ray > 0.
struct Unbounded {
  RationalVector start;
  RationalVector ray;  ///< Coprime integers.
};

using LpOutcome = std::variant<Optimal, Infeasible, Unbounded>;

class LpObserver;

struct LpOptions {
  /// Of the order of the rows. Kind, x, start and ray do not depend on it; where more rows are
  /// tight than needed, multipliers may.
  std::uint64_t seed = 1;
  LpObserver* observer = nullptr;  ///< Of our lessons; null for none.
};

/// Solves a linear program by randomised incremental construction, exactly. Of several optimal
/// points it takes the lexicographically largest if there is one.
/// @throws Error InvalidArgument if the shapes of N, d and c do not fit.
/// @par Cost    Expected O(k! n) dot products of integers in k coordinates; memory O(k n).
/// @par Source  [Seidel1991]; infinity and certificates: docs/design/lp.md
[[nodiscard]] LpOutcome maximise(const LinearProgram& lp, const LpOptions& options = {});

// ---- Halfspaces: empty, flat, bounded

// Below, N and d are the normals (rows) and offsets of m >= 0 halfspaces and P = {x : N x + d <=
// 0}. A Multiplier's row is an index into the halfspaces. m = 0 is the whole space.

/// P is empty: y >= 0, y'N = 0, y'd > 0.
struct EmptyProof {
  std::vector<Multiplier> farkas;  ///< At most 4.
};

/// P is not empty and has no interior: `point` lies in P; y >= 0, y != 0, y'N = 0, y'd = 0, so
/// that P lies in the plane of every halfspace named.
struct FlatProof {
  RationalPoint point;
  std::vector<Multiplier> multipliers;  ///< At least 2, at most 4.
};

/// N point + d < 0.
struct InteriorPoint {
  RationalPoint point;  ///< Dyadic and short.
};

/// No direction leads to infinity: y > 0 (every entry), y'N = 0, and three normals are independent.
/// (N u <= 0 and y'N u = 0 give N u = 0, so u = 0.)
struct BoundedProof {
  std::vector<Rational> multipliers;    ///< m entries; all but at most three of them are equal.
  std::array<std::size_t, 3> spanning;  ///< Halfspaces whose normals are independent.
};

/// u != 0 and N u <= 0: from any point of P, P extends to infinity along u.
struct RecessionRay {
  RationalVector3 direction;
};

using InteriorOutcome = std::variant<InteriorPoint, FlatProof, EmptyProof>;
using BoundedOutcome = std::variant<BoundedProof, RecessionRay>;

/// Whether P is empty, flat or has an interior, bounded or not.
/// @par Cost  One LP in 4 variables, so expected O(m).
[[nodiscard]] InteriorOutcome find_interior(std::span<const Halfspace> halfspaces,
                                            const LpOptions& options = {});

/// Whether {u : N u <= 0} is {0}. A nonempty P is bounded iff it is. (An empty P is always bounded;
/// call find_interior() first.)
/// @par Cost  One LP in 3 variables, so expected O(m).
[[nodiscard]] BoundedOutcome find_recession(std::span<const Halfspace> halfspaces,
                                            const LpOptions& options = {});

/// Whether a certificate proves its claim, by the definition; shares no code with the solver.
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const EmptyProof& claim);
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const FlatProof& claim);
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const InteriorPoint& claim);
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const BoundedProof& claim);
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const RecessionRay& claim);

// ---- The Chebyshev center

/// A ball that is almost the largest one. Let r* be the largest radius of a Euclidean ball in the
/// (not necessarily bounded) intersection P of the halfspaces. Proven exactly:
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

/// Whether the two balls lie in P and no ball is larger than radius_high, by the definition; shares
/// no code with the solver.
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const ChebyshevCenter& claim);
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const UnboundedRadius& claim);

}  // namespace convexact
