// SPDX-License-Identifier: MIT
// Property of clip: planes cut the triangle or segment of a frame into halves. Every half has an
// area, the shares of all pieces add up to 1, every sign of a corner is that of the plane at its
// point, each corner is on the right side of every plane that cut its piece, and interior points
// strictly so. Property of subtract: for boxes mapped by an integer matrix, the volume of the
// union, the volume of a solid outside of it, and the verdict with its witness are those that unit
// cells give; for small solids and flat parts, the uncovered share of a triangle is that of
// inclusion and exclusion, each grid point of it is in a part or in an uncovered piece, and common
// interiors exist exactly where common parts have a volume.
#include <algorithm>
#include <vector>

#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "overlay/convex_piece.hpp"
#include "overlay_scenes.hpp"

using namespace convexact;

namespace {

// ---- clip

// Small integers, some of them off by a last bit, in a unit.
Rational hard_coordinate(FuzzInput& in, int unit) {
  const int whole = static_cast<int>(in.below(9)) - 4;
  Rational x = whole;
  const std::size_t kind = in.below(8);
  if (kind == 1) x += to_rational(0x1p-50);
  if (kind == 2) x -= to_rational(0x1p-50);
  if (kind == 3) x /= 3;
  return scale_by_power_of_two(x, unit);
}

RationalPoint hard_point(FuzzInput& in, int unit) {
  RationalPoint p;
  for (Rational& x : p) x = hard_coordinate(in, unit);
  return p;
}

template <std::size_t N>
struct Tracked {
  ConvexPiece<N> piece;
  std::vector<std::pair<std::size_t, Sign>> cuts;  // a plane, and the side on which the piece lies
};

template <std::size_t N>
void check_pieces(Arrangement<N>& arrangement, const std::vector<Halfspace>& planes,
                  const std::vector<std::uint32_t>& rows, std::vector<Tracked<N>>& pieces,
                  unsigned attempt) {
  Rational sum = 0;
  for (Tracked<N>& tracked : pieces) {
    const Rational share = share_of(arrangement, tracked.piece);
    FUZZ_CHECK(share > 0);
    sum += share;
    FUZZ_CHECK(N == 2 ? tracked.piece.corners.size() == 2 : tracked.piece.corners.size() >= 3);
    for (const auto& corner : tracked.piece.corners) {
      const RationalPoint x = arrangement.point(corner.at);
      for (std::size_t p = 0; p < planes.size(); ++p) {
        FUZZ_CHECK(arrangement.side(corner.at, rows[p]) == sign_of(planes[p](x)));
      }
      for (const auto& [p, side] : tracked.cuts)
        FUZZ_CHECK(sign_of(planes[p](x)) * side != Sign::Negative);
    }
    const RationalPoint x = arrangement.point(interior_of(arrangement, tracked.piece, attempt));
    for (const auto& [p, side] : tracked.cuts) FUZZ_CHECK(sign_of(planes[p](x)) == side);
  }
  FUZZ_CHECK(sum == 1);
}

template <std::size_t N>
void clip_frame(FuzzInput& in) {
  constexpr int kUnits[] = {0, 300, -300, -1000};
  const int unit = kUnits[in.below(4)];
  const unsigned attempt = static_cast<unsigned>(in.below(3));
  std::array<RationalPoint, N> points;
  for (RationalPoint& p : points) p = hard_point(in, unit);
  if (affine_dimension(points) != static_cast<int>(N) - 1) return;
  std::array<HomogeneousPoint, N> frame;
  for (std::size_t k = 0; k < N; ++k) frame[k] = clear_denominators(points[k]);
  Arrangement<N> arrangement(frame);
  std::vector<Halfspace> planes;
  std::vector<std::uint32_t> rows;
  std::vector<Tracked<N>> pieces{{whole_frame<N>(), {}}};
  for (std::size_t count = 1 + in.below(6); count-- > 0 && !in.empty();) {
    std::array<RationalPoint, 3> on{hard_point(in, unit), hard_point(in, unit),
                                    hard_point(in, unit)};
    // Often through points of the frame.
    if (in.below(2) == 0) on[0] = points[0];
    if (in.below(4) == 0) on[1] = points[1];
    if (affine_dimension(on) < 2) continue;
    planes.push_back(Halfspace::through(on[0], on[1], on[2]));
    rows.push_back(arrangement.add(planes.back()));
    std::vector<Tracked<N>> result;
    for (Tracked<N>& tracked : pieces) {
      const Position where = position(arrangement, tracked.piece, rows.back());
      FUZZ_CHECK((where == Position::On) == arrangement.is_zero(rows.back()));
      if (where != Position::Crossed) {
        result.push_back(std::move(tracked));
        continue;
      }
      Halves<N> halves = split(arrangement, tracked.piece, rows.back());
      Tracked<N> beyond{std::move(halves.beyond), tracked.cuts};
      tracked.piece = std::move(halves.inside);
      tracked.cuts.emplace_back(planes.size() - 1, Sign::Negative);
      beyond.cuts.emplace_back(planes.size() - 1, Sign::Positive);
      result.push_back(std::move(tracked));
      result.push_back(std::move(beyond));
    }
    pieces = std::move(result);
  }
  check_pieces(arrangement, planes, rows, pieces, attempt);
}

void hold_clip(FuzzInput& in) {
  if (in.below(4) == 0) {
    clip_frame<2>(in);
  } else {
    clip_frame<3>(in);
  }
}

// ---- subtract

support::IntegerBox small_box(FuzzInput& in) {
  support::IntegerBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = static_cast<int>(in.below(3));
    box.high[k] = box.low[k] + 1 + static_cast<int>(in.below(2));
  }
  return box;
}

