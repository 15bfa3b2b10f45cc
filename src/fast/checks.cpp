// SPDX-License-Identifier: MIT
#include "fast/checks.hpp"

#include <algorithm>
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

// k - 2 triangles on the k ring vertices. Their directed edges, and those of the ring turned round,
// are pairs of opposites, each edge there once. Then the triangles form a disk: the component that
// the ring bounds has F triangles, at least k vertices and an Euler characteristic of at most 1, so
// F >= k - 2. Hence F = k - 2, and there is no other component.
// Degenerate: in a ring that visits a halfspace twice, no edge starts at the first of the two
// places, so that place has no new triangle.
void StepCheck::check_disk(const ClaimedStep& step) {
  const std::size_t k = step.ring.size();
  require(step.triangles.size() + 2 == k, "a ring of k is closed by k - 2 triangles");
  edges_.clear();
  // Both directions of an edge share a key but for the lowest bit.
  const auto add_edge = [&](std::uint64_t a, std::uint64_t b) {
    edges_.push_back(a < b ? a << 33 | b << 1 : b << 33 | a << 1 | 1);
  };
  rim_owner_.assign(k, step.removed);
  for (std::uint32_t m = 0; m < k; ++m) add_edge(m + 1 == k ? 0 : m + 1, m);
  for (const DualTriangle& t : step.triangles) {
    for (int c = 0; c < 3; ++c) {
      const std::uint32_t a = position_[t[c].index()], b = position_[t[(c + 1) % 3].index()];
      require(a != kNotInRing, "new triangles have their corners on the ring");
      add_edge(a, b);
      if (b == (a + 1 == k ? 0 : a + 1)) rim_owner_[a] = t[(c + 2) % 3];
    }
  }
  require(std::find(rim_owner_.begin(), rim_owner_.end(), step.removed) == rim_owner_.end(),
          "the ring bounds the new triangles");
  // k + 3 (k - 2) edges: an even number. Sorted, the two directions of an edge are neighbours.
  std::sort(edges_.begin(), edges_.end());
  for (std::size_t e = 0; e < edges_.size(); e += 2) {
    require((edges_[e] ^ edges_[e + 1]) == 1, "every edge has two sides");
  }
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

// Each new triangle is a vertex of the cap: it exists, it lies on or beyond the removed plane, and
// inside all planes of the ring. The last also says that every inner edge is convex.
void StepCheck::check_triangles(const ClaimedStep& step) const {
  for (const DualTriangle& t : step.triangles) {
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
    for (const HalfspaceId r : step.ring) {
      if (r == t[0] || r == t[1] || r == t[2]) continue;
      require(!is_beyond(t, r, dot(normal, dual_.near(r) - a)),
              "new vertices lie inside the ring's planes");
    }
  }
}

// Convex across the edges of the ring, between new triangles and the old ones outside.
void StepCheck::check_rim(const ClaimedStep& step) const {
  const std::size_t k = step.ring.size();
  require(step.across.size() == k, "every edge of the ring has an outside");
  for (std::size_t m = 0; m < k; ++m) {
    const HalfspaceId a = step.ring[m], b = step.ring[m + 1 == k ? 0 : m + 1];
    require(step.across[m] != rim_owner_[m], "no edge is there twice");
    const Triple<double>& origin = dual_.near(a);
    const Triple<double> normal = cross(dual_.near(b) - origin, dual_.near(rim_owner_[m]) - origin);
    require(!is_beyond({a, b, rim_owner_[m]}, step.across[m],
                       dot(normal, dual_.near(step.across[m]) - origin)),
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
