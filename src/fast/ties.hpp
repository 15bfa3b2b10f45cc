// SPDX-License-Identifier: MIT
// ties.hpp - ranks the caps that doubles cannot tell apart.
#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "convexact/number.hpp"
#include "fast/cap.hpp"
#include "fast/dual.hpp"
#include "fast/signs.hpp"

namespace convexact {

/// Whether some isometry x -> S x + t, S one of the 48 signed permutations of the axes, carries the
/// planes of `a` to those of `b`. True proves that both caps have the same volume, as it is with
/// mirror images in modelled shapes; false proves nothing.
/// @par Cost  Comparisons of integers, mostly of the first few; k - 2 determinants if t != 0.
[[nodiscard]] bool are_congruent(const FastDual& dual, const CapOutline& a, const CapOutline& b);

/// Knows more about a few caps than their ranges in doubles: ranges in DoubleDouble, which of them
/// are congruent, and of what is still undecided the exact costs.
template <class Audit>
class TieBreaker {
 public:
  struct Ends {
    double lower, upper;  ///< Of six times the cost.
  };

  TieBreaker(const FastDual& dual, CapEvaluator<Audit>& cap, FastCounts& counts)
      : dual_(dual), cap_(cap), counts_(counts) {}

  /// Encloses i by the next better arithmetic, if there is one.
  Ends refine(HalfspaceId i);
  bool is_refined(HalfspaceId i) const { return refined_.contains(i); }
  bool is_exact(HalfspaceId i) const;
  /// Computed at the first call, for all caps that are known to be congruent.
  const Rational& exact_cost(HalfspaceId i);
  /// Reduces refined contenders to those of minimal cost: the tie, proven.
  void keep_cheapest(std::vector<HalfspaceId>& contenders);
  /// The ring of i has changed, or is gone.
  void forget(HalfspaceId i) { refined_.erase(i); }

 private:
  // Caps that are known to be equally large.
  struct CostClass {
    CapOutline outline;  // of one of them, as it was when the class was made
    std::optional<Rational> cost;
  };
  struct Refined {
    CapRange<DoubleDouble> range;
    std::shared_ptr<CostClass> cost_class;  // null: not asked yet
    bool is_exact = false;                  // the range is that of the exact cost
  };

  bool are_all_congruent(const std::vector<HalfspaceId>& contenders);
  std::shared_ptr<CostClass> new_class(HalfspaceId i);

  const FastDual& dual_;
  CapEvaluator<Audit>& cap_;
  FastCounts& counts_;
  std::unordered_map<HalfspaceId, Refined> refined_;
};

template <class Audit>
typename TieBreaker<Audit>::Ends TieBreaker<Audit>::refine(HalfspaceId i) {
  if (is_refined(i)) {
    (void)exact_cost(i);
  } else {
    cap_.prepare(i);
    refined_[i].range = cap_.in_double_doubles();
    ++counts_.extended;
  }
  const Refined& refined = refined_.at(i);
  if (refined.is_exact) return {refined.range.lower.hi(), refined.range.upper.hi()};
  return {next_below(refined.range.lower.hi()), next_above(refined.range.upper.hi())};
}

template <class Audit>
bool TieBreaker<Audit>::is_exact(HalfspaceId i) const {
  const auto refined = refined_.find(i);
  return refined != refined_.end() && refined->second.is_exact;
}

template <class Audit>
const Rational& TieBreaker<Audit>::exact_cost(HalfspaceId i) {
  Refined& refined = refined_[i];
  if (refined.cost_class == nullptr) refined.cost_class = new_class(i);
  std::optional<Rational>& cost = refined.cost_class->cost;
  if (!cost) {
    cap_.prepare(i);
    cost = cap_.exactly();
    ++counts_.exact;
  }
  if (!refined.is_exact) {
    const Rational scaled = scale_by_power_of_two(*cost * 6, -dual_.volume_exponent());
    refined.range = {CapRange<DoubleDouble>::Kind::Bounded, to_double(scaled, Rounding::Down),
                     to_double(scaled, Rounding::Up)};
    refined.is_exact = true;
  }
  return *cost;
}

template <class Audit>
std::shared_ptr<typename TieBreaker<Audit>::CostClass> TieBreaker<Audit>::new_class(HalfspaceId i) {
  cap_.prepare(i);
  return std::make_shared<CostClass>(CostClass{cap_.outline(), {}});
}

template <class Audit>
void TieBreaker<Audit>::keep_cheapest(std::vector<HalfspaceId>& contenders) {
  DoubleDouble best = refined_.at(contenders[0]).range.upper;
  for (const HalfspaceId i : contenders) {
    const DoubleDouble& upper = refined_.at(i).range.upper;
    if (upper < best) best = upper;
  }
  std::erase_if(contenders, [&](HalfspaceId i) { return refined_.at(i).range.lower > best; });
  if (contenders.size() == 1 || are_all_congruent(contenders)) return;

  Rational least = exact_cost(contenders[0]);
  for (const HalfspaceId i : contenders) least = std::min(least, exact_cost(i));
  std::erase_if(contenders, [&](HalfspaceId i) { return exact_cost(i) != least; });
}

// Whether the tie is proven without computing a cost. Sorts all contenders into classes.
template <class Audit>
bool TieBreaker<Audit>::are_all_congruent(const std::vector<HalfspaceId>& contenders) {
  std::vector<std::shared_ptr<CostClass>> classes;
  for (const HalfspaceId i : contenders) {
    std::shared_ptr<CostClass>& its_class = refined_.at(i).cost_class;
    if (its_class == nullptr) {
      its_class = new_class(i);
      const auto same = std::find_if(classes.begin(), classes.end(), [&](const auto& known) {
        return are_congruent(dual_, known->outline, its_class->outline);
      });
      if (same != classes.end()) {
        its_class = *same;
        ++counts_.congruent;
      }
    }
    if (std::find(classes.begin(), classes.end(), its_class) == classes.end()) {
      classes.push_back(its_class);
    }
  }
  return classes.size() == 1;
}

}  // namespace convexact
