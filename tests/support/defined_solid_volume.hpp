// SPDX-License-Identifier: MIT
// defined_solid_volume.hpp - the volume of a closed surface's solid in another way than the
// library's: every triangle is cut along the whole plane of every one that crosses it, in rational
// barycentric coordinates, and each piece asks for its winding numbers.
#pragma once
#include <algorithm>
#include <vector>

#include "convexact/surface.hpp"
#include "surface/common_point.hpp"

namespace support {

using namespace convexact;

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

inline Piece whole() {
  const At a(1, 0, 0), b(0, 1, 0), c(0, 0, 1);
  return {{a, b, c}, {c, a, b}};  // the line ab is where the third coordinate is 0
}

inline At meet(const Line& a, const Line& b) {
  At at = a.cross(b);
  const Rational sum = at.sum();
  return at / sum;
}

// The part of the piece on the positive side of the line.
inline Piece part_beyond(const Piece& piece, const Line& line) {
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

inline bool has_area(const Piece& piece) { return piece.corners.size() >= 3; }

// Cuts the pieces that have interior points on both sides.
inline void cut(std::vector<Piece>& pieces, const Line& line) {
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
inline Rational share_of(const Piece& piece) {
  Rational sum = 0;
  for (std::size_t k = 1; k + 1 < piece.corners.size(); ++k) {
    sum += piece.corners[0].dot(piece.corners[k].cross(piece.corners[k + 1]));
  }
  return sum;
}

inline At centroid_of(const Piece& piece) {
  At sum = At::Zero();
  for (const At& corner : piece.corners) sum += corner;
  return sum / Rational(piece.corners.size());
}

class DefinedSolid {
 public:
  explicit DefinedSolid(const Surface& surface)
      : surface_(surface), winding_(surface), crossings_(surface.triangles.size()) {
    const auto count = static_cast<std::uint32_t>(surface.triangles.size());
    for (std::uint32_t t = 0; t < count; ++t) {
      for (std::uint32_t s = t + 1; s < count; ++s) {
        const Triangle &a = surface.triangles[t], &b = surface.triangles[s];
        if (has_no_area(surface.points, a) || has_no_area(surface.points, b)) continue;
        if (!cross(surface.points, a, b)) continue;
        crossings_[t].push_back(s);
        crossings_[s].push_back(t);
      }
    }
  }

  Rational volume() const {
    const RationalPoint o = surface_.points[PointId(0)];
    Rational total = 0;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      const auto& [a, b, c] = surface_.triangles[t];
      if (has_no_area(surface_.points, surface_.triangles[t])) continue;
      const Rational cone = RationalVector3(surface_.points[a] - o)
                                .dot(RationalVector3(surface_.points[b] - o)
                                         .cross(RationalVector3(surface_.points[c] - o)));
      for (const Piece& piece : pieces_of(t)) {
        const At at = centroid_of(piece);
        if (!is_counted_before(t, at)) total += side_at(t, at) * share_of(piece) * cone / 6;
      }
    }
    return total;
  }

 private:
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
  std::vector<std::vector<std::uint32_t>> crossings_;
};

inline Rational defined_solid_volume(const Surface& surface) {
  return DefinedSolid(surface).volume();
}

}  // namespace support
