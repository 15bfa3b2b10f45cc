// SPDX-License-Identifier: MIT
// The filtered and the float engine: a queue of lower bounds. Concavity never falls when a cluster
// grows, so an old value bounds a new one, and a pair beyond the limit stays beyond it.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <tuple>

#include "decompose/cluster_engines.hpp"
#include "decompose/merge_cost.hpp"
#include "decompose/near_concavity.hpp"
#include "decompose/near_shapes.hpp"
#include "number/ordering.hpp"
#include "number/precision.hpp"
#include "number/roundoff.hpp"

namespace convexact {
namespace {

constexpr std::uint32_t kNoClass = 0;

struct Cluster {
  std::vector<TriangleId> triangles;
  NearCluster near;
  NearShape shape;
  std::vector<std::uint32_t> neighbours;  // in any order
};

// What a merge costs in exact numbers, and bounds of kMeasureBits bits once it was compared with
// another.
struct ExactCost {
  MergeCost cost;
  std::optional<Enclosure> bounds;
};

// Two neighbouring clusters, first < second, and the data on their union.
struct CandidatePair {
  LengthBounds concavity;           // of the union; the lower bound holds also while it is stale
  LengthBounds key;                 // the number that the queue compares: the cost, or the
                                    // concavity
  bool is_fresh = false;            // `concavity` is of the clusters as they are
  bool is_beyond = false;           // exceeds the limit
  std::uint32_t equals = kNoClass;  // candidates of one class are proven to have the same key
  std::unique_ptr<NearCluster> united = {};
  std::unique_ptr<ExactCost> exact = {};

  bool has_fine_bounds() const { return exact && exact->bounds; }
};

class FilteredEngine {
 public:
  FilteredEngine(const Surface& surface, const ClusterOptions& options, const ClusterStart& start)
      : surface_(surface),
        options_(options),
        start_(start),
        is_float_(options.engine == Engine::Float),
        order_(start.squared_weight),
        near_(surface, options.measure, is_float_),
        shapes_(surface, near_, start.squared_weight, is_float_),
        limit_(near_.root_bounds(start.squared_limit)) {
    make_clusters();
    for (const ClusterPair& pair : start.pairs) {
      clusters_.at(pair.first).neighbours.push_back(pair.second);
      clusters_.at(pair.second).neighbours.push_back(pair.first);
      enter(pair, CandidatePair{});
    }
  }

  Clustering run() {
    while (merge_cheapest()) {
    }
    if (options_.max_parts && clusters_.size() > *options_.max_parts) {
      queue_by_concavity();
      while (clusters_.size() > *options_.max_parts && merge_cheapest()) {
        made_.stopped_by_count = true;
      }
    }
    for (const auto& [name, cluster] : clusters_) {
      made_.clusters.push_back(cluster.triangles);
      std::sort(made_.clusters.back().begin(), made_.clusters.back().end());
    }
    if (options_.further) {
      const std::size_t merges = made_.merges.size();
      if (!by_concavity_) queue_by_concavity();
      while (merge_cheapest()) {
      }
      made_.further_merges = tail_after(merges, made_.merges);
    }
    return std::move(made_);
  }

 private:
  // In the queue: by lower bound; of equal ones those of a class side by side.
  using Place = std::tuple<double, std::uint32_t, ClusterPair>;
  static Place place(const ClusterPair& pair, const CandidatePair& candidate) {
    return {candidate.key.low, candidate.equals, pair};
  }

  void make_clusters() {
    std::vector<bool> has_neighbours(surface_.triangles.size(), false);
    for (const auto& [a, b] : start_.pairs) has_neighbours[a] = has_neighbours[b] = true;
    for (auto& triangles : clusters_of(start_.lowest)) {
      Cluster cluster;
      cluster.shape = shapes_.shape(triangles);
      const std::uint32_t name = triangles.front().value;
      if (has_neighbours[name]) cluster.near = near_.cluster(triangles);
      cluster.triangles = std::move(triangles);
      clusters_.emplace(name, std::move(cluster));
    }
  }

