// SPDX-License-Identifier: MIT
#include "overlay/solid_boundary.hpp"

#include "surface/flat_polygon.hpp"
#include "surface/patches.hpp"

namespace convexact {
namespace {

class Walk {
 public:
  Walk(const Surface& surface, const Winding& winding, std::span<const ConvexPart> parts,
       long exponent, const BoundaryVisitor& visitor, const Watch& watch)
      : surface_(surface, exponent),
        winding_(winding),
        patches_(find_patches(surface, watch)),
        beside_(surface.triangles.size()),
        union_(parts, exponent),
        holders_(union_.holders(surface_.points(), watch)),
        visitor_(visitor),
        whole_triangles_(parts.empty() && visitor.whole),
        watch_(watch) {}

  void run() {
    const std::size_t triangles = surface_.surface().triangles.size();
    steps_ = triangles + union_.facets().size();
    for (std::size_t t = 0; t < triangles; ++t) {
      watch_.at(done_++, steps_);
      if (!triangle(t)) return;
    }
    for (const UnionBoundary::FacetId f : union_.facets()) {
      watch_.at(done_++, steps_);
      if (!facet(f)) return;
    }
  }

 private:
  // A point strictly inside the piece, off the boundary of every related triangle.
  RationalPoint clear_point(Arrangement<3>& arrangement, const ConvexPiece<3>& piece,
                            const LaidSurface::Related& related,
                            std::optional<std::size_t>& inside) const {
    constexpr unsigned kAttempts = 10000;
    for (unsigned attempt = 0; attempt < kAttempts; ++attempt) {
      RationalPoint x = arrangement.point(interior_of(arrangement, piece, attempt));
      if (surface_.is_clear(x, related, inside)) return x;
    }
    throw Error(ErrorCode::Internal, "no point of a piece is clear of the surface");
  }

  // (1)
  bool triangle(std::size_t t) {
    const auto corners = surface_.corners(t);
    if (patches_.repeats_last[t]) return true;  // its pieces count for the first of them
    if (whole_triangles_ && !patches_.is_crossed[t]) return whole_triangle(t);
    if (holders_.any_holds(corners)) return true;
    const LaidSurface::Walls* walls = surface_.walls(t);
    if (walls == nullptr) return true;
    auto rest = union_.rest_of(surface_.points(), corners);
    if (!rest) return true;
    if (!patches_.is_crossed[t]) return plain_triangle(t, *walls, *rest);
    const auto related = surface_.relate(walls->plane, surface_.box(t), corners, t);
    surface_.cut(rest->arrangement, rest->pieces, related, t);
    for (const ConvexPiece<3>& piece : rest->pieces) {
      watch_.ask();
      std::optional<std::size_t> inside;
      const RationalPoint x = clear_point(rest->arrangement, piece, related, inside);
      const auto [before, behind] = winding_.beside(TriangleId(t), x);
      if (!is_boundary(before, behind)) continue;
      if (!visitor_.piece({rest->arrangement, piece, walls->plane, x, behind != 0})) return false;
    }
    return true;
  }

  static bool is_boundary(long before, long behind) { return (before == 0) != (behind == 0); }

  // The winding numbers beside a point strictly inside a triangle: those of its patch, if nothing
  // crosses it.
  std::pair<long, long> beside(std::size_t t, const RationalPoint& x) {
    if (patches_.is_crossed[t]) return winding_.beside(TriangleId(t), x);
    std::optional<std::pair<long, long>>& known = beside_[patches_.patch[t]];
    if (!known) known = winding_.beside(TriangleId(t), x);
    return *known;
  }

  // One without area adds nothing.
  bool whole_triangle(std::size_t t) {
    std::optional<std::pair<long, long>>& known = beside_[patches_.patch[t]];
    if (!known) {
      const std::optional<RationalPoint> x = inside_of(t);
      if (!x) return true;
      known = winding_.beside(TriangleId(t), *x);
    }
    const auto [before, behind] = *known;
    if (is_boundary(before, behind)) visitor_.whole(TriangleId(t), behind != 0);
    return true;
  }

  // Its centroid; nothing for a triangle without area.
  std::optional<RationalPoint> inside_of(std::size_t t) const {
    const PointSet& points = surface_.surface().points;
    const auto& corners = surface_.surface().triangles[t];
    if (area_vector(points, corners).isZero()) return {};
    const RationalPoint sum = points[corners[0]] + points[corners[1]] + points[corners[2]];
    return RationalPoint(sum / Rational(3));
  }

  // Nothing crosses the triangle: its patch has the same winding numbers everywhere.
  bool plain_triangle(std::size_t t, const LaidSurface::Walls& walls, PlanePieces& rest) {
    const auto inside_of = [&](const ConvexPiece<3>& piece) {
      return rest.arrangement.point(interior_of(rest.arrangement, piece, 0));
    };
    const auto [before, behind] = beside(t, inside_of(rest.pieces.front()));
    if (!is_boundary(before, behind)) return true;
    for (const ConvexPiece<3>& piece : rest.pieces) {
      watch_.ask();
      if (!visitor_.piece({rest.arrangement, piece, walls.plane, inside_of(piece), behind != 0})) {
        return false;
      }
    }
    return true;
  }

  // (2)
  bool facet(UnionBoundary::FacetId f) {
    auto rest = union_.rest(f);
    if (!rest) return true;
    const Halfspace& plane = union_.plane(f);
    const auto related = surface_.relate(plane, union_.box(f), {}, std::nullopt);
    surface_.cut(rest->arrangement, rest->pieces, related, 0);
    const bool is_plain = related.crossing.empty() && related.coplanar.empty();
    std::optional<long> outside;
    for (const ConvexPiece<3>& piece : rest->pieces) {
      watch_.ask();
      std::optional<std::size_t> inside;
      const RationalPoint x = clear_point(rest->arrangement, piece, related, inside);
      if (!is_plain || !outside) outside = winding_before(plane, x, inside);
      if (*outside == 0) continue;
      if (!visitor_.piece({rest->arrangement, piece, plane, x, false})) return false;
    }
    return true;
  }

  // The winding number on the side that the plane faces.
  long winding_before(const Halfspace& plane, const RationalPoint& x,
                      std::optional<std::size_t> coplanar) {
    if (!coplanar) {
      const std::optional<long> number = winding_(x);
      if (!number) throw Error(ErrorCode::Internal, "a point off the surface lies on it");
      return *number;
    }
    const auto [before, behind] = beside(*coplanar, x);
    const bool looks_alike = dot(surface_.walls(*coplanar)->plane.normal(), plane.normal()) > 0;
    return looks_alike ? before : behind;
  }

  LaidSurface surface_;
  const Winding& winding_;
  Patches patches_;
  std::vector<std::optional<std::pair<long, long>>> beside_;  // by patch, once it is known
  UnionBoundary union_;
  Holders holders_;
  const BoundaryVisitor& visitor_;
  bool whole_triangles_;
  const Watch& watch_;
  std::size_t done_ = 0, steps_ = 0;
};

}  // namespace

void visit_uncovered_boundary(const Surface& surface, const Winding& winding,
                              std::span<const ConvexPart> parts, long exponent,
                              const BoundaryVisitor& visitor, const Watch& watch) {
  Walk(surface, winding, parts, exponent, visitor, watch).run();
}

long common_exponent(const Surface& surface, std::span<const ConvexPart> parts) {
  std::vector<BoundingBox> boxes;
  if (surface.points.size() > 0) boxes.push_back(bounding_box(surface.points));
  for (const ConvexPart& part : parts) boxes.push_back(part.box);
  return common_exponent(boxes);
}

}  // namespace convexact
