// SPDX-License-Identifier: MIT

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"

namespace convexact {
namespace {

template <class Coordinates>
std::pair<Coordinates, Coordinates> extent(std::span<const Coordinates> points) {
  if (points.empty()) throw Error(ErrorCode::InvalidArgument, "a bounding box needs a point");
  std::pair<Coordinates, Coordinates> box(points.front(), points.front());
  for (const Coordinates& p : points) {
    for (int k = 0; k < 3; ++k) {
      if (p[k] < box.first[k]) box.first[k] = p[k];
      if (p[k] > box.second[k]) box.second[k] = p[k];
    }
  }
  return box;
}

}  // namespace

BoundingBox bounding_box(std::span<const RationalPoint> points) {
  const auto [low, high] = extent(points);
  return {low, high};
}

BoundingBox bounding_box(const PointSet& points) {
  if (points.is_binary()) {  // comparing doubles is exact
    const auto [low, high] = extent(points.doubles());
    return {to_rational(low), to_rational(high)};
  }
  std::vector<RationalPoint> exact;
  for (std::size_t i = 0; i < points.size(); ++i) exact.push_back(points[PointId(i)]);
  return bounding_box(exact);
}

}  // namespace convexact
