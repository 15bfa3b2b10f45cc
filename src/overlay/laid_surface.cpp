// SPDX-License-Identifier: MIT
#include "overlay/laid_surface.hpp"

#include <algorithm>

namespace convexact {
namespace {

BoxTree tree_over_triangles(const Surface& surface, const ScaledPoints& points) {
  std::vector<NearBox> boxes;
  boxes.reserve(surface.triangles.size());
  for (const auto& ids : surface.triangles) {
    NearBox& box = boxes.emplace_back();
    for (const PointId id : ids) box.include(points.box(id.index()));
  }
  return BoxTree(std::move(boxes));
}

}  // namespace

LaidSurface::LaidSurface(const Surface& surface, long exponent)
    : surface_(surface),
      exponent_(exponent),
      points_(surface.points, exponent),
      tree_(tree_over_triangles(surface, points_)),
      walls_(surface.triangles.size()) {}

std::unique_ptr<const LaidSurface::Walls> LaidSurface::make_walls(std::size_t t) const {
  const auto ids = corners(t);
  const HomogeneousPoint* p[3];
  for (std::size_t k = 0; k < 3; ++k) p[k] = &points_.exact(ids[k]);
  // (b - a) x (c - a), times the weights.
  const auto difference = [](const HomogeneousPoint& to, const HomogeneousPoint& from) {
    IntegerVector3 d;
    for (int k = 0; k < 3; ++k) d[k] = to.n[k] * from.w - from.n[k] * to.w;
    return d;
  };
  const IntegerVector3 u = difference(*p[1], *p[0]), v = difference(*p[2], *p[0]);
  const IntegerVector3 n = u.cross(v);
  if (n == IntegerVector3::Zero()) return nullptr;
  const Halfspace plane(IntegerVector3(n * p[0]->w), Integer(-dot(n, p[0]->n)));
  return std::make_unique<const Walls>(
      Walls{plane, {wall(*p[0], *p[1], n), wall(*p[1], *p[2], n), wall(*p[2], *p[0], n)}});
}

LaidSurface::Related LaidSurface::relate(const Halfspace& plane, const NearBox& box,
                                         std::span<const std::uint32_t> skip,
                                         std::optional<std::size_t> self) const {
  Related related;
  std::vector<std::uint32_t> near;
  tree_.find(box, near);
  if (near.empty()) return related;
  const ScaledPlane scaled(plane, exponent_);
  for (const std::uint32_t t : near) {
    if (self && t == *self) continue;
    int beyond = 0, inside = 0, common = 0;
    for (const std::uint32_t i : corners(t)) {
      const Sign s = scaled.side(plane, points_, i);
      beyond += s == Sign::Positive;
      inside += s == Sign::Negative;
      common += std::find(skip.begin(), skip.end(), i) != skip.end();
    }
    if (beyond == 3 || inside == 3) continue;
    const bool is_in_plane = beyond == 0 && inside == 0;
    if (!is_in_plane && common >= 2) continue;
    const bool touches = beyond + inside == 2 && beyond != 1;  // with one corner
    if (touches || walls(t) == nullptr) {
      related.touching.push_back(t);
    } else {
      (is_in_plane ? related.coplanar : related.crossing).push_back(t);
    }
  }
  return related;
}

void LaidSurface::cut(Arrangement<3>& arrangement, std::vector<ConvexPiece<3>>& pieces,
                      const Related& related, std::size_t drop_below) const {
  using RowId = Arrangement<3>::RowId;
  // (1) Along the planes of triangles that cross. The common part of piece and triangle lies on the
  // chord of the piece. If one wall has the chord beyond it, that is at most a point.
  for (const std::uint32_t t : related.crossing) {
    if (pieces.empty()) return;
    const Walls& w = *walls(t);
    const RowId row = arrangement.add(w.plane);
    std::optional<std::array<RowId, 3>> rows;
    std::vector<ConvexPiece<3>> result;
    for (ConvexPiece<3>& piece : pieces) {
      if (position(arrangement, piece, row) != Position::Crossed) {
        result.push_back(std::move(piece));
        continue;
      }
      if (!rows) {
        rows.emplace();
        for (std::size_t k = 0; k < 3; ++k) (*rows)[k] = arrangement.add(w.walls[k]);
      }
      Halves<3> halves = split(arrangement, piece, row);
      const auto& corners = halves.inside.corners;
      std::size_t tail = 0;
      while (corners[tail].side != row) ++tail;
      const auto u = corners[tail].at, v = corners[(tail + 1) % corners.size()].at;
      const bool is_apart = std::any_of(rows->begin(), rows->end(), [&](RowId wall) {
        const Sign at_u = arrangement.side(u, wall), at_v = arrangement.side(v, wall);
        // Zero at both: the chord lies along the edge.
        return at_u != Sign::Negative && at_v != Sign::Negative &&
               (at_u == Sign::Positive || at_v == Sign::Positive);
      });
      if (is_apart) {
        result.push_back(std::move(piece));
      } else {
        result.push_back(std::move(halves.inside));
        result.push_back(std::move(halves.beyond));
      }
    }
    pieces = std::move(result);
  }
  // (2) Along the edges of coplanar ones. The pieces that one has taken are cut only by those that
  //     overlap it.
  struct Taken {
    std::uint32_t triangle;
    std::vector<ConvexPiece<3>> pieces;
  };
  std::vector<Taken> taken;
  for (const std::uint32_t t : related.coplanar) {
    const Walls& w = *walls(t);
    std::array<RowId, 3> rows;
    for (std::size_t k = 0; k < 3; ++k) rows[k] = arrangement.add(w.walls[k]);
    Taken own{t, subtract<3>(arrangement, pieces, rows)};
    for (Taken& earlier : taken) {
      if (earlier.pieces.empty() || !box(earlier.triangle).meets(box(t))) continue;
      for (ConvexPiece<3>& piece : subtract<3>(arrangement, earlier.pieces, rows)) {
        own.pieces.push_back(std::move(piece));
      }
    }
    if (t >= drop_below && !own.pieces.empty()) taken.push_back(std::move(own));
  }
  for (Taken& own : taken) {
    for (ConvexPiece<3>& piece : own.pieces) pieces.push_back(std::move(piece));
  }
}

bool LaidSurface::is_clear(const RationalPoint& x, const Related& related,
                           std::optional<std::size_t>& inside) const {
  const HomogeneousPoint p = clear_denominators(x);
  NearBox near;  // holds the scaled point
  for (int k = 0; k < 3; ++k) {
    const Rational scaled = scale_by_power_of_two(x[k], -exponent_);
    near.low[k] = to_double(scaled, Rounding::Down);
    near.high[k] = to_double(scaled, Rounding::Up);
  }
  inside.reset();
  const auto is_on = [&](const Walls& w) {
    return plane_value(w.plane, p) == 0 &&
           std::all_of(w.walls.begin(), w.walls.end(),
                       [&](const Halfspace& wall) { return plane_value(wall, p) <= 0; });
  };
  for (const std::uint32_t t : related.crossing) {
    if (box(t).meets(near) && is_on(*walls(t))) return false;
  }
  for (const std::uint32_t t : related.touching) {
    if (!box(t).meets(near)) continue;
    if (const Walls* w = walls(t)) {
      if (is_on(*w)) return false;
      continue;
    }
    // Without area: tests whether it is on the segment between two of the corners.
    const auto ids = corners(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const RationalPoint a = points_.rational(ids[k]), b = points_.rational(ids[(k + 1) % 3]);
      const RationalVector3 u = x - a, v = x - b;
      if (u.cross(v) == RationalVector3::Zero() && u.dot(v) <= 0) return false;
    }
  }
  for (const std::uint32_t t : related.coplanar) {
    if (!box(t).meets(near)) continue;
    const Walls& w = *walls(t);
    bool is_inside = true, is_outside = false;
    for (const Halfspace& wall : w.walls) {
      const Sign s = sign_of(plane_value(wall, p));
      is_inside = is_inside && s == Sign::Negative;
      is_outside = is_outside || s == Sign::Positive;
    }
    if (is_inside && !inside) inside = t;
    if (!is_inside && !is_outside) return false;
  }
  return true;
}

}  // namespace convexact
