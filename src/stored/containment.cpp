// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/stored.hpp"
#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"
#include "stored/prepared_halfspaces.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

// Blocks stay in the first-level cache while all halfspaces pass over them.
constexpr std::size_t kBlock = 128;
// What a thread takes at a time.
constexpr std::size_t kTurn = 64 * kBlock;
// Halfspaces that are tested against a block at once, where there are many.
constexpr std::size_t kGroup = 32, kManyHalfspaces = 256;

// An order of points in which those of a block are close together: by the cells of a grid, along a
// path from each cell to one beside it. A surface of points meets about as many cells as there are
// blocks.
class BlockOrder {
 public:
  BlockOrder(std::span<const Point> points, std::size_t block) {
    if (points.empty()) return;
    low_ = points[0] / 2;
    Point high = low_;
    for (const Point& p : points) {
      low_ = low_.cwiseMin(p / 2);
      high = high.cwiseMax(p / 2);
    }
    const double cells = static_cast<double>(points.size()) / static_cast<double>(3 * block);
    side_ = static_cast<std::size_t>(std::clamp(std::sqrt(cells), 1.0, 64.0));
    for (int k = 0; k < 3; ++k) {  // halved, so that no extent overflows
      const double scale = static_cast<double>(side_) / (high[k] - low_[k]);
      scale_[k] = std::isfinite(scale) ? scale : 0;
    }
    sort(points);
  }
  std::vector<std::uint32_t> take() { return std::move(order_); }

 private:
  std::size_t place(const Point& p, int k) const {
    return std::min(side_ - 1, static_cast<std::size_t>((p[k] / 2 - low_[k]) * scale_[k]));
  }
  // Its number on the path.
  std::size_t cell(const Point& p) const {
    const std::size_t x = place(p, 0);
    const std::size_t y = x % 2 == 0 ? place(p, 1) : side_ - 1 - place(p, 1);
    const std::size_t row = x * side_ + y;
    return row * side_ + (row % 2 == 0 ? place(p, 2) : side_ - 1 - place(p, 2));
  }
  void sort(std::span<const Point> points) {
    std::vector<std::uint32_t> cells(points.size());
    std::vector<std::uint32_t> first(side_ * side_ * side_ + 1);  // of each cell
    for (std::size_t i = 0; i < points.size(); ++i) {
      cells[i] = static_cast<std::uint32_t>(cell(points[i]));
      ++first[cells[i] + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    order_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      order_[first[cells[i]]++] = static_cast<std::uint32_t>(i);
    }
  }

  Point low_ = Point::Zero(), scale_ = Point::Zero();
  std::size_t side_ = 1;
  std::vector<std::uint32_t> order_;
};

std::vector<PointId> ids_in_blocks(const PointSet& points) {
  std::vector<PointId> ids;
  ids.reserve(points.size());
  for (const std::uint32_t i : BlockOrder(points.doubles(), kBlock).take()) ids.emplace_back(i);
  return ids;
}

std::vector<HalfspaceGroup> groups_of(std::span<const DoubleHalfspace> halfspaces) {
  std::vector<Point> normals;  // their largest component is 1 or -1
  std::vector<double> offsets;
  for (const DoubleHalfspace& h : halfspaces) {
    const Point n(h.n[0], h.n[1], h.n[2]);
    const double largest = n.lpNorm<Eigen::Infinity>();
    normals.push_back(n / largest);
    offsets.push_back(h.d / largest);
  }
  const std::vector<std::uint32_t> order = BlockOrder(normals, kGroup).take();
  std::vector<HalfspaceGroup> groups;
  for (std::size_t first = 0; first < order.size(); first += kGroup) {
    HalfspaceGroup& group = groups.emplace_back();
    group.members.assign(
        order.begin() + static_cast<std::ptrdiff_t>(first),
        order.begin() + static_cast<std::ptrdiff_t>(std::min(order.size(), first + kGroup)));
    group.largest_d = offsets[group.members[0]];
    for (int k = 0; k < 3; ++k) {
      group.normals.low[k] = group.normals.high[k] = normals[group.members[0]][k];
    }
    for (const std::uint32_t i : group.members) {
      for (int k = 0; k < 3; ++k) {
        group.normals.low[k] = std::min(group.normals.low[k], normals[i][k]);
        group.normals.high[k] = std::max(group.normals.high[k], normals[i][k]);
      }
      group.largest_d = std::max(group.largest_d, offsets[i]);
      group.largest_size = std::max(group.largest_size, std::abs(offsets[i]));
    }
  }
  return groups;
}

class OutsideSearch {
 public:
  OutsideSearch(const PreparedHalfspaces& halfspaces, const PointSet& points)
      : halfspaces_(halfspaces),
        points_(points),
        is_double_(find_doubles(points)),
        ids_(ids_in_blocks(points)),
        doubles_(points, ids_),
        absolute_(absolute_plane_error(std::max(1.0, doubles_.largest))) {}

