// SPDX-License-Identifier: MIT
#include "fast/ties.hpp"

#include <algorithm>
#include <cmath>

#include "number/arithmetic.hpp"

namespace convexact {

Interval<DoubleDouble> TieBreaker::refine(HalfspaceId i) {
  if (is_refined(i)) {
    (void)exact_cost(i);
  } else {
    (void)class_for(i);
  }
  const CostBounds<DoubleDouble>& bounds = refined_.at(i)->bounds;
  return {bounds.lower, bounds.upper};
}

bool TieBreaker::is_exact(HalfspaceId i) const {
  const auto refined = refined_.find(i);
  return refined != refined_.end() && refined->second->cost;
}

namespace {

// The key of TieBreaker::Classes.
std::int64_t cell_of(double size) {
  constexpr double kCells = 0x1p30;
  return static_cast<std::int64_t>(std::floor(size * kCells));
}

}  // namespace

TieBreaker::CostClass& TieBreaker::class_for(HalfspaceId i) {
  const auto [place, is_new] = refined_.try_emplace(i, nullptr);
  if (!is_new) return *place->second;
  const std::array<double, 3> sizes = dual_.normal_sizes(i);
  CostClass* its_class = congruent_class(i, sizes);
  if (its_class != nullptr) {
    ++its_class->members;
    ++counts_.congruent;
  } else {
    cap_.prepare(i);
    its_class =
        &classes_
             .emplace(cell_of(sizes[1]), CostClass{i, {}, sizes, 1, cap_.in_double_doubles(), {}})
             ->second;
    ++counts_.extended;
  }
  return *(place->second = its_class);
}

// A class of caps congruent to that of i, or null.
TieBreaker::CostClass* TieBreaker::congruent_class(HalfspaceId i,
                                                   const std::array<double, 3>& sizes) {
  std::optional<FacetOutline> outline;
  const std::int64_t low = cell_of(sizes[1] - FastDual::kEqualSizes),
                     high = cell_of(sizes[1] + FastDual::kEqualSizes);
  for (std::int64_t cell = low; cell <= high; ++cell) {
    const auto [begin, end] = classes_.equal_range(cell);
    for (auto known = begin; known != end; ++known) {
      const std::array<double, 3>& others = known->second.sizes;
      if (std::abs(sizes[0] - others[0]) > FastDual::kEqualSizes) continue;
      if (std::abs(sizes[1] - others[1]) > FastDual::kEqualSizes) continue;
      if (!outline) outline = cap_.outline(i);
      if (is_congruent(known->second, *outline)) return &known->second;
    }
  }
  return nullptr;
}

bool TieBreaker::is_congruent(CostClass& known, const FacetOutline& outline) {
  if (!known.outline) known.outline = cap_.outline(known.first);
  return are_congruent(dual_, *known.outline, outline);
}

void TieBreaker::forget(HalfspaceId i) {
  const auto refined = refined_.find(i);
  if (refined == refined_.end()) return;
  CostClass* its_class = refined->second;
  refined_.erase(refined);
  if (--its_class->members > 0) return;
  const auto [begin, end] = classes_.equal_range(cell_of(its_class->sizes[1]));
  classes_.erase(std::find_if(begin, end, [&](const auto& x) { return &x.second == its_class; }));
}

namespace {

Interval<DoubleDouble> enclosed(const Rational& x) {
  const double near = to_double(x, Rounding::Nearest);
  if (!std::isfinite(near)) return {to_double(x, Rounding::Down), to_double(x, Rounding::Up)};
  const Rational rest = x - to_rational(near);
  return {DoubleDouble(fast_two_sum(near, to_double(rest, Rounding::Down))),
          DoubleDouble(fast_two_sum(near, to_double(rest, Rounding::Up)))};
}

// Bounds of the multiple of the cost that FilteredCap bounds.
Interval<DoubleDouble> bounds_of(const Cost& cost, long exponent) {
  if (cost.measure() == CostMeasure::Volume) {
    return enclosed(scale_by_power_of_two(cost.rational() * 6, -exponent));
  }
  const Interval<double> value = scaled_enclosure(cost, exponent),
                         multiple = cost_multiple(cost.measure());
  return {next_below(value.lower * multiple.lower), next_above(value.upper * multiple.upper)};
}

}  // namespace

const Cost& TieBreaker::exact_cost(HalfspaceId i) {
  CostClass& its_class = class_for(i);
  if (!its_class.cost) {
    cap_.prepare(i);
    its_class.cost = cap_.exactly();
    ++counts_.exact;
    const Cost& cost = *its_class.cost;
    const auto [lower, upper] = bounds_of(cost, dual_.cost_exponent(cost.measure()));
    // Of an area they are wider than those in DoubleDouble may have been.
    its_class.bounds = {Boundedness::Bounded, std::max(its_class.bounds.lower, lower),
                        std::min(its_class.bounds.upper, upper)};
  }
  return *its_class.cost;
}

TieEvidence TieBreaker::keep_cheapest(std::vector<HalfspaceId>& candidates,
                                      const CompareLimits& limits, const Watch& watch) {
  DoubleDouble best = refined_.at(candidates[0])->bounds.upper;
  for (const HalfspaceId i : candidates) {
    const DoubleDouble& upper = refined_.at(i)->bounds.upper;
    if (upper < best) best = upper;
  }
  std::erase_if(candidates, [&](HalfspaceId i) { return refined_.at(i)->bounds.lower > best; });
  if (candidates.size() == 1) return {};
  const bool are_all_congruent =
      std::all_of(candidates.begin(), candidates.end(),
                  [&](HalfspaceId i) { return class_of(i) == class_of(candidates[0]); });
  if (are_all_congruent) return {TieProof::Congruent, 0};
  return keep_cheapest_class(candidates, limits, watch);
}

// What proves that the classes cost the same proves the tie. A cost that is not proven to differ
// from the least one counts as a tie. (That is no equivalence: mean widths may be too close to
// distinguish, see CompareLimits.)
TieEvidence TieBreaker::keep_cheapest_class(std::vector<HalfspaceId>& candidates,
                                            const CompareLimits& limits, const Watch& watch) {
  const auto are_congruent_now = [&](HalfspaceId i, HalfspaceId j) {
    return class_of(i) == class_of(j);
  };
  HalfspaceId least = candidates[0];
  for (const HalfspaceId i : candidates) {
    if (are_congruent_now(i, least)) continue;
    const Ordering comparison = compare(exact_cost(i), exact_cost(least), limits, watch);
    if (comparison.order == Order::Less) least = i;
  }
  TieEvidence evidence;
  std::erase_if(candidates, [&](HalfspaceId i) {
    if (i == least) return false;
    if (are_congruent_now(i, least)) return false;
    const Ordering comparison = compare(exact_cost(i), exact_cost(least), limits, watch);
    if (comparison.order == Order::Greater) return true;
    evidence.add({comparison.tie_proof, comparison.bits});
    return false;
  });
  if (candidates.size() > 1 && !evidence.proof) return {TieProof::Congruent, 0};
  return evidence;
}

}  // namespace convexact
