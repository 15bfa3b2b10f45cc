// SPDX-License-Identifier: MIT
// Whether a union holds a solid, with a point outside as the witness; and the volume outside.
#include <algorithm>

#include "overlay/six_volumes.hpp"
#include "overlay/solid_boundary.hpp"

namespace convexact {
namespace {

// x in lowest bits: each coordinate rounded down to a multiple of 2^power.
RationalPoint on_grid(const RationalPoint& x, long power) {
  RationalPoint rounded;
  for (int k = 0; k < 3; ++k) {
    const Integer steps = floor_of(scale_by_power_of_two(x[k], -power));
    rounded[k] = scale_by_power_of_two(Rational(steps), power);
  }
  return rounded;
}

class WitnessSearch {
 public:
  WitnessSearch(const Winding& winding, std::span<const ConvexPart> parts, long exponent)
      : winding_(winding), parts_(parts), exponent_(exponent) {}

  // A point beside a piece, on the side to which the normal points.
  // Precondition: the piece has an area, and on that side of all of it lie points of the solid
  // outside of all parts.
  //
  // Parts may touch the piece, in segments and at points: where an edge of a part leads through the
  // point that is tried, all that is near and behind it may lie in that part. So others are tried.
  // @param inside  The points of the piece to try, from 1 on, different ones.
  template <class Inside>
  UncoveredSolid beside(const Inside& inside, const IntegerVector3& normal) const {
    constexpr unsigned kMostPoints = 256;
    for (unsigned t = 1; t < kMostPoints; ++t) {
      if (auto found = near(inside(t), normal)) return std::move(*found);
    }
    throw Error(ErrorCode::Internal, "no point near an uncovered piece is uncovered");
  }

 private:
  // The first attempts are far from x. Steps shrink, and their directions differ: those of
  // (1, t, t^2) added to the normal. A flat part through x holds at most two of them.
  std::optional<UncoveredSolid> near(const RationalPoint& x, const IntegerVector3& normal) const {
    const auto length = static_cast<long>(bit_length(normal));
    const Integer unit = Integer(1) << static_cast<unsigned>(length);
    for (long j = 1; j < 4096; ++j) {
      // The vector added has a length < 4.6 2^22 unit, and 2^26 |n| >= 2^25 unit: so it is less
      // than 0.6 of the latter.
      const IntegerVector3 aside(Integer(unit << 22u), Integer(unit * (j << 11)),
                                 Integer(unit * (j * j)));
      const IntegerVector3 direction = normal * (Integer(1) << 26u) + aside;
      const long shrink = j < 64 ? j : j * j / 64;
      const long power = exponent_ - shrink - length - 26;
      RationalPoint y = x;
      for (int k = 0; k < 3; ++k) {
        y[k] += scale_by_power_of_two(Rational(direction[k]), power);
      }
      if (j % 2 == 1) y = on_grid(y, exponent_ - shrink - 6);
      if (is_held(y)) continue;
      const std::optional<long> number = winding_(y);
      if (number && *number != 0) return UncoveredSolid{std::move(y), *number};
    }
    return {};
  }

  bool is_held(const RationalPoint& y) const {
    return std::any_of(parts_.begin(), parts_.end(), [&](const ConvexPart& part) {
      for (int k = 0; k < 3; ++k) {
        if (y[k] < part.box.low[k] || part.box.high[k] < y[k]) return false;
      }
      return holds(part, y);
    });
  }

  const Winding& winding_;
  std::span<const ConvexPart> parts_;
  long exponent_;
};

// The middle of a convex polygon for t = 1, others for more: those of weights 1, t, t^2, ... lie on
// a line for fewer t than there are corners.
RationalPoint weighted_mean(const std::vector<RationalPoint>& corners, unsigned t) {
  RationalPoint sum = RationalPoint::Zero();
  Integer weight = 1, total = 0;
  for (const RationalPoint& corner : corners) {
    for (int k = 0; k < 3; ++k) sum[k] += corner[k] * Rational(weight);
    total += weight;
    weight *= t;
  }
  for (Rational& x : sum) x /= Rational(total);
  return sum;
}

}  // namespace

std::optional<UncoveredSolid> find_uncovered_solid(const Surface& surface, const Winding& winding,
                                                   std::span<const ConvexPart> parts,
                                                   const SurfaceCoverage& coverage,
                                                   const Watch& watch, std::size_t jobs) {
  const long exponent = common_exponent(surface, parts);
  const WitnessSearch search(winding, parts, exponent);
  // (1) Beside an uncovered piece of a triangle the solid is uncovered, too: this is cheap, and
  // enough in most cases. Sheets that cancel have no solid beside them here, but may have
  // elsewhere.
  for (const UncoveredPiece& piece : coverage.uncovered) {
    watch.ask();
    if (piece.corners.size() < 3) continue;
    const auto inside = [&](unsigned t) { return weighted_mean(piece.corners, t); };
    const auto [before, behind] = winding.beside(piece.triangle, inside(1));
    if (before == 0 && behind == 0) continue;
    const auto& ids = surface.triangles[piece.triangle.index()];
    const Halfspace plane =
        Halfspace::through(surface.points[ids[0]], surface.points[ids[1]], surface.points[ids[2]]);
    const IntegerVector3& n = plane.normal();
    return search.beside(inside, before != 0 ? n : IntegerVector3(-n));
  }
  // (2) The boundary of the uncovered set.
  std::optional<UncoveredSolid> found;
  const auto visit = [&](const SolidPiece& piece) {
    const IntegerVector3& n = piece.plane.normal();
    const auto inside = [&](unsigned t) {
      return t == 1 ? piece.x
                    : piece.arrangement.point(interior_of(piece.arrangement, piece.piece, t));
    };
    found = search.beside(inside, piece.looks_out ? IntegerVector3(-n) : n);
    return false;
  };
  visit_uncovered_boundary(surface, winding, parts, exponent, {visit}, watch, jobs);
  return found;
}

Measured uncovered_volume(const Surface& surface, const Winding& winding,
                          std::span<const ConvexPart> parts, long precision, bool exact,
                          const Watch& watch, std::size_t jobs) {
  if (surface.points.size() == 0) {
    return {Enclosure(precision), exact ? std::optional<Rational>(0) : std::nullopt};
  }
  const long exponent = common_exponent(surface, parts);
  const auto add_boundary = [&](SixVolumes& sum) {
    const auto visit = [&](const SolidPiece& p) {
      sum.add(sum.term(p.arrangement, std::span(&p.piece, 1), p.looks_out));
      return true;
    };
    const auto add_whole = [&](TriangleId t, bool looks_out) {
      const auto& [a, b, c] = surface.triangles[t.index()];
      sum.add(sum.term({surface.points[a], surface.points[b], surface.points[c]}, looks_out));
    };
    visit_uncovered_boundary(surface, winding, parts, exponent, {visit, add_whole}, watch, jobs);
  };
  return measure_inside(bounding_box(surface.points).middle(), precision, exact, add_boundary);
}

// The rest of the solid outside of no part.
Measured solid_volume(const Surface& surface, long precision, bool exact, const Watch& watch,
                      std::size_t jobs) {
  return uncovered_volume(surface, Winding(surface), {}, precision, exact, watch, jobs);
}

}  // namespace convexact
