// SPDX-License-Identifier: MIT
// overlay_scenes.hpp - surfaces and parts for the tests of overlay/, and their coverage by
// definition: cell by cell, and by inclusion and exclusion with intersections by enumeration.
#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "affine_dimension.hpp"
#include "convexact/overlay.hpp"
#include "number/random.hpp"
#include "polytope_by_definition.hpp"

namespace support {

using convexact::ConvexPart;
using convexact::Halfspace;
using convexact::Integer;
using convexact::Point;
using convexact::PointId;
using convexact::PointSet;
using convexact::Rational;
using convexact::RationalPoint;
using convexact::RationalVector3;
using convexact::Surface;
using convexact::uniform_below;

using SoupTriangle = std::array<RationalPoint, 3>;
using Soup = std::vector<SoupTriangle>;

inline bool comes_before(const RationalPoint& a, const RationalPoint& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

inline RationalPoint rational_point(double x, double y, double z) {
  return convexact::to_rational(Point(x, y, z));
}

/// The surface as surface.hpp describes it: distinct points in order, each triangle beginning with
/// its lowest point, triangles by their sorted points.
inline Surface surface_of(const Soup& soup, bool is_closed = true) {
  std::vector<RationalPoint> points;
  for (const SoupTriangle& t : soup) points.insert(points.end(), t.begin(), t.end());
  std::sort(points.begin(), points.end(), comes_before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Surface surface;
  for (const SoupTriangle& t : soup) {
    std::array<PointId, 3> ids;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = std::lower_bound(points.begin(), points.end(), t[k], comes_before);
      ids[k] = PointId(static_cast<std::size_t>(at - points.begin()));
    }
    std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
    surface.triangles.push_back(ids);
  }
  const auto sorted = [](std::array<PointId, 3> ids) {
    std::sort(ids.begin(), ids.end());
    return ids;
  };
  std::stable_sort(surface.triangles.begin(), surface.triangles.end(),
                   [&](const auto& a, const auto& b) { return sorted(a) < sorted(b); });
  surface.points = PointSet(std::move(points));
  surface.is_closed = is_closed;
  return surface;
}

inline SoupTriangle corners_of(const Surface& surface, std::size_t t) {
  const auto& ids = surface.triangles[t];
  return {surface.points[ids[0]], surface.points[ids[1]], surface.points[ids[2]]};
}

inline ConvexPart part_of(const std::vector<RationalPoint>& points) {
  return convexact::convex_part(PointSet(points));
}

inline std::vector<RationalPoint> box_corners(const RationalPoint& low, const RationalPoint& high) {
  std::vector<RationalPoint> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back(
        {k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]});
  }
  return corners;
}

inline ConvexPart box_part(const RationalPoint& low, const RationalPoint& high) {
  return part_of(box_corners(low, high));
}
inline ConvexPart box_part(double x, double y, double z, double u, double v, double w) {
  return box_part(rational_point(x, y, z), rational_point(u, v, w));
}

/// The facets of a polytope as triangles, fans from their first corners.
inline void add_solid(const convexact::Polytope& solid, Soup& soup, bool reversed = false) {
  for (const auto& facet : solid.facets) {
    for (std::size_t m = 2; m < facet.size(); ++m) {
      SoupTriangle t{solid.vertices[facet[0]], solid.vertices[facet[m - 1]],
                     solid.vertices[facet[m]]};
      if (reversed) std::swap(t[1], t[2]);
      soup.push_back(t);
    }
  }
}
inline void add_box(double x, double y, double z, double u, double v, double w, Soup& soup,
                    bool reversed = false) {
  add_solid(*box_part(x, y, z, u, v, w).solid, soup, reversed);
}

// ---- Cells

using Cell = std::array<int, 3>;  ///< [x, x + 1] x [y, y + 1] x [z, z + 1]

