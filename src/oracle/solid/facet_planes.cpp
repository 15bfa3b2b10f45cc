// SPDX-License-Identifier: MIT
#include "oracle/solid/facet_planes.hpp"

#include <algorithm>
#include <ranges>

#include "convexact/geometry.hpp"

namespace convexact {

FacetPlanes::FacetPlanes(const Hull& hull, std::span<const Halfspace> planes)
    : facets_(hull.facets), planes_(planes) {
  for (std::uint32_t f = 0; f < facets_.size(); ++f) {
    const std::span<const PointId> corners = facets_[f];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      sides_.push_back({key(corners[k], corners[(k + 1) % corners.size()]), f});
    }
  }
  std::sort(sides_.begin(), sides_.end());
}

bool FacetPlanes::have(const Halfspace& plane) {
  if (sorted_.empty()) {
    sorted_.assign(planes_.begin(), planes_.end());
    std::sort(sorted_.begin(), sorted_.end());
  }
  return std::binary_search(sorted_.begin(), sorted_.end(), plane);
}

// A side of the facet runs between the first two corners, unless the face is a piece of it.
bool FacetPlanes::surely_have(std::span<const std::uint32_t> corners,
                              const RationalVector3& area_vector) const {
  constexpr std::size_t kMostPairs = 64;  // of corners to be compared
  for (const auto& [from, to] : {std::pair{0, 1}, std::pair{1, 0}}) {
    const Side wanted{key(PointId(corners[from]), PointId(corners[to])), 0};
    const auto side = std::lower_bound(sides_.begin(), sides_.end(), wanted);
    if (side == sides_.end() || side->first != wanted.first) continue;
    const std::span<const PointId> facet = facets_[side->second];
    if (facet.size() * corners.size() > kMostPairs) continue;
    const bool has_all = std::ranges::all_of(corners, [&](std::uint32_t c) {
      return std::ranges::find(facet, PointId(c)) != facet.end();
    });
    if (has_all) return planes_[side->second].normal().cast<Rational>().dot(area_vector) > 0;
  }
  return false;
}

}  // namespace convexact
