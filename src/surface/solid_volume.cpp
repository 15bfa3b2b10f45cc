// SPDX-License-Identifier: MIT
// The volume of {winding number != 0}. Its boundary is where just one of the two winding numbers
// beside a triangle is zero; signed cones over it add up to the volume. Triangles that others cross
// are cut into pieces beside which the winding numbers do not change.
#include <algorithm>

#include "convexact/surface.hpp"
#include "surface/box_tree.hpp"
#include "surface/common_point.hpp"
#include "surface/edges.hpp"

namespace convexact {
namespace {

// A line in a triangle's plane: its values at the three corners, in proportion. A point: its
// barycentric coordinates, in proportion, with a positive sum.
using Line = RationalVector3;
using At = RationalVector3;

// A convex polygon in a triangle. Corners are where two lines of the triangle's edges or of other
// triangles meet, so numbers do not grow with the number of cuts.
struct Piece {
  std::vector<At> corners;
  std::vector<Line> edges;  // edges[k] leads from corners[k] to the next
};

Piece whole() {
  const At a(1, 0, 0), b(0, 1, 0), c(0, 0, 1);
  return {{a, b, c}, {c, a, b}};  // the line ab is where the third coordinate is 0
}

At meet(const Line& a, const Line& b) {
  At at = a.cross(b);
  const Rational sum = at.sum();
  return at / sum;
}

// The part of the piece on the positive side of the line.
Piece part_beyond(const Piece& piece, const Line& line) {
  Piece part;
  const std::size_t n = piece.corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Sign here = sign_of(Rational(line.dot(piece.corners[k]))),
               next = sign_of(Rational(line.dot(piece.corners[(k + 1) % n])));
    if (here != Sign::Negative) {
      part.corners.push_back(piece.corners[k]);
      // On the line and going to its other side: the next edge is the line's.
      part.edges.push_back(here == Sign::Zero && next == Sign::Negative ? line : piece.edges[k]);
    }
    if (here * next == Sign::Negative) {
      part.corners.push_back(meet(piece.edges[k], line));
      part.edges.push_back(here == Sign::Positive ? line : piece.edges[k]);
    }
  }
  return part;
}

bool has_area(const Piece& piece) { return piece.corners.size() >= 3; }

// Cuts the pieces that have interior points on both sides.
void cut(std::vector<Piece>& pieces, const Line& line) {
  std::vector<Piece> all;
  for (Piece& piece : pieces) {
    bool has_positive = false, has_negative = false;
    for (const At& corner : piece.corners) {
      const Sign side = sign_of(Rational(line.dot(corner)));
      has_positive = has_positive || side == Sign::Positive;
      has_negative = has_negative || side == Sign::Negative;
    }
    if (!has_positive || !has_negative) {
      all.push_back(std::move(piece));
      continue;
    }
    for (const Line& side : {line, Line(-line)}) {
      Piece part = part_beyond(piece, side);
      if (has_area(part)) all.push_back(std::move(part));
    }
  }
  pieces = std::move(all);
}

// The share of the triangle's area.
Rational share_of(const Piece& piece) {
  Rational sum = 0;
  for (std::size_t k = 1; k + 1 < piece.corners.size(); ++k) {
    sum += piece.corners[0].dot(piece.corners[k].cross(piece.corners[k + 1]));
  }
  return sum;
}

At centroid_of(const Piece& piece) {
  At sum = At::Zero();
  for (const At& corner : piece.corners) sum += corner;
  return sum / Rational(piece.corners.size());
}

// ---- Crossings

// By triangle: those that it meets elsewhere than at common corners and edges. None for triangles
// without area.
std::vector<std::vector<std::uint32_t>> find_crossings(const Surface& surface,
                                                       const std::vector<bool>& has_area,
                                                       const Watch& watch) {
  std::vector<NearBox> boxes;
  for (const Triangle& t : surface.triangles) boxes.push_back(box_of(surface.points, t));
  const BoxTree tree(boxes);
  std::vector<std::vector<std::uint32_t>> crossings(surface.triangles.size());
  std::vector<std::uint32_t> found;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    watch.at(t, surface.triangles.size());
    if (!has_area[t]) continue;
    tree.find(boxes[t], found);
    for (const std::uint32_t s : found) {
      if (s <= t || !has_area[s]) continue;
      if (!cross(surface.points, surface.triangles[t], surface.triangles[s])) continue;
      crossings[t].push_back(s);
      crossings[s].push_back(t);
    }
  }
  return crossings;
}

class SolidBoundary {
 public:
  SolidBoundary(const Surface& surface, const Watch& watch) : surface_(surface), winding_(surface) {
    for (const Triangle& t : surface.triangles) {
      has_area_.push_back(!has_no_area(surface.points, t));
    }
    crossings_ = find_crossings(surface, has_area_, watch);
  }

