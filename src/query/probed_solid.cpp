// SPDX-License-Identifier: MIT
#include "query/probed_solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "number/arithmetic.hpp"
#include "query/probe_errors.hpp"

namespace convexact {
namespace {

// Whether the vertices, as values of one function, lie on both sides of 0 or on it.
class Sides {
 public:
  void add(Sign side) {
    touches_ = touches_ || side == Sign::Zero;
    above_ = above_ || side == Sign::Positive;
    below_ = below_ || side == Sign::Negative;
  }
  bool meet() const { return touches_ || (above_ && below_); }

 private:
  bool touches_ = false, above_ = false, below_ = false;
};

}  // namespace

RationalPoint ProbeFrame::operator()(const RationalPoint& x) const {
  RationalPoint y;
  for (int k = 0; k < 3; ++k) y[k] = scale_by_power_of_two(x[k] - center[k], -exponent);
  return y;
}

// n.x + d = 2^exponent n.y + (n.center + d).
Halfspace ProbeFrame::operator()(const Halfspace& h) const {
  const RationalVector3 normal = h.normal().cast<Rational>();
  return {normal, scale_by_power_of_two(h(center), -exponent)};
}

ProbeFrame probe_frame(const Polytope& a, const Polytope& b) {
  std::vector<RationalPoint> vertices = a.vertices;
  vertices.insert(vertices.end(), b.vertices.begin(), b.vertices.end());
  ProbeFrame frame;
  frame.center = bounding_box(vertices).middle();
  Rational squared = 0;
  for (const RationalPoint& v : vertices) {
    const RationalVector3 from_center = v - frame.center;
    squared = std::max<Rational>(squared, from_center.squaredNorm());
  }
  // 2^(e-2) < squared < 2^e, so with m = ceil(e / 2) + 1 the square is below 1/4 in units of 4^m.
  const long e = exponent_of(squared);
  frame.exponent = (e >= 0 ? (e + 1) / 2 : -(-e / 2)) + 1;
  const Rational in_frame = scale_by_power_of_two(squared, -2 * frame.exponent);
  frame.radius = std::sqrt(to_double(in_frame, Rounding::Nearest));
  while (to_rational(frame.radius) * to_rational(frame.radius) < in_frame) {
    frame.radius = std::nextafter(frame.radius, 1.0);
  }
  return frame;
}

ProbedSolid::ProbedSolid(const Polytope& solid, const ProbeFrame& frame) {
  exact_.facets = solid.facets;
  for (const Halfspace& plane : solid.planes) {
    planes_.emplace_back(exact_.planes.emplace_back(frame(plane)));
  }
  for (const RationalPoint& vertex : solid.vertices) {
    vertices_.push_back(nearest(exact_.vertices.emplace_back(frame(vertex))));
  }
}

bool ProbedSolid::is_hit(const Point& point) const {
  bool is_certain = true;
  for (const DoubleHalfspace& plane : planes_) {
    const double value = plane(point);
    if (value > kPlaneError) return false;
    is_certain = is_certain && value < -kPlaneError;
  }
  if (is_certain) return true;
  ++exact_decisions_;
  const RationalPoint y = to_rational(point);
  return std::all_of(exact_.planes.begin(), exact_.planes.end(),
                     [&](const Halfspace& plane) { return plane(y) <= 0; });
}

// With v the values of the facets at `first` and w the differences to those at `second`, the line
// hits iff some t has v_i + t w_i <= 0 for all i. A t that satisfies all of them by more than their
// errors proves a hit. Facets with w_i < 0 < w_j prove a miss if w_j v_i - w_i v_j > 0: this sum,
// with two positive factors, is the same for every t, and would be <= 0 on a hit.
bool ProbedSolid::is_hit(const ProbeLine& line) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double low = -kInfinity, high = kInfinity;
  LineValues entry{}, exit{};  // of the facets that give the ends
  for (const DoubleHalfspace& plane : planes_) {
    const LineValues values(plane, line.first, line.second);
    const double zero = -values.at_first / values.slope;
    if (values.slope < -kSlopeError && zero > low) {
      low = zero;
      entry = values;
    } else if (values.slope > kSlopeError && zero < high) {
      high = zero;
      exit = values;
    }
  }
  if (low > -kInfinity && high < kInfinity) {
    if (entry.gap_before(exit) > kLineError) return false;
    const double t = low + (high - low) / 2;
    if (std::abs(t) <= kMostT &&
        std::all_of(planes_.begin(), planes_.end(), [&](const DoubleHalfspace& plane) {
          return LineValues(plane, line.first, line.second).at(t) < -kLineError;
        })) {
      return true;
    }
  }
  ++exact_decisions_;
  const RationalPoint first = to_rational(line.first), second = to_rational(line.second);
  return cast_ray(exact_, {first, second - first}).line.has_value();
}

bool ProbedSolid::is_hit(const ProbePlane& plane) const {
  const Point& u = plane.normal;
  Sides sides;
  bool is_certain = true;
  for (const Point& y : vertices_) {
    const double value = u[0] * y[0] + u[1] * y[1] + u[2] * y[2] - plane.offset;
    if (std::abs(value) > kPlaneError) {
      sides.add(value > 0 ? Sign::Positive : Sign::Negative);
    } else {
      is_certain = false;
    }
    if (sides.meet()) return true;
  }
  if (is_certain) return false;
  ++exact_decisions_;
  const RationalVector3 normal = to_rational(u);
  const Rational offset = to_rational(plane.offset);
  for (const RationalPoint& y : exact_.vertices) {
    sides.add(sign_of(Rational(normal.dot(y) - offset)));
    if (sides.meet()) return true;
  }
  return false;
}

std::optional<EscapingVertex> ProbedSolid::first_outside(const ProbedSolid& inner) const {
  for (std::size_t v = 0; v < inner.vertices_.size(); ++v) {
    for (std::size_t f = 0; f < planes_.size(); ++f) {
      const double value = planes_[f](inner.vertices_[v]);
      if (value < -kPlaneError) continue;
      if (value > kPlaneError || exact_.planes[f](inner.exact_.vertices[v]) > 0) {
        return EscapingVertex{static_cast<std::uint32_t>(v), HalfspaceId(f)};
      }
    }
  }
  return {};
}

}  // namespace convexact
