// SPDX-License-Identifier: MIT
// removal_cost.hpp - the cost of removing a halfspace, by definition, how accurately doubles can
// compute it, and the confirmation of judged costs.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/verify_order.hpp"
#include "number/roundoff.hpp"

namespace convexact {

/// The unit of rounding() below: doubles hold a dual point with a relative error of 2^-52 per
/// coordinate (FastDual::kNearError), that is one; a term of the cap's volume has at most eight
/// determinants as factors (fast/cap_volume.hpp), each of about a dozen operations that are off by
/// 2^-53, that is 8 * 12 / 2 = 48 more. 64 leaves room for the sum of the terms.
inline constexpr double kPlaneRounding = 64 * 2 * kUnitRoundoff;

/// The price of one removal from a bounded solid.
struct RemovalCost {
  /// The exact growth of the measure; none if the rest is unbounded.
  std::optional<Cost> cost;
  /// The largest error of a cost when each plane is off by kPlaneRounding, in units of the cost; 0
  /// if it is unbounded; none if a plane with that error may not bound the cap at all.
  ///
  /// Take the center as origin, so that planes are P.x = 1. A relative error e per coordinate of P
  /// moves the plane, seen from the center at a point x of it, by the share e |P|.|x| at most
  /// (absolute values by coordinate), so by e k, where k is the largest such product over the cap's
  /// planes and its box. In a direction that meets the facet, the cap reaches from radius r to R,
  /// so it is the integral of (R^3 - r^3) / 3 over these directions. When r and R are off by the
  /// share e k each, that changes by the integral of (R^3 + r^3) e k to first order:
  ///   3 e k (2 cone + cost),  cone = the pyramid from the center over the facet.
  /// With e k >= 1, P.x = 1 +- e k may be 0 or less: seen from the center, the plane is turned
  /// away.
  ///
  /// Areas and mean widths, to first order too. A plane at the distance w from the center moves by
  /// e k w at most along its normal, at each point of the cap. Where two planes meet in an edge of
  /// length l at the exterior angle theta, the area changes by l tan(theta / 2) times the sum of
  /// both motions; so the area of the cap's edges, on the base or not, by
  ///   e k sum of l (w_q + w_r) tan(theta / 2).
  /// The mean width is the integral over all directions of the support function h, over 2 pi. What
  /// h is before and after the removal differs, for planes that are off too, only in directions
  /// between the normals of planes through corners of the cap (where several planes share a corner,
  /// those off may meet the cap that did not before). If rho, the largest angle between these and
  /// the normal removed, is at most a right angle, that is a share of (1 - cos rho) / 2 of the
  /// sphere, or less. There h is at most the distance R from the center to the farthest point of
  /// the cap, and it is off by e k h, with these planes in k, hence
  ///   e k 2 R (1 - cos rho).
  std::optional<Rational> rounding;
};

/// A set of halfspaces with a bounded intersection, and the cost of each removal from it. All
/// intersections are computed from scratch, without an engine.
class RemovalOracle {
 public:
  /// @param halfspaces  None redundant. @param center  Strictly inside.
  /// @throws Error  InvalidArgument if the center is not inside or the intersection is unbounded;
  ///                Stopped when the watch ends the call.
  /// @par Cost      Expected O(n log n).
  RemovalOracle(std::vector<Halfspace> halfspaces, const RationalPoint& center,
                CostMeasure measure = CostMeasure::Volume, const Watch& watch = {});

  /// The measure of all but `removed` less that of all. @par Cost  Expected O(n log n) again.
  RemovalCost without(const Halfspace& removed) const;

 private:
  std::vector<Halfspace> halfspaces_;
  RationalPoint center_;
  CostMeasure measure_;
  Watch watch_;
  Polytope polytope_;
  Cost whole_ = Rational(0);
};

/// The intersection of halfspaces from scratch; none if it is unbounded.
/// @param center  Strictly inside. @throws Error InvalidArgument if it is not.
[[nodiscard]] std::optional<Polytope> intersect(std::span<const Halfspace> halfspaces,
                                                const RationalPoint& center);

/// The halfspaces that are left before step `step`, in canonical order; those that were left out
/// are not among them.
[[nodiscard]] std::vector<Halfspace> left_before(const TraceVerdict& verdict, std::size_t step);

/// Checks cost and boundedness of the removal that a step made and of the one that it should have
/// made.
/// @throws Error Internal if they differ from those of the step; Stopped when the watch ends the
///         call.
void confirm_step(const TraceVerdict& verdict, const RationalPoint& center, std::size_t step,
                  const Watch& watch = {});

/// Checks that the measure before the first step plus all costs is the measure after the last
/// bounded one: volumes modulo two random primes, areas and mean widths by enclosures of 256 bits.
/// @throws Error Internal if not; Stopped when the watch ends the call.
void confirm_sum(const TraceVerdict& verdict, const RationalPoint& center, const Watch& watch = {});

}  // namespace convexact
