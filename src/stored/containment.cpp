// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/stored.hpp"
#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"
#include "stored/prepared_halfspaces.hpp"

namespace convexact {
namespace {

// Blocks stay in the first-level cache while all halfspaces pass over them.
constexpr std::size_t kBlock = 128;
// With at least this many halfspaces, blocks of neighbouring points are faster.
constexpr std::size_t kManyHalfspaces = 256;

// All points, with those of a block close together if that is worth it: they are halved along the
// longest side of their box until a part is no larger than a block.
class BlockOrder {
 public:
  BlockOrder(const PointSet& points, bool is_worth_it) : points_(points.doubles()) {
    for (std::size_t i = 0; i < points.size(); ++i) ids_.emplace_back(i);
    if (is_worth_it) split(0, ids_.size());
  }
  std::vector<PointId> take() { return std::move(ids_); }

 private:
  void split(std::size_t first, std::size_t last) {
    if (last - first <= kBlock) return;
    Point low = points_[ids_[first].index()], high = low;
    for (std::size_t j = first; j < last; ++j) {
      low = low.cwiseMin(points_[ids_[j].index()]);
      high = high.cwiseMax(points_[ids_[j].index()]);
    }
    Eigen::Index longest = 0;
    Point(high / 2 - low / 2).maxCoeff(&longest);
    // Whole blocks to the left, so that no part straddles two.
    const std::size_t blocks = (last - first + kBlock - 1) / kBlock;
    const std::size_t middle = first + blocks / 2 * kBlock;
    const auto at = [&](std::size_t j) { return ids_.begin() + static_cast<std::ptrdiff_t>(j); };
    std::nth_element(at(first), at(middle), at(last), [&](PointId a, PointId b) {
      return points_[a.index()][longest] < points_[b.index()][longest];
    });
    split(first, middle);
    split(middle, last);
  }

  std::span<const Point> points_;
  std::vector<PointId> ids_;
};

class OutsideSearch {
 public:
  OutsideSearch(const PreparedHalfspaces& halfspaces, const PointSet& points)
      : halfspaces_(halfspaces),
        points_(points),
        is_double_(find_doubles(points)),
        ids_(BlockOrder(points, halfspaces.exact().size() >= kManyHalfspaces).take()),
        doubles_(points, ids_),
        absolute_(absolute_plane_error(std::max(1.0, doubles_.largest))) {}

  std::vector<PointId> find(const Watch& watch) {
    for (std::size_t first = 0; first < points_.size(); first += kBlock) {
      watch.ask();
      search_block(first, std::min(points_.size(), first + kBlock));
    }
    std::sort(found_.begin(), found_.end());
    return std::move(found_);
  }

 private:
  struct Box {
    double low[3], high[3];
  };

  Box box_of(std::size_t first, std::size_t last) const {
    const auto range = [&](const std::vector<double>& x, double& low, double& high) {
      const auto begin = x.begin() + static_cast<std::ptrdiff_t>(first);
      const auto [least, most] =
          std::minmax_element(begin, x.begin() + static_cast<std::ptrdiff_t>(last));
      low = *least;
      high = *most;
    };
    Box box;
    range(doubles_.x, box.low[0], box.high[0]);
    range(doubles_.y, box.low[1], box.high[1]);
    range(doubles_.z, box.low[2], box.high[2]);
    return box;
  }

  // Tests the corner of the box where n.x is largest: if it is inside, the whole block is. Rounding
  // is monotone, so the bound holds for coordinates that are no doubles, too; and where a component
  // of n is rounded to 0, the other corner exceeds this one by less than 2^-1074 times a
  // coordinate, which the absolute error covers.
  bool surely_inside(const DoubleHalfspace& h, const Box& box) const {
    double corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = h.n[k] > 0 ? box.high[k] : box.low[k];
    return h.at(corner[0], corner[1], corner[2], absolute_).surely_negative();
  }

  bool surely_inside(const DoubleHalfspace& h, std::size_t j) const {
    return h.at(doubles_, j, absolute_).surely_negative();
  }

