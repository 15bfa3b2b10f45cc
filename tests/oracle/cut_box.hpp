// SPDX-License-Identifier: MIT
// cut_box.hpp - [0, 4]^3 with corners cut off, so that every cost has a closed form.
#pragma once
#include <stdexcept>
#include <vector>

#include "convexact/dual.hpp"

/// The center of the cube.
inline const convexact::RationalPoint kCutBoxCenter(2, 2, 2);

/// One plane per entry, at most four of them, through the points at distance 0 < depth < 2 from a
/// corner along its edges; the corners are (0,0,0), (4,4,0), (4,0,4), (0,4,4), no two of an edge.
inline convexact::Halfspace corner_cut(std::size_t corner, const convexact::Rational& depth) {
  using namespace convexact;
  constexpr int kInward[4][3] = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  RationalVector3 outward;
  Rational highest = 0;  // of outward.x over the cube, attained at the corner
  for (int k = 0; k < 3; ++k) {
    outward[k] = -kInward[corner][k];
    if (outward[k] > 0) highest += 4;
  }
  return Halfspace(outward, depth - highest);
}

inline std::vector<convexact::Halfspace> cube_sides() {
  using namespace convexact;
  std::vector<Halfspace> sides;
  for (int k = 0; k < 3; ++k) {
    IntegerVector3 up = IntegerVector3::Zero();
    up[k] = 1;
    sides.push_back(Halfspace(up, -4));
    sides.push_back(Halfspace(IntegerVector3(-up), 0));
  }
  return sides;
}

/// Removing the cut of depth t costs t^3 / 6; removing a side is unbounded or, where a cut
/// leans over it, costs much more.
inline convexact::DualHull cut_box(const std::vector<convexact::Rational>& depths) {
  std::vector<convexact::Halfspace> planes = cube_sides();
  for (std::size_t c = 0; c < depths.size(); ++c) planes.push_back(corner_cut(c, depths[c]));
  return convexact::dual_of(planes, kCutBoxCenter).dual;
}

/// Where a plane stands in canonical order.
inline convexact::HalfspaceId id_of(const convexact::DualHull& solid,
                                    const convexact::Halfspace& plane) {
  for (std::size_t i = 0; i < solid.halfspaces.size(); ++i) {
    if (solid.halfspaces[i] == plane) return convexact::HalfspaceId(i);
  }
  throw std::logic_error("no such plane");
}
