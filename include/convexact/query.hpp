// SPDX-License-Identifier: MIT
// query.hpp - questions about solids, answered exactly: whether two overlap, where a ray meets one,
// and how many random probes hit one that encloses another without hitting that one.
//
// Solids are closed sets: touching counts. Facets are named by their positions in
// Polytope::planes, so in canonical order.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/number.hpp"
#include "convexact/scene.hpp"

namespace convexact {

/// The solid of a shape: the hull of points or the intersection of halfspaces, its certificates
/// checked; or why there is none. The seed is for random orders; the answer does not depend on it.
/// @throws Error Stopped; Internal if a certificate fails.
[[nodiscard]] std::variant<Polytope, NotSolid> queried_solid(const Shape& shape,
                                                             std::uint64_t seed = 1);

// ---- Overlap

/// A point of both solids.
struct CommonPoint {
  RationalPoint point;
};

/// Two solids without a common point. The multipliers y > 0 of facets n.x + d <= 0 of both, at
/// most 4, have y'N = 0 and y'd > 0, so no point satisfies all of these facets [Farkas1902]. With
/// n the sum of y_i n_i over `of_a`, the points of A have n.x <= a and those of B have n.x >= b,
/// where b - a = y'd.
struct Separation {
  std::vector<Multiplier> of_a, of_b;  ///< Rows are facets.
  /// n.x <= (a + b) / 2: A is strictly inside and B strictly outside.
  Halfspace plane;
};

using Overlap = std::variant<CommonPoint, Separation>;

/// The lexicographically largest common point of two solids, or the proof that there is none.
/// @param seed  Of the order of insertion. Where several sets of facets prove the same, the
///              multipliers may depend on it.
/// @par Cost    One LP in 3 variables, so expected time linear in the facets; and a product for
///              each vertex of solids that are apart.
/// @par Source  [Jacobson2026, eq. 1], [Seidel1991]
[[nodiscard]] Overlap find_overlap(const Polytope& a, const Polytope& b, std::uint64_t seed = 1);

/// Whether an answer is true, by the definition: the point satisfies every facet of both; or the
/// multipliers prove that no point does, and all vertices of A are strictly inside of the plane
/// and all of B strictly outside. Shares no code with the solver.
[[nodiscard]] bool check(const Polytope& a, const Polytope& b, const CommonPoint& claim);
[[nodiscard]] bool check(const Polytope& a, const Polytope& b, const Separation& claim);
[[nodiscard]] bool check(const Polytope& a, const Polytope& b, const Overlap& claim);

// ---- Rays

/// origin + t direction for t >= 0.
struct Ray {
  RationalPoint origin;
  RationalVector3 direction;  ///< Nonzero; t is in units of its length.
};

/// The points of a line within a solid: entry <= t <= exit, equal where the line only touches.
struct LineInterval {
  Rational entry, exit;
  /// Every facet whose plane the line crosses inwards at `entry`, or outwards at `exit`;
  /// ascending. Planes that the line lies in are not crossed.
  std::vector<HalfspaceId> entry_facets, exit_facets;
};

/// Where a ray meets a solid.
struct RayAnswer {
  /// The interval of the ray's whole line, so that entry < 0 <= exit identifies a ray that begins
  /// inside; nothing if the line misses the solid.
  std::optional<LineInterval> line;
  /// Without a hit: one or two facets that no point of the ray satisfies together.
  std::vector<HalfspaceId> missed;

  bool is_hit() const { return missed.empty(); }
  /// The first t >= 0 in the solid: max(0, entry). Precondition: a hit.
  Rational first() const { return line->entry > 0 ? line->entry : Rational(0); }
};

/// Intersects a ray with a solid, exactly. A ray that touches a vertex, an edge or a facet hits.
/// @throws Error InvalidArgument if the direction is zero.
/// @par Cost    Two dot products of integers per facet, and the fractions of entry and exit.
/// @par Source  [Jacobson2026, eqs. 6 to 9]
[[nodiscard]] RayAnswer cast_ray(const Polytope& solid, const Ray& ray);

/// Whether an answer is true, by the definition: both ends lie in the solid and on the planes of
/// their facets, which bound the line there; or the facets of the miss exclude the whole ray.
[[nodiscard]] bool check(const Polytope& solid, const Ray& ray, const RayAnswer& claim);

/// Rays from lines "ox oy oz ux uy uz". Integers and fractions are exact; a number spelled with a
/// point or an exponent is read by `decimal`. A token that starts with # ends its line.
/// @throws Error Malformed with the line, also for a zero direction and if there is no ray at all;
///               NotFinite for decimals beyond the largest double.
[[nodiscard]] std::vector<Ray> read_rays_bytes(std::string_view bytes,
                                               Decimal decimal = Decimal::Nearest);

/// @throws Error as read_rays_bytes, with the path in front; Unreadable as read_bytes.
[[nodiscard]] std::vector<Ray> read_rays(const std::string& path,
                                         Decimal decimal = Decimal::Nearest);

// ---- False positives

struct FalsePositiveRequest {
  std::size_t lines = 1000, planes = 1000, points = 1000;  ///< How many probes; 0 for none.
  std::uint64_t seed = 1;                                  ///< Of the probes.
  Watch watch = {};
};

/// The probes of one kind, each decided exactly.
struct ProbeTally {
  std::size_t samples = 0;
  std::size_t hits_a = 0, hits_b = 0;
  std::size_t only_b = 0;  ///< False positives: they hit B and not A.
  std::size_t only_a = 0;  ///< They hit A and not B: none if A is inside B.
  std::size_t exact = 0;   ///< Decisions that doubles left open.
  /// The number of hits of B to be expected: samples times the measure of B over that of the ball.
  Enclosure expected_b;
  /// 1 - measure of A / measure of B, the expected rate; only if A is inside B.
  std::optional<Enclosure> prediction;

  /// Of the probes that hit B, the share that miss A; nothing if there are none.
  std::optional<double> rate() const;
  /// The standard deviation of rate(), given hits_b, if `prediction` is its expectation.
  std::optional<double> sigma() const;
};

/// A vertex of A that is not in B.
struct EscapingVertex {
  std::uint32_t vertex;  ///< The lowest one.
  HalfspaceId facet;     ///< Of B, the lowest one that the vertex is beyond.
};

/// How often something hits B and not A. Lines are measured by the area, planes by the mean width
/// and points by the volume of what they hit [Santalo2004].
struct FalsePositives {
  std::optional<EscapingVertex> outside;  ///< Nothing: A is inside B, which is proven exactly.
  RationalPoint center;                   ///< Of the ball of the probes.
  Rational radius;
  std::optional<ProbeTally> lines, planes, points;  ///< Each if samples were asked for.
};

/// Casts random probes at both solids: lines through two independent uniform points of a sphere
/// around both, planes of uniform direction and uniform offset within it, and uniform points of
/// its ball. The center is that of the box around both, so that the probes depend on nothing but
/// the solids, the seed and the numbers of samples. They are the same on every machine: doubles
/// in the frame of the sphere, drawn by rejection, so that a scaling of both by a power of two, or
/// a translation, changes no count.
/// @throws Error Stopped; Unrepresentable if a measure is beyond an Enclosure's range.
/// @par Cost    A product in doubles per facet (lines, points) or vertex (planes) and probe; exact
///              numbers only where these leave a sign open. In addition, the measures of both
///              solids.
/// @par Source  [Jacobson2026, fig. 12], [Marsaglia1972] for points of a sphere
[[nodiscard]] FalsePositives count_false_positives(const Polytope& a, const Polytope& b,
                                                   const FalsePositiveRequest& request = {});

}  // namespace convexact
