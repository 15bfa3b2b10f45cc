// SPDX-License-Identifier: MIT
#include "fast/ties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fast/signs.hpp"
#include "number/arithmetic.hpp"

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

// x -> S x + t carries {n.x + d = 0} to {Sn.x + d - Sn.t = 0}. So t solves Sn.t = d - d' for all
// pairs. The first three planes meet in a vertex, so they determine t, by Cramer's rule as a
// fraction.
bool differ_by_one_translation(const PlanePairs& pairs) {
  std::vector<Integer> shifts;
  for (const auto& [from, to] : pairs) shifts.push_back(from->offset() - to->offset());
  if (std::all_of(shifts.begin(), shifts.end(), [](const Integer& x) { return x == 0; })) {
    return true;  // t = 0
  }
  const auto normal = [&](std::size_t m) -> const IntegerVector3& {
    return pairs[m].second->normal();
  };
  const IntegerVector3 yz = normal(1).cross(normal(2)), zx = normal(2).cross(normal(0)),
                       xy = normal(0).cross(normal(1));
  Integer below = dot(normal(0), yz);
  IntegerVector3 t;
  for (int k = 0; k < 3; ++k) t[k] = yz[k] * shifts[0] + zx[k] * shifts[1] + xy[k] * shifts[2];
  // Mostly a difference of coordinates, so a short fraction.
  const Integer common = gcd(gcd(below, t[0]), gcd(t[1], t[2]));
  below /= common;
  for (int k = 0; k < 3; ++k) t[k] /= common;
  for (std::size_t m = 3; m < pairs.size(); ++m) {
    if (dot(normal(m), t) != below * shifts[m]) return false;
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
  cap_.prepare(i);  // again, if the other cap had to be read: callers go on with this one
  if (its_class != nullptr) {
    ++its_class->members;
    ++counts_.congruent;
  } else {
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
      if (!outline) {
        cap_.prepare(i);
        outline = cap_.outline();
      }
      if (is_congruent(known->second, *outline)) return &known->second;
    }
  }
  return nullptr;
}

bool TieBreaker::is_congruent(CostClass& known, const FacetOutline& outline) {
  if (!known.outline) {
    cap_.prepare(known.first);
    known.outline = cap_.outline();
  }
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