  // Sets the key for the queue, and enters the candidate.
  void enter(const ClusterPair& pair, CandidatePair candidate) {
    candidate.key = candidate.concavity;
    if (!by_concavity_) {
      const LengthBounds shape =
          shapes_.term(clusters_.at(pair.first).shape, clusters_.at(pair.second).shape);
      const double round = is_float_ ? 0 : 2 * kUnitRoundoff;
      candidate.key.low = (candidate.concavity.low + shape.low) * (1 - round);
      candidate.key.high = (candidate.concavity.high + shape.high) * (1 + round);
      if (std::isnan(candidate.key.low)) candidate.key.low = 0;
    }
    if (!candidate.is_beyond) queue_.insert(place(pair, candidate));
    candidates_.insert_or_assign(pair, std::move(candidate));
  }

  // It must be entered again, or dropped.
  void leave(const ClusterPair& pair) {
    const auto it = candidates_.find(pair);
    queue_.erase(place(pair, it->second));
    if (it->second.equals != kNoClass) --classes_[it->second.equals].members;
    candidates_.erase(it);
  }

  // Bounds the concavity of the union of clusters as they are, and decides whether it is allowed.
  void evaluate(const ClusterPair& pair) {
    ++made_.evaluations;
    report_progress();
    CandidatePair candidate = std::move(candidates_.at(pair));
    leave(pair);
    const Cluster& a = clusters_.at(pair.first);
    const Cluster& b = clusters_.at(pair.second);
    NearCluster both = near_.unite(a.near, b.near, by_concavity_ ? kNoBound : limit_.high);
    both.concavity.low = std::max(both.concavity.low, candidate.concavity.low);
    candidate.concavity = both.concavity;
    candidate.united = std::make_unique<NearCluster>(std::move(both));
    candidate.is_fresh = true;
    if (!by_concavity_) candidate.is_beyond = exceeds_limit(pair, candidate);
    if (candidate.is_beyond) candidate.united.reset();
    enter(pair, std::move(candidate));
  }

  bool exceeds_limit(const ClusterPair& pair, CandidatePair& candidate) {
    if (is_float_) return candidate.concavity.high > limit_.high;
    if (candidate.concavity.low > limit_.high) return true;
    if (candidate.concavity.high <= limit_.low) return false;
    return exact_cost(pair, candidate).squared_concavity > start_.squared_limit;
  }

  // There are about 1.4 evaluations and one merge for each triangle.
  void report_progress() const {
    const std::size_t expected = start_.lowest.size() * 12 / 5 + 1;
    options_.watch.at(std::min(made_.merges.size() + made_.evaluations, expected), expected);
  }

