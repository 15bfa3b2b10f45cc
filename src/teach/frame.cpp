// SPDX-License-Identifier: MIT
#include "teach/frame.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/json.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// The e with 2^(e-1) < |x| <= 2^e. Precondition: x != 0.
long power_above(const Rational& x) {
  long e = exponent_of(x);
  while (scale_by_power_of_two(abs(x), 1 - e) <= 1) --e;
  return e;
}

// Nine digits are enough for a picture and keep a lesson short. A solid may grow beyond every
// double; a picture need not.
double drawn(const Rational& x) {
  constexpr double kFar = 1e300;
  const double value = std::clamp(to_double(x, Rounding::Nearest), -kFar, kFar);
  return value == 0 ? 0 : nearest_double(fmt::format("{:.9g}", value));
}

}  // namespace

LessonFrame::LessonFrame(std::span<const RationalPoint> vertices, const RationalPoint& center)
    : center_(center) {
  RationalPoint low = vertices.front(), high = low;
  for (const RationalPoint& v : vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const RationalVector3 extent = high - low;
  RationalVector3 reach;  // of the farther side of the box, > 0: the center is inside
  for (int k = 0; k < 3; ++k)
    reach[k] = std::max(Rational(high[k] - center[k]), Rational(center[k] - low[k]));
  const bool is_long = extent.maxCoeff() > 16 * extent.minCoeff();
  for (int k = 0; k < 3; ++k) exponent_[k] = power_above(is_long ? reach[k] : reach.maxCoeff());
}

Json LessonFrame::at(const RationalPoint& point) const {
  Json at = Json::array();
  for (int k = 0; k < 3; ++k) {
    at.push_back(drawn(scale_by_power_of_two(Rational(point[k] - center_[k]), -exponent_[k])));
  }
  return at;
}

Json LessonFrame::both(const RationalPoint& point) const {
  return {{"exact", vector_json(point)}, {"at", at(point)}};
}

Json LessonFrame::plane(const Halfspace& halfspace) const {
  RationalVector3 normal;
  for (int k = 0; k < 3; ++k) {
    normal[k] = scale_by_power_of_two(Rational(halfspace.normal()[k]), exponent_[k]);
  }
  const long bits = power_above(normal.cwiseAbs().maxCoeff());
  Json plane = Json::array();
  for (int k = 0; k < 3; ++k) plane.push_back(drawn(scale_by_power_of_two(normal[k], -bits)));
  plane.push_back(drawn(scale_by_power_of_two(halfspace(center_), -bits)));
  return plane;
}

Json LessonFrame::dual(const DualPoint& dual) const {
  Json at = Json::array();
  for (int k = 0; k < 3; ++k) {
    at.push_back(drawn(scale_by_power_of_two(Rational(dual.n[k], dual.w), exponent_[k])));
  }
  return at;
}

Json LessonFrame::json() const {
  Json scale = Json::array();
  for (const long e : exponent_) scale.push_back(scale_by_power_of_two(Rational(1), -e));
  return {{"center", vector_json(center_)}, {"scale", std::move(scale)}};
}

}  // namespace convexact
