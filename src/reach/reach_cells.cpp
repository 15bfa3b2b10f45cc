// SPDX-License-Identifier: MIT
#include "reach/reach_cells.hpp"

#include "convexact/reach.hpp"

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
      is_at_zero_(is_at_zero),
      most_(kReachCells) {
  // Finer than rounding nothing can be told.
  while (least_half_ > std::max(limit_down_ / kFinest, 0x1p-30)) least_half_ /= 2;
}

ReachCells::Label ReachCells::label(const CellPlace& place) {
  if (cells_[place.cell].label != Label::Unknown) return cells_[place.cell].label;
  const NearTriangles::Nearest nearest =
      triangles_.nearest(place.center, cells_[place.cell].triangle);
  Cell& cell = cells_[place.cell];
  cell.low = nearest.distance.low;
  cell.high = nearest.distance.high;
  cell.triangle = nearest.triangle;
  cell.label = Label::Open;
  const double radius = place.radius() * (1 + 0x1p-50);
  if (cell.high + radius <= limit_near_ || is_near_one_triangle(place)) {
    cell.label = Label::Near;
  } else if (winding_ != nullptr && cell.low > radius && side(place) == Side::Inside) {
    cell.label = Label::Inside;
  }
  return cells_[place.cell].label;
}

bool ReachCells::is_near_one_triangle(const CellPlace& place) const {
  const Cell& cell = cells_[place.cell];
  // The center is among the points between the corners.
  if (cell.high > limit_near_) return false;
  for (int k = 0; k < 8; ++k) {
    if (triangles_.to_triangle(cell.triangle, place.corner(k)).high > limit_near_) return false;
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
  if (cell.side == Side::Unknown) cell.side = side_of(frame_.point(place.center));
  return cell.side;
}

std::array<CellPlace, 8> ReachCells::children(const CellPlace& place) {
  std::uint32_t first = cells_[place.cell].first_child;
  if (first == 0) {
    const Cell parent = cells_[place.cell];
    first = static_cast<std::uint32_t>(cells_.size());
    Cell child;
    child.triangle = parent.triangle;
    // No triangle separates the centers.
    if (parent.low > place.radius() / 2) child.side = parent.side;
    cells_.resize(cells_.size() + 8, child);
    cells_[place.cell].first_child = first;
  }
  std::array<CellPlace, 8> eight;
  for (std::uint32_t k = 0; k < 8; ++k) {
    const CellPlace half{0, place.center, place.half / 2};
    eight[k] = {first + k, half.corner(static_cast<int>(k)), place.half / 2};
  }
  return eight;
}

}  // namespace convexact
