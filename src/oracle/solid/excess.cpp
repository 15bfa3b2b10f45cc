// SPDX-License-Identifier: MIT
#include "oracle/solid/excess.hpp"

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "near/near_plane.hpp"

namespace convexact {
namespace {

class ExcessSearch {
 public:
  explicit ExcessSearch(const PointSet& points)
      : points_(points),
        doubles_(points.doubles()),
        absolute_(absolute_plane_error(std::max(1.0, doubles_.largest))) {}

  /// Where n.x + d is largest, if it is positive anywhere.
  std::optional<Excess> largest_beyond(const Halfspace& h, std::size_t plane) {
    find_contenders(DoubleHalfspace(h));
    std::optional<PointId> farthest;
    Rational largest = 0;
    for (const PointId id : contenders_) {
      Rational value = h(points_[id]);
      if (value <= largest) continue;
      largest = std::move(value);
      farthest = id;
    }
    if (!farthest) return {};
    const Rational squared_length(h.normal().squaredNorm());
    return Excess{*farthest, plane, largest * largest / squared_length};
  }

 private:
  // The points that may have the largest value, unless that is negative for certain.
  void find_contenders(const DoubleHalfspace& h) {
    contenders_.clear();
    double surely_reached = 0;
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const NearValue near = h.at(doubles_, j, absolute_);
      if (near.value - near.error > surely_reached) surely_reached = near.value - near.error;
    }
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const NearValue near = h.at(doubles_, j, absolute_);
      if (!(near.value + near.error < surely_reached)) contenders_.emplace_back(j);  // true for NaN
    }
  }

  const PointSet& points_;
  CoordinateArrays doubles_;
  double absolute_;
  std::vector<PointId> contenders_;
};

}  // namespace

std::optional<Excess> find_excess(std::span<const Halfspace> halfspaces, const PointSet& points) {
  ExcessSearch search(points);
  std::optional<Excess> worst;
  for (std::size_t i = 0; i < halfspaces.size(); ++i) {
    std::optional<Excess> here = search.largest_beyond(halfspaces[i], i);
    if (here && (!worst || here->squared_distance > worst->squared_distance)) {
      worst = std::move(here);
    }
  }
  return worst;
}

std::optional<Farthest> find_farthest(const Polytope& polytope, const PointSet& points,
                                      std::span<const PointId> ids, const Watch& watch) {
  const NearestPoint nearest_point(polytope);
  std::optional<Farthest> farthest;
  for (const PointId id : ids) {
    watch.ask();
    const RationalPoint point = points[id];
    RationalPoint nearest = nearest_point(point);
    const RationalVector3 gap = point - nearest;
    Rational squared = gap.squaredNorm();
    if (squared > (farthest ? farthest->squared_distance : Rational(0))) {
      farthest = Farthest{id, std::move(nearest), std::move(squared)};
    }
  }
  return farthest;
}

}  // namespace convexact
