// SPDX-License-Identifier: MIT
#include "reach/reach_cells.hpp"

#include "convexact/error.hpp"

namespace convexact {
namespace {

constexpr double kFinest = 64;  // cells are refined until T is this many times their half width

}  // namespace

ReachCells::ReachCells(const Surface& surface, const Winding* winding, const NearFrame& frame,
                       const Rational& squared_limit, bool is_at_zero)
    : surface_(surface),
      winding_(winding),
      frame_(frame),
      triangles_(surface, frame),
      limit_down_(frame.root_down(squared_limit)),
      limit_up_(frame.root_up(squared_limit)),
      limit_near_(limit_down_ * (1 - kReachSlack)),
      is_at_zero_(is_at_zero) {
  // Finer than rounding nothing can be told.
  while (least_half_ > std::max(limit_down_ / kFinest, 0x1p-30)) least_half_ /= 2;
}

ReachCells::Label ReachCells::label(const CellPlace& place) {
  Cell& cell = cells_[place.cell];
  const Label known = cell.label.load(std::memory_order_acquire);
  if (known != Label::Unknown) return known;
  const NearTriangles::Nearest nearest = triangles_.nearest(place.center, cell.first_triangle);
  const auto [low, high] = nearest.distance;
  cell.low.store(low, kRelaxed);
  cell.high.store(high, kRelaxed);
  cell.triangle.store(nearest.triangle, kRelaxed);
  const double radius = place.radius() * (1 + 0x1p-50);
  Label label = Label::Open;
  if (high + radius <= limit_near_ || is_near_one_triangle(place)) {
    label = Label::Near;
  } else if (winding_ != nullptr && low > radius && side(place) == Side::Inside) {
    label = Label::Inside;
  }
  cell.label.store(label, std::memory_order_release);
  return label;
}

bool ReachCells::is_near_one_triangle(const CellPlace& place) const {
  // The center is among the points between the corners.
  if (distance(place.cell).high > limit_near_) return false;
  for (int k = 0; k < 8; ++k) {
    const NearBounds corner = triangles_.to_triangle(triangle(place.cell), place.corner(k));
    if (corner.high > limit_near_) return false;
  }
  return true;
}

ReachCells::Side ReachCells::side_of(const RationalPoint& x) const {
  if (winding_ == nullptr) return Side::Outside;
  const std::optional<long> number = (*winding_)(x);
  return number && *number == 0 ? Side::Outside : Side::Inside;
}

ReachCells::Side ReachCells::side(const CellPlace& place) {
  Cell& cell = cells_[place.cell];
  Side side = cell.side.load(kRelaxed);
  if (side == Side::Unknown) {
    side = side_of(frame_.point(place.center));
    cell.side.store(side, kRelaxed);
  }
  return side;
}

std::array<CellPlace, 8> ReachCells::children(const CellPlace& place) {
  Cell& cell = cells_[place.cell];
  std::uint32_t first = cell.first_child.load(std::memory_order_acquire);
  if (first == 0) {
    // No triangle separates the centers.
    const bool is_beside = cell.low.load(kRelaxed) > place.radius() / 2;
    first = cells_.divide(cell, is_beside ? cell.side.load(kRelaxed) : Side::Unknown);
  }
  std::array<CellPlace, 8> eight;
  for (std::uint32_t k = 0; k < 8; ++k) {
    const CellPlace half{0, place.center, place.half / 2};
    eight[k] = {first + k, half.corner(static_cast<int>(k)), place.half / 2};
  }
  return eight;
}

void ReachCells::Store::clear() {
  for (std::unique_ptr<Cell[]>& block : blocks_) block.reset();
  blocks_[0] = std::make_unique<Cell[]>(kBlock);
  size_ = 1;
}

std::uint32_t ReachCells::Store::divide(Cell& parent, Side side) {
  const std::lock_guard lock(adding_);
  if (const std::uint32_t known = parent.first_child.load(kRelaxed)) return known;
  const std::size_t first = size_;
  CONVEXACT_ASSERT(first + 8 <= kMostBlocks * kBlock);
  for (std::size_t k = first; k < first + 8; ++k) {
    std::unique_ptr<Cell[]>& block = blocks_[k / kBlock];
    if (block == nullptr) block = std::make_unique<Cell[]>(kBlock);
    Cell& child = block[k % kBlock];
    child.first_triangle = parent.triangle.load(kRelaxed);
    child.side.store(side, kRelaxed);
  }
  size_ = first + 8;
  parent.first_child.store(static_cast<std::uint32_t>(first), std::memory_order_release);
  return static_cast<std::uint32_t>(first);
}

}  // namespace convexact
