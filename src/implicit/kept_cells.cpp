// SPDX-License-Identifier: MIT
// The octree: cells that may hold the surface, level by level.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/implicit.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

using CellIndex = std::array<std::uint32_t, 3>;

// The proven facts about a cell: f > L rho or f < -L rho at its center, or neither.
enum class CellPlace { Outside, Inside, Kept, Undecided };

// Whether x and every coordinate between it and x + edge that is a multiple of `unit` away from x
// is a double.
bool are_doubles(double x, double edge, int unit) {
  const auto is_multiple = [&](double y) {
    return std::ldexp(y, -unit) == std::nearbyint(std::ldexp(y, -unit));
  };
  const double last = x + edge;
  constexpr double kMostWhole = 0x1p53;
  return std::isfinite(last) && to_rational(last) == to_rational(x) + to_rational(edge) &&
         is_multiple(x) && std::ldexp(std::max(std::abs(x), std::abs(last)), -unit) <= kMostWhole;
}

// Trailing zeros of the significand of x, as an exponent: x is an odd integer times 2^that.
int odd_exponent(double x) {
  int exponent = 0;
  const double significand = std::ldexp(std::frexp(x, &exponent), 53);
  auto bits = static_cast<std::uint64_t>(std::abs(significand));
  exponent -= 53;
  while (bits % 2 == 0) {
    bits /= 2;
    ++exponent;
  }
  return exponent;
}

// The corners of cells and their centers are multiples of a power of two that is also a divisor of
// the box's corner, so that none of them is rounded.
void require_exact_box(const ImplicitBox& box, std::size_t depth) {
  for (const double x : {box.low[0], box.low[1], box.low[2], box.edge}) {
    if (!std::isfinite(x)) throw Error(ErrorCode::NotFinite, "expected a box of finite numbers");
  }
  if (!(box.edge > 0))
    reject_argument(fmt::format("expected a box with an edge above 0, found {}", box.edge));
  if (depth > kMostImplicitDepth) {
    reject_argument(fmt::format("expected a depth up to {}, found {}", kMostImplicitDepth, depth));
  }
  const int half_cell = odd_exponent(box.edge) - static_cast<int>(depth) - 1;
  for (const double x : box.low) {
    const int unit = x == 0 ? half_cell : std::min(half_cell, odd_exponent(x));
    if (unit < -1074 || !are_doubles(x, box.edge, unit)) {
      reject_argument(fmt::format(
          "the cells of the box at depth {} have corners or centers that are no doubles: choose "
          "numbers of fewer bits, such as whole ones",
          depth));
    }
  }
}

class Octree {
 public:
  Octree(const ImplicitShape& shape, const ImplicitBox& box, const Watch& watch)
      : shape_(shape), box_(box), watch_(watch) {}

  // One level: those kept of the children of the cells that the last level kept.
  std::vector<CellIndex> next_level(const std::vector<CellIndex>& parents, std::size_t level,
                                    bool is_last, ImplicitCells::Level& counts) {
    set_level(level);
    const std::size_t children = level == 0 ? 1 : 8;
    counts.tested = children * parents.size();
    std::vector<CellIndex> kept;
    std::size_t done = 0;
    for (const CellIndex& parent : parents) {
      for (std::uint32_t child = 0; child < children; ++child) {
        watch_.at(done++, counts.tested);
        const CellIndex cell =
            level == 0 ? parent
                       : CellIndex{2 * parent[0] + (child >> 2), 2 * parent[1] + (child >> 1 & 1),
                                   2 * parent[2] + (child & 1)};
        const CellPlace place = place_of(cell);
        const bool is_kept = place == CellPlace::Kept || place == CellPlace::Undecided;
        if (place != CellPlace::Outside && (is_last || !is_kept)) require_inside_box(cell, level);
        if (!is_kept) continue;
        counts.undecided += place == CellPlace::Undecided;
        kept.push_back(cell);
        if (kept.size() > kMostImplicitCells) refuse_level(level);
      }
    }
    counts.kept = kept.size();
    return kept;
  }

  double edge() const { return edge_; }
  double coordinate(std::size_t axis, std::uint32_t index) const {
    return box_.low[static_cast<Eigen::Index>(axis)] + index * edge_;
  }

 private:
  void set_level(std::size_t level) {
    edge_ = std::ldexp(box_.edge, -static_cast<int>(level));
    last_ = (std::uint32_t(1) << level) - 1;
    // L rho: the square of rho is 3/4 of that of the edge.
    const Rational edge = to_rational(edge_);
    for (std::size_t k = 0; k < kBits.size(); ++k) {
      bounds_[k] = Enclosure(shape_.bounds().lipschitz, kBits[k]) *
                   sqrt(Enclosure(3 * edge * edge / 4, kBits[k]));
    }
    bound_ = {bounds_.back().low_double(), bounds_.back().high_double()};
  }