  std::vector<TriangleId> triangles_of(const ClusterPair& pair) const {
    std::vector<TriangleId> triangles = clusters_.at(pair.first).triangles;
    const auto& more = clusters_.at(pair.second).triangles;
    triangles.insert(triangles.end(), more.begin(), more.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }

  // The cost in exact numbers. The bounds become as narrow as doubles allow.
  const MergeCost& exact_cost(const ClusterPair& pair, CandidatePair& candidate) {
    if (candidate.exact) return candidate.exact->cost;
    ++made_.exact_evaluations;
    const std::vector<TriangleId> triangles = triangles_of(pair);
    candidate.exact = std::make_unique<ExactCost>();
    MergeCost& cost = candidate.exact->cost;
    cost.squared_concavity = near_.squared(*candidate.united, triangles, options_.watch);
    shapes_.set_exact(cost, clusters_.at(pair.first).shape, clusters_.at(pair.second).shape,
                      triangles);
    candidate.concavity = candidate.united->concavity;
    return cost;
  }

  // Computes a fresh candidate in exact numbers, and enters it again with the narrowest key. Those
  // of a class are equal, so they share bounds and key.
  void narrow(const ClusterPair& pair, std::uint32_t equals) {
    CandidatePair candidate = std::move(candidates_.at(pair));
    leave(pair);
    const MergeCost& cost = exact_cost(pair, candidate);
    Class own;
    Class& of = equals == kNoClass ? own : classes_[equals];
    if (of.members++ == 0) {
      of.bounds = by_concavity_ ? sqrt(Enclosure(cost.squared_concavity, kMeasureBits))
                                : order_.enclose(cost, kMeasureBits, options_.watch);
      const Enclosure unit(scale_by_power_of_two(Rational(1), -near_.exponent()), kMeasureBits);
      const Enclosure scaled = *of.bounds * unit;
      of.key = {scaled.low_double(), scaled.high_double()};
    }
    candidate.equals = equals;
    candidate.exact->bounds = of.bounds;
    candidate.key = of.key;
    queue_.insert(place(pair, candidate));
    candidates_.insert_or_assign(pair, std::move(candidate));
  }

  // Most ties are of congruent triangles, and need no bounds.
  bool is_plain_tie(const ClusterPair& a, const ClusterPair& b) {
    return !by_concavity_ && CostOrder::have_same_terms(exact_cost(a, candidates_.at(a)),
                                                        exact_cost(b, candidates_.at(b)));
  }

  Ordering compare(const CandidatePair& a, const CandidatePair& b) const {
    if (const auto order = order_to_zero(*a.exact->bounds - *b.exact->bounds)) return {*order};
    if (!by_concavity_) return order_.compare(a.exact->cost, b.exact->cost, options_.watch);
    const Rational &x = a.exact->cost.squared_concavity, &y = b.exact->cost.squared_concavity;
    if (x != y) return {x < y ? Order::Less : Order::Greater};
    return {Order::Equal, TieProof::EqualRationals};
  }

  // The first of the cheapest candidates. All that are as cheap are fresh and of one class.
  std::optional<ClusterPair> cheapest() {
    while (!queue_.empty()) {
      const ClusterPair first = std::get<ClusterPair>(*queue_.begin());
      if (!candidates_.at(first).is_fresh) {
        evaluate(first);
        continue;
      }
      if (is_float_) return first;
      if (const auto best = cheapest_of_rivals(first)) return best;
    }
    return std::nullopt;
  }

  // The same among those whose keys begin before the first one's key ends; or nothing, after a
  // candidate that may be as cheap was evaluated, narrowed, or joined to a class.
  std::optional<ClusterPair> cheapest_of_rivals(const ClusterPair& first) {
    ClusterPair best_pair = first;
    auto it = std::next(queue_.begin());
    while (it != queue_.end()) {
      const ClusterPair rival_pair = std::get<ClusterPair>(*it);
      const CandidatePair &best = candidates_.at(best_pair), &rival = candidates_.at(rival_pair);
      if (rival.key.low > best.key.high) break;
      if (!rival.is_fresh) {
        evaluate(rival_pair);
        return std::nullopt;
      }
      if (best.equals != kNoClass && rival.equals == best.equals) {  // and so are all of its class
        it = queue_.upper_bound({rival.key.low, rival.equals, {UINT32_MAX, UINT32_MAX}});
        continue;
      }
      if (!best.has_fine_bounds() || !rival.has_fine_bounds()) {
        if (is_plain_tie(best_pair, rival_pair)) {
          join_class(best_pair, rival_pair, {Order::Equal, TieProof::SquareClasses});
          return std::nullopt;
        }
        for (const ClusterPair& pair : {best_pair, rival_pair}) {
          if (!candidates_.at(pair).has_fine_bounds()) narrow(pair, kNoClass);
        }
        return std::nullopt;
      }
      const Ordering ordering = compare(best, rival);
      if (ordering.order == Order::Equal || ordering.order == Order::Undecided) {
        join_class(best_pair, rival_pair, ordering);
        return std::nullopt;
      }
      if (ordering.order == Order::Greater) best_pair = rival_pair;
      ++it;
    }
    return best_pair;
  }

  void join_class(const ClusterPair& a, const ClusterPair& b, const Ordering& ordering) {
    std::uint32_t equals = candidates_.at(a).equals;
    if (equals == kNoClass) equals = candidates_.at(b).equals;
    if (equals == kNoClass) {
      equals = static_cast<std::uint32_t>(classes_.size());
      classes_.emplace_back();
    }
    for (const ClusterPair& pair : {a, b}) {
      if (candidates_.at(pair).equals != equals) narrow(pair, equals);
    }
    classes_[equals].evidence.add({ordering.tie_proof, ordering.bits});
  }

  bool merge_cheapest() {
    const auto pair = cheapest();
    if (!pair) return false;
    if (!by_concavity_ && options_.guard && !options_.guard(triangles_of(*pair))) {
      refuse(*pair);
      return true;  // the next call finds another one
    }
    Merge merge{.kept = TriangleId(pair->first),
                .gone = TriangleId(pair->second),
                .beyond_limit = by_concavity_};
    CandidatePair& winner = candidates_.at(*pair);
    if (winner.equals != kNoClass && classes_[winner.equals].members > 1) {
      merge.ties = classes_[winner.equals].members - 1;
      merge.tie_evidence = classes_[winner.equals].evidence;
    }
    if (options_.costs) {
      const MergeCost& cost = exact_cost(*pair, winner);
      merge.squared_concavity = cost.squared_concavity;
      merge.cost = order_.enclose(cost, kMeasureBits, options_.watch);
    }
    collapse(*pair);
    made_.merges.push_back(std::move(merge));
    report_progress();
    return true;
  }

  // A union that holds this one will be refused, too, like one that is too concave.
  void refuse(const ClusterPair& pair) {
    ++made_.refused;
    CandidatePair candidate = std::move(candidates_.at(pair));
    leave(pair);
    candidate.is_beyond = true;
    candidate.equals = kNoClass;
    candidate.united.reset();
    enter(pair, std::move(candidate));
  }

  void collapse(const ClusterPair& pair) {
    const std::uint32_t kept = pair.first, gone = pair.second;
    NearCluster near = std::move(*candidates_.at(pair).united);
    leave(pair);
    Cluster a = std::move(clusters_.at(kept)), b = std::move(clusters_.at(gone));
    clusters_.erase(gone);
    std::erase(a.neighbours, gone);
    std::erase(b.neighbours, kept);
    // The bounds of a union are lower bounds for a larger one.
    std::map<std::uint32_t, CandidatePair> known;
    for (const auto& [name, beside] :
         {std::pair(kept, &a.neighbours), std::pair(gone, &b.neighbours)}) {
      for (const std::uint32_t other : *beside) {
        const ClusterPair old = std::minmax(name, other);
        const CandidatePair& before = candidates_.at(old);
        CandidatePair& after = known[other];
        after.concavity.low =
            std::max({after.concavity.low, before.concavity.low, near.concavity.low});
        after.is_beyond = after.is_beyond || before.is_beyond;
        leave(old);
        std::erase(clusters_.at(other).neighbours, name);
      }
    }
    a.triangles.insert(a.triangles.end(), b.triangles.begin(), b.triangles.end());
    a.shape = shapes_.unite(a.shape, b.shape);
    a.near = std::move(near);
    a.neighbours.clear();
    for (const auto& [other, candidate] : known) {
      a.neighbours.push_back(other);
      clusters_.at(other).neighbours.push_back(kept);
    }
    clusters_.at(kept) = std::move(a);
    for (auto& [other, candidate] : known) enter(std::minmax(kept, other), std::move(candidate));
  }

  // No merge within the limit is left: all candidates are beyond it.
  void queue_by_concavity() {
    by_concavity_ = true;
    auto before = std::exchange(candidates_, {});
    for (const auto& [pair, candidate] : before) {
      CandidatePair stale;
      stale.concavity.low = candidate.concavity.low;
      enter(pair, std::move(stale));
    }
  }

  struct Class {
    std::size_t members = 0;
    std::optional<Enclosure> bounds;
    LengthBounds key;
    TieEvidence evidence;
  };

  const Surface& surface_;
  const ClusterOptions& options_;
  const ClusterStart& start_;
  bool is_float_, by_concavity_ = false;
  CostOrder order_;
  NearConcavity near_;
  NearShapes shapes_;
  LengthBounds limit_;
  std::map<std::uint32_t, Cluster> clusters_;  // by their lowest triangles
  std::map<ClusterPair, CandidatePair> candidates_;
  std::set<Place> queue_;  // candidates that are not certain to exceed the limit
  std::vector<Class> classes_{1};
  Clustering made_;
};

}  // namespace

Clustering cluster_filtered(const Surface& surface, const ClusterOptions& options,
                            const ClusterStart& start) {
  return FilteredEngine(surface, options, start).run();
}

}  // namespace convexact
