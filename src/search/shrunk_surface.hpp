// SPDX-License-Identifier: MIT
// shrunk_surface.hpp - the solid of the halfspaces that a search for the least volume has left.
#pragma once
#include <memory>
#include <vector>

#include "convexact/dual.hpp"
#include "fast/cap_volume.hpp"
#include "fast/dual.hpp"

namespace convexact {

/// A solid that loses halfspaces and regains them. Volumes in doubles are in a unit of the surface.
class ShrunkSurface {
 public:
  virtual ~ShrunkSurface() = default;
  /// Bounds of the volume that removing i adds; both infinite if that leaves the solid unbounded.
  virtual Interval<double> cost(HalfspaceId i) = 0;
  virtual Rational exact_cost(HalfspaceId i) = 0;
  /// Contains all halfspaces that share an edge with i.
  virtual std::vector<HalfspaceId> ring(HalfspaceId i) = 0;
  virtual void remove(HalfspaceId i) = 0;
  virtual void insert(HalfspaceId i) = 0;
  virtual Rational volume() const = 0;
  /// Bounds of a volume in the unit, and a volume from there.
  virtual Interval<double> in_unit(const Rational& volume) const = 0;
  virtual Rational from_unit(double volume) const = 0;
};

/// Every sign and every volume in integers and rationals. Starts with all halfspaces of the input.
/// @param dual  Of the input; must outlive the surface.
[[nodiscard]] std::unique_ptr<ShrunkSurface> make_exact_shrunk_surface(const DualHull& dual,
                                                                       const RationalPoint& center);

/// Volumes in doubles with bounds; exact ones where they are asked for.
/// @param dual  Must outlive the surface.
[[nodiscard]] std::unique_ptr<ShrunkSurface> make_filtered_shrunk_surface(const FastDual& dual);

}  // namespace convexact
