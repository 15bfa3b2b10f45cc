// SPDX-License-Identifier: MIT
#include "convexact/overlay.hpp"
#include "overlay/six_volumes.hpp"
#include "overlay/union_boundary.hpp"

namespace convexact {

Measured union_volume(std::span<const ConvexPart> parts, long precision, bool exact,
                      const Watch& watch) {
  std::vector<BoundingBox> boxes;
  std::vector<RationalPoint> ends;
  for (const ConvexPart& part : parts) {
    if (!part.solid) continue;
    boxes.push_back(part.box);
    ends.push_back(part.box.low);
    ends.push_back(part.box.high);
  }
  if (boxes.empty()) {
    return {Enclosure(precision), exact ? std::optional<Rational>(0) : std::nullopt};
  }
  const UnionBoundary boundary(parts, common_exponent(boxes));
  const auto add_boundary = [&](SixVolumes& sum) {
    std::size_t done = 0;
    for (const UnionBoundary::FacetId f : boundary.facets()) {
      watch.at(done++, boundary.facets().size());
      if (auto rest = boundary.rest(f)) sum.add(rest->arrangement, rest->pieces, true);
    }
  };
  return measure_inside(bounding_box(ends).middle(), precision, exact, add_boundary);
}

}  // namespace convexact
