// SPDX-License-Identifier: MIT
#include "reach/clipped_part.hpp"

#include <array>

#include "overlay/union_distance_flat.hpp"

namespace convexact {
namespace {

using Polygon = std::vector<RationalPoint>;  // convex; its corners in order

// The part of it on the inner side of n.x + d <= 0.
template <class Value>
Polygon cut_off(const Polygon& polygon, const Value& value) {
  Polygon rest;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const RationalPoint &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const Rational at_a = value(a), at_b = value(b);
    if (at_a <= 0) rest.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) {
      const Rational share = at_a / (at_a - at_b);
      rest.push_back(a + share * (b - a));
    }
  }
  return rest;
}

struct ExactCell {
  RationalPoint center;
  Rational half;

  Polygon clip(Polygon polygon) const {
    for (int axis = 0; axis < 3; ++axis) {
      polygon = cut_off(
          polygon, [&](const RationalPoint& x) { return Rational(x[axis] - center[axis] - half); });
      polygon = cut_off(
          polygon, [&](const RationalPoint& x) { return Rational(center[axis] - half - x[axis]); });
    }
    return polygon;
  }

  Polygon side(int axis, bool is_high) const {
    Polygon corners;
    for (const auto& [u, v] :
         {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
      RationalPoint x = center;
      x[axis] += is_high ? half : Rational(-half);
      x[(axis + 1) % 3] += u * half;
      x[(axis + 2) % 3] += v * half;
      corners.push_back(x);
    }
    return corners;
  }
};

// The facets of a solid; of a flat part the segment, the point, or the sides of the polygon.
std::vector<Polygon> faces_of(const ConvexPart& part) {
  std::vector<Polygon> faces;
  if (part.solid) {
    for (const auto& facet : part.solid->facets) {
      Polygon& face = faces.emplace_back();
      for (const std::uint32_t v : facet) face.push_back(part.solid->vertices[v]);
    }
  } else if (part.dimension == 2) {
    for (const auto& [a, b] : FlatFeatures(part).sides) {
      faces.push_back({part.vertices[a], part.vertices[b]});
    }
  } else {
    faces.push_back(part.vertices);
  }
  return faces;
}

}  // namespace

// Each extreme point lies on a face of the part, cut off by the cell, or on a side of the cell, cut
// off by the part.
std::vector<RationalPoint> common_corners(const ConvexPart& part, const CellPlace& place,
                                          const NearFrame& frame) {
  const ExactCell cell{frame.point(place.center), frame.length(place.half)};
  std::vector<RationalPoint> corners;
  const auto add = [&](const Polygon& polygon) {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
  };
  for (const Polygon& face : faces_of(part)) add(cell.clip(face));
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool is_high : {false, true}) {
      Polygon side = cell.side(axis, is_high);
      for (const Halfspace& h : part.halfspaces) {
        if (side.empty()) break;
        side = cut_off(side, [&](const RationalPoint& x) { return h(x); });
      }
      add(side);
    }
  }
  return corners;
}

std::vector<RationalPoint> on_one_side(std::span<const RationalPoint> points,
                                       const Halfspace& plane) {
  std::vector<RationalPoint> kept;
  std::vector<std::pair<Rational, const RationalPoint*>> inner, beyond;
  for (const RationalPoint& x : points) {
    Rational value = plane(x);
    if (value <= 0) kept.push_back(x);
    if (value < 0)
      inner.emplace_back(std::move(value), &x);
    else if (value > 0)
      beyond.emplace_back(std::move(value), &x);
  }
  for (const auto& [below, a] : inner) {
    for (const auto& [above, b] : beyond) {
      const Rational share = below / (below - above);
      kept.push_back(*a + share * (*b - *a));
    }
  }
  if (kept.empty()) return kept;
  return convex_part(PointSet(kept)).vertices;
}

FarthestPoint nearest_on_triangle(const Surface& surface, std::uint32_t triangle,
                                  const RationalPoint& x) {
  const auto& [a, b, c] = surface.triangles[triangle];
  const RationalPoint nearest =
      nearest_in_triangle({surface.points[a], surface.points[b], surface.points[c]}, x);
  const RationalVector3 gap = x - nearest;
  return {x, nearest, gap.squaredNorm()};
}

FarthestPoint nearest_on_surface(const ReachCells& cells, const RationalPoint& x) {
  const Surface& surface = cells.surface();
  const Point y = cells.frame()(x);
  const double high = cells.triangles().nearest(y).distance.high;
  std::optional<FarthestPoint> best;
  for (const std::uint32_t t : cells.triangles().within(y, high)) {
    FarthestPoint found = nearest_on_triangle(surface, t, x);
    if (!best || found.squared < best->squared) best = std::move(found);
  }
  return *best;
}

}  // namespace convexact
