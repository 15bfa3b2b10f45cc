// SPDX-License-Identifier: MIT
#include "near/frame.hpp"

#include <cmath>
#include <limits>

#include "number/arithmetic.hpp"

namespace convexact {

Point NearFrame::operator()(const RationalPoint& x) const {
  Point y;
  for (int k = 0; k < 3; ++k) {
    y[k] = to_double(scale_by_power_of_two(x[k] - center[k], -exponent), Rounding::Nearest);
  }
  return y;
}

// The difference of two doubles is rounded once, as the exact one is, and a power of two changes no
// digit of it unless it leaves the normal range.
std::vector<Point> NearFrame::operator()(const PointSet& points) const {
  constexpr double kNormal = 0x1p-1000;
  Point middle;
  for (int k = 0; k < 3; ++k) middle[k] = to_double(center[k], Rounding::Nearest);
  const bool are_doubles =
      points.is_binary() && middle.allFinite() && to_rational(middle) == center;
  std::vector<Point> framed;
  framed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool is_exact = are_doubles;
    Point y;
    for (int k = 0; k < 3 && is_exact; ++k) {
      const double difference = points.doubles()[i][k] - middle[k];
      y[k] = difference == 0 ? 0.0 : std::ldexp(difference, static_cast<int>(-exponent));  // no -0
      is_exact = difference == 0 || (std::isfinite(y[k]) && std::abs(y[k]) >= kNormal);
    }
    framed.push_back(is_exact ? y : (*this)(points[PointId(i)]));
  }
  return framed;
}

RationalPoint NearFrame::point(const Point& y) const {
  RationalPoint x;
  for (int k = 0; k < 3; ++k) x[k] = center[k] + length(y[k]);
  return x;
}

Rational NearFrame::length(double y) const {
  return scale_by_power_of_two(to_rational(y), exponent);
}

double NearFrame::root_down(const Rational& squared) const {
  const double y = to_double(scale_by_power_of_two(squared, -2 * exponent), Rounding::Down);
  return std::max(0.0, std::nextafter(std::sqrt(y), 0.0));
}

double NearFrame::root_up(const Rational& squared) const {
  const double y = to_double(scale_by_power_of_two(squared, -2 * exponent), Rounding::Up);
  return std::nextafter(std::sqrt(y), std::numeric_limits<double>::infinity());
}

// The center is rounded to few bits, so that differences from it are no longer than the
// coordinates.
NearFrame frame_around(std::span<const BoundingBox> boxes) {
  RationalPoint low = boxes.front().low, high = boxes.front().high;
  for (const BoundingBox& box : boxes) {
    for (int k = 0; k < 3; ++k) {
      if (box.low[k] < low[k]) low[k] = box.low[k];
      if (box.high[k] > high[k]) high[k] = box.high[k];
    }
  }
  const RationalVector3 size = high - low;
  const Rational longest = size.maxCoeff();
  if (longest == 0) return {low, 0};
  NearFrame frame{low, exponent_of(longest)};
  for (int k = 0; k < 3; ++k) {
    const Integer units = floor_of(scale_by_power_of_two(low[k] + high[k], 9 - frame.exponent));
    frame.center[k] = scale_by_power_of_two(Rational(units), frame.exponent - 10);
  }
  return frame;
}

}  // namespace convexact
