// SPDX-License-Identifier: MIT
#include "convexact/stored/containment.hpp"

#include "convexact/geometry/plane_side.hpp"
#include "double_halfspace.hpp"

namespace convexact {
namespace {

using stored::Coordinates;
using stored::DoubleHalfspace;

// Blocks stay in the first-level cache while all halfspaces pass over them.
constexpr std::size_t kBlock = 128;

class OutsideCounter {
 public:
  OutsideCounter(std::span<const Halfspace> halfspaces, const PointSet& points)
      : halfspaces_(halfspaces),
        points_(points),
        doubles_(points.doubles()),
        absolute_(stored::absolute_error(std::max(1.0, doubles_.largest))) {
    filters_.reserve(halfspaces.size());
    for (const Halfspace& h : halfspaces) filters_.emplace_back(h);
  }

  std::size_t count() {
    std::size_t total = 0;
    for (std::size_t first = 0; first < points_.size(); first += kBlock) {
      total += count_block(first, std::min(points_.size(), first + kBlock));
    }
    return total;
  }

 private:
  bool surely_inside(const DoubleHalfspace& h, std::size_t j) const {
    return h.at(doubles_, j, absolute_).surely_negative();
  }

  // Whether the error bound at the largest coordinates of a block settles all of its points. Counts
  // in doubles and without a branch, so that compilers turn it into vector code.
  bool surely_inside(const DoubleHalfspace& h, std::size_t first, std::size_t last,
                     double largest) const {
    const double size = (std::abs(h.n[0]) + std::abs(h.n[1]) + std::abs(h.n[2])) * largest;
    const double error = stored::kRelative * (size + std::abs(h.d)) + absolute_;
    const double *x = doubles_.x.data(), *y = doubles_.y.data(), *z = doubles_.z.data();
    double open = 0;
    for (std::size_t j = first; j < last; ++j) {
      const double value = h.n[0] * x[j] + h.n[1] * y[j] + h.n[2] * z[j] + h.d;
      open += value + error < 0 ? 0.0 : 1.0;  // 1 for NaN
    }
    return open == 0 && size < 0x1p1022;  // no partial sum overflowed
  }

  bool is_outside(const Halfspace& h, std::size_t j) const {
    return points_.is_binary() ? side_of(h, points_.doubles()[j]) == Sign::Positive
                               : h(points_[PointId(j)]) > 0;
  }

  std::size_t count_block(std::size_t first, std::size_t last) {
    const double largest = doubles_.largest_of(first, last);
    std::vector<bool> outside(last - first, false);
    for (std::size_t i = 0; i < filters_.size(); ++i) {
      if (surely_inside(filters_[i], first, last, largest)) continue;
      for (std::size_t j = first; j < last; ++j) {
        if (outside[j - first] || surely_inside(filters_[i], j)) continue;
        outside[j - first] = is_outside(halfspaces_[i], j);
      }
    }
    return static_cast<std::size_t>(std::count(outside.begin(), outside.end(), true));
  }

  std::span<const Halfspace> halfspaces_;
  const PointSet& points_;
  Coordinates doubles_;
  double absolute_;
  std::vector<DoubleHalfspace> filters_;
};

}  // namespace

std::size_t count_outside(std::span<const Halfspace> halfspaces, const PointSet& points) {
  return OutsideCounter(halfspaces, points).count();
}

}  // namespace convexact
