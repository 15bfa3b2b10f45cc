// SPDX-License-Identifier: MIT
#include "convexact/mass.hpp"
#include "measure/mass_sum.hpp"
#include "overlay/solid_boundary.hpp"
#include "overlay/union_boundary.hpp"

namespace convexact {
namespace {

void add_piece(MassSum& sum, Arrangement<3>& arrangement, const ConvexPiece<3>& piece,
               bool looks_out) {
  std::vector<RationalPoint> corners;
  for (const auto& corner : piece.corners) corners.emplace_back(arrangement.point(corner.at));
  for (std::size_t k = 2; k < corners.size(); ++k) {
    sum.add(corners[0], corners[looks_out ? k - 1 : k], corners[looks_out ? k : k - 1]);
  }
}

}  // namespace

std::optional<MassProperties> mass_properties(const Surface& surface, const Watch& watch) {
  const Winding winding(surface);
  if (surface.points.size() == 0) return {};
  MassSum sum(bounding_box(surface.points).middle());
  const auto visit = [&](const SolidPiece& p) {
    add_piece(sum, p.arrangement, p.piece, p.looks_out);
    return true;
  };
  visit_uncovered_boundary(surface, winding, {}, common_exponent(surface, {}), {visit}, watch, 1);
  return sum.total();
}

std::optional<MassProperties> mass_properties(std::span<const ConvexPart> parts,
                                              const Watch& watch) {
  std::vector<BoundingBox> boxes;
  std::vector<RationalPoint> ends;
  for (const ConvexPart& part : parts) {
    if (!part.solid) continue;
    boxes.push_back(part.box);
    ends.push_back(part.box.low);
    ends.push_back(part.box.high);
  }
  if (boxes.empty()) return {};
  const UnionBoundary boundary(parts, common_exponent(boxes));
  MassSum sum(bounding_box(ends).middle());
  std::size_t done = 0;
  for (const UnionBoundary::FacetId f : boundary.facets()) {
    watch.at(done++, boundary.facets().size());
    if (auto rest = boundary.rest(f)) {
      for (const ConvexPiece<3>& piece : rest->pieces)
        add_piece(sum, rest->arrangement, piece, true);
    }
  }
  return sum.total();
}

}  // namespace convexact
