// SPDX-License-Identifier: MIT
// The filtered and the float engine: a queue of lower bounds. Concavity never falls when a cluster
// grows, so an old value bounds a new one, and a pair beyond the limit stays beyond it.
#include <algorithm>
#include <cmath>
#include <memory>

#include "decompose/candidate_queue.hpp"
#include "decompose/cluster_engines.hpp"
#include "decompose/merge_cost.hpp"
#include "decompose/near_concavity.hpp"
#include "decompose/near_shapes.hpp"
#include "number/ordering.hpp"
#include "number/precision.hpp"
#include "number/roundoff.hpp"

namespace convexact {
namespace {

struct Neighbour {
  std::uint32_t cluster;
  std::uint32_t candidate;  // the pair of both

  static bool is_before(const Neighbour& a, const Neighbour& b) { return a.cluster < b.cluster; }
};

struct Cluster {
  std::vector<TriangleId> triangles;  // none if it was merged into another one
  NearCluster near;
  NearShape shape;
  std::vector<Neighbour> neighbours;  // ascending by cluster
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
    candidates_.reserve(start.pairs.size());
    for (const ClusterPair& pair : start.pairs) {
      const auto candidate = static_cast<std::uint32_t>(candidates_.size());
      candidates_.push_back({.pair = pair});
      clusters_[pair.first].neighbours.push_back({pair.second, candidate});
      clusters_[pair.second].neighbours.push_back({pair.first, candidate});
      enter(candidate);
    }
    for (Cluster& cluster : clusters_) {
      std::sort(cluster.neighbours.begin(), cluster.neighbours.end(), Neighbour::is_before);
    }
  }

