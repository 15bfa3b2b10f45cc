// SPDX-License-Identifier: MIT
// solid.hpp - the stages from a shape to its solid, and from a solid to the formats that store it.
#pragma once
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/hull.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/scene.hpp"
#include "solid/stage_log.hpp"

namespace convexact {

/// A shape that has a volume, with the stages that showed it.
struct Solid {
  Polytope polytope;
  DualHull dual;
  /// The points that a result must hold: the input's, or the vertices of the input's polytope.
  PointSet points;
  std::vector<PointId> extreme;        ///< Of `points`: those whose hull holds the rest.
  std::size_t input_points = 0;        ///< 0 where the input is halfspaces.
  std::vector<std::size_t> redundant;  ///< Of halfspace input.
  std::vector<std::size_t> hull_rows;  ///< Of halfspace input, as HalfspaceDual has them.
  HullCertificate certificate;         ///< Of point input.
  /// Strictly inside; set only if the construction of the dual needed it.
  std::optional<RationalPoint> interior;
};

using SolidOutcome = std::variant<Solid, NotSolid>;

struct SolidOptions {
  std::uint64_t seed = 1;  ///< Of every random order; nothing depends on it.
  bool check = true;       ///< Whether certificates are checked, each as a separate stage.
  bool wants_dual = true;  ///< If not, the solid of points gets no dual, which only removals need.
  /// Sees the hull grow, of the points or of the halfspaces' dual points; null for none.
  HullObserver* observer = nullptr;
  std::size_t jobs = 1;  ///< Threads, at least 1; nothing depends on them.
};

/// The hull of points with its certificate checked if asked for, or why there is none.
/// @throws Error Internal if a certificate fails.
[[nodiscard]] std::variant<Hull, NotSolid> make_hull(const PointSet& points,
                                                     const SolidOptions& options, StageLog& log);

/// The intersection of halfspaces, whose vertices may be beyond the largest double, or why it is no
/// bounded solid. @throws Error Internal if a certificate fails.
[[nodiscard]] std::variant<Polytope, NotSolid> make_polytope(std::span<const Halfspace> halfspaces,
                                                             std::uint64_t seed, StageLog& log);

/// Runs the stages that the shape needs and notes in `log` those that it does not.
/// @throws Error Internal if a certificate fails.
[[nodiscard]] SolidOutcome make_solid(const Shape& shape, const SolidOptions& options,
                                      StageLog& log);

/// A point strictly inside, for callers that need no deeper one: the one that is set, or the mean
/// of the solid's vertices on a short grid.
[[nodiscard]] RationalPoint interior_point_of(const Solid& solid);

/// The center that a caller gives. @throws Error InvalidArgument unless it is strictly inside.
[[nodiscard]] RationalPoint given_center(const RationalPoint& center,
                                         std::span<const Halfspace> halfspaces, StageLog& log);

/// The center of a ball that is nearly the largest one inside, with its certificate.
/// @throws Error Internal if the certificate fails.
[[nodiscard]] ChebyshevCenter certified_center(std::span<const Halfspace> halfspaces,
                                               const LpOptions& options, StageLog& log);

/// Rounds outward to each format asked for, and proves it. @param extreme  Of `points`: those whose
/// hull holds the rest.
/// @throws Error Unrepresentable if a format cannot hold the solid; Internal if a proof fails.
[[nodiscard]] Stored store(Polytope exact, const PointSet& points, std::span<const PointId> extreme,
                           const StoreRequest& request, StageLog& log);

}  // namespace convexact