support::IntegerMap small_map(FuzzInput& in) {
  support::IntegerMap map;
  for (auto& row : map.matrix) {
    for (int& x : row) x = static_cast<int>(in.below(5)) - 2;
  }
  return map.determinant() != 0 ? map : support::IntegerMap{};
}

void subtract_boxes(FuzzInput& in) {
  const support::IntegerMap map = small_map(in);
  constexpr int kUnits[] = {0, 0, 300, -300};
  const int unit = kUnits[in.below(4)];
  // The solid: cells, or boxes that may cross and may be inside out.
  support::Soup soup;
  std::set<support::Cell> cells;
  std::vector<support::IntegerBox> shells;
  std::vector<int> turns;
  if (in.below(2) == 0) {
    for (std::size_t count = 1 + in.below(6); count-- > 0;) {
      const int place = static_cast<int>(in.below(27));
      cells.insert({place % 3, place / 3 % 3, place / 9});
    }
    soup = support::boundary_of(cells);
  } else {
    for (std::size_t count = 1 + in.below(3); count-- > 0;) {
      shells.push_back(small_box(in));
      turns.push_back(in.below(3) == 0 ? -1 : 1);
      support::add_solid(*shells.back().part().solid, soup, turns.back() < 0);
    }
  }
  std::vector<support::IntegerBox> boxes;
  for (std::size_t count = in.below(6); count-- > 0;) boxes.push_back(small_box(in));
  int in_union = 0, uncovered = 0;
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) {
      for (int z = 0; z < 5; ++z) {
        const support::Cell cell{x, y, z};
        int number = static_cast<int>(cells.count(cell));
        for (std::size_t i = 0; i < shells.size(); ++i) {
          if (shells[i].holds(cell)) number += turns[i];
        }
        const bool is_held = support::any_holds(boxes, cell);
        in_union += is_held;
        uncovered += number != 0 && !is_held;
      }
    }
  }
  std::vector<ConvexPart> parts;
  for (const auto& box : boxes) parts.push_back(support::scaled(map(box.part()), unit));
  const Rational cell_volume =
      scale_by_power_of_two(Rational(std::abs(map.determinant())), 3 * unit);
  FUZZ_CHECK(*union_volume(parts, 64, true).exact == in_union * cell_volume);
  const Surface surface = support::surface_of(support::scaled(map(soup), unit));
  const Winding winding(surface);
  FUZZ_CHECK(*uncovered_volume(surface, winding, parts, 64, true).exact == uncovered * cell_volume);
  const SurfaceCoverage coverage = find_uncovered(surface, parts);
  for (const SurfaceCoverage& known : {coverage, SurfaceCoverage{}}) {
    const auto witness = find_uncovered_solid(surface, winding, parts, known);
    FUZZ_CHECK(witness.has_value() == (uncovered > 0));
    if (!witness) continue;
    FUZZ_CHECK(witness->winding != 0);
    FUZZ_CHECK(winding(witness->point) == witness->winding);
    for (const ConvexPart& part : parts) FUZZ_CHECK(!holds(part, witness->point));
  }
}

