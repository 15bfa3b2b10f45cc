// SPDX-License-Identifier: MIT
#include "hull/exact_points.hpp"

#include <algorithm>
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

double& coordinate(NearPoint& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

bool is_between(const Point& low, const Point& x, const Point& high) {
  return (low.array() < x.array()).all() && (x.array() < high.array()).all();
}

// Whether it is on the same side of each facet as the fourth corner, which is not in it.
bool is_strictly_inside(const Point& x, const std::array<Point, 4>& simplex) {
  for (std::size_t k = 0; k < 4; ++k) {
    const auto &a = simplex[(k + 1) % 4], &b = simplex[(k + 2) % 4], &c = simplex[(k + 3) % 4];
    const Sign side = orient3d(a, b, c, x);
    if (side == Sign::Zero || side != orient3d(a, b, c, simplex[k])) return false;
  }
  return true;
}

}  // namespace

DoublePoints::DoublePoints(std::span<const Point> points) : points_(points), near_(points.size()) {
  if (points.empty()) return;
  low_ = high_ = points.front();
  for (const Point& p : points) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  }
  double_center_ = low_ / 2 + high_ / 2;
  compute_near();
}

// Hulls of few points are asked for by the thousand, so fractions are made only where the doubles
// are not strictly inside of the simplex.
void DoublePoints::center_at(const std::array<PointId, 4>& simplex) {
  const std::array<Point, 4> corners{at(simplex[0]), at(simplex[1]), at(simplex[2]),
                                     at(simplex[3])};
  double_center_ = (corners[0] / 4 + corners[1] / 4) + (corners[2] / 4 + corners[3] / 4);
  if (!is_strictly_inside(*double_center_, corners)) {
    double_center_.reset();
    RationalPoint sum = rational(simplex[0]);
    for (int k = 1; k < 4; ++k) sum += rational(simplex[k]);
    center_ = sum / Rational(4);
  }
  compute_near();
}

void DoublePoints::compute_near() {
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = high_[axis] / 2 - low_[axis] / 2;  // halved: no overflow
    const int exponent = exponent_of(extent) + 1;  // extent <= 2^(exponent - 1), though rounded
    if (std::abs(exponent) > 900 || std::max(-low_[axis], high_[axis]) > 0x1p1000) {
      const Rational center = double_center_ ? to_rational((*double_center_)[axis]) : center_[axis];
      for (std::size_t i = 0; i < size(); ++i) {
        const Rational shifted = to_rational(points_[i][axis]) - center;
        coordinate(near_[i], axis) =
            to_double(scale_by_power_of_two(shifted, -exponent), Rounding::Nearest);
      }
      continue;
    }
    // Each subtraction is off by 1u relative to the extent. Scaling by a power of two is exact, or
    // an underflow far below kNearError.
    double high = 0, low = 0;
    if (double_center_) {
      high = (*double_center_)[axis];
    } else {
      // As a sum of two doubles, off by u^2 |center|. The box has doubles on both sides of the
      // center, so its extent is at least u |center|, and that error u of it.
      high = to_double(center_[axis], Rounding::Nearest);
      low = to_double(center_[axis] - to_rational(high), Rounding::Nearest);
    }
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
  if (double_center_) return orient3d(at(a), at(b), at(p), *double_center_);
  const RationalVector3 to_a = rational(a) - center_, to_b = rational(b) - center_;
  const RationalVector3 cross = to_a.cross(to_b), to_p = rational(p) - center_;
  return sign_of(Rational(cross.dot(to_p)));
}

bool DoublePoints::collinear(PointId a, PointId b, PointId c) const {
  const RationalVector3 ab = rational(b) - rational(a), ac = rational(c) - rational(a);
  const RationalVector3 cross = ab.cross(ac);
  return cross == RationalVector3::Zero();
}

namespace {

// The sign of det[a; b; c; d], rows (n, w): by w > 0 that of det[a-d; b-d; c-d] of the points.
Sign determinant_sign(const HomogeneousPoint& a, const HomogeneousPoint& b,
                      const HomogeneousPoint& c, const HomogeneousPoint& d) {
  const IntegerVector3 ab = a.n.cross(b.n), cd = c.n.cross(d.n);
  const IntegerVector3 p = a.n * b.w - b.n * a.w, q = c.n * d.w - d.n * c.w;
  // Laplace expansion by the first two rows: the six 2x2 minors of (a, b) are ab and p.
  return sign_of(Integer(dot(ab, q) + dot(cd, p)));
}

}  // namespace

HomogeneousPoints::HomogeneousPoints(std::span<const HomogeneousPoint> points)
    : points_(points), near_(points.size()) {
  for (const HomogeneousPoint& p : points) {
    if (p.w <= 0) throw Error(ErrorCode::InvalidArgument, "a homogeneous point needs w > 0");
  }
  find_box();
}

