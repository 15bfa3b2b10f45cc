// SPDX-License-Identifier: MIT
#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/simplify.hpp"
#include "convexact/stored.hpp"

namespace convexact {
namespace {

using Polygon = std::vector<std::uint32_t>;

// Whether a face of one part is inside the solid of another; no halfspaces are the empty set.
bool is_inside(const Polygon& face, const PointSet& points, std::span<const Halfspace> solid) {
  return !solid.empty() && std::all_of(face.begin(), face.end(), [&](std::uint32_t corner) {
    const RationalPoint point = points[PointId(corner)];
    return std::all_of(solid.begin(), solid.end(),
                       [&](const Halfspace& halfspace) { return halfspace(point) <= 0; });
  });
}

// For each point, whether it is outside the solid of its part.
std::vector<bool> points_outside(const PointSet& points, const std::vector<Halfspace>& solid,
                                 const Watch& watch) {
  std::vector<bool> is_outside(points.size(), solid.empty());
  for (const PointId p : find_outside(solid, points, watch)) is_outside[p.index()] = true;
  return is_outside;
}

}  // namespace

Gaps find_gaps(std::span<const SceneObject> parts, std::span<const std::vector<Halfspace>> solids,
               const Watch& watch) {
  if (parts.size() != solids.size()) {
    throw Error(ErrorCode::InvalidArgument, "the gap test needs a solid for each part");
  }
  Gaps gaps;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const auto* points = std::get_if<PointSet>(&parts[part].shape);
    const std::vector<Polygon>& faces = parts[part].polygons;
    if (points == nullptr || faces.empty()) continue;
    gaps.faces += faces.size();
    const std::vector<bool> is_outside = points_outside(*points, solids[part], watch);
    for (std::size_t face = 0; face < faces.size(); ++face) {
      const bool sticks_out = std::any_of(faces[face].begin(), faces[face].end(),
                                          [&](std::uint32_t corner) { return is_outside[corner]; });
      if (!sticks_out) continue;
      watch.ask();
      gaps.out_of_own.push_back({part, face});
      const bool is_elsewhere =
          std::any_of(solids.begin(), solids.end(), [&](const std::vector<Halfspace>& solid) {
            return &solid != &solids[part] && is_inside(faces[face], *points, solid);
          });
      if (!is_elsewhere) gaps.in_no_part.push_back({part, face});
    }
  }
  return gaps;
}

}  // namespace convexact