  Clustering run() {
    while (merge_cheapest()) {
    }
    if (options_.max_parts && count_ > *options_.max_parts) {
      queue_by_concavity();
      while (count_ > *options_.max_parts && merge_cheapest()) {
        made_.stopped_by_count = true;
      }
    }
    for (const Cluster& cluster : clusters_) {
      if (cluster.triangles.empty()) continue;
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
  void make_clusters() {
    std::vector<bool> has_neighbours(surface_.triangles.size(), false);
    for (const auto& [a, b] : start_.pairs) has_neighbours[a] = has_neighbours[b] = true;
    clusters_.resize(surface_.triangles.size());
    for (auto& triangles : clusters_of(start_.lowest)) {
      const std::uint32_t name = triangles.front().value;
      Cluster& cluster = clusters_[name];
      cluster.shape = shapes_.shape(triangles);
      if (has_neighbours[name]) cluster.near = near_.cluster(triangles);
      cluster.triangles = std::move(triangles);
      ++count_;
    }
  }

  // Sets the key for the queue, and enters the candidate.
  void enter(std::uint32_t entered) {
    CandidatePair& candidate = candidates_[entered];
    candidate.key = candidate.concavity;
    if (!by_concavity_) {
      const auto& [a, b] = candidate.pair;
      const LengthBounds shape = shapes_.term(clusters_[a].shape, clusters_[b].shape);
      const double round = is_float_ ? 0 : 2 * kUnitRoundoff;
      candidate.key.low = (candidate.concavity.low + shape.low) * (1 - round);
      candidate.key.high = (candidate.concavity.high + shape.high) * (1 + round);
      if (std::isnan(candidate.key.low)) candidate.key.low = 0;
    }
    queue_.insert(entered);
  }

  // Before the candidate changes: it must be entered again, or dropped.
  void leave(std::uint32_t left) {
    queue_.remove(left);
    std::uint32_t& equals = candidates_[left].equals;
    if (equals != kNoClass) --classes_[equals].members;
    equals = kNoClass;
  }

  // Bounds the concavity of the union of clusters as they are, and decides whether it is allowed.
  void evaluate(std::uint32_t stale) {
    ++made_.evaluations;
    report_progress();
    CandidatePair& candidate = candidates_[stale];
    const Cluster& a = clusters_[candidate.pair.first];
    const Cluster& b = clusters_[candidate.pair.second];
    NearCluster both = near_.unite(a.near, b.near, by_concavity_ ? kNoBound : limit_.high);
    both.concavity.low = std::max(both.concavity.low, candidate.concavity.low);
    candidate.concavity = both.concavity;
    candidate.united = std::make_unique<NearCluster>(std::move(both));
    candidate.state = CandidateState::Fresh;
    if (!by_concavity_ && exceeds_limit(candidate)) {
      candidate.state = CandidateState::Beyond;
      candidate.united.reset();
    }
    enter(stale);
  }

  bool exceeds_limit(CandidatePair& candidate) {
    if (is_float_) return candidate.concavity.high > limit_.high;
    if (candidate.concavity.low > limit_.high) return true;
    if (candidate.concavity.high <= limit_.low) return false;
    return exact_cost(candidate).squared_concavity > start_.squared_limit;
  }

  // There are about 1.4 evaluations and one merge for each triangle.
  void report_progress() const {
    const std::size_t expected = start_.lowest.size() * 12 / 5 + 1;
    options_.watch.at(std::min(made_.merges.size() + made_.evaluations, expected), expected);
  }

  std::vector<TriangleId> triangles_of(const ClusterPair& pair) const {
    std::vector<TriangleId> triangles = clusters_[pair.first].triangles;
    const auto& more = clusters_[pair.second].triangles;
    triangles.insert(triangles.end(), more.begin(), more.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }

  // The cost in exact numbers. The bounds become as narrow as doubles allow.
  const MergeCost& exact_cost(CandidatePair& candidate) {
    if (candidate.exact) return candidate.exact->cost;
    ++made_.exact_evaluations;
    const auto& [a, b] = candidate.pair;
    const std::vector<TriangleId> triangles = triangles_of(candidate.pair);
    candidate.exact = std::make_unique<ExactCost>();
    MergeCost& cost = candidate.exact->cost;
    cost.squared_concavity = near_.squared(*candidate.united, triangles, options_.watch);
    shapes_.set_exact(cost, clusters_[a].shape, clusters_[b].shape, triangles);
    candidate.concavity = candidate.united->concavity;
    return cost;
  }

  // Computes a fresh candidate in exact numbers, and enters it again with the narrowest key. Those
  // of a class are equal, so they share bounds and key.
  void narrow(std::uint32_t narrowed, std::uint32_t equals) {
    leave(narrowed);
    CandidatePair& candidate = candidates_[narrowed];
    const MergeCost& cost = exact_cost(candidate);
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
    queue_.insert(narrowed);
  }

  // Most ties are of congruent triangles, and need no bounds.
  bool is_plain_tie(std::uint32_t a, std::uint32_t b) {
    return !by_concavity_ &&
           CostOrder::have_same_terms(exact_cost(candidates_[a]), exact_cost(candidates_[b]));
  }

  Ordering compare(const CandidatePair& a, const CandidatePair& b) const {
    if (const auto order = order_to_zero(*a.exact->bounds - *b.exact->bounds)) return {*order};
    if (!by_concavity_) return order_.compare(a.exact->cost, b.exact->cost, options_.watch);
    const Rational &x = a.exact->cost.squared_concavity, &y = b.exact->cost.squared_concavity;
    if (x != y) return {x < y ? Order::Less : Order::Greater};
    return {Order::Equal, TieProof::EqualRationals};
  }

  // The first of the cheapest candidates. All that are as cheap are fresh and of one class.
  std::optional<std::uint32_t> cheapest() {
    while (const auto first = queue_.first(queue_.first_fresh())) {
      if (candidates_[*first].state == CandidateState::Stale) {
        evaluate(*first);
        continue;
      }
      if (is_float_) return first;
      if (const auto best = cheapest_of_rivals(*first)) return best;
    }
    return std::nullopt;
  }

  // The same among those whose keys begin before the first one's key ends; or nothing, after a
  // candidate that may be as cheap was evaluated, narrowed, or joined to a class.
  std::optional<std::uint32_t> cheapest_of_rivals(std::uint32_t first) {
    std::uint32_t best_id = first;
    auto it = std::next(queue_.first_fresh());
    while (const auto rival_id = queue_.first(it)) {
      const CandidatePair &best = candidates_[best_id], &rival = candidates_[*rival_id];
      if (rival.key.low > best.key.high) break;
      if (rival.state == CandidateState::Stale) {
        evaluate(*rival_id);
        return std::nullopt;
      }
      if (best.equals != kNoClass && rival.equals == best.equals) {  // and so are all of its class
        it = queue_.after_class(it);
        continue;
      }
      if (!best.has_fine_bounds() || !rival.has_fine_bounds()) {
        if (is_plain_tie(best_id, *rival_id)) {
          join_class(best_id, *rival_id, {Order::Equal, TieProof::SquareClasses});
          return std::nullopt;
        }
        for (const std::uint32_t each : {best_id, *rival_id}) {
          if (!candidates_[each].has_fine_bounds()) narrow(each, kNoClass);
        }
        return std::nullopt;
      }
      const Ordering ordering = compare(best, rival);
      if (ordering.order == Order::Equal || ordering.order == Order::Undecided) {
        join_class(best_id, *rival_id, ordering);
        return std::nullopt;
      }
      if (ordering.order == Order::Greater) best_id = *rival_id;
      ++it;
    }
    return best_id;
  }

  void join_class(std::uint32_t a, std::uint32_t b, const Ordering& ordering) {
    std::uint32_t equals = candidates_[a].equals;
    if (equals == kNoClass) equals = candidates_[b].equals;
    if (equals == kNoClass) {
      equals = static_cast<std::uint32_t>(classes_.size());
      classes_.emplace_back();
    }
    for (const std::uint32_t each : {a, b}) {
      if (candidates_[each].equals != equals) narrow(each, equals);
    }
    classes_[equals].evidence.add({ordering.tie_proof, ordering.bits});
  }

  bool merge_cheapest() {
    const auto cheapest_id = cheapest();
    if (!cheapest_id) return false;
    CandidatePair& winner = candidates_[*cheapest_id];
    if (!by_concavity_ && options_.guard && !options_.guard(triangles_of(winner.pair))) {
      refuse(*cheapest_id);
      return true;  // the next call finds another one
    }
    Merge merge{.kept = TriangleId(winner.pair.first),
                .gone = TriangleId(winner.pair.second),
                .beyond_limit = by_concavity_};
    if (winner.equals != kNoClass && classes_[winner.equals].members > 1) {
      merge.ties = classes_[winner.equals].members - 1;
      merge.tie_evidence = classes_[winner.equals].evidence;
    }
    if (options_.costs) {
      const MergeCost& cost = exact_cost(winner);
      merge.squared_concavity = cost.squared_concavity;
      merge.cost = order_.enclose(cost, kMeasureBits, options_.watch);
    }
    collapse(*cheapest_id);
    made_.merges.push_back(std::move(merge));
    report_progress();
    return true;
  }

  // A union that holds this one will be refused, too, like one that is too concave.
  void refuse(std::uint32_t refused) {
    ++made_.refused;
    leave(refused);
    candidates_[refused].state = CandidateState::Beyond;
    candidates_[refused].united.reset();
  }

  void collapse(std::uint32_t merged) {
    const std::uint32_t kept = candidates_[merged].pair.first;
    const std::uint32_t gone = candidates_[merged].pair.second;
    Cluster& a = clusters_[kept];
    const Cluster b = std::exchange(clusters_[gone], {});
    a.triangles.insert(a.triangles.end(), b.triangles.begin(), b.triangles.end());
    a.shape = shapes_.unite(a.shape, b.shape);
    a.near = std::move(*candidates_[merged].united);
    leave(merged);
    candidates_[merged] = {.state = CandidateState::Gone};
    --count_;
    std::vector<Neighbour> beside;  // twice those that are beside both
    std::merge(a.neighbours.begin(), a.neighbours.end(), b.neighbours.begin(), b.neighbours.end(),
               std::back_inserter(beside), Neighbour::is_before);
    a.neighbours.clear();
    for (const auto& [other, beside_it] : beside) {
      if (other == kept || other == gone) continue;
      leave(beside_it);
      CandidatePair& before = candidates_[beside_it];
      // The bounds of a union are lower bounds for a larger one.
      CandidatePair after{.pair = std::minmax(kept, other)};
      after.concavity.low = std::max(before.concavity.low, a.near.concavity.low);
      if (before.state == CandidateState::Beyond) after.state = CandidateState::Beyond;
      if (!a.neighbours.empty() && a.neighbours.back().cluster == other) {
        CandidatePair& twin = candidates_[a.neighbours.back().candidate];
        twin.concavity.low = std::max(twin.concavity.low, after.concavity.low);
        if (after.state == CandidateState::Beyond) twin.state = CandidateState::Beyond;
        before = {.state = CandidateState::Gone};
        continue;
      }
      before = std::move(after);
      a.neighbours.push_back({other, beside_it});
    }
    for (const Neighbour& beside_a : a.neighbours) {
      std::vector<Neighbour>& theirs = clusters_[beside_a.cluster].neighbours;
      std::erase_if(theirs, [&](const Neighbour& each) {
        return each.cluster == kept || each.cluster == gone;
      });
      const Neighbour own{kept, beside_a.candidate};
      theirs.insert(std::upper_bound(theirs.begin(), theirs.end(), own, Neighbour::is_before), own);
      enter(beside_a.candidate);
    }
  }

  // No merge within the limit is left: all candidates are beyond it.
  void queue_by_concavity() {
    by_concavity_ = true;
    for (std::uint32_t k = 0; k < candidates_.size(); ++k) {
      CandidatePair& candidate = candidates_[k];
      if (candidate.state == CandidateState::Gone) continue;
      candidate = {.pair = candidate.pair, .concavity = {.low = candidate.concavity.low}};
      enter(k);
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
  std::vector<Cluster> clusters_;  // by their lowest triangles
  std::size_t count_ = 0;          // of clusters
  std::vector<CandidatePair> candidates_;
  CandidateQueue queue_{candidates_};
  std::vector<Class> classes_{1};
  Clustering made_;
};

}  // namespace

Clustering cluster_filtered(const Surface& surface, const ClusterOptions& options,
                            const ClusterStart& start) {
  return FilteredEngine(surface, options, start).run();
}

}  // namespace convexact
