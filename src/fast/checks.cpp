// SPDX-License-Identifier: MIT
#include "fast/checks.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "convexact/error.hpp"
#include "fast/signs.hpp"

namespace convexact {

namespace {

void require(bool holds, const char* claim) {
  if (!holds) {
    throw Error(ErrorCode::Internal, std::string("verification of a step failed: ") + claim);
  }
}

}  // namespace

void StepCheck::check(const ClaimedStep& step) {
  for (std::uint32_t m = 0; m < step.ring.size(); ++m) position_[step.ring[m].index()] = m;
  check_disk(step);
  measure(step);
  check_triangles(step);
  check_rim(step);
  for (const HalfspaceId r : step.ring) position_[r.index()] = kNotInRing;
}

// The triangles divide the polygon 0, 1, ..., k - 1 of the ring's places. Each of its k - 2 inner
// places is the middle corner of one. One has the edge (0, k - 1); every other one hangs with its
// edge (low, high) on the side (low, middle) or (middle, high) of another, and alone on that side.
// So they form a tree, and on 2 (k - 2) - (k - 3) = k - 1 sides nothing hangs. These divide
// 0 .. k - 1 into k - 1 parts, which are therefore the edges of the ring.
// Degenerate: a halfspace that the ring visits twice has the second of its places; then the first
// is the middle corner of none, or no triangle has the edge (0, k - 1).
void StepCheck::check_disk(const ClaimedStep& step) {
  const auto k = static_cast<std::uint32_t>(step.ring.size());
  require(step.triangles.size() + 2 == k, "a ring of k is closed by k - 2 triangles");
  pieces_.assign(k, {});
  for (const DualTriangle& t : step.triangles) {
    std::array<std::uint32_t, 3> place;
    for (std::size_t c = 0; c < 3; ++c) place[c] = position_[t[c].index()];
    require(std::find(place.begin(), place.end(), kNotInRing) == place.end(),
            "new triangles have their corners on the ring");
    std::rotate(place.begin(), std::min_element(place.begin(), place.end()), place.end());
    const auto [low, middle, high] = place;
    require(low < middle && middle < high && pieces_[middle].high == 0, "every edge has two sides");
    pieces_[middle].low = low;
    pieces_[middle].high = high;
  }
  root_ = kNotInRing;
  for (std::uint32_t middle = 1; middle + 1 < k; ++middle) {
    Piece& piece = pieces_[middle];
    Piece &below_high = pieces_[piece.high], &below_low = pieces_[piece.low];
    std::uint32_t* side = nullptr;  // what hangs on it
    if (piece.low == 0 && piece.high == k - 1) {
      side = &root_;
    } else if (below_high.low == piece.low) {
      side = &below_high.at_left;
      piece.across = below_high.high;
    } else if (below_low.high == piece.high) {
      side = &below_low.at_right;
      piece.across = below_low.low;
    }
    require(side != nullptr && *side == kNotInRing, "every edge has two sides");
    *side = middle;
  }
  require(root_ != kNotInRing, "the ring bounds the new triangles");
}

// One error bound for all determinants of the step, from the largest differences to its center.
void StepCheck::measure(const ClaimedStep& step) {
  Extent extent;
  for (const HalfspaceId r : step.ring) extent.include(dual_.near(r) - dual_.near(step.removed));
  for (const HalfspaceId r : step.across) extent.include(dual_.near(r) - dual_.near(step.removed));
  filter_ = PlaneFilter::within(extent.doubled(), Roundoff<double>::kUnit);
}

// `height` is H in doubles; where it is within its error, exact numbers decide.
bool StepCheck::is_beyond(const DualTriangle& t, HalfspaceId p, double height) const {
  const FilterSign sure = filter_sign(height, filter_.height);
  if (sure != FilterSign::Unknown) return sure == FilterSign::Positive;
  return signs_.height_beyond_doubles(t[0], t[1], t[2], p) == Sign::Positive;
}

// Each new triangle is a vertex of the cap: it exists, and it lies on or beyond the removed plane.
// Every inner edge is convex.
void StepCheck::check_triangles(const ClaimedStep& step) const {
  for (std::size_t middle = 1; middle + 1 < step.ring.size(); ++middle) {
    const Piece& piece = pieces_[middle];
    const DualTriangle t{step.ring[piece.low], step.ring[middle], step.ring[piece.high]};
    const Triple<double>& a = dual_.near(t[0]);
    const Triple<double> normal = cross(dual_.near(t[1]) - a, dual_.near(t[2]) - a);
    require(filter_sign(dot(normal, a), filter_.determinant) == FilterSign::Positive ||
                signs_.determinant_beyond_doubles(t[0], t[1], t[2]) == Sign::Positive,
            "every new triangle has a vertex");
    // On or beyond the removed plane: seen from the other side, not strictly inside it.
    const double height = dot(normal, dual_.near(step.removed) - a);
    require(
        height > filter_.height || signs_.height(t[0], t[1], t[2], step.removed) != Sign::Negative,
        "new vertices lie on or beyond the removed plane");
    if (middle == root_) continue;
    const HalfspaceId across = step.ring[piece.across];
    require(!is_beyond(t, across, dot(normal, dual_.near(across) - a)),
            "every inner edge is convex");
  }
}

// The third corner of the new triangle at the edge of the ring from place m on.
HalfspaceId StepCheck::owner_of_edge(const ClaimedStep& step, std::size_t m) const {
  if (m + 1 == step.ring.size()) return step.ring[root_];
  const bool is_right_side = pieces_[m].high == m + 1;
  return step.ring[is_right_side ? pieces_[m].low : pieces_[m + 1].high];
}

// Convex across the edges of the ring, between new triangles and the old ones outside.
void StepCheck::check_rim(const ClaimedStep& step) const {
  const std::size_t k = step.ring.size();
  require(step.across.size() == k, "every edge of the ring has an outside");
  for (std::size_t m = 0; m < k; ++m) {
    const HalfspaceId a = step.ring[m], b = step.ring[m + 1 == k ? 0 : m + 1],
                      owner = owner_of_edge(step, m), across = step.across[m];
    require(across != owner, "no edge is there twice");
    const Triple<double>& origin = dual_.near(a);
    const Triple<double> normal = cross(dual_.near(b) - origin, dual_.near(owner) - origin);
    require(!is_beyond({a, b, owner}, across, dot(normal, dual_.near(across) - origin)),
            "every edge of the ring is convex");
  }
}

namespace {

// A directed edge and the third corner of its triangle.
struct Edge {
  HalfspaceId from, to, apex;

