// SPDX-License-Identifier: MIT
#include "fast/ties.hpp"

#include <algorithm>
#include <cmath>

#include "number/arithmetic.hpp"

namespace convexact {

Interval<DoubleDouble> TieBreaker::refine(HalfspaceId i) {
  auto& [its_class, is_refined] = member(i);
  if (!its_class->bounds) {
    cap_.prepare(i);
    const CostBounds<DoubleDouble> bounds = cap_.in_double_doubles();
    its_class->bounds = {bounds.lower, bounds.upper};
    ++counts_.extended;
  } else if (is_refined) {
    (void)exact_cost(i);
  }
  is_refined = true;
  return *its_class->bounds;
}

bool TieBreaker::is_refined(HalfspaceId i) const {
  const auto found = members_.find(i);
  return found != members_.end() && found->second.is_refined;
}

bool TieBreaker::is_exact(HalfspaceId i) const {
  const auto found = members_.find(i);
  return found != members_.end() && found->second.its_class->cost;
}

namespace {

// The key of TieBreaker::Classes.
std::int64_t cell_of(double size) {
  constexpr double kCells = 0x1p30;
  return static_cast<std::int64_t>(std::floor(size * kCells));
}

}  // namespace

TieBreaker::Member& TieBreaker::member(HalfspaceId i) {
  const auto [place, is_new] = members_.try_emplace(i, Member{nullptr, false});
  if (!is_new) return place->second;
  const std::array<double, 3> sizes = dual_.normal_sizes(i);
  CostClass* its_class = congruent_class(i, sizes);
  if (its_class != nullptr) {
    ++its_class->members;
    ++counts_.congruent;
  } else {
    its_class = &classes_.emplace(cell_of(sizes[1]), CostClass{i, {}, sizes, 1, {}, {}})->second;
  }
  place->second.its_class = its_class;
  return place->second;
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
  const auto found = members_.find(i);
  if (found == members_.end()) return;
  CostClass* its_class = found->second.its_class;
  members_.erase(found);
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
  CostClass& its_class = *member(i).its_class;
  if (!its_class.cost) {
    cap_.prepare(i);
    its_class.cost = cap_.exactly();
    ++counts_.exact;
    const Cost& cost = *its_class.cost;
    Interval<DoubleDouble> bounds = bounds_of(cost, dual_.cost_exponent(cost.measure()));
    // Of an area they are wider than those in DoubleDouble may have been.
    if (its_class.bounds) {
      bounds = {std::max(its_class.bounds->lower, bounds.lower),
                std::min(its_class.bounds->upper, bounds.upper)};
    }
    its_class.bounds = bounds;
  }
  return *its_class.cost;
}

bool TieBreaker::are_one_class(const std::vector<HalfspaceId>& candidates) {
  const CostClass* first = member(candidates[0]).its_class;
  return std::all_of(candidates.begin(), candidates.end(),
                     [&](HalfspaceId i) { return member(i).its_class == first; });
}

TieEvidence TieBreaker::keep_cheapest(std::vector<HalfspaceId>& candidates,
                                      const CompareLimits& limits, const Watch& watch) {
  if (!are_one_class(candidates)) {
    const auto bounds = [&](HalfspaceId i) -> const Interval<DoubleDouble>& {
      return *members_.at(i).its_class->bounds;
    };
    DoubleDouble best = bounds(candidates[0]).upper;
    for (const HalfspaceId i : candidates) best = std::min(best, bounds(i).upper);
    std::erase_if(candidates, [&](HalfspaceId i) { return bounds(i).lower > best; });
  }
  if (candidates.size() == 1) return {};
  if (are_one_class(candidates)) return {TieProof::Congruent, 0};
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
