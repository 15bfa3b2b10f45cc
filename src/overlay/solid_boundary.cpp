// SPDX-License-Identifier: MIT
#include "overlay/solid_boundary.hpp"

#include <algorithm>

#include "surface/flat_polygon.hpp"
#include "surface/patches.hpp"
#include "task/lazy.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

class Walk {
 public:
  Walk(const Surface& surface, const Winding& winding, std::span<const ConvexPart> parts,
       long exponent, const BoundaryVisitor& visitor, const Watch& watch, std::size_t jobs)
      : surface_(surface, exponent),
        winding_(winding),
        patches_(find_patches(surface, watch)),
        beside_(surface.triangles.size()),
        union_(parts, exponent),
        holders_(union_.holders(surface_.points(), watch, jobs)),
        visitor_(visitor),
        whole_triangles_(parts.empty() && visitor.whole) {}

  void run(const Watch& watch, std::size_t jobs) const {
    const std::size_t triangles = surface_.surface().triangles.size();
    take_in_order(
        triangles + union_.facets().size(), jobs, watch,
        [&](std::size_t i, const Watch& quiet) {
          return i < triangles ? triangle(i, quiet) : facet(union_.facets()[i - triangles], quiet);
        },
        [&](std::size_t i, Found&& found) { return visit(i, found); }, 4);
  }

 private:
  // A piece of a plane that belongs to the boundary.
  struct At {
    std::size_t piece;
    RationalPoint x;  // strictly inside of it
    bool looks_out;
  };
  // What a triangle, or a facet, adds to the boundary.
  struct Found {
    std::optional<bool> whole = {};        // a whole triangle: whether it looks out
    std::optional<PlanePieces> rest = {};  // of these the following
    const Halfspace* plane = nullptr;
    std::vector<At> pieces = {};
  };

  bool visit(std::size_t triangle, Found& found) const {
    if (found.whole) visitor_.whole(TriangleId(triangle), *found.whole);
    return std::all_of(found.pieces.begin(), found.pieces.end(), [&](const At& at) {
      return visitor_.piece({found.rest->arrangement, found.rest->pieces[at.piece], *found.plane,
                             at.x, at.looks_out});
    });
  }

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
  Found triangle(std::size_t t, const Watch& watch) const {
    const auto corners = surface_.corners(t);
    if (patches_.repeats_last[t]) return {};  // its pieces count for the first of them
    if (whole_triangles_ && !patches_.is_crossed[t]) return {whole_triangle(t)};
    if (holders_.any_holds(corners)) return {};
    const LaidSurface::Walls* walls = surface_.walls(t);
    if (walls == nullptr) return {};
    Found found{{}, union_.rest_of(surface_.points(), corners), &walls->plane};
    if (!found.rest) return {};
    if (!patches_.is_crossed[t]) return plain_triangle(t, std::move(found));
    auto& [arrangement, pieces] = *found.rest;
    const auto related = surface_.relate(walls->plane, surface_.box(t), corners, t);
    surface_.cut(arrangement, pieces, related, t);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      watch.ask();
      std::optional<std::size_t> inside;
      RationalPoint x = clear_point(arrangement, pieces[k], related, inside);
      const auto [before, behind] = winding_.beside(TriangleId(t), x);
      if (is_boundary(before, behind)) found.pieces.push_back({k, std::move(x), behind != 0});
    }
    return found;
  }

  static bool is_boundary(long before, long behind) { return (before == 0) != (behind == 0); }

  // The winding numbers beside a point strictly inside a triangle: those of its patch, if nothing
  // crosses it.
  std::pair<long, long> beside(std::size_t t, const RationalPoint& x) const {
    if (patches_.is_crossed[t]) return winding_.beside(TriangleId(t), x);
    return beside_[patches_.patch[t]].get([&] { return winding_.beside(TriangleId(t), x); });
  }

  // Whether it looks out, if it is in the boundary.
  std::optional<bool> whole_triangle(std::size_t t) const {
    const auto [before, behind] =
        beside_[patches_.patch[t]].get([&] { return beside_patch_of(t); });
    return is_boundary(before, behind) ? std::optional(behind != 0) : std::nullopt;
  }

  // A triangle without area is a patch of its own, and bounds nothing.
  std::pair<long, long> beside_patch_of(std::size_t t) const {
    const auto x = inside_of(t);
    return x ? winding_.beside(TriangleId(t), *x) : std::pair(0L, 0L);
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
  Found plain_triangle(std::size_t t, Found found) const {
    Arrangement<3>& arrangement = found.rest->arrangement;
    const std::vector<ConvexPiece<3>>& pieces = found.rest->pieces;
    const auto inside_of = [&](const ConvexPiece<3>& piece) {
      return arrangement.point(interior_of(arrangement, piece, 0));
    };
    const auto [before, behind] = beside(t, inside_of(pieces.front()));
    if (!is_boundary(before, behind)) return {};
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      found.pieces.push_back({k, inside_of(pieces[k]), behind != 0});
    }
    return found;
  }

  // (2)
  Found facet(UnionBoundary::FacetId f, const Watch& watch) const {
    Found found{{}, union_.rest(f), &union_.plane(f)};
    if (!found.rest) return {};
    auto& [arrangement, pieces] = *found.rest;
    const auto related = surface_.relate(*found.plane, union_.box(f), {}, std::nullopt);
    surface_.cut(arrangement, pieces, related, 0);
    const bool is_plain = related.crossing.empty() && related.coplanar.empty();
    std::optional<long> outside;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      watch.ask();
      std::optional<std::size_t> inside;
      RationalPoint x = clear_point(arrangement, pieces[k], related, inside);
      if (!is_plain || !outside) outside = winding_before(*found.plane, x, inside);
      if (*outside != 0) found.pieces.push_back({k, std::move(x), false});
    }
    return found;
  }

  // The winding number on the side that the plane faces.
  long winding_before(const Halfspace& plane, const RationalPoint& x,
                      std::optional<std::size_t> coplanar) const {
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
  std::vector<Lazy<std::pair<long, long>>> beside_;  // by patch
  UnionBoundary union_;
  Holders holders_;
  const BoundaryVisitor& visitor_;
  bool whole_triangles_;
};

}  // namespace

void visit_uncovered_boundary(const Surface& surface, const Winding& winding,
                              std::span<const ConvexPart> parts, long exponent,
                              const BoundaryVisitor& visitor, const Watch& watch,
                              std::size_t jobs) {
  Walk(surface, winding, parts, exponent, visitor, watch, jobs).run(watch, jobs);
}

long common_exponent(const Surface& surface, std::span<const ConvexPart> parts) {
  std::vector<BoundingBox> boxes;
  if (surface.points.size() > 0) boxes.push_back(bounding_box(surface.points));
  for (const ConvexPart& part : parts) boxes.push_back(part.box);
  return common_exponent(boxes);
}

}  // namespace convexact
