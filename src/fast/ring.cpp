// SPDX-License-Identifier: MIT
#include "fast/ring.hpp"

#include <span>

namespace convexact {

void RingTriangulator::take_out(std::uint32_t k, Random& random) {
  order_.resize(k);
  next_.resize(k);
  previous_.resize(k);
  for (std::uint32_t v = 0; v < k; ++v) {
    order_[v] = v;
    next_[v] = v + 1 == k ? 0 : v + 1;
    previous_[v] = v == 0 ? k - 1 : v - 1;
  }
  shuffle(std::span<std::uint32_t>(order_), random);
  for (std::uint32_t j = k - 1; j >= 3; --j) {
    const std::uint32_t v = order_[j];
    next_[previous_[v]] = next_[v];
    previous_[next_[v]] = previous_[v];
  }
}

void RingTriangulator::start_with_triangle(std::uint32_t k) {
  const std::uint32_t a = order_[0], b = next_[a], c = next_[b];
  pieces_.assign(1, {{a, b, c}, {kNone, kNone, kNone}});
  free_.clear();
  rim_.assign(k, 0);
}

std::uint32_t RingTriangulator::new_piece() {
  if (free_.empty()) {
    pieces_.push_back({});
    return static_cast<std::uint32_t>(pieces_.size() - 1);
  }
  const std::uint32_t piece = free_.back();
  free_.pop_back();
  return piece;
}

// One triangle (tail, head, p) for each link; neighbours in the chain share an edge at p.
void RingTriangulator::fill_fan(std::uint32_t p, std::uint32_t before, std::uint32_t after) {
  std::uint32_t last = kNone;
  for (const Link& link : chain_) {
    const std::uint32_t self = new_piece();
    pieces_[self] = {{link.tail, link.head, p}, {link.across, last, kNone}};
    if (last != kNone) pieces_[last].across[2] = self;
    if (link.across == kNone) {
      rim_[link.tail] = self;
    } else {
      Piece& behind = pieces_[link.across];
      behind.across[behind.edge_from(link.head)] = self;
    }
    if (link.head == before) rim_[before] = self;
    if (link.tail == after) rim_[p] = self;
    last = self;
  }
}

void RingTriangulator::as_tree(std::uint32_t k, std::vector<RingTriangle>& triangles) {
  stack_.assign(1, {rim_[k - 1], pieces_[rim_[k - 1]].edge_from(k - 1)});
  tasks_.assign(1, {0, k - 1, kNone});
  while (!stack_.empty()) {
    const Side side = stack_.back();
    const Task task = tasks_.back();
    stack_.pop_back();
    tasks_.pop_back();
    const Piece& piece = pieces_[side.piece];
    const std::uint32_t middle = piece.corner[(side.edge + 2) % 3];
    const auto self = static_cast<std::uint32_t>(triangles.size());
    triangles.push_back({task.low, middle, task.high, task.parent});
    const auto descend = [&](std::uint32_t low, std::uint32_t high, std::uint32_t edge) {
      const std::uint32_t across = piece.across[edge % 3];
      if (across == kNone) return;
      stack_.push_back({across, pieces_[across].edge_from(high)});
      tasks_.push_back({low, high, self});
    };
    descend(task.low, middle, side.edge + 1);
    descend(middle, task.high, side.edge + 2);
  }
}

}  // namespace convexact
