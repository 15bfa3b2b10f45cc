// SPDX-License-Identifier: MIT
// symmetries.hpp - the facets of a solid that its symmetries exchange.
#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/measure.hpp"

namespace convexact {

/// A permutation of facets: which one each becomes.
using Symmetry = std::vector<HalfspaceId>;

/// The symmetries of a solid among the 48 of a cube, which exchange coordinates and change their
/// signs, about the middle of the solid's box: a group, without the identity. Others hardly survive
/// the rounding of coordinates to doubles.
/// @param halfspaces  The facets of the solid.
/// @par Cost          48 searches for each facet if all of them are symmetries; for a solid without
///                    any mostly 48 in all.
[[nodiscard]] inline std::vector<Symmetry> symmetries_of(std::span<const Halfspace> halfspaces,
                                                         const Polytope& solid) {
  const RationalPoint middle = bounding_box(solid.vertices).middle();
  std::vector<Halfspace> centered;
  std::map<Halfspace, HalfspaceId> ids;
  for (const Halfspace& halfspace : halfspaces) {
    centered.emplace_back(halfspace.normal().cast<Rational>(), halfspace(middle));
    ids.emplace(centered.back(), HalfspaceId(ids.size()));
  }
  std::vector<Symmetry> symmetries;
  std::array<int, 3> axes = {0, 1, 2};
  do {
    for (unsigned turned = 0; turned < 8; ++turned) {
      Symmetry symmetry;
      for (const Halfspace& halfspace : centered) {
        IntegerVector3 normal;
        for (const int k : {0, 1, 2}) {
          const Integer& part = halfspace.normal()[axes[static_cast<std::size_t>(k)]];
          normal[k] = (turned >> k & 1) != 0 ? Integer(-part) : part;
        }
        const auto found = ids.find(Halfspace(std::move(normal), halfspace.offset()));
        if (found == ids.end()) break;
        symmetry.push_back(found->second);
      }
      const bool is_identity = turned == 0 && std::is_sorted(axes.begin(), axes.end());
      if (symmetry.size() == centered.size() && !is_identity) {
        symmetries.push_back(std::move(symmetry));
      }
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return symmetries;
}

}  // namespace convexact