  friend bool operator<(const Edge& a, const Edge& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  }
};

std::vector<Edge> edges_of(std::span<const DualTriangle> triangles) {
  std::vector<Edge> edges;
  for (const DualTriangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3]});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Each directed edge once and its opposite too; convex or flat there.
bool is_closed_and_convex(const DualSigns& signs, const std::vector<Edge>& edges) {
  const auto same = [](const Edge& a, const Edge& b) { return a.from == b.from && a.to == b.to; };
  if (std::adjacent_find(edges.begin(), edges.end(), same) != edges.end()) return false;
  for (const Edge& e : edges) {
    const auto opposite = std::lower_bound(edges.begin(), edges.end(), Edge{e.to, e.from, {}});
    const bool is_there =
        opposite != edges.end() && opposite->from == e.to && opposite->to == e.from;
    if (!is_there) return false;
    if (e.from < e.to && signs.height(e.from, e.to, e.apex, opposite->apex) == Sign::Positive) {
      return false;
    }
  }
  return true;
}

// A ray through the first triangle meets no other: the surface surrounds the center once.
bool is_met_once(const FastDual& dual, std::span<const DualTriangle> triangles) {
  const auto normal = [&](HalfspaceId i) -> const IntegerVector3& {
    return dual.exact(i).normal();
  };
  const auto& [a, b, c] = triangles[0];
  const IntegerVector3 ray = normal(a) + normal(b) + normal(c);
  return std::all_of(triangles.begin() + 1, triangles.end(), [&](const DualTriangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const IntegerVector3 side = normal(t[k]).cross(normal(t[(k + 1) % 3]));
      if (ray.dot(side) < 0) return true;
    }
    return false;
  });
}

}  // namespace

bool is_dual_hull(const FastDual& dual, std::span<const DualTriangle> triangles) {
  const DualSigns signs(dual);
  return triangles.size() >= 4 &&
         std::all_of(triangles.begin(), triangles.end(),
                     [&](const DualTriangle& t) {
                       return signs.determinant(t[0], t[1], t[2]) == Sign::Positive;
                     }) &&
         is_closed_and_convex(signs, edges_of(triangles)) && is_met_once(dual, triangles);
}

}  // namespace convexact