  // Whether the error bound at the largest coordinates of a block settles all of its points. Counts
  // in doubles and without a branch, so that compilers turn it into vector code. Where a partial
  // sum overflows and the others could outweigh it, size + |d| overflows as well: the error is
  // infinite, and the value plus it not negative.
  bool surely_inside(const DoubleHalfspace& h, std::size_t first, std::size_t last,
                     double largest) const {
    const double size = (std::abs(h.n[0]) + std::abs(h.n[1]) + std::abs(h.n[2])) * largest;
    const double error = kRelativePlaneError * (size + std::abs(h.d)) + absolute_;
    const double *x = doubles_.x.data(), *y = doubles_.y.data(), *z = doubles_.z.data();
    double open = 0;
    for (std::size_t j = first; j < last; ++j) {
      const double value = h.n[0] * x[j] + h.n[1] * y[j] + h.n[2] * z[j] + h.d;
      open += value + error < 0 ? 0.0 : 1.0;  // 1 for NaN
    }
    return open == 0;
  }

  // One point that is no double makes a whole set rational; the others are tested in integers. A
  // remainder of 0 may have been rounded to it.
  static std::vector<bool> find_doubles(const PointSet& points) {
    std::vector<bool> are(points.size(), true);
    for (std::size_t i = 0; !points.is_binary() && i < points.size(); ++i) {
      are[i] = points.remainders()[i].isZero(0) &&
               to_rational(points.doubles()[i]) == points[PointId(i)];
    }
    return are;
  }

  bool is_outside(const Halfspace& h, PointId id, std::optional<HomogeneousPoint>& integers) const {
    if (is_double_[id.index()]) {
      return side_of(h, points_.doubles()[id.index()]) == Sign::Positive;
    }
    if (!integers) integers = clear_denominators(points_[id]);
    return plane_value(h, *integers) > 0;
  }

  void search_block(std::size_t first, std::size_t last) {
    const double largest = doubles_.largest_of(first, last);
    const Box box = box_of(first, last);
    std::vector<bool> outside(last - first, false);
    std::vector<std::optional<HomogeneousPoint>> integers(last - first);  // of those that need them
    for (std::size_t i = 0; i < halfspaces_.near().size(); ++i) {
      const DoubleHalfspace& near = halfspaces_.near()[i];
      if (surely_inside(near, box)) continue;
      if (surely_inside(near, first, last, largest)) continue;
      for (std::size_t j = first; j < last; ++j) {
        if (outside[j - first] || surely_inside(near, j)) continue;
        outside[j - first] = is_outside(halfspaces_.exact()[i], ids_[j], integers[j - first]);
      }
    }
    for (std::size_t j = first; j < last; ++j) {
      if (outside[j - first]) found_.push_back(ids_[j]);
    }
  }

  const PreparedHalfspaces& halfspaces_;
  const PointSet& points_;
  std::vector<bool> is_double_;  // by id
  std::vector<PointId> ids_;     // in blocks
  CoordinateArrays doubles_;     // in the order of the ids
  double absolute_;
  std::vector<PointId> found_;
};

}  // namespace

PreparedHalfspaces::PreparedHalfspaces(std::span<const Halfspace> halfspaces) : exact_(halfspaces) {
  near_.reserve(halfspaces.size());
  for (const Halfspace& h : halfspaces) near_.emplace_back(h);
}

std::vector<PointId> find_outside(const PreparedHalfspaces& halfspaces, const PointSet& points,
                                  const Watch& watch) {
  return OutsideSearch(halfspaces, points).find(watch);
}

std::vector<PointId> find_outside(std::span<const Halfspace> halfspaces, const PointSet& points,
                                  const Watch& watch) {
  return find_outside(PreparedHalfspaces(halfspaces), points, watch);
}

std::size_t count_outside(std::span<const Halfspace> halfspaces, const PointSet& points) {
  return find_outside(halfspaces, points).size();
}

}  // namespace convexact
