// SPDX-License-Identifier: MIT
#include "convexact/point_set.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

PointSet::PointSet(std::vector<Point> points) : points_(std::move(points)) {
  const auto bad =
      std::find_if(points_.begin(), points_.end(), [](const Point& p) { return !p.allFinite(); });
  if (bad != points_.end()) {
    throw Error(ErrorCode::NotFinite,
                "point " + std::to_string(bad - points_.begin()) +
                    " (counting from 0) has a coordinate that is NaN or infinite");
  }
}

PointSet::PointSet(std::vector<RationalPoint> points) {
  bool binary = true;
  for (const RationalPoint& p : points) {
    Point rounded;
    for (int k = 0; k < 3; ++k) rounded[k] = to_double(p[k], Rounding::Nearest);
    if (!rounded.allFinite()) {
      throw Error(ErrorCode::NotFinite, "point " + std::to_string(points_.size()) +
                                            " (counting from 0) is beyond the largest double");
    }
    binary = binary && to_rational(rounded) == p;
    points_.push_back(rounded);
  }
  if (!binary) rationals_ = std::move(points);
}

RationalPoint PointSet::operator[](PointId id) const {
  return is_binary() ? to_rational(points_[id.index()]) : rationals_[id.index()];
}

PointSet subset(const PointSet& points, std::span<const PointId> ids) {
  if (!points.is_binary()) {
    std::vector<RationalPoint> chosen;
    for (const PointId id : ids) chosen.push_back(points[id]);
    return PointSet(std::move(chosen));
  }
  std::vector<Point> chosen;
  for (const PointId id : ids) chosen.push_back(points.doubles()[id.index()]);
  return PointSet(std::move(chosen));
}

PointSet concatenated(const PointSet& first, const PointSet& second) {
  if (first.is_binary() && second.is_binary()) {
    std::vector<Point> points(first.doubles().begin(), first.doubles().end());
    points.insert(points.end(), second.doubles().begin(), second.doubles().end());
    return PointSet(std::move(points));
  }
  std::vector<RationalPoint> points;
  for (const PointSet* set : {&first, &second}) {
    for (std::size_t p = 0; p < set->size(); ++p) points.push_back((*set)[PointId(p)]);
  }
  return PointSet(std::move(points));
}

}  // namespace convexact
