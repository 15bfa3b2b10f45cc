// SPDX-License-Identifier: MIT
// reach_cells.hpp - a lazy octree around a solid: how far the centers of its cells are from the
// surface, and which cells lie within T of the solid as a whole.
#pragma once
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "convexact/reach.hpp"
#include "convexact/surface.hpp"
#include "near/frame.hpp"
#include "overlay/union_distance_triangles.hpp"

namespace convexact {

/// The error that rounding adds to comparisons of cells and parts in a frame, whose coordinates are
/// at most 2: several times kDistanceError there.
inline constexpr double kReachError = 0x1p-43;
/// The share of T by which cells are nearer than T if they are said to be near.
inline constexpr double kReachSlack = 0x1p-12;

/// A cell as a place: the cube around a center. Centers and half widths are dyadic, and exact.
struct CellPlace {
  std::uint32_t cell;
  Point center;
  double half;

  /// Of the sphere around the cell, rounded up.
  double radius() const { return half * 1.7320508075688774; }
  Point corner(int k) const {
    return center + Point(k & 1 ? half : -half, k & 2 ? half : -half, k & 4 ? half : -half);
  }
};

/// Several threads may ask at the same time: what is found about a cell depends on its place alone,
/// so it does not matter who finds it.
class ReachCells {
 public:
  /// @param winding  Null for an open surface.
  /// @param squared_limit  > 0.
  /// @param is_at_zero  It stands for 0.
  ReachCells(const Surface& surface, const Winding* winding, const NearFrame& frame,
             const Rational& squared_limit, bool is_at_zero = false);

  enum class Label : std::uint8_t { Unknown, Near, Inside, Open };

  CellPlace root() const { return {0, Point::Zero(), 2}; }
  double least_half() const { return least_half_; }
  /// Bounds of T in the frame.
  double limit_down() const { return limit_down_; }
  double limit_up() const { return limit_up_; }
  /// Whether T is 0: the limit is that of cells only, and what is certainly outside is beyond.
  bool is_at_zero() const { return is_at_zero_; }
  std::size_t size() const { return cells_.size(); }
  /// Forgets all cells if there are more than half of kReachCells, so that other questions have
  /// room. What they were is found again. Not while another thread asks.
  void make_room() {
    if (cells_.size() > kReachCells / 2) cells_.clear();
  }

  /// Whether the cell is fine, and why. Open: it is not, or that is not certain.
  Label label(const CellPlace& place);
  /// Bounds of the distance of the center to the surface.
  NearBounds distance(std::uint32_t cell) const {
    return {cells_[cell].low.load(kRelaxed), cells_[cell].high.load(kRelaxed)};
  }
  /// A triangle that is about nearest to the center, or within T of the whole cell.
  std::uint32_t triangle(std::uint32_t cell) const { return cells_[cell].triangle.load(kRelaxed); }
  /// Whether the center lies outside of the solid, exactly; of an open surface: always.
  bool is_outside(const CellPlace& place) { return side(place) == Side::Outside; }
  bool is_outside(const Point& y) const { return is_outside(frame_.point(y)); }
  bool is_outside(const RationalPoint& x) const { return side_of(x) == Side::Outside; }
  /// The eight cells of half the size, without labels if they are new.
  std::array<CellPlace, 8> children(const CellPlace& place);
  bool has_children(std::uint32_t cell) const { return cells_[cell].first_child.load() != 0; }

  /// Whether the surface is closed, so that it may wind about a point.
  bool has_inside() const { return winding_ != nullptr; }

  const NearTriangles& triangles() const { return triangles_; }
  const NearFrame& frame() const { return frame_; }
  const Surface& surface() const { return surface_; }

 private:
  static constexpr auto kRelaxed = std::memory_order_relaxed;
  enum class Side : std::uint8_t { Unknown, Outside, Inside };
  // Distance, triangle and label are found together, and the label is written last.
  struct Cell {
    std::atomic<double> low = 0, high = 0;  // of the distance of the center to the surface
    std::uint32_t first_triangle = 0;       // from which the nearest one is searched
    std::atomic<std::uint32_t> triangle = 0, first_child = 0;
    std::atomic<Label> label = Label::Unknown;
    std::atomic<Side> side = Side::Unknown;  // of the center
  };

  // Cells by number, which stay where they are while more are added.
  class Store {
   public:
    Store() : blocks_(kMostBlocks) { clear(); }
    Cell& operator[](std::uint32_t k) { return blocks_[k / kBlock][k % kBlock]; }
    const Cell& operator[](std::uint32_t k) const { return blocks_[k / kBlock][k % kBlock]; }
    std::size_t size() const { return size_; }
    /// All but the root, which is as new.
    void clear();
    /// Gives a cell its eight children, unless another thread has.
    /// @return The first of them.
    std::uint32_t divide(Cell& parent, Side side);

   private:
    static constexpr std::size_t kBlock = std::size_t{1} << 13;
    static constexpr std::size_t kMostBlocks = 16 * kReachCells / kBlock;
    std::vector<std::unique_ptr<Cell[]>> blocks_;
    std::atomic<std::size_t> size_ = 0;
    std::mutex adding_;
  };

  Side side_of(const RationalPoint& x) const;
  Side side(const CellPlace& place);
  bool is_near_one_triangle(const CellPlace& place) const;

  const Surface& surface_;
  const Winding* winding_;
  NearFrame frame_;
  NearTriangles triangles_;
  double limit_down_, limit_up_, limit_near_, least_half_ = 2;
  bool is_at_zero_;
  Store cells_;
};

}  // namespace convexact
