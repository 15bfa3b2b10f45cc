// SPDX-License-Identifier: MIT
// ring.hpp - a dual point with its one-ring: coordinates in one arithmetic, and the triangles that
// close the hole when it is removed.
#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "fast/dual.hpp"
#include "fast/mesh.hpp"
#include "fast/signs.hpp"
#include "number/random.hpp"

namespace convexact {

/// Dual point `center` and the points around it. `arm[m]` = point[m] - center, `side[m]` =
/// arm[m] x arm[m + 1], cyclic.
template <class Scalar>
struct RingGeometry {
  Triple<Scalar> center;
  std::size_t size = 0;                          ///< How many points there are.
  std::vector<Triple<Scalar>> point, arm, side;  ///< As long as the longest ring so far.
  Extent extent;                                 ///< Of the arms.

  /// @param coordinates  From an id to Triple<Scalar>.
  template <class Coordinates, class Id, class Ids>
  void load(Id i, const Ids& ring, const Coordinates& coordinates) {
    center = coordinates(i);
    const std::size_t k = size = ring.size();
    if (k > point.size()) {
      point.resize(k);
      arm.resize(k);
      side.resize(k);
    }
    extent = Extent();
    for (std::size_t m = 0; m < k; ++m) {
      point[m] = coordinates(ring[m]);
      arm[m] = point[m] - center;
      extent.include(arm[m]);
    }
    for (std::size_t m = 0; m + 1 < k; ++m) side[m] = cross(arm[m], arm[m + 1]);
    side[k - 1] = cross(arm[k - 1], arm[0]);
  }
  /// Bounds for determinants of arms, and of arms with one of the points.
  PlaneFilter arm_filter(double unit) const { return filter_for<Scalar>(extent.size, unit); }
  /// Bounds for determinants of any of these points: differences between ring points are at most
  /// twice the arms.
  PlaneFilter filter(double unit) const { return filter_for<Scalar>(extent.doubled(), unit); }
};

/// Triangulates one-rings. Beyond is any type with
///   void set_triangle(low, middle, high)  positions in the ring, ascending
///   bool is_beyond(m)                     whether ring point m is strictly beyond that triangle
/// The result is a triangulation of the polygon 0 .. k - 1 for *any* answers of is_beyond; with
/// true answers it is the hull of the ring as the removed point saw it. So it ends in any
/// arithmetic; flipping would not.
class RingTriangulator {
 public:
  /// @par Cost  Up to kShortRing points: at most (k - 2)(k - 3) / 2 questions, fewer than by
  ///            insertion. Above: expected O(k) questions, by insertion in random order.
  /// @param seed  Of that order: the same ring and seed give the same triangles.
  /// @par Source  [Chew1990] for long rings.
  template <class Beyond>
  void run(std::uint32_t k, Beyond& beyond, std::uint64_t seed,
           std::vector<RingTriangle>& triangles) {
    if (k <= kShortRing) {
      wrap(k, beyond, triangles);
    } else {
      triangles.clear();
      Random random(seed);
      insert_all(k, beyond, random);
      as_tree(k, triangles);
    }
  }

  static constexpr std::uint32_t kShortRing = 16;

 private:
  struct Task {
    std::uint32_t low, high, parent;
  };
  // A triangle while inserting: edge e runs from corner[e] to the next corner, counter-clockwise;
  // across[e] is the piece behind it, kNone at the polygon's rim.
  struct Piece {
    std::array<std::uint32_t, 3> corner, across;
    std::uint32_t edge_from(std::uint32_t tail) const {
      return corner[0] == tail ? 0 : corner[1] == tail ? 1 : 2;
    }
  };
  struct Side {
    std::uint32_t piece, edge;
  };
  static constexpr std::uint32_t kRim = 3;  // added to an edge: on the rim; keeps it modulo 3
  // An edge of the polygon that a new point sees, as the new triangle over it will have it.
  struct Link {
    std::uint32_t tail, head, across;
  };