  // Doubles first, then numbers of ever more bits.
  CellPlace place_of(const CellIndex& cell) const {
    Point center;
    for (std::size_t k = 0; k < 3; ++k) {
      center[static_cast<Eigen::Index>(k)] = coordinate(k, cell[k]) + edge_ / 2;
    }
    const ImplicitRange value = enclose_value(shape_, center);
    if (value.low > bound_.high) return CellPlace::Outside;
    if (value.high < -bound_.high) return CellPlace::Inside;
    if (value.low >= -bound_.low && value.high <= bound_.low) return CellPlace::Kept;
    const RationalPoint exact = to_rational(center);
    for (std::size_t k = 0; k < kBits.size(); ++k) {
      const Enclosure f = enclose_value(shape_, exact, kBits[k]);
      const Enclosure above = f - bounds_[k], below_negative = f + bounds_[k];
      if (above.low() > 0) return CellPlace::Outside;
      if (below_negative.high() < 0) return CellPlace::Inside;
      if (above.high() <= 0 && below_negative.low() >= 0) return CellPlace::Kept;
    }
    return CellPlace::Undecided;
  }

  void require_inside_box(const CellIndex& cell, std::size_t level) const {
    if (std::none_of(cell.begin(), cell.end(),
                     [&](std::uint32_t index) { return index == 0 || index == last_; })) {
      return;
    }
    throw Error(ErrorCode::NoInterior,
                fmt::format("the shape may leave the box: its cell at ({:g}, {:g}, {:g}) of edge "
                            "{:g}, level {}, is not proven to lie outside of the shape",
                            coordinate(0, cell[0]), coordinate(1, cell[1]), coordinate(2, cell[2]),
                            edge_, level));
  }

  [[noreturn]] static void refuse_level(std::size_t level) {
    reject_argument(fmt::format("more than {} cells are kept at level {}: choose a smaller depth",
                                with_separators(kMostImplicitCells), level));
  }

  static constexpr std::array<long, 2> kBits = {128, 512};

  const ImplicitShape& shape_;
  const ImplicitBox& box_;
  const Watch& watch_;
  double edge_ = 0;
  std::uint32_t last_ = 0;  // the greatest index of a cell
  ImplicitRange bound_{};   // of L rho
  std::array<Enclosure, 2> bounds_{Enclosure(kBits[0]), Enclosure(kBits[1])};
};

// Corners are sorted as numbers of 21 bits for each axis, to find those that cells share.
std::vector<Point> corners_of(const std::vector<CellIndex>& cells, const Octree& octree) {
  static_assert(kMostImplicitDepth < 21);
  std::vector<std::uint64_t> keys;
  keys.reserve(8 * cells.size());
  for (const CellIndex& cell : cells) {
    for (std::uint64_t corner = 0; corner < 8; ++corner) {
      keys.push_back((cell[0] + (corner >> 2)) << 42 | (cell[1] + (corner >> 1 & 1)) << 21 |
                     (cell[2] + (corner & 1)));
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  std::vector<Point> corners;
  corners.reserve(keys.size());
  const auto index = [](std::uint64_t key) { return static_cast<std::uint32_t>(key & 0x1fffff); };
  for (const std::uint64_t key : keys) {
    corners.emplace_back(octree.coordinate(0, index(key >> 42)),
                         octree.coordinate(1, index(key >> 21)), octree.coordinate(2, index(key)));
  }
  return corners;
}

// A corner x of a kept cell has f(x) <= |f(m)| + L rho <= 2 L rho, and 2 rho = sqrt(3) h.
double corner_distance(const Rational& lipschitz, const Rational& tightness, double edge) {
  const Rational h = to_rational(edge);
  return (Enclosure(lipschitz / tightness, kMeasureBits) * sqrt(Enclosure(3 * h * h, kMeasureBits)))
      .high_double();
}

}  // namespace

ImplicitCells kept_cells(const ImplicitShape& shape, const ImplicitBox& box, std::size_t depth,
                         const Watch& watch) {
  require_exact_box(box, depth);
  ImplicitCells cells;
  cells.levels.resize(depth + 1);
  Octree octree(shape, box, watch);
  cells.leaves = {CellIndex{0, 0, 0}};
  for (std::size_t level = 0; level <= depth; ++level) {
    cells.leaves = octree.next_level(cells.leaves, level, level == depth, cells.levels[level]);
  }
  if (cells.leaves.empty()) {
    throw Error(ErrorCode::NoInterior,
                "empty: every cell of the box is proven to hold no point of the shape");
  }
  std::sort(cells.leaves.begin(), cells.leaves.end());
  cells.leaf_edge = octree.edge();
  cells.corners = corners_of(cells.leaves, octree);
  const auto& [lipschitz, tightness] = shape.bounds();
  if (tightness) cells.distance = corner_distance(lipschitz, *tightness, cells.leaf_edge);
  return cells;
}

}  // namespace convexact