/// The faces of cells of the size `size` that no other cell shares, each as two triangles, looking
/// out of the cells.
inline Soup boundary_of(const std::set<Cell>& cells, int size = 1) {
  Soup soup;
  for (const Cell& c : cells) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell neighbour = c;
        neighbour[axis] += side ? 1 : -1;
        if (cells.count(neighbour)) continue;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        RationalPoint corner[4];
        for (int k = 0; k < 4; ++k) {
          corner[k][axis] = (c[axis] + side) * size;
          corner[k][u] = (c[u] + (k == 1 || k == 2)) * size;
          corner[k][v] = (c[v] + (k >= 2)) * size;
        }
        if (side == 0) std::swap(corner[1], corner[3]);
        soup.push_back({corner[0], corner[1], corner[2]});
        soup.push_back({corner[0], corner[2], corner[3]});
      }
    }
  }
  return soup;
}

struct IntegerBox {
  Cell low, high;
  bool holds(const Cell& cell) const {
    for (int k = 0; k < 3; ++k) {
      if (cell[k] < low[k] || cell[k] >= high[k]) return false;
    }
    return true;
  }
  ConvexPart part() const { return box_part(low[0], low[1], low[2], high[0], high[1], high[2]); }
};

inline bool any_holds(const std::vector<IntegerBox>& boxes, const Cell& cell) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const IntegerBox& box) { return box.holds(cell); });
}

// ---- Maps

/// x -> A x + b in integers, det A != 0.
struct IntegerMap {
  int matrix[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  int shift[3] = {0, 0, 0};

  RationalPoint operator()(const RationalPoint& x) const {
    RationalPoint y;
    for (int i = 0; i < 3; ++i) {
      y[i] = shift[i];
      for (int k = 0; k < 3; ++k) y[i] += Rational(matrix[i][k]) * x[k];
    }
    return y;
  }
  int determinant() const {
    const auto& m = matrix;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
  Soup operator()(const Soup& soup) const {
    Soup mapped;
    for (const SoupTriangle& t : soup) {
      SoupTriangle m{(*this)(t[0]), (*this)(t[1]), (*this)(t[2])};
      if (determinant() < 0) std::swap(m[1], m[2]);
      mapped.push_back(m);
    }
    return mapped;
  }
  ConvexPart operator()(const ConvexPart& part) const {
    std::vector<RationalPoint> points;
    for (const RationalPoint& v : part.vertices) points.push_back((*this)(v));
    return part_of(points);
  }
};

inline RationalPoint scaled(const RationalPoint& p, long power) {
  return {convexact::scale_by_power_of_two(p[0], power),
          convexact::scale_by_power_of_two(p[1], power),
          convexact::scale_by_power_of_two(p[2], power)};
}
inline ConvexPart scaled(const ConvexPart& part, long power) {
  std::vector<RationalPoint> points;
  for (const RationalPoint& v : part.vertices) points.push_back(scaled(v, power));
  return part_of(points);
}
inline Soup scaled(const Soup& soup, long power) {
  Soup result;
  for (const SoupTriangle& t : soup) {
    result.push_back({scaled(t[0], power), scaled(t[1], power), scaled(t[2], power)});
  }
  return result;
}

inline IntegerMap random_map(convexact::Random& random) {
  IntegerMap map;
  do {
    for (auto& row : map.matrix) {
      for (int& x : row) x = static_cast<int>(uniform_below(random, 7)) - 3;
    }
    for (int& x : map.shift) x = static_cast<int>(uniform_below(random, 21)) - 10;
  } while (map.determinant() == 0);
  return map;
}

// ---- Intersections by enumeration

/// The distinct points where three of the planes meet and that are beyond none.
inline std::vector<RationalPoint> vertices_by_enumeration(const std::vector<Halfspace>& planes) {
  std::vector<RationalPoint> found;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const RationalVector3 a = planes[i].normal().cast<Rational>(),
                              b = planes[j].normal().cast<Rational>(),
                              c = planes[k].normal().cast<Rational>();
        if (a.dot(b.cross(c)) == 0) continue;
        const RationalPoint x = meet(planes[i], planes[j], planes[k]);
        const bool is_in = std::all_of(planes.begin(), planes.end(),
                                       [&](const Halfspace& h) { return h(x) <= 0; });
        if (is_in) found.push_back(x);
      }
    }
  }
  std::sort(found.begin(), found.end(), comes_before);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// The volume of the intersection of the parts.
