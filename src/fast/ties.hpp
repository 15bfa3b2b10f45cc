// SPDX-License-Identifier: MIT
// ties.hpp - ranks the caps that doubles cannot distinguish.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "convexact/number.hpp"
#include "fast/cap.hpp"
#include "fast/congruence.hpp"
#include "fast/dual.hpp"
#include "fast/engines.hpp"

namespace convexact {

/// Computes more about a few caps than their bounds in doubles: which of them are congruent, and
/// for each class of these, once and only if that leaves the choice open, bounds in DoubleDouble,
/// and the exact cost if they are not enough.
class TieBreaker {
 public:
  TieBreaker(const FastDual& dual, FilteredCap& cap, FastCounts& counts)
      : dual_(dual), cap_(cap), counts_(counts) {}

  /// Encloses the cost of i, in units of FilteredCap's bounds, by the next better arithmetic, if
  /// there is one.
  Interval<DoubleDouble> refine(HalfspaceId i);
  bool is_refined(HalfspaceId i) const;
  bool is_exact(HalfspaceId i) const;
  /// Computed at the first call, for all caps that are known to be congruent.
  const Cost& exact_cost(HalfspaceId i);
  /// Whether all of these are known to be congruent.
  bool are_one_class(const std::vector<HalfspaceId>& candidates);
  /// Reduces candidates, of one class or all refined, to those of minimal cost: the tie.
  /// @return  What proves it.
  TieEvidence keep_cheapest(std::vector<HalfspaceId>& candidates, const CompareLimits& limits,
                            const Watch& watch);
  /// Of such a candidate: the same for all congruent ones.
  const void* class_of(HalfspaceId i) const { return members_.at(i).its_class; }
  /// The ring of i has changed, or is gone.
  void forget(HalfspaceId i);

 private:
  // Congruent caps.
  struct CostClass {
    HalfspaceId first;                    // the one that it was made for
    std::optional<FacetOutline> outline;  // of `first`, as it was; none while it is the only one
    std::array<double, 3> sizes;          // FastDual::normal_sizes()
    std::size_t members = 1;              // not forgotten since
    // Once there is a cost, that cost, rounded.
    std::optional<Interval<DoubleDouble>> bounds;
    std::optional<Cost> cost;
  };
  struct Member {
    CostClass* its_class;
    bool is_refined;  // whether it was given bounds of its class
  };
  // By one of their sizes, in cells that are wide compared with its error.
  using Classes = std::unordered_multimap<std::int64_t, CostClass>;

  Member& member(HalfspaceId i);
  CostClass* congruent_class(HalfspaceId i, const std::array<double, 3>& sizes);
  bool is_congruent(CostClass& known, const FacetOutline& outline);
  TieEvidence keep_cheapest_class(std::vector<HalfspaceId>& candidates, const CompareLimits& limits,
                                  const Watch& watch);

  const FastDual& dual_;
  FilteredCap& cap_;
  FastCounts& counts_;
  Classes classes_;
  std::unordered_map<HalfspaceId, Member> members_;
};

}  // namespace convexact
