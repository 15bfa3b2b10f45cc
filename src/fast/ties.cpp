// SPDX-License-Identifier: MIT
#include "fast/ties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "fast/signs.hpp"
#include "geometry/plane_determinants.hpp"

namespace convexact {
namespace {

// Row k has its only entry, sign[k], in column axis[k].
struct SignedPermutation {
  std::array<int, 3> axis, sign;

  // Mirror images are run through clockwise.
  bool is_reflection() const {
    const bool even = (axis[1] - axis[0] + 3) % 3 == 1;
    return sign[0] * sign[1] * sign[2] * (even ? 1 : -1) < 0;
  }
  // Whether to = S from.
  bool carries(const IntegerVector3& from, const IntegerVector3& to) const {
    for (int k = 0; k < 3; ++k) {
      const Integer& x = from[axis[k]];
      if (x.sign() * sign[k] != to[k].sign()) return false;
      if (mpz_cmpabs(x.backend().data(), to[k].backend().data()) != 0) return false;
    }
    return true;
  }
};

std::array<SignedPermutation, 48> all_signed_permutations() {
  std::array<SignedPermutation, 48> all;
  auto next = all.begin();
  std::array<int, 3> axis{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      *next++ = {axis, {signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1}};
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
  return all;
}

// Pairs of planes, one of each cap, whose normals correspond.
using PlanePairs = std::vector<std::pair<const Halfspace*, const Halfspace*>>;

// x -> S x + t carries {n.x + d = 0} to {Sn.x + d - Sn.t = 0}. So there is a t for all pairs if and
// only if some (t, 1) is orthogonal to all rows (Sn, d' - d). The first three planes meet in a
// vertex, so they determine t.
bool differ_by_one_translation(const PlanePairs& pairs) {
  if (std::all_of(pairs.begin(), pairs.end(),
                  [](const auto& p) { return p.first->offset() == p.second->offset(); })) {
    return true;  // t = 0
  }
  const auto row = [&](std::size_t m) {
    const auto& [from, to] = pairs[m];
    return Halfspace(to->normal(), Integer(to->offset() - from->offset()));
  };
  const Halfspace a = row(0), b = row(1), c = row(2);
  for (std::size_t m = 3; m < pairs.size(); ++m) {
    if (plane_determinant(a, b, c, row(m)) != 0) return false;
  }
  return true;
}

}  // namespace

bool are_congruent(const FastDual& dual, const FacetOutline& a, const FacetOutline& b) {
  static const std::array<SignedPermutation, 48> kSymmetries = all_signed_permutations();
  const std::size_t k = a.neighbours.size();
  if (b.neighbours.size() != k) return false;
  PlanePairs pairs(k + 1);
  pairs[0] = {&dual.exact(a.facet), &dual.exact(b.facet)};
  for (const SignedPermutation& symmetry : kSymmetries) {
    if (!symmetry.carries(pairs[0].first->normal(), pairs[0].second->normal())) continue;
    const std::size_t step = symmetry.is_reflection() ? k - 1 : 1;
    for (std::size_t start = 0; start < k; ++start) {
      std::size_t m = 0;
      for (; m < k; ++m) {
        pairs[m + 1] = {&dual.exact(a.neighbours[m]),
                        &dual.exact(b.neighbours[(start + m * step) % k])};
        if (!symmetry.carries(pairs[m + 1].first->normal(), pairs[m + 1].second->normal())) break;
      }
      if (m == k && differ_by_one_translation(pairs)) return true;
    }
  }
  return false;
}

Interval<DoubleDouble> TieBreaker::refine(HalfspaceId i) {
  if (is_refined(i)) {
    (void)exact_cost(i);
  } else {
    cap_.prepare(i);
    refined_[i].bounds = cap_.in_double_doubles();
    ++counts_.extended;
  }
  const Refined& refined = refined_.at(i);
  return {refined.bounds.lower, refined.bounds.upper};
}

bool TieBreaker::is_exact(HalfspaceId i) const {
  const auto refined = refined_.find(i);
  return refined != refined_.end() && refined->second.is_exact;
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
  Refined& refined = refined_[i];
  if (refined.cost_class == nullptr) refined.cost_class = new_class(i);
  std::optional<Cost>& cost = refined.cost_class->cost;
  if (!cost) {
    cap_.prepare(i);
    cost = cap_.exactly();
    ++counts_.exact;
  }
  if (!refined.is_exact) {
    const auto [lower, upper] = bounds_of(*cost, dual_.cost_exponent(cost->measure()));
    refined.bounds = {Boundedness::Bounded, lower, upper};
    refined.is_exact = true;
  }
  return *cost;
}

std::shared_ptr<TieBreaker::CostClass> TieBreaker::new_class(HalfspaceId i) {
  cap_.prepare(i);
  return std::make_shared<CostClass>(CostClass{cap_.outline(), {}});
}

TieEvidence TieBreaker::keep_cheapest(std::vector<HalfspaceId>& candidates,
                                      const CompareLimits& limits, const Watch& watch) {
  DoubleDouble best = refined_.at(candidates[0]).bounds.upper;
  for (const HalfspaceId i : candidates) {
    const DoubleDouble& upper = refined_.at(i).bounds.upper;
    if (upper < best) best = upper;
  }
  std::erase_if(candidates, [&](HalfspaceId i) { return refined_.at(i).bounds.lower > best; });
  if (candidates.size() == 1) return {};
  if (are_all_congruent(candidates)) return {TieProof::Congruent, 0};
  return keep_cheapest_class(candidates, limits, watch);
}

// What proves that the classes cost the same proves the tie. A cost that is not proven to differ
// from the least one counts as a tie. (That is no equivalence: mean widths may be too close to
// distinguish, see CompareLimits.)
TieEvidence TieBreaker::keep_cheapest_class(std::vector<HalfspaceId>& candidates,
                                            const CompareLimits& limits, const Watch& watch) {
  const auto are_congruent_now = [&](HalfspaceId i, HalfspaceId j) {
    return refined_.at(i).cost_class == refined_.at(j).cost_class;
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

TieBreaker::Signature TieBreaker::signature_of(HalfspaceId i) const {
  const IntegerVector3 normal = dual_.exact(i).normal();
  Signature signature;
  for (int k = 0; k < 3; ++k) signature[k] = std::abs(normal[k].convert_to<double>());
  std::sort(signature.begin(), signature.end());
  return signature;
}

// Whether the tie is proven without computing a cost. Sorts all candidates into classes.
bool TieBreaker::are_all_congruent(const std::vector<HalfspaceId>& candidates) {
  std::map<Signature, std::vector<std::shared_ptr<CostClass>>> classes;
  std::size_t count = 0;
  for (const HalfspaceId i : candidates) {
    std::vector<std::shared_ptr<CostClass>>& alike = classes[signature_of(i)];
    std::shared_ptr<CostClass>& its_class = refined_.at(i).cost_class;
    if (its_class == nullptr) {
      its_class = new_class(i);
      const auto same = std::find_if(alike.begin(), alike.end(), [&](const auto& known) {
        return are_congruent(dual_, known->outline, its_class->outline);
      });
      if (same != alike.end()) {
        its_class = *same;
        ++counts_.congruent;
      }
    }
    if (std::find(alike.begin(), alike.end(), its_class) == alike.end()) {
      alike.push_back(its_class);
      ++count;
    }
  }
  return count == 1;
}

}  // namespace convexact
