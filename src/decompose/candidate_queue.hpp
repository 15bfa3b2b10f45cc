// SPDX-License-Identifier: MIT
// candidate_queue.hpp - the merges that may come next, in the order of their lower bounds.
#pragma once
#include <compare>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <set>
#include <vector>

#include "convexact/number.hpp"
#include "decompose/cluster_engines.hpp"
#include "decompose/merge_cost.hpp"
#include "decompose/near_concavity.hpp"
#include "decompose/near_rays.hpp"

namespace convexact {

/// Of candidates that are not known to equal another one.
inline constexpr std::uint32_t kNoClass = 0;

/// What a merge costs in exact numbers, and bounds of kMeasureBits bits once it was compared with
/// another.
struct ExactCost {
  MergeCost cost;
  std::optional<Enclosure> bounds;
};

/// What is known of a candidate, and whether the queue holds it.
enum class CandidateState {
  Stale,   ///< Its bounds are of clusters that have grown since.
  Fresh,   ///< Its bounds are of the clusters as they are.
  Beyond,  ///< Exceeds the limit, or was refused: not in the queue.
  Gone,    ///< Another one stands for it since its clusters were merged.
};

/// Two neighbouring clusters, first < second, and the data on their union.
struct CandidatePair {
  ClusterPair pair;
  LengthBounds concavity;  ///< Of the union; the lower bound holds also while it is stale.
  LengthBounds key;        ///< The number that the queue compares: the cost, or the concavity.
  CandidateState state = CandidateState::Stale;
  std::uint32_t equals = kNoClass;  ///< Candidates of one class are proven to have the same key.
  std::unique_ptr<NearCluster> united = {};
  std::unique_ptr<ExactCost> exact = {};

  bool has_fine_bounds() const { return exact && exact->bounds; }
};

/// Where a candidate stands in the queue: by lower bound; of equal ones those of a class side by
/// side.
struct CandidatePlace {
  double low;
  std::uint32_t equals;
  ClusterPair pair;
  std::uint32_t candidate;

  auto operator<=>(const CandidatePlace&) const = default;
};

/// The candidates in order. Most are stale, and change or go before they come first, so these wait
/// in a heap, where outdated places stay until they come up. Fresh ones are few; they are in a set,
/// since the first of them are compared one after another.
class CandidateQueue {
 public:
  using FreshPlace = std::set<CandidatePlace>::const_iterator;

  /// Keeps a reference.
  explicit CandidateQueue(const std::vector<CandidatePair>& candidates) : candidates_(candidates) {}

  /// Before the candidate changes.
  void remove(std::uint32_t candidate) {
    if (candidates_[candidate].state == CandidateState::Fresh) fresh_.erase(place(candidate));
  }
  void insert(std::uint32_t candidate) {
    if (candidates_[candidate].state == CandidateState::Fresh) fresh_.insert(place(candidate));
    if (candidates_[candidate].state == CandidateState::Stale) stale_.push(place(candidate));
    if (stale_.size() > 2 * candidates_.size()) drop_outdated();
  }

  FreshPlace first_fresh() const { return fresh_.begin(); }
  /// The first one of another class, or of none.
  FreshPlace after_class(FreshPlace of) const {
    constexpr std::uint32_t last = UINT32_MAX;
    return fresh_.upper_bound({of->low, of->equals, {last, last}, last});
  }
  /// The first candidate if no fresh one before `fresh` counts.
  std::optional<std::uint32_t> first(FreshPlace fresh) {
    while (!stale_.empty() && is_outdated(stale_.top())) stale_.pop();
    if (!stale_.empty() && (fresh == fresh_.end() || stale_.top() < *fresh)) {
      return stale_.top().candidate;
    }
    return fresh == fresh_.end() ? std::nullopt : std::optional(fresh->candidate);
  }

 private:
  CandidatePlace place(std::uint32_t candidate) const {
    const CandidatePair& of = candidates_[candidate];
    return {of.key.low, of.equals, of.pair, candidate};
  }
  bool is_outdated(const CandidatePlace& stale) const {
    return candidates_[stale.candidate].state != CandidateState::Stale ||
           place(stale.candidate) != stale;
  }

  void drop_outdated() {
    std::vector<CandidatePlace> places;
    for (std::uint32_t k = 0; k < candidates_.size(); ++k) {
      if (candidates_[k].state == CandidateState::Stale) places.push_back(place(k));
    }
    stale_ = StaleHeap(std::greater<>(), std::move(places));
  }

  using StaleHeap =
      std::priority_queue<CandidatePlace, std::vector<CandidatePlace>, std::greater<>>;

  const std::vector<CandidatePair>& candidates_;
  std::set<CandidatePlace> fresh_;
  StaleHeap stale_;
};

}  // namespace convexact