inline Rational common_volume(const std::vector<const ConvexPart*>& parts) {
  std::vector<Halfspace> planes;
  for (const ConvexPart* part : parts) {
    planes.insert(planes.end(), part->halfspaces.begin(), part->halfspaces.end());
  }
  const std::vector<RationalPoint> vertices = vertices_by_enumeration(planes);
  if (vertices.size() < 4 || affine_dimension(vertices) < 3) return 0;
  return volume(polytope_by_definition(PointSet(vertices)));
}

/// By inclusion and exclusion of a measure of common parts.
template <class Measure>
Rational measure_of_union(const std::vector<ConvexPart>& parts, const Measure& measure) {
  Rational sum = 0;
  for (unsigned set = 1; set < 1u << parts.size(); ++set) {
    std::vector<const ConvexPart*> chosen;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (set >> i & 1u) chosen.push_back(&parts[i]);
    }
    const Rational term = measure(chosen);
    sum += chosen.size() % 2 == 1 ? term : Rational(-term);
  }
  return sum;
}

/// The share of a triangle's area in the common part: the corners of the intersection with the
/// triangle's plane by enumeration, then a fan from the lexicographically first one.
inline Rational common_share(const SoupTriangle& t, const std::vector<const ConvexPart*>& parts) {
  const Halfspace plane = Halfspace::through(t[0], t[1], t[2]);
  const RationalVector3 normal = plane.normal().cast<Rational>();
  std::vector<Halfspace> planes{
      plane, Halfspace(convexact::IntegerVector3(-plane.normal()), Integer(-plane.offset()))};
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalVector3 side = t[(k + 1) % 3] - t[k];
    const RationalVector3 outward = side.cross(normal);
    planes.emplace_back(outward, Rational(-outward.dot(t[k])));
  }
  for (const ConvexPart* part : parts) {
    planes.insert(planes.end(), part->halfspaces.begin(), part->halfspaces.end());
  }
  std::vector<RationalPoint> corners = vertices_by_enumeration(planes);
  if (corners.size() < 3) return 0;
  const RationalPoint first = corners.front();
  std::sort(corners.begin() + 1, corners.end(),
            [&](const RationalPoint& p, const RationalPoint& q) {
              const RationalVector3 u = p - first, v = q - first;
              return normal.dot(u.cross(v)) > 0;
            });
  const RationalVector3 whole_u = t[1] - t[0], whole_v = t[2] - t[0];
  const Rational whole = normal.dot(whole_u.cross(whole_v));
  Rational sum = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const RationalVector3 u = corners[i - 1] - first, v = corners[i] - first;
    sum += normal.dot(u.cross(v));
  }
  return sum / whole;
}

/// By triangle: the sum of the shares of its uncovered pieces.
inline std::map<std::size_t, Rational> shares_of(const convexact::SurfaceCoverage& coverage) {
  std::map<std::size_t, Rational> shares;
  for (const auto& piece : coverage.uncovered) shares[piece.triangle.index()] += piece.share;
  return shares;
}

/// A small solid with vertices on the grid.
inline ConvexPart grid_part(convexact::Random& random, int count, int reach) {
  const auto entry = [&] {
    return Rational(static_cast<int>(uniform_below(random, 2 * reach + 1)) - reach);
  };
  while (true) {
    std::vector<RationalPoint> points;
    for (int i = 0; i < count; ++i) {
      RationalPoint& p = points.emplace_back();
      for (Rational& x : p) x = entry();
    }
    ConvexPart part = part_of(points);
    if (part.dimension == 3) return part;
  }
}

/// The same with some coordinates off by a few units of 2^-50: facets that are nearly parallel,
/// planes that nearly share a vertex.
inline ConvexPart nearly_grid_part(convexact::Random& random, int count, int reach) {
  while (true) {
    std::vector<RationalPoint> points;
    for (int i = 0; i < count; ++i) {
      RationalPoint& p = points.emplace_back();
      for (Rational& x : p) {
        x = static_cast<int>(uniform_below(random, 2 * reach + 1)) - reach;
        if (uniform_below(random, 3) == 0) {
          x += (static_cast<int>(uniform_below(random, 5)) - 2) * convexact::to_rational(0x1p-50);
        }
      }
    }
    ConvexPart part = part_of(points);
    if (part.dimension == 3) return part;
  }
}

}  // namespace support
