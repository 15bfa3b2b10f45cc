// SPDX-License-Identifier: MIT
#include "cut/cut_points.hpp"

#include "number/arithmetic.hpp"

namespace convexact {

CutPlane::CutPlane(Halfspace plane, const NearFrame& frame) : exact(std::move(plane)) {
  // n.x + d of x = c + 2^e y.
  const Rational at_center = exact(frame.center);
  normal = scaled_direction(exact.normal());
  const auto bits = static_cast<long>(bit_length(exact.normal()));
  offset = to_double(scale_by_power_of_two(at_center, -bits - frame.exponent), Rounding::Nearest);
  const double length = normal.norm();
  normal /= length;
  offset /= length;
}

Halfspace triangle_plane(const Surface& surface, std::uint32_t triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  if (surface.points.is_binary()) {
    const auto& x = surface.points.doubles();
    return Halfspace::through(x[a.index()], x[b.index()], x[c.index()]);
  }
  return Halfspace::through(surface.points[a], surface.points[b], surface.points[c]);
}

CutPoints::CutPoints(const Surface& surface, const NearFrame& frame, bool is_exact)
    : surface_(surface), frame_(frame), is_exact_(is_exact) {
  for (std::size_t p = 0; p < surface.points.size(); ++p) {
    near_.push_back(frame(surface.points[PointId(p)]));
  }
}

std::uint32_t CutPoints::add(RationalPoint x) {
  near_.push_back(frame_(x));
  made_.push_back(std::move(x));
  return static_cast<std::uint32_t>(near_.size() - 1);
}

RationalPoint CutPoints::exact(std::uint32_t id) const {
  const std::size_t given = surface_.points.size();
  return id < given ? surface_.points[PointId(id)] : made_[id - given];
}

Sign CutPoints::side(const CutPlane& plane, std::uint32_t id) const {
  if (is_exact_) return sign_of(plane.exact(exact(id)));
  const double value = plane(near_[id]);
  if (value > kCutError) return Sign::Positive;
  if (value < -kCutError) return Sign::Negative;
  const std::size_t given = surface_.points.size();
  if (id >= given) return sign_of(plane.exact(made_[id - given]));
  if (surface_.points.is_binary()) return side_of(plane.exact, surface_.points.doubles()[id]);
  return sign_of(plane.exact(surface_.points[PointId(id)]));
}

}  // namespace convexact
