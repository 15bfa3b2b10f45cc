// SPDX-License-Identifier: MIT
#include "simplify/exact_inner.hpp"

#include <set>
#include <utility>

#include "convexact/error.hpp"
#include "measure/vertex_determinants.hpp"
#include "simplify/ring_triangulation.hpp"

namespace convexact {
namespace {

// The change by one removal, and what it loses: six times its volume, in the unit of the integers.
struct Loss {
  std::vector<VertexId> ring;
  std::vector<VertexTriangle> triangles;
  Integer cost;
};

// The greedy loop. It is eager: a removal changes the neighbourhoods of the ring, and costs may
// fall as well as rise, so every vertex of the ring is evaluated again at once.
class ExactInner {
 public:
  ExactInner(const VertexHull& hull, std::uint64_t seed)
      : determinants_(hull.points),
        adjacency_(hull.points.size()),
        random_(seed),
        losses_(hull.points.size()) {
    // The rows of a triangulation take homogeneous points, which vertices with w = 1 are.
    for (std::size_t v = 0; v < hull.points.size(); ++v) {
      points_.push_back({determinants_[v], 1});
    }
    for (const VertexTriangle& t : hull.triangles) adjacency_.add(t);
  }

  const VertexDeterminants& determinants() const { return determinants_; }
  const Loss& loss(VertexId v) const { return losses_[v.index()]; }
  std::vector<VertexTriangle> triangles() const { return adjacency_.triangles(); }

  void evaluate(VertexId v);
  std::vector<VertexId> cheapest() const;
  void remove(VertexId v);

 private:
  void forget(VertexId v) { queue_.erase({losses_[v.index()].cost, v}); }

  VertexDeterminants determinants_;
  std::vector<HomogeneousPoint> points_;
  AdjacencyMatrix adjacency_;
  Random random_;
  std::vector<Loss> losses_;
  std::set<std::pair<Integer, VertexId>> queue_;
};

// The whole region that the hull loses is visible from v: it is the union of the tetrahedra between
// v and the triangles that close its ring, so no term is negative.
void ExactInner::evaluate(VertexId v) {
  Loss& loss = losses_[v.index()];
  loss.ring = adjacency_.one_ring(v);
  loss.triangles = triangulate_ring(points_, loss.ring, random_).triangles;
  loss.cost = 0;
  for (const VertexTriangle& t : loss.triangles) {
    loss.cost += determinants_.height(t[0].index(), t[1].index(), t[2].index(), v.index());
  }
  queue_.insert({loss.cost, v});
}

// All of the least cost, ascending.
std::vector<VertexId> ExactInner::cheapest() const {
  std::vector<VertexId> tie;
  for (const auto& [cost, v] : queue_) {
    if (cost != queue_.begin()->first) break;
    tie.push_back(v);
  }
  return tie;
}

// Never removes a vertex whose removal leaves a flat rest: that would lose all of the volume, and
// among five or more vertices of a solid there is one that loses less, as four that span a volume
// can stay.
void ExactInner::remove(VertexId v) {
  const Loss loss = losses_[v.index()];
  for (std::size_t m = 0; m < loss.ring.size(); ++m) {
    adjacency_.remove({v, loss.ring[m], loss.ring[(m + 1) % loss.ring.size()]});
  }
  for (const VertexTriangle& t : loss.triangles) adjacency_.add(t);
  forget(v);
  for (const VertexId r : loss.ring) {
    forget(r);
    evaluate(r);
  }
}

}  // namespace

InnerRun simplify_inner_exact(const VertexHull& hull, const InnerOptions& options) {
  if (options.vertices < 4) {
    throw Error(ErrorCode::InvalidArgument, "a solid has at least 4 vertices");
  }
  if (options.max_loss && *options.max_loss < 0) {
    throw Error(ErrorCode::InvalidArgument, "a limit of the loss is not negative");
  }
  ExactInner engine(hull, options.seed);
  const VertexDeterminants& determinants = engine.determinants();
  std::optional<Rational> limit;  // of six times the volume lost
  if (options.max_loss) {
    limit = *options.max_loss * Rational(determinants.six_volumes(hull.triangles));
  }
  Integer lost = 0;
  InnerRun run;
  const std::size_t at_start = hull.points.size();
  std::size_t left = at_start;
  for (std::size_t v = 0; v < at_start && left > options.vertices; ++v) {
    options.watch.ask();
    engine.evaluate(VertexId(v));
  }
  while (left > options.vertices) {
    options.watch.ask();
    std::vector<VertexId> tie = engine.cheapest();
    const VertexId v = tie.front();
    const Loss& loss = engine.loss(v);
    lost += loss.cost;
    if (limit && Rational(lost) > *limit) {
      run.stop = InnerStop::LossLimit;
      break;
    }
    run.steps.push_back({.removed = v,
                         .cost = determinants.volume(loss.cost),
                         .tie = std::move(tie),
                         .ring = loss.ring,
                         .triangles = loss.triangles,
                         .left = --left});
    engine.remove(v);
    options.watch.report(at_start - left, at_start - options.vertices);
  }
  run.triangles = engine.triangles();
  return run;
}

}  // namespace convexact
