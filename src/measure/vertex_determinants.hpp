// SPDX-License-Identifier: MIT
// vertex_determinants.hpp - points as integers, and the volumes of tetrahedra between them.
#pragma once
#include <span>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// Points whose coordinates are integers in a unit of each axis. A volume is an integer then, times
/// one common factor: it needs no division.
class VertexDeterminants {
 public:
  /// @param points  Must outlive the object.
  explicit VertexDeterminants(const PointSet& points);

  const IntegerVector3& operator[](std::size_t i) const { return integers_[i]; }
  std::size_t size() const { return integers_.size(); }
  /// det[b - a; c - a; p - a]: six times the volume of the tetrahedron a, b, c, p, in units of
  /// unit(). Positive iff p lies strictly beyond the plane of a, b, c, which look counter-clockwise
  /// from beyond: of (0,0,0), (1,0,0), (0,1,0) and (0,0,1) it is 1 / unit().
  [[nodiscard]] Integer height(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const;
  /// The sign of height(): by the filters of orient3d() where the points are doubles.
  [[nodiscard]] Sign side(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const;
  /// Six times the volume inside a closed surface of triangles, counter-clockwise from outside.
  [[nodiscard]] Integer six_volumes(std::span<const DualTriangle> triangles) const;
  /// The unit of these determinants, in the caller's cubed length units.
  const Rational& unit() const { return unit_; }
  /// The volume of which this is six times, in the caller's cubed length units.
  [[nodiscard]] Rational volume(const Integer& six_volumes) const {
    return Rational(six_volumes) * unit_ / 6;
  }

 private:
  const PointSet& points_;
  std::vector<IntegerVector3> integers_;
  Rational unit_ = 1;
};

}  // namespace convexact
