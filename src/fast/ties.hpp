// SPDX-License-Identifier: MIT
// ties.hpp - ranks the caps that doubles cannot distinguish.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "convexact/number.hpp"
#include "fast/cap.hpp"
#include "fast/dual.hpp"
#include "fast/engines.hpp"

namespace convexact {

/// Whether some isometry x -> S x + t, S one of the 48 signed permutations of the axes, carries the
/// planes of `a` to those of `b`. True proves that both caps have the same volume, as mirror images
/// in modelled shapes have; false proves nothing.
/// @par Cost  Comparisons of integers, mostly of the first few; k - 2 determinants if t != 0.
[[nodiscard]] bool are_congruent(const FastDual& dual, const FacetOutline& a,
                                 const FacetOutline& b);

/// Computes more about a few caps than their bounds in doubles: bounds in DoubleDouble, which of
/// them are congruent, and the exact costs of those that are still undecided.
class TieBreaker {
 public:
  TieBreaker(const FastDual& dual, FilteredCap& cap, FastCounts& counts)
      : dual_(dual), cap_(cap), counts_(counts) {}

  /// Encloses the cost of i, in units of FilteredCap's bounds, by the next better arithmetic, if
  /// there is one.
  Interval<DoubleDouble> refine(HalfspaceId i);
  bool is_refined(HalfspaceId i) const { return refined_.contains(i); }
  bool is_exact(HalfspaceId i) const;
  /// Computed at the first call, for all caps that are known to be congruent.
  const Cost& exact_cost(HalfspaceId i);
  /// Reduces refined candidates to those of minimal cost: the tie. @return  What proves it.
  TieEvidence keep_cheapest(std::vector<HalfspaceId>& candidates, const CompareLimits& limits,
                            const Watch& watch);
  /// Of a candidate that keep_cheapest() left among others: the same for caps that are known to be
  /// congruent.
  const void* class_of(HalfspaceId i) const { return refined_.at(i).cost_class.get(); }
  /// The ring of i has changed, or is gone.
  void forget(HalfspaceId i) { refined_.erase(i); }

 private:
  // Caps that are known to be equally large.
  struct CostClass {
    FacetOutline outline;  // of one of them, as it was when the class was made
    std::optional<Cost> cost;
  };
  // The same for congruent caps: the coordinates of the facet's normal without signs, ascending.
  using Signature = std::array<double, 3>;
  struct Refined {
    CostBounds<DoubleDouble> bounds;
    std::shared_ptr<CostClass> cost_class;  // null: not computed yet
    bool is_exact = false;                  // the bounds are the exact cost, rounded
  };

  bool are_all_congruent(const std::vector<HalfspaceId>& candidates);
  Signature signature_of(HalfspaceId i) const;
  std::shared_ptr<CostClass> new_class(HalfspaceId i);
  TieEvidence keep_cheapest_class(std::vector<HalfspaceId>& candidates, const CompareLimits& limits,
                                  const Watch& watch);

  const FastDual& dual_;
  FilteredCap& cap_;
  FastCounts& counts_;
  std::unordered_map<HalfspaceId, Refined> refined_;
};

}  // namespace convexact
