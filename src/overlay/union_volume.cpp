// SPDX-License-Identifier: MIT
#include "convexact/overlay.hpp"
#include "overlay/six_volumes.hpp"
#include "overlay/union_boundary.hpp"
#include "task/parallel.hpp"

namespace convexact {

Measured union_volume(std::span<const ConvexPart> parts, long precision, bool exact,
                      const Watch& watch, std::size_t jobs) {
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
    using Term = std::optional<SixVolumes::Term>;
    take_in_order(
        boundary.facets().size(), jobs, watch,
        [&](std::size_t k, const Watch&) -> Term {
          auto rest = boundary.rest(boundary.facets()[k]);
          if (!rest) return {};
          return sum.term(rest->arrangement, rest->pieces, true);
        },
        [&](std::size_t, Term term) {
          if (term) sum.add(std::move(*term));
          return true;
        },
        4);
  };
  return measure_inside(bounding_box(ends).middle(), precision, exact, add_boundary);
}

}  // namespace convexact
