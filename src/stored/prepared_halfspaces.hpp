// SPDX-License-Identifier: MIT
// prepared_halfspaces.hpp - halfspaces that several sets of points are compared with: their
// doubles, which cost more than many a set, are made once, and so are groups of them.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "near/near_plane.hpp"

namespace convexact {

/// A box of doubles.
struct CoordinateBox {
  double low[3], high[3];
};

/// Bounds of halfspaces with neighbouring normals, each divided by its largest component.
struct HalfspaceGroup {
  CoordinateBox normals;
  double largest_d = 0;     ///< The largest d.
  double largest_size = 0;  ///< The largest |d|.
  std::vector<std::uint32_t> members;

  /// Whether all points of the box are inside of all members.
  /// @param absolute  absolute_plane_error() of the box.
  bool surely_hold(const CoordinateBox& box, double absolute) const;
};

/// Several threads may ask at the same time.
class PreparedHalfspaces {
 public:
  /// Keeps a reference.
  explicit PreparedHalfspaces(std::span<const Halfspace> halfspaces);

  std::span<const Halfspace> exact() const { return exact_; }
  /// Of the same order.
  const std::vector<DoubleHalfspace>& near() const { return near_; }
  /// Each halfspace is in one of them. None where halfspaces are few: then single tests are faster.
  const std::vector<HalfspaceGroup>& groups() const { return groups_; }

 private:
  std::span<const Halfspace> exact_;
  std::vector<DoubleHalfspace> near_;
  std::vector<HalfspaceGroup> groups_;
};

/// As find_outside() in convexact/stored.hpp.
[[nodiscard]] std::vector<PointId> find_outside(const PreparedHalfspaces& halfspaces,
                                                const PointSet& points, const Watch& watch = {},
                                                std::size_t jobs = 1);

}  // namespace convexact