  // Calls take(triangle, share), share > 0 where the triangle looks out of the solid and < 0 where
  // it looks in.
  template <class Take>
  void for_each(const Watch& watch, const Take& take) const {
    const std::vector<std::uint32_t> patches = find_patches();
    std::vector<std::optional<int>> side_of(surface_.triangles.size());  // by patch
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      watch.at(t, surface_.triangles.size());
      if (!has_area_[t]) continue;
      if (crossings_[t].empty()) {
        std::optional<int>& side = side_of[patches[t]];
        if (!side) side = side_at(t, At::Constant(Rational(1, 3)));
        if (*side != 0) take(t, Rational(*side));
        continue;
      }
      for (const Piece& piece : pieces_of(t)) {
        const At at = centroid_of(piece);
        if (is_counted_before(t, at)) continue;
        const int side = side_at(t, at);
        if (side != 0) take(t, Rational(side * share_of(piece)));
      }
    }
  }

 private:
  // Triangles without crossings that are neighbours along edges with two triangles have the same
  // winding numbers beside them.
  std::vector<std::uint32_t> find_patches() const {
    std::vector<std::uint32_t> root(surface_.triangles.size());
    for (std::uint32_t t = 0; t < root.size(); ++t) root[t] = t;
    const auto find = [&](std::uint32_t t) {
      while (root[t] != t) t = root[t] = root[root[t]];
      return t;
    };
    EdgeTable(surface_.triangles).for_each([&](std::span<const EdgeUse> uses) {
      if (uses.size() != 2) return;
      const std::uint32_t s = uses[0].triangle, t = uses[1].triangle;
      const bool joins = has_area_[s] && has_area_[t] && crossings_[s].empty() &&
                         crossings_[t].empty() && uses[0].is_forward != uses[1].is_forward;
      if (joins) root[std::max(find(s), find(t))] = std::min(find(s), find(t));
    });
    for (std::uint32_t t = 0; t < root.size(); ++t) root[t] = find(t);
    return root;
  }

  RationalPoint point_at(std::uint32_t t, const At& at) const {
    const auto& [a, b, c] = surface_.triangles[t];
    return surface_.points[a] * at[0] + surface_.points[b] * at[1] + surface_.points[c] * at[2];
  }

  int side_at(std::uint32_t t, const At& at) const {
    const auto [front, back] = winding_.beside(TriangleId(t), point_at(t, at));
    return (front == 0) == (back == 0) ? 0 : front == 0 ? 1 : -1;
  }

  std::vector<Piece> pieces_of(std::uint32_t t) const {
    std::vector<Piece> pieces{whole()};
    for (const std::uint32_t s : crossings_[t]) {
      for (const Line& line : lines_of(s, t)) cut(pieces, line);
    }
    return pieces;
  }

  // Where the plane of s meets the plane of t; if they are one, the edges of s.
  std::vector<Line> lines_of(std::uint32_t s, std::uint32_t t) const {
    const Triangle &cutter = surface_.triangles[s], &cut = surface_.triangles[t];
    const RationalVector3 normal = area_vector(surface_.points, cutter);
    const auto values = [&](const RationalVector3& n, PointId at) {
      const RationalPoint o = surface_.points[at];
      Line line;
      for (int k = 0; k < 3; ++k) line[k] = n.dot(RationalVector3(surface_.points[cut[k]] - o));
      return line;
    };
    const Line plane = values(normal, cutter[0]);
    if (!plane.isZero(0)) return {plane};
    std::vector<Line> lines;
    for (int k = 0; k < 3; ++k) {
      const PointId a = cutter[k], b = cutter[(k + 1) % 3];
      const RationalVector3 along = surface_.points[b] - surface_.points[a];
      lines.push_back(values(normal.cross(along), a));
    }
    return lines;
  }

  // Whether a triangle before this one, in the same plane, holds the point as well.
  bool is_counted_before(std::uint32_t t, const At& at) const {
    const RationalPoint x = point_at(t, at);
    return std::any_of(crossings_[t].begin(), crossings_[t].end(), [&](std::uint32_t s) {
      if (s > t) return false;
      const Triangle& other = surface_.triangles[s];
      const RationalVector3 normal = area_vector(surface_.points, other);
      if (normal.dot(RationalVector3(x - surface_.points[other[0]])) != 0) return false;
      const Triangle& own = surface_.triangles[t];
      for (const PointId p : own) {
        if (normal.dot(RationalVector3(surface_.points[p] - surface_.points[other[0]])) != 0) {
          return false;
        }
      }
      for (int k = 0; k < 3; ++k) {
        const RationalPoint a = surface_.points[other[k]], b = surface_.points[other[(k + 1) % 3]];
        if (normal.dot(RationalVector3(b - a).cross(RationalVector3(x - a))) < 0) return false;
      }
      return true;
    });
  }

  const Surface& surface_;
  Winding winding_;
  std::vector<bool> has_area_;
  std::vector<std::vector<std::uint32_t>> crossings_;
};

}  // namespace

Measured solid_volume(const Surface& surface, long precision, bool exact, const Watch& watch) {
  const SolidBoundary boundary(surface, watch);
  const RationalPoint o = surface.points[PointId(0)];
  // One more bit for every doubling of the number of terms.
  long guard = 8;
  for (std::size_t n = surface.triangles.size(); n > 0; n /= 2) ++guard;
  Enclosure sum(precision + guard);
  Rational total = 0;
  boundary.for_each(watch, [&](std::uint32_t t, const Rational& share) {
    const auto& [a, b, c] = surface.triangles[t];
    const Rational cone = share / 6 *
                          RationalVector3(surface.points[a] - o)
                              .dot(RationalVector3(surface.points[b] - o)
                                       .cross(RationalVector3(surface.points[c] - o)));
    if (exact) {
      total += cone;
    } else {
      sum += Enclosure(cone, sum.precision());
    }
  });
  if (exact) return {Enclosure(total, precision), total};
  return {sum, std::nullopt};
}

}  // namespace convexact
