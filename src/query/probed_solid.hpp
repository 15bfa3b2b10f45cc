// SPDX-License-Identifier: MIT
// probed_solid.hpp - a solid in the frame of a sphere around it: whether points, lines and planes
// in doubles hit it, decided in doubles where their error bounds allow, and otherwise exactly.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/query.hpp"
#include "near/near_plane.hpp"

namespace convexact {

/// x = center + 2^exponent y for y in the frame, where solids lie in |y| <= radius <= 1/2.
struct ProbeFrame {
  RationalPoint center;
  long exponent = 0;
  double radius = 0.5;  ///< In the frame.

  RationalPoint operator()(const RationalPoint& x) const;
  Halfspace operator()(const Halfspace& h) const;
};

/// The center of the box around both, and a radius less than 2^-50 above the least.
[[nodiscard]] ProbeFrame probe_frame(const Polytope& a, const Polytope& b);

/// A plane {y : dot(u, y) = h}, |u_k| <= 1 + 2^-50, |h| <= 1/2.
struct ProbePlane {
  Point normal;
  double offset;
};

/// The line through two points.
struct ProbeLine {
  Point first, second;
};

/// A solid and its planes and vertices rounded to doubles, in one frame. All points that are tested
/// have |y_k| <= 1.
class ProbedSolid {
 public:
  ProbedSolid(const Polytope& solid, const ProbeFrame& frame);

  [[nodiscard]] bool is_hit(const Point& point) const;
  [[nodiscard]] bool is_hit(const ProbeLine& line) const;
  [[nodiscard]] bool is_hit(const ProbePlane& plane) const;
  /// How many of these decisions needed exact numbers.
  [[nodiscard]] std::size_t exact_decisions() const { return exact_decisions_; }

  /// The first vertex of `inner` that is not in this solid.
  [[nodiscard]] std::optional<EscapingVertex> first_outside(const ProbedSolid& inner) const;

 private:
  Polytope exact_;
  std::vector<DoubleHalfspace> planes_;
  std::vector<Point> vertices_;
  mutable std::size_t exact_decisions_ = 0;
};

}  // namespace convexact