  std::vector<PointId> find(const Watch& watch, std::size_t jobs) const {
    std::vector<PointId> found;
    const auto search = [&](std::size_t turn, const Watch& quiet) {
      std::vector<PointId> here;
      const std::size_t end = std::min(points_.size(), (turn + 1) * kTurn);
      for (std::size_t first = turn * kTurn; first < end; first += kBlock) {
        quiet.ask();
        search_block(first, std::min(end, first + kBlock), here);
      }
      return here;
    };
    const auto take = [&](std::size_t, const std::vector<PointId>& here) {
      found.insert(found.end(), here.begin(), here.end());
      return true;
    };
    take_in_order((points_.size() + kTurn - 1) / kTurn, jobs, watch.without_reports(), search, take,
                  1);
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  CoordinateBox box_of(std::size_t first, std::size_t last) const {
    const auto range = [&](const std::vector<double>& x, double& low, double& high) {
      double least = x[first], most = x[first];
      for (std::size_t j = first; j < last; ++j) {
        least = std::min(least, x[j]);
        most = std::max(most, x[j]);
      }
      low = least;
      high = most;
    };
    CoordinateBox box;
    range(doubles_.x, box.low[0], box.high[0]);
    range(doubles_.y, box.low[1], box.high[1]);
    range(doubles_.z, box.low[2], box.high[2]);
    return box;
  }

  // Tests the corner of the box where n.x is largest: if it is inside, the whole block is. Rounding
  // is monotone, so the bound holds for coordinates that are no doubles, too; and where a component
  // of n is rounded to 0, the other corner exceeds this one by less than 2^-1074 times a
  // coordinate, which the absolute error covers.
  bool surely_inside(const DoubleHalfspace& h, const CoordinateBox& box) const {
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

  // Points [first, last) in the order of the ids, and what is known of them.
  struct Block {
    std::size_t first, last;
    double largest;
    CoordinateBox box;
    std::array<bool, kBlock> outside = {};
    std::vector<std::optional<HomogeneousPoint>> integers = {};  // of those that need them
    bool is_clear = true;                                        // whether none is outside
  };

  void compare(std::size_t i, Block& block) const {
    const DoubleHalfspace& near = halfspaces_.near()[i];
    if (surely_inside(near, block.box)) return;
    if (surely_inside(near, block.first, block.last, block.largest)) return;
    for (std::size_t j = block.first; j < block.last; ++j) {
      const std::size_t own = j - block.first;
      if (block.outside[own] || surely_inside(near, j)) continue;
      block.integers.resize(kBlock);
      block.outside[own] = is_outside(halfspaces_.exact()[i], ids_[j], block.integers[own]);
      block.is_clear = block.is_clear && !block.outside[own];
    }
  }

  void search_block(std::size_t first, std::size_t last, std::vector<PointId>& found) const {
    Block block{first, last, doubles_.largest_of(first, last), box_of(first, last)};
    if (halfspaces_.groups().empty()) {
      for (std::size_t i = 0; i < halfspaces_.near().size(); ++i) compare(i, block);
    }
    for (const HalfspaceGroup& group : halfspaces_.groups()) {
      if (group.surely_hold(block.box, absolute_)) continue;
      for (const std::uint32_t i : group.members) compare(i, block);
    }
    for (std::size_t j = first; j < last && !block.is_clear; ++j) {
      if (block.outside[j - first]) found.push_back(ids_[j]);
    }
  }

  const PreparedHalfspaces& halfspaces_;
  const PointSet& points_;
  std::vector<bool> is_double_;  // by id
  std::vector<PointId> ids_;     // in blocks
  CoordinateArrays doubles_;     // in the order of the ids
  double absolute_;
};

}  // namespace

// n.x is largest at corners of both boxes. Each rounding is monotone, so the value and the bound of
// its error in doubles are no less than those of any member at any point. A member was divided,
// which rounds n and d once more than kRelativePlaneError counts: twice that covers it.
bool HalfspaceGroup::surely_hold(const CoordinateBox& box, double absolute) const {
  double most[3], size = largest_size;
  for (int k = 0; k < 3; ++k) {
    const double low = normals.low[k], high = normals.high[k];
    most[k] = std::max(std::max(low * box.low[k], low * box.high[k]),
                       std::max(high * box.low[k], high * box.high[k]));
    size += std::max(std::abs(low), std::abs(high)) *
            std::max(std::abs(box.low[k]), std::abs(box.high[k]));
  }
  const double error = 2 * (kRelativePlaneError * size + absolute);
  return most[0] + most[1] + most[2] + largest_d + error < 0;
}

PreparedHalfspaces::PreparedHalfspaces(std::span<const Halfspace> halfspaces) : exact_(halfspaces) {
  near_.reserve(halfspaces.size());
  for (const Halfspace& h : halfspaces) near_.emplace_back(h);
  if (near_.size() >= kManyHalfspaces) groups_ = groups_of(near_);
}

std::vector<PointId> find_outside(const PreparedHalfspaces& halfspaces, const PointSet& points,
                                  const Watch& watch, std::size_t jobs) {
  return OutsideSearch(halfspaces, points).find(watch, jobs);
}

std::vector<PointId> find_outside(std::span<const Halfspace> halfspaces, const PointSet& points,
                                  const Watch& watch, std::size_t jobs) {
  return find_outside(PreparedHalfspaces(halfspaces), points, watch, jobs);
}

std::size_t count_outside(std::span<const Halfspace> halfspaces, const PointSet& points,
                          std::size_t jobs) {
  return find_outside(halfspaces, points, {}, jobs).size();
}

}  // namespace convexact
