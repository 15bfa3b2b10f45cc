// SPDX-License-Identifier: MIT
// The exact engine: every pair of neighbours, at every step, by the definitions.
#include <algorithm>
#include <map>

#include "decompose/cluster_engines.hpp"
#include "decompose/merge_cost.hpp"
#include "number/ordering.hpp"
#include "number/precision.hpp"

namespace convexact {
namespace {

class ExactEngine {
 public:
  ExactEngine(const Surface& surface, const ClusterOptions& options, const ClusterStart& start)
      : surface_(surface),
        options_(options),
        start_(start),
        order_(start.squared_weight),
        concavity_(surface, options.measure) {
    for (auto& triangles : clusters_of(start.lowest)) {
      clusters_.emplace(triangles.front().value, std::move(triangles));
    }
    for (const ClusterPair& pair : start.pairs) pairs_.emplace(pair, evaluate(pair));
  }

  Clustering run() {
    while (merge_cheapest(false)) {
    }
    while (options_.max_parts && clusters_.size() > *options_.max_parts && merge_cheapest(true)) {
      made_.stopped_by_count = true;
    }
    for (const auto& [name, triangles] : clusters_) made_.clusters.push_back(triangles);
    if (options_.further) {
      const std::size_t merges = made_.merges.size();
      while (merge_cheapest(true)) {
      }
      made_.further_merges = tail_after(merges, made_.merges);
    }
    return std::move(made_);
  }

 private:
  struct Candidate {
    MergeCost cost;
    Enclosure bounds;         // of the cost
    bool is_refused = false;  // by the guard
  };

  std::vector<TriangleId> triangles_of(const ClusterPair& pair) const {
    const auto& [a, b] = std::tie(clusters_.at(pair.first), clusters_.at(pair.second));
    std::vector<TriangleId> both;
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
  }

  Candidate evaluate(const ClusterPair& pair) {
    ++made_.evaluations;
    ++made_.exact_evaluations;
    MergeCost cost = merge_cost(surface_, triangles_of(pair), concavity_, options_.watch);
    Enclosure bounds = order_.enclose(cost, kMeasureBits, options_.watch);
    return {std::move(cost), std::move(bounds), false};
  }

  // Within the limit by cost; for a number of parts by concavity alone.
  Ordering compare(const Candidate& a, const Candidate& b, bool beyond_limit) const {
    if (beyond_limit) {
      const auto& x = a.cost.squared_concavity;
      const auto& y = b.cost.squared_concavity;
      if (x != y) return {x < y ? Order::Less : Order::Greater};
      return {Order::Equal, TieProof::EqualRationals};
    }
    if (const auto order = order_to_zero(a.bounds - b.bounds)) {
      return {*order, std::nullopt, kMeasureBits};
    }
    return order_.compare(a.cost, b.cost, options_.watch);
  }

  bool merge_cheapest(bool beyond_limit) {
    std::pair<const ClusterPair, Candidate>* best = nullptr;
    Merge merge;
    merge.beyond_limit = beyond_limit;
    for (auto& pair : pairs_) {
      if (!beyond_limit &&
          (pair.second.cost.squared_concavity > start_.squared_limit || pair.second.is_refused)) {
        continue;
      }
      const Ordering ordering =
          best ? compare(pair.second, best->second, beyond_limit) : Ordering{Order::Less};
      if (ordering.order == Order::Greater) continue;
      if (ordering.order == Order::Less) {
        best = &pair;
        merge.ties = 0;
        merge.tie_evidence = {};
      } else {
        ++merge.ties;
        merge.tie_evidence.add({ordering.tie_proof, ordering.bits});
      }
    }
    if (best == nullptr) return false;
    if (!beyond_limit && options_.guard && !options_.guard(triangles_of(best->first))) {
      best->second.is_refused = true;
      ++made_.refused;
      return true;  // the next call finds another one
    }
    merge.kept = TriangleId(best->first.first);
    merge.gone = TriangleId(best->first.second);
    if (options_.costs) {
      merge.squared_concavity = best->second.cost.squared_concavity;
      merge.cost = best->second.bounds;
    }
    collapse(best->first);
    made_.merges.push_back(std::move(merge));
    options_.watch.at(made_.merges.size(), start_.lowest.size());
    return true;
  }

  void collapse(ClusterPair merged) {
    const std::uint32_t kept = merged.first, gone = merged.second;
    auto& triangles = clusters_.at(kept);
    const auto& more = clusters_.at(gone);
    triangles.insert(triangles.end(), more.begin(), more.end());
    std::sort(triangles.begin(), triangles.end());
    clusters_.erase(gone);
    std::map<std::uint32_t, bool> beside;  // whether one of its pairs was refused
    std::erase_if(pairs_, [&](const auto& pair) {
      const auto [a, b] = pair.first;
      if (a != kept && b != kept && a != gone && b != gone) return false;
      for (const std::uint32_t c : {a, b}) {
        if (c != kept && c != gone) beside[c] = beside[c] || pair.second.is_refused;
      }
      return true;
    });
    for (const auto& [other, is_refused] : beside) {
      const ClusterPair pair = std::minmax(kept, other);
      pairs_.emplace(pair, evaluate(pair)).first->second.is_refused = is_refused;
    }
  }

  const Surface& surface_;
  const ClusterOptions& options_;
  const ClusterStart& start_;
  CostOrder order_;
  ExactConcavity concavity_;
  std::map<std::uint32_t, std::vector<TriangleId>> clusters_;  // by their lowest triangles
  std::map<ClusterPair, Candidate> pairs_;
  Clustering made_;
};

}  // namespace

Clustering cluster_exact(const Surface& surface, const ClusterOptions& options,
                         const ClusterStart& start) {
  return ExactEngine(surface, options, start).run();
}

}  // namespace convexact