HomogeneousPoints::HomogeneousPoints(const PointSet& points)
    : set_(&points), of_set_(points.size()), near_(points.size()) {
  find_box();
}

const HomogeneousPoint& HomogeneousPoints::at(PointId p) const {
  if (set_ == nullptr) return points_[p.index()];
  std::optional<HomogeneousPoint>& made = of_set_[p.index()];
  if (!made) made = clear_denominators((*set_)[p]);
  return *made;
}

void HomogeneousPoints::find_box() {
  if (size() == 0) return;
  low_ = high_ = rational(PointId(0));
  Point near_low = nearest(low_), near_high = near_low;
  for (std::size_t i = 1; i < size(); ++i) {
    // Rounding is monotone: a double strictly between those of the box is of a point within.
    if (set_ != nullptr && is_between(near_low, set_->doubles()[i], near_high)) continue;
    const RationalPoint exact = rational(PointId(i));
    for (int k = 0; k < 3; ++k) {
      if (exact[k] < low_[k]) low_[k] = exact[k];
      if (exact[k] > high_[k]) high_[k] = exact[k];
    }
    near_low = nearest(low_);
    near_high = nearest(high_);
  }
  compute_near((low_ + high_) / Rational(2));
}

void HomogeneousPoints::center_at(const std::array<PointId, 4>& simplex) {
  RationalPoint sum = rational(simplex[0]);
  for (int k = 1; k < 4; ++k) sum += rational(simplex[k]);
  const RationalPoint center = sum / Rational(4);
  center_ = clear_denominators(center);
  compute_near(center);
}

void HomogeneousPoints::compute_near(const RationalPoint& center) {
  for (int axis = 0; axis < 3; ++axis) {
    if (compute_near_in_doubles(axis, center[axis])) continue;
    const bool is_flat = high_[axis] == low_[axis];
    const long exponent = is_flat ? 0 : exponent_of(Rational(high_[axis] - low_[axis]));
    for (std::size_t i = 0; i < size(); ++i) {
      const Rational shifted = rational(PointId(i))[axis] - center[axis];
      coordinate(near_[i], axis) =
          to_double(scale_by_power_of_two(shifted, -exponent), Rounding::Nearest);
    }
  }
}

// Of a set of common sizes, from its doubles and their remainders: false for others.
bool HomogeneousPoints::compute_near_in_doubles(int axis, const Rational& center) {
  constexpr double kSmallest = 0x1p-800, kLargest = 0x1p+800, kLeastShare = 0x1p-40;
  if (set_ == nullptr) return false;
  const double extent = to_double(high_[axis] - low_[axis], Rounding::Up);
  const double largest = to_double(std::max(high_[axis], Rational(-low_[axis])), Rounding::Up);
  if (!(extent >= kSmallest && largest <= kLargest && extent >= kLeastShare * largest))
    return false;
  // The remainder and the lower part of the center are rounded, each by u^2 of the largest
  // coordinate, and so is the center's upper part's remainder: together below u 2^-10 of the
  // extent. Each of the three operations rounds by u of it; it is at most 1 after scaling.
  const double scale = std::ldexp(1.0, -exponent_of(extent));
  const double high = to_double(center, Rounding::Nearest);
  const double low = to_double(center - to_rational(high), Rounding::Nearest);
  const auto doubles = set_->doubles(), remainders = set_->remainders();
  for (std::size_t i = 0; i < size(); ++i) {
    coordinate(near_[i], axis) = (((doubles[i][axis] - high) - low) + remainders[i][axis]) * scale;
  }
  return true;
}

Sign HomogeneousPoints::side(PointId a, PointId b, PointId c, PointId p) const {
  return -determinant_sign(at(a), at(b), at(c), at(p));
}

Sign HomogeneousPoints::center_side(PointId a, PointId b, PointId p) const {
  return determinant_sign(at(a), at(b), at(p), center_);
}

bool HomogeneousPoints::equal(PointId p, PointId q) const {
  return at(p).n * at(q).w == at(q).n * at(p).w;
}

bool HomogeneousPoints::collinear(PointId a, PointId b, PointId c) const {
  const RationalVector3 ab = rational(b) - rational(a), ac = rational(c) - rational(a);
  const RationalVector3 cross = ab.cross(ac);
  return cross == RationalVector3::Zero();
}

RationalPoint HomogeneousPoints::rational(PointId p) const {
  if (set_ != nullptr) return (*set_)[p];
  const HomogeneousPoint& h = at(p);
  return {Rational(h.n[0], h.w), Rational(h.n[1], h.w), Rational(h.n[2], h.w)};
}

}  // namespace convexact
