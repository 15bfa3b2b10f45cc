// SPDX-License-Identifier: MIT
// solid.hpp - from an input, points or halfspaces, to the dual hull that every engine starts from.
#pragma once
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "convexact/dual/dual_hull.hpp"
#include "convexact/pipeline/not_solid.hpp"
#include "convexact/pipeline/stage.hpp"

namespace convexact {

/// What is to be enclosed: the hull of points, or an intersection of halfspaces.
using Shape = std::variant<PointSet, std::vector<Halfspace>>;

/// A shape that has a volume, with the stages that showed it.
struct Solid {
  Polytope polytope;
  DualHull dual;
  /// The points that a result must hold: the input's, or the vertices of the input's polytope.
  PointSet points;
  std::vector<PointId> extreme;               ///< Of `points`: those whose hull holds the rest.
  std::size_t input_points = 0;               ///< 0 where the input is halfspaces.
  std::vector<RedundantHalfspace> redundant;  ///< Of halfspace input.
  HullCertificate certificate;                ///< Of point input.
  /// Strictly inside; known beforehand only where the way to the dual needed it.
  std::optional<RationalPoint> interior;
};

using SolidOutcome = std::variant<Solid, NotSolid>;

/// The hull of points with its certificate checked if asked for, or why there is none.
/// @throws Error Internal if a certificate fails.
[[nodiscard]] std::variant<Hull, NotSolid> make_hull(const PointSet& points, std::uint64_t seed,
                                                     bool check, StageLog& log);

/// The intersection of halfspaces, whose vertices may be beyond the largest double, or why it is no
/// bounded solid. @throws Error Internal if a certificate fails.
[[nodiscard]] std::variant<Polytope, NotSolid> make_polytope(std::span<const Halfspace> halfspaces,
                                                             std::uint64_t seed, StageLog& log);

/// Runs the stages that the shape needs and notes in `log` those that it does not.
/// @param check  Whether the certificates of the stages are checked, each a stage of its own.
/// @throws Error Internal if a certificate fails.
[[nodiscard]] SolidOutcome make_solid(const Shape& shape, std::uint64_t seed, bool check,
                                      StageLog& log);

/// A point strictly inside for programs that need no deeper one: the one that is known, or the mean
/// of the solid's vertices on a short grid.
[[nodiscard]] RationalPoint interior_point_of(const Solid& solid);

}  // namespace convexact
