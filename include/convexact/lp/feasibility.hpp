// SPDX-License-Identifier: MIT
// feasibility.hpp - is an intersection of halfspaces empty, flat, bounded? Each answer is a proof.
#pragma once
#include <array>
#include <span>
#include <variant>
#include <vector>

#include "convexact/geometry/halfspace.hpp"
#include "convexact/lp/linear_program.hpp"
#include "convexact/lp/seidel.hpp"

namespace convexact {

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

/// Whether P is empty, flat or has an interior. Bounded or not plays no part.
/// @par Cost  One LP in 4 variables, so expected O(m).
[[nodiscard]] InteriorOutcome find_interior(std::span<const Halfspace> halfspaces,
                                            const LpOptions& options = {});

/// Whether {u : N u <= 0} is {0}. For a nonempty P that means: whether P is bounded. (An empty P
/// is bounded whatever the answer; ask find_interior() first.)
/// @par Cost  One LP in 3 variables, so expected O(m).
[[nodiscard]] BoundedOutcome find_recession(std::span<const Halfspace> halfspaces,
                                            const LpOptions& options = {});

/// Whether a certificate proves its claim, from the definition; shares nothing with the solver.
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const EmptyProof& claim);
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const FlatProof& claim);
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const InteriorPoint& claim);
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const BoundedProof& claim);
[[nodiscard]] bool check(std::span<const Halfspace> halfspaces, const RecessionRay& claim);

}  // namespace convexact
