// SPDX-License-Identifier: MIT
#include "cut/leaf.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "surface/flat_polygon.hpp"

namespace convexact {
namespace {

std::vector<Piece::Corner> corners_of(const Surface& surface, const Piece& piece) {
  if (!piece.corners.empty()) return piece.corners;
  const auto& [a, b, c] = surface.triangles[piece.triangle];
  return {{a.value, 0}, {b.value, 1}, {c.value, 2}};
}

}  // namespace

// Of one plane: the sides of corners, and where it crosses sides of pieces.
class LeafCutter::PieceCutter {
 public:
  PieceCutter(const Surface& surface, CutPoints& points, const std::vector<CutPlane>& planes,
              std::uint32_t plane)
      : surface_(surface), points_(points), planes_(planes), plane_(plane) {}

  Sign side(std::uint32_t point) {
    const auto [known, is_new] = sides_.try_emplace(point, Sign::Zero);
    if (is_new) known->second = points_.side(planes_[plane_], point);
    return known->second;
  }

  // What is not on the other side of the plane, which runs through the piece.
  Piece keep(const Piece& piece, const std::vector<Piece::Corner>& corners, Sign sign) {
    Piece rest{piece.triangle, {}};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Piece::Corner &a = corners[k], &b = corners[(k + 1) % corners.size()];
      const Sign at_a = side(a.point), at_b = side(b.point);
      const bool leaves = at_b == -sign;  // along the plane, from here on
      if (at_a == sign) rest.corners.push_back(a);
      if (at_a == Sign::Zero) rest.corners.push_back({a.point, leaves ? 3 + plane_ : a.side});
      if (at_a != Sign::Zero && at_a == -at_b) {
        rest.corners.push_back(
            {crossing(piece.triangle, a, b), at_a == sign ? 3 + plane_ : a.side});
      }
    }
    return rest;
  }

 private:
  std::uint32_t crossing(std::uint32_t triangle, const Piece::Corner& a, const Piece::Corner& b) {
    const auto [made, is_new] = crossings_.try_emplace(std::minmax(a.point, b.point), 0);
    if (!is_new) return made->second;
    const Halfspace& plane = planes_[plane_].exact;
    if (a.side >= 3) {
      made->second =
          points_.add(meet(triangle_plane(surface_, triangle), planes_[a.side - 3].exact, plane));
    } else {
      const auto& corners = surface_.triangles[triangle];
      const RationalPoint p = surface_.points[corners[a.side]],
                          q = surface_.points[corners[(a.side + 1) % 3]];
      const Rational at_p = plane(p), share = at_p / (at_p - plane(q));
      made->second = points_.add(p + share * (q - p));
    }
    return made->second;
  }

  const Surface& surface_;
  CutPoints& points_;
  const std::vector<CutPlane>& planes_;
  std::uint32_t plane_;
  std::unordered_map<std::uint32_t, Sign> sides_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
};

std::vector<std::uint32_t> Leaf::points(const Surface& surface) const {
  std::vector<std::uint32_t> all = solid_corners;
  for (const Piece& piece : pieces) {
    if (piece.corners.empty()) {
      for (const PointId p : surface.triangles[piece.triangle]) all.push_back(p.value);
    }
    for (const Piece::Corner& corner : piece.corners) all.push_back(corner.point);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::pair<Leaf, Leaf> LeafCutter::cut(const Leaf& leaf, std::uint32_t plane,
                                      std::vector<TriangleId>& raised) {
  auto [below, above] = leaf.region.cut(plane, planes_, points_);
  Leaf lower{std::move(below), {}, {}, {}}, upper{std::move(above), {}, {}, {}};
  PieceCutter cutter(surface_, points_, planes_, plane);
  for (const Piece& piece : leaf.pieces) {
    watch_.ask();
    const std::vector<Piece::Corner> corners = corners_of(surface_, piece);
    bool is_below = false, is_above = false;
    for (const Piece::Corner& corner : corners) {
      const Sign side = cutter.side(corner.point);
      is_below = is_below || side == Sign::Negative;
      is_above = is_above || side == Sign::Positive;
    }
    if (is_below && is_above) {
      lower.pieces.push_back(cutter.keep(piece, corners, Sign::Negative));
      upper.pieces.push_back(cutter.keep(piece, corners, Sign::Positive));
    } else {
      const bool is_raised = !is_below && !is_above && goes_up(piece, planes_[plane]);
      if (is_raised) raised.emplace_back(piece.triangle);
      const bool is_upper = is_above || is_raised;
      (is_upper ? upper : lower).pieces.push_back(piece);
    }
  }
  lower.solid_corners = solid_corners(lower.region);
  upper.solid_corners = solid_corners(upper.region);
  return {std::move(lower), std::move(upper)};
}

// A piece in the plane: whether the solid is above it only.
bool LeafCutter::goes_up(const Piece& piece, const CutPlane& plane) const {
  const Triangle& triangle = surface_.triangles[piece.triangle];
  if (winding_ == nullptr || has_no_area(surface_.points, triangle)) return false;
  const std::vector<Piece::Corner> corners = corners_of(surface_, piece);
  // A point strictly inside: the middle of a triangle of its corners with an area.
  RationalPoint sum = RationalPoint::Zero();
  for (const Piece::Corner& corner : corners) sum += points_.exact(corner.point);
  const auto [front, back] = winding_->beside(
      TriangleId(piece.triangle), RationalPoint(sum / Rational(static_cast<long>(corners.size()))));
  const RationalVector3 normal = area_vector(surface_.points, triangle);
  Rational along = 0;
  for (int k = 0; k < 3; ++k) along += normal[k] * Rational(plane.exact.normal()[k]);
  const long above = along > 0 ? front : back, below = along > 0 ? back : front;
  return above != 0 && below == 0;
}

// The solid has a volume in the region at a corner c, in the direction of a point m inside; or if
// not there, then a piece bounds what it has, and has c.
std::vector<std::uint32_t> LeafCutter::solid_corners(const Region& region) const {
  std::vector<std::uint32_t> found;
  if (winding_ == nullptr) return found;
  const RationalPoint middle = region.middle(planes_, points_);
  for (const std::uint32_t c : region.corners()) {
    const RationalPoint corner = points_.exact(c);
    if (winding_->towards(corner, RationalVector3(middle - corner)) != 0) found.push_back(c);
  }
  return found;
}

}  // namespace convexact