int side_of_piece(const RationalVector3& normal, const UncoveredPiece& piece,
                  const RationalPoint& x) {
  int side = 1;
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const RationalPoint& a = piece.corners[i];
    const RationalVector3 u = piece.corners[(i + 1) % piece.corners.size()] - a, v = x - a;
    const Rational turn = normal.dot(u.cross(v));
    if (turn < 0) return -1;
    if (turn == 0) side = 0;
  }
  return side;
}

void subtract_solids(FuzzInput& in) {
  std::vector<RationalPoint> corners;
  for (const Point& p : in.grid_points(3, 3)) corners.push_back(to_rational(p));
  if (corners.size() < 3 || affine_dimension(corners) < 2) return;
  std::vector<ConvexPart> parts;
  for (std::size_t count = in.rarely() ? 3 : 2; count-- > 0;) {
    const std::vector<Point> points = in.grid_points(in.rarely() ? 6 : 5, 2);
    if (!points.empty()) parts.push_back(convex_part(PointSet(points)));
  }
  const support::SoupTriangle t{corners[0], corners[1], corners[2]};
  const Surface surface = support::surface_of({t}, false);
  const SurfaceCoverage coverage = find_uncovered(surface, parts);
  Rational uncovered = 0;
  for (const UncoveredPiece& piece : coverage.uncovered) uncovered += piece.share;
  const Rational covered = support::measure_of_union(
      parts,
      [&](const std::vector<const ConvexPart*>& set) { return support::common_share(t, set); });
  FUZZ_CHECK(covered + uncovered == 1);
  const support::SoupTriangle own = support::corners_of(surface, 0);
  const RationalVector3 u = own[1] - own[0], v = own[2] - own[0], normal = u.cross(v);
  for (int i = 1; i < 7; ++i) {
    for (int j = 1; i + j < 7; ++j) {
      const RationalPoint x = own[0] + Rational(i, 7) * u + Rational(j, 7) * v;
      const bool is_held = std::any_of(parts.begin(), parts.end(),
                                       [&](const ConvexPart& part) { return holds(part, x); });
      int best = -1;
      for (const UncoveredPiece& piece : coverage.uncovered) {
        best = std::max(best, side_of_piece(normal, piece, x));
      }
      FUZZ_CHECK(is_held || best >= 0);
      // Flat parts that cross the triangle hold points of pieces, too.
      const bool is_held_by_solid = std::any_of(
          parts.begin(), parts.end(),
          [&](const ConvexPart& part) { return part.dimension == 3 && holds(part, x); });
      if (is_held_by_solid) {
        const bool inside_of_piece = best == 1;
        // A solid may touch the triangle in a point or an edge only.
        const bool has_area = std::any_of(parts.begin(), parts.end(), [&](const ConvexPart& part) {
          return holds(part, x) && support::common_share(t, {&part}) > 0;
        });
        FUZZ_CHECK(!inside_of_piece || !has_area);
      }
    }
  }
  if (parts.size() < 2) return;
  const Rational common = support::common_volume({&parts[0], &parts[1]});
  const auto inside = common_interior(parts[0], parts[1]);
  FUZZ_CHECK(inside.has_value() == (common > 0));
  if (!inside) return;
  for (const ConvexPart* part : {&parts[0], &parts[1]}) {
    for (const Halfspace& h : part->halfspaces) FUZZ_CHECK(h(*inside) < 0);
  }
  if (parts.size() > 2) return;
  Rational volumes = 0;
  for (const ConvexPart& part : parts) {
    if (part.solid) volumes += volume(*part.solid);
  }
  FUZZ_CHECK(*union_volume(parts, 64, true).exact == volumes - common);
}

void hold_subtract(FuzzInput& in) {
  if (in.below(2) == 0) {
    subtract_boxes(in);
  } else {
    subtract_solids(in);
  }
}

const FuzzTarget kClip("clip", hold_clip);
const FuzzTarget kSubtract("subtract", hold_subtract);

}  // namespace
