// SPDX-License-Identifier: MIT
#include "lab/compare/collapse.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace convexact {

Point area_vector(const Point& a, const Point& b, const Point& c) { return (b - a).cross(c - a); }

CollapsingMesh::CollapsingMesh(std::vector<Point> vertices, std::span<const MeshTriangle> triangles,
                               CollapseRule& rule)
    : vertices_(std::move(vertices)),
      triangles_(triangles.begin(), triangles.end()),
      around_(vertices_.size()),
      rule_(rule),
      left_(vertices_.size()) {
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (const MeshCorner v : triangles_[t]) around_[v].push_back(t);
  }
  plan_all();
}

void CollapsingMesh::plan_all() {
  std::set<Edge> edges;
  for (const MeshTriangle& t : triangles()) {
    for (const std::size_t k : {0u, 1u, 2u}) edges.insert(std::minmax({t[k], t[(k + 1) % 3]}));
  }
  for (const Edge& edge : edges) plan(edge);
}

std::set<MeshCorner> CollapsingMesh::neighbours(MeshCorner v) const {
  std::set<MeshCorner> found;
  for (const std::uint32_t t : around_[v]) found.insert(triangles_[t].begin(), triangles_[t].end());
  found.erase(v);
  return found;
}

bool CollapsingMesh::has_simple_link(MeshCorner a, MeshCorner b) const {
  const std::set<MeshCorner> of_a = neighbours(a), of_b = neighbours(b);
  const auto common =
      std::count_if(of_a.begin(), of_a.end(), [&](MeshCorner v) { return of_b.contains(v); });
  return common == 2;
}

bool CollapsingMesh::turns_over(MeshCorner a, MeshCorner b, const Point& to) const {
  const auto has = [](const MeshTriangle& t, MeshCorner v) {
    return t[0] == v || t[1] == v || t[2] == v;
  };
  for (const MeshTriangle& t : triangles_at(a, b)) {
    if (has(t, a) && has(t, b)) continue;  // it is removed
    const auto moved = [&](MeshCorner v) { return v == a || v == b ? to : at(v); };
    const Point before = area_vector(at(t[0]), at(t[1]), at(t[2]));
    if (!(before.dot(area_vector(moved(t[0]), moved(t[1]), moved(t[2]))) > 0)) return true;
  }
  return false;
}

// Puts the edge into the queue, if it can be collapsed.
void CollapsingMesh::plan(Edge edge) {
  const auto [a, b] = edge;
  if (!has_simple_link(a, b)) return;
  for (const Contraction& contraction : rule_.contractions(*this, a, b)) {
    if (!std::isfinite(contraction.cost)) continue;
    if (!may_turn_over_ && turns_over(a, b, contraction.at)) continue;
    planned_.insert_or_assign(edge, contraction);
    queue_.insert({contraction.cost, edge});
    return;
  }
}

void CollapsingMesh::forget(Edge edge) {
  const auto found = planned_.find(edge);
  if (found == planned_.end()) return;
  queue_.erase({found->second.cost, edge});
  planned_.erase(found);
}

void CollapsingMesh::reduce_to(std::size_t vertices, const Watch& watch) {
  while (left_ > std::max<std::size_t>(vertices, 4)) {
    watch.ask();
    if (queue_.empty()) {
      if (may_turn_over_) return;
      may_turn_over_ = true;
      plan_all();
      continue;
    }
    const Edge edge = queue_.begin()->edge;
    const Point to = planned_.at(edge).at;  // the plan is removed
    collapse(edge, to);
  }
}

// b becomes a. The cost of an edge depends on the triangles at its ends, so every edge with an end
// next to the new vertex is planned again.
void CollapsingMesh::collapse(Edge edge, const Point& to) {
  const auto [a, b] = edge;
  const auto forget_edges_of = [&](MeshCorner v) {
    for (const MeshCorner w : neighbours(v)) forget(std::minmax({v, w}));
  };
  std::set<MeshCorner> near = neighbours(a);
  near.merge(neighbours(b));
  for (const MeshCorner v : near) forget_edges_of(v);
  for (const std::uint32_t t : std::vector<std::uint32_t>(around_[b])) {
    MeshTriangle& triangle = triangles_[t];
    if (std::find(triangle.begin(), triangle.end(), a) == triangle.end()) {
      std::replace(triangle.begin(), triangle.end(), b, a);
      around_[a].push_back(t);
      continue;
    }
    for (const MeshCorner v : triangle) std::erase(around_[v], t);
    triangle = {0, 0, 0};
  }
  around_[b].clear();
  vertices_[a] = to;
  --left_;
  rule_.merged(a, b);
  near.erase(b);
  std::set<Edge> again;
  for (const MeshCorner v : near) {
    for (const MeshCorner w : neighbours(v)) again.insert(std::minmax({v, w}));
  }
  for (const Edge& other : again) plan(other);
}

std::vector<MeshTriangle> CollapsingMesh::triangles() const {
  std::vector<MeshTriangle> left;
  std::copy_if(triangles_.begin(), triangles_.end(), std::back_inserter(left),
               [&](const MeshTriangle& t) { return !is_gone(t); });
  return left;
}

std::vector<MeshTriangle> CollapsingMesh::triangles_at(MeshCorner a, MeshCorner b) const {
  std::set<std::uint32_t> numbers(around_[a].begin(), around_[a].end());
  numbers.insert(around_[b].begin(), around_[b].end());
  std::vector<MeshTriangle> found;
  for (const std::uint32_t t : numbers) found.push_back(triangles_[t]);
  return found;
}

std::vector<MeshCorner> CollapsingMesh::corners() const {
  std::vector<MeshCorner> left;
  for (MeshCorner v = 0; v < around_.size(); ++v) {
    if (!around_[v].empty()) left.push_back(v);
  }
  return left;
}

}  // namespace convexact