  template <class Beyond>
  void wrap(std::uint32_t k, Beyond& beyond, std::vector<RingTriangle>& triangles);
  template <class Beyond>
  void insert_all(std::uint32_t k, Beyond& beyond, Random& random);
  template <class Beyond>
  void collect_chain(std::uint32_t p, std::uint32_t before, Beyond& beyond);
  void take_out(std::uint32_t k, Random& random);
  void start_with_triangle(std::uint32_t k);
  void fill_fan(std::uint32_t p, std::uint32_t before, std::uint32_t after);
  void as_tree(std::uint32_t k, std::vector<RingTriangle>& triangles);
  std::uint32_t new_piece();

  std::vector<Task> tasks_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> free_;  // positions in pieces_
  std::vector<std::uint32_t> rim_;   // of each vertex of the polygon the piece along its next edge
  std::vector<Side> stack_;
  std::vector<Link> chain_;
  std::vector<std::uint32_t> order_, next_, previous_;
};

// Below a known edge (low, high) hangs the point first met by a plane turning about that edge.
// All candidates lie within half a turn, so pairwise comparison finds it.
template <class Beyond>
void RingTriangulator::wrap(std::uint32_t k, Beyond& beyond, std::vector<RingTriangle>& triangles) {
  std::array<Task, kShortRing> tasks;
  std::size_t pending = 0;
  tasks[pending++] = {0, k - 1, kNone};
  triangles.resize(k - 2);
  for (std::uint32_t self = 0; self < k - 2; ++self) {
    const Task task = tasks[--pending];
    std::uint32_t best = task.low + 1;
    if (best + 1 < task.high) {
      beyond.set_triangle(task.low, best, task.high);
      for (std::uint32_t m = best + 1; m < task.high; ++m) {
        if (!beyond.is_beyond(m)) continue;
        best = m;
        if (m + 1 < task.high) beyond.set_triangle(task.low, best, task.high);
      }
    }
    triangles[self] = {task.low, best, task.high, task.parent};
    if (best > task.low + 1) tasks[pending++] = {task.low, best, self};
    if (task.high > best + 1) tasks[pending++] = {best, task.high, self};
  }
}

template <class Beyond>
void RingTriangulator::insert_all(std::uint32_t k, Beyond& beyond, Random& random) {
  // (1) Take points out in random order until three are left; each remembers the neighbours that it
  //     had when it was taken out.
  take_out(k, random);
  // (2) The last three are a triangle.
  start_with_triangle(k);
  // (3) Put the others back in reverse order, each between those neighbours.
  for (std::uint32_t j = 3; j < k; ++j) {
    const std::uint32_t p = order_[j];
    collect_chain(p, previous_[p], beyond);
    fill_fan(p, previous_[p], next_[p]);
  }
}

// The pieces that p is beyond, connected through the rim edge from `before`, are freed; the other
// edges of their union are met in order, starting at `before`.
template <class Beyond>
void RingTriangulator::collect_chain(std::uint32_t p, std::uint32_t before, Beyond& beyond) {
  chain_.clear();
  const std::uint32_t first = rim_[before];
  stack_.assign(1, {first, pieces_[first].edge_from(before)});
  while (!stack_.empty()) {
    const Side side = stack_.back();
    stack_.pop_back();
    const Piece& piece = pieces_[side.piece];
    const auto corner = [&](std::uint32_t k) { return piece.corner[(side.edge + k) % 3]; };
    if (side.edge >= kRim) {  // an edge of a freed piece with nothing behind it
      chain_.push_back({corner(0), corner(1), kNone});
      continue;
    }
    std::array<std::uint32_t, 3> sorted = piece.corner;
    std::sort(sorted.begin(), sorted.end());
    beyond.set_triangle(sorted[0], sorted[1], sorted[2]);
    if (!beyond.is_beyond(p)) {
      chain_.push_back({corner(1), corner(0), side.piece});
      continue;
    }
    free_.push_back(side.piece);
    // Edge 2 leads back to corner 0, which is nearer to `before`: it is popped first. A rim edge
    // has nothing behind it and joins the chain in its turn.
    for (const std::uint32_t k : {1u, 2u}) {
      const std::uint32_t across = piece.across[(side.edge + k) % 3];
      if (across == kNone) {
        stack_.push_back({side.piece, (side.edge + k) % 3 + kRim});
      } else {
        stack_.push_back({across, pieces_[across].edge_from(corner(k + 1))});
      }
    }
  }
}

}  // namespace convexact
