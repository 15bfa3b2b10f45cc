// SPDX-License-Identifier: MIT
#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/number.hpp"
#include "number/arithmetic.hpp"

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
    Point rounded = nearest(p);
    if (!rounded.allFinite()) {
      throw Error(ErrorCode::NotFinite, "point " + std::to_string(points_.size()) +
                                            " (counting from 0) is beyond the largest double");
    }
    binary = binary && to_rational(rounded) == p;
    points_.push_back(rounded);
  }
  if (binary) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    remainders_.push_back(nearest(points[i] - to_rational(points_[i])));
  }
  rationals_ = std::move(points);
}

RationalPoint PointSet::operator[](PointId id) const {
  return is_binary() ? to_rational(points_[id.index()]) : rationals_[id.index()];
}

PointSet subset(const PointSet& points, std::span<const PointId> ids) {
  PointSet chosen;
  for (const PointId id : ids) chosen.points_.push_back(points.points_[id.index()]);
  const auto is_double = [&](PointId id) {
    return points.remainders_[id.index()].isZero(0) &&
           to_rational(points.points_[id.index()]) == points.rationals_[id.index()];
  };
  if (points.is_binary() || std::all_of(ids.begin(), ids.end(), is_double)) return chosen;
  for (const PointId id : ids) {
    chosen.rationals_.push_back(points.rationals_[id.index()]);
    chosen.remainders_.push_back(points.remainders_[id.index()]);
  }
  return chosen;
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
