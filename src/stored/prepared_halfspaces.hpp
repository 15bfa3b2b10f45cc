// SPDX-License-Identifier: MIT
// prepared_halfspaces.hpp - halfspaces that several sets of points are compared with: their
// doubles, which cost more than many a set, are made once.
#pragma once
#include <span>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "near/near_plane.hpp"

namespace convexact {

/// Several threads may ask at the same time.
class PreparedHalfspaces {
 public:
  /// Keeps a reference.
  explicit PreparedHalfspaces(std::span<const Halfspace> halfspaces);

  std::span<const Halfspace> exact() const { return exact_; }
  /// Of the same order.
  const std::vector<DoubleHalfspace>& near() const { return near_; }

 private:
  std::span<const Halfspace> exact_;
  std::vector<DoubleHalfspace> near_;
};

/// As find_outside() in convexact/stored.hpp.
[[nodiscard]] std::vector<PointId> find_outside(const PreparedHalfspaces& halfspaces,
                                                const PointSet& points, const Watch& watch = {});

}  // namespace convexact
