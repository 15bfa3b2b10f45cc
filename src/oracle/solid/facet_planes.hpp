// SPDX-License-Identifier: MIT
// facet_planes.hpp - whether a face lies in a facet plane of a hull and looks outward.
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "convexact/hull.hpp"

namespace convexact {

class FacetPlanes {
 public:
  /// Keeps references. @param planes  Those of the hull's facets.
  FacetPlanes(const Hull& hull, std::span<const Halfspace> planes);

  /// Whether one of the planes is that of a face, which is not bent.
  [[nodiscard]] bool have(const Halfspace& plane);

  /// The same without the plane of the face, which costs more than all else. True if its corners
  /// are all those of one facet; false if that is to be asked with the plane.
  /// @param corners  At least two, ids of points. @param area_vector  Of the face; not zero.
  [[nodiscard]] bool surely_have(std::span<const std::uint32_t> corners,
                                 const RationalVector3& area_vector) const;

 private:
  using Side = std::pair<std::uint64_t, std::uint32_t>;  // its ends, and the facet to its left
  static std::uint64_t key(PointId from, PointId to) {
    return std::uint64_t{from.index()} << 32 | to.index();
  }
  const FacetList& facets_;
  std::span<const Halfspace> planes_;
  std::vector<Side> sides_;        // ascending
  std::vector<Halfspace> sorted_;  // once they are asked for
};

}  // namespace convexact
