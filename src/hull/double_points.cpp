// SPDX-License-Identifier: MIT
#include "hull/double_points.hpp"

#include <cmath>

#include "convexact/number.hpp"
#include "convexact/predicates.hpp"

namespace convexact {
namespace {

// The e with extent <= 2^e, for an extent that was rounded to nearest.
int exponent_of(double extent) {
  int exponent = 0;
  std::frexp(extent, &exponent);
  return exponent;
}

double& coordinate(NearPoint& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

}  // namespace

DoublePoints::DoublePoints(std::span<const Point> points) : points_(points), near_(points.size()) {
  if (points.empty()) return;
  low_ = high_ = points.front();
  for (const Point& p : points) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  }
  compute_near((to_rational(low_) + to_rational(high_)) / Rational(2));
}

void DoublePoints::center_at(const std::array<PointId, 4>& simplex) {
  RationalPoint sum = rational(simplex[0]);
  for (int k = 1; k < 4; ++k) sum += rational(simplex[k]);
  center_ = sum / Rational(4);
  compute_near(center_);
}

void DoublePoints::compute_near(const RationalPoint& center) {
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = high_[axis] / 2 - low_[axis] / 2;  // halved: no overflow
    const int exponent = exponent_of(extent) + 1;
    if (std::abs(exponent) > 900 || std::max(-low_[axis], high_[axis]) > 0x1p1000) {
      for (std::size_t i = 0; i < size(); ++i) {
        const Rational shifted = to_rational(points_[i][axis]) - center[axis];
        coordinate(near_[i], axis) =
            to_double(scale_by_power_of_two(shifted, -exponent), Rounding::Nearest);
      }
      continue;
    }
    // The center as a sum of two doubles, off by u^2 |center|. The box has doubles on both sides of
    // the center, so its extent is at least u |center|. The error relative to the extent is u from
    // `low`, 1u from each subtraction. Scaling by a power of two is exact, or an underflow far
    // below kNearError.
    const double high = to_double(center[axis], Rounding::Nearest);
    const double low = to_double(center[axis] - to_rational(high), Rounding::Nearest);
    const double scale = std::ldexp(1.0, -exponent);
    for (std::size_t i = 0; i < size(); ++i) {
      coordinate(near_[i], axis) = ((points_[i][axis] - high) - low) * scale;
    }
  }
}

Sign DoublePoints::side(PointId a, PointId b, PointId c, PointId p) const {
  return -orient3d(at(a), at(b), at(c), at(p));
}

Sign DoublePoints::center_side(PointId a, PointId b, PointId p) const {
  const RationalVector3 u = rational(a) - center_, v = rational(b) - center_;
  const RationalVector3 cross = u.cross(v), w = rational(p) - center_;
  return sign_of(Rational(cross.dot(w)));
}

bool DoublePoints::collinear(PointId a, PointId b, PointId c) const {
  const RationalVector3 u = rational(b) - rational(a), v = rational(c) - rational(a);
  const RationalVector3 cross = u.cross(v);
  return cross == RationalVector3::Zero();
}

}  // namespace convexact
