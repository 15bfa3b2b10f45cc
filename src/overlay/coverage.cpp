// SPDX-License-Identifier: MIT
// The rest of triangles outside the parts: one part after another is subtracted from each triangle,
// in its plane.
#include <algorithm>
#include <iterator>

#include "number/arithmetic.hpp"
#include "overlay/convex_piece.hpp"
#include "overlay/scaled.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

template <std::size_t N>
using Ids = std::array<std::uint32_t, N>;

class Coverage {
 public:
  Coverage(const Surface& surface, std::span<const ConvexPart> parts, long exponent)
      : surface_(surface), points_(surface.points, exponent) {
    for (const ConvexPart& part : parts) parts_.emplace_back(part, exponent);
    std::vector<NearBox> boxes;
    for (const LaidPart& part : parts_) boxes.push_back(part.box);
    tree_.emplace(std::move(boxes));
  }

  SurfaceCoverage find(const Watch& watch, std::size_t jobs) const {
    SurfaceCoverage coverage;
    const Holders holders(points_, parts_, *tree_, watch, jobs);
    take_in_order(
        surface_.triangles.size(), jobs, watch,
        [&](std::size_t t, const Watch&) { return rest_of(TriangleId(t), holders); },
        [&](std::size_t, std::optional<std::vector<UncoveredPiece>> rest) {
          coverage.in_one_part += rest ? 0 : 1;
          if (rest) std::move(rest->begin(), rest->end(), std::back_inserter(coverage.uncovered));
          return true;
        });
    return coverage;
  }

 private:
  // Nothing of a triangle in one part.
  std::optional<std::vector<UncoveredPiece>> rest_of(TriangleId t, const Holders& holders) const {
    const auto& ids = surface_.triangles[t.index()];
    const Ids<3> corners{ids[0].value, ids[1].value, ids[2].value};
    if (holders.any_holds(corners)) return {};
    if (has_area(corners)) return subtract_parts<3>(t, corners);
    const Ids<2> ends = far_ends(corners);
    const RationalPoint first = points_.rational(ends[0]);
    if (first != points_.rational(ends[1])) return subtract_parts<2>(t, ends);
    return {{{t, {first}, 1}}};  // a point in no part
  }

  bool has_area(const Ids<3>& ids) const {
    const HomogeneousPoint &a = points_.exact(ids[0]), &b = points_.exact(ids[1]),
                           &c = points_.exact(ids[2]);
    const IntegerVector3 u = b.n * a.w - a.n * b.w, v = c.n * a.w - a.n * c.w;
    return u.cross(v) != IntegerVector3::Zero();
  }

  // The lexicographically first and last of corners in a line.
  Ids<2> far_ends(Ids<3> ids) const {
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
      return precedes(points_.rational(a), points_.rational(b));
    };
    const auto [low, high] = std::minmax_element(ids.begin(), ids.end(), less);
    return {*low, *high};
  }

  template <std::size_t N>
  std::vector<UncoveredPiece> subtract_parts(TriangleId t, const Ids<N>& corners) const {
    NearBox box;
    for (const std::uint32_t i : corners) box.include(points_.box(i));
    std::vector<std::uint32_t> near;
    tree_->find(box, near);
    std::vector<std::pair<std::uint32_t, Meeting>> meetings;
    for (const std::uint32_t p : near) {
      Meeting met = meeting(parts_[p], points_, corners);
      if (met.kind == Meeting::Holds) return {};
      if (met.kind == Meeting::Crossing) meetings.emplace_back(p, std::move(met));
    }
    if (meetings.empty()) {
      UncoveredPiece piece{t, {}, 1};
      for (const std::uint32_t i : corners) piece.corners.push_back(points_.rational(i));
      return {std::move(piece)};
    }
    std::array<HomogeneousPoint, N> frame;
    for (std::size_t k = 0; k < N; ++k) frame[k] = points_.exact(corners[k]);
    Arrangement<N> arrangement(frame);
    std::vector<ConvexPiece<N>> pieces{whole_frame<N>()};
    std::vector<std::uint32_t> rows;
    for (const auto& [p, met] : meetings) {
      rows.clear();
      for (const std::size_t h : met.planes) {
        rows.push_back(arrangement.add(parts_[p].part->halfspaces[h]));
      }
      (void)subtract<N>(arrangement, pieces, rows);
      if (pieces.empty()) return {};
    }
    std::vector<UncoveredPiece> left;
    for (const ConvexPiece<N>& rest : pieces) {
      UncoveredPiece& piece = left.emplace_back();
      piece.triangle = t;
      for (const auto& corner : rest.corners) piece.corners.push_back(arrangement.point(corner.at));
      piece.share = share_of(arrangement, rest);
    }
    return left;
  }

  const Surface& surface_;
  ScaledPoints points_;
  std::vector<LaidPart> parts_;
  std::optional<BoxTree> tree_;
};

}  // namespace

SurfaceCoverage find_uncovered(const Surface& surface, std::span<const ConvexPart> parts,
                               const Watch& watch, std::size_t jobs) {
  if (surface.triangles.empty()) return {};
  std::vector<BoundingBox> boxes{bounding_box(surface.points)};
  for (const ConvexPart& part : parts) boxes.push_back(part.box);
  return Coverage(surface, parts, common_exponent(boxes)).find(watch, jobs);
}

}  // namespace convexact
