// SPDX-License-Identifier: MIT
// Directions of the facets that removals leave: the greedy ones, those after a search, random ones.
// And the vertices that greedy removals leave.
#include <algorithm>
#include <numeric>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/search.hpp"
#include "fast/engines.hpp"
#include "fast/filtered_inner.hpp"
#include "lab/compare/method.hpp"
#include "number/random.hpp"
#include "search/exchange_surface.hpp"

namespace convexact {
namespace {

Normals normals_of(const DualHull& dual, std::span<const HalfspaceId> kept) {
  Normals normals;
  for (const HalfspaceId i : kept) {
    normals.push_back(dual.halfspaces[i.index()].normal().cast<Rational>());
  }
  return normals;
}

std::vector<HalfspaceId> greedily_kept(const HullToFit& hull, const FastDual& dual,
                                       std::size_t faces, std::uint64_t seed, CostMeasure cost) {
  SimplifyOptions options;
  options.faces = faces;
  options.cost = cost;
  options.seed = seed;
  options.watch = hull.watch;
  return simplify_filtered(dual, options).survivors;
}

Normals greedy_by(const HullToFit& hull, std::size_t faces, std::uint64_t seed, CostMeasure cost) {
  const DualHull& dual = hull.solid.dual;
  const FastDual fast = FastDual::of(dual, interior_point_of(hull.solid));
  return normals_of(dual, greedily_kept(hull, fast, faces, seed, cost));
}

// Halfspaces in a random order. Removals go through it once: a removal that is not bounded is not
// bounded later either, when fewer halfspaces are left.
class RandomRemovals {
 public:
  RandomRemovals(const HullToFit& hull, std::uint64_t seed)
      : hull_(hull), order_(hull.solid.dual.halfspaces.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    Random random(seed);
    shuffle(std::span(order_), random);
  }

  /// The remaining halfspaces when this many are left, or when no further removal is bounded.
  std::vector<HalfspaceId> left_at(std::size_t count) {
    std::size_t next = 0;
    while (next < order_.size() && kept_.size() + order_.size() - next > count) {
      const std::size_t wanted = std::min(order_.size(), kept_.size() + order_.size() - count);
      next = furthest_bounded(next, wanted);
      if (next == wanted) break;
      kept_.push_back(order_[next++]);
    }
    std::vector<HalfspaceId> left;
    for (const std::size_t i : what_is_left(next)) left.emplace_back(i);
    return left;
  }

 private:
  std::vector<std::size_t> what_is_left(std::size_t next) const {
    std::vector<std::size_t> left = kept_;
    left.insert(left.end(), order_.begin() + static_cast<std::ptrdiff_t>(next), order_.end());
    return left;
  }

  bool is_bounded_from(std::size_t next) const {
    hull_.watch.ask();
    std::vector<Halfspace> halfspaces;
    for (const std::size_t i : what_is_left(next)) {
      halfspaces.push_back(hull_.solid.dual.halfspaces[i]);
    }
    return std::holds_alternative<BoundedProof>(find_recession(halfspaces));
  }

  // The largest number in [next, last] up to which all may be removed. If halfspaces leave a solid
  // unbounded, fewer of them do so, too; so it is found by halving.
  std::size_t furthest_bounded(std::size_t next, std::size_t last) const {
    if (is_bounded_from(last)) return last;
    std::size_t unbounded = last;
    while (unbounded - next > 1) {
      const std::size_t middle = next + (unbounded - next) / 2;
      (is_bounded_from(middle) ? next : unbounded) = middle;
    }
    return next;
  }

  const HullToFit& hull_;
  std::vector<std::size_t> order_;
  std::vector<std::size_t> kept_;  // those that cannot be removed
};

}  // namespace

Normals propose_greedy(const HullToFit& hull, std::size_t faces, std::uint64_t seed) {
  return greedy_by(hull, faces, seed, CostMeasure::Volume);
}

Normals propose_greedy_area(const HullToFit& hull, std::size_t faces, std::uint64_t seed) {
  return greedy_by(hull, faces, seed, CostMeasure::Area);
}

Normals propose_greedy_mean_width(const HullToFit& hull, std::size_t faces, std::uint64_t seed) {
  return greedy_by(hull, faces, seed, CostMeasure::MeanWidth);
}

Normals propose_search(const HullToFit& hull, std::size_t faces, std::uint64_t seed) {
  const DualHull& dual = hull.solid.dual;
  const RationalPoint center = interior_point_of(hull.solid);
  const FastDual fast = FastDual::of(dual, center);
  std::vector<HalfspaceId> kept = greedily_kept(hull, fast, faces, seed, CostMeasure::Volume);
  const SearchOptions options{.request = {SearchKind::Local}, .seed = seed, .watch = hull.watch};
  const SearchRun found = search_exchanges(dual, hull.polytope(), center, kept, options);
  return normals_of(dual, after_moves(std::move(kept), found.moves));
}

Normals propose_random(const HullToFit& hull, std::size_t faces, std::uint64_t seed) {
  return normals_of(hull.solid.dual, RandomRemovals(hull, seed).left_at(faces));
}

HullCorners select_drop(const HullToFit& hull, std::size_t vertices, std::uint64_t seed) {
  const PointSet points(hull.polytope().vertices);
  const HullOutcome outcome = convex_hull(points, {.seed = seed, .watch = hull.watch});
  const auto* found = std::get_if<Hull>(&outcome);
  if (found == nullptr) throw Error(ErrorCode::Internal, "the vertices of a hull have none");
  const VertexHull start = vertex_hull(*found, points);
  const InnerRun run = simplify_inner_filtered(
      start, InnerOptions{.vertices = vertices, .seed = seed, .watch = hull.watch});
  HullCorners left;
  for (const VertexId v : vertices_left(run, start.ids.size())) {
    left.push_back(start.ids[v.index()].value);
  }
  return left;
}

}  // namespace convexact
