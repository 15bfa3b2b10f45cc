// SPDX-License-Identifier: MIT
#include "simplify/growth_limit.hpp"

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "number/precision.hpp"

namespace convexact {

// kMeasureBits decide all but equality up to 30 digits; exact numbers decide the rest.

GrowthLimit::GrowthLimit(Polytope polytope, const SimplifyOptions& options)
    : polytope_(std::move(polytope)),
      options_(options),
      allowance_(Enclosure(*options.max_growth, kMeasureBits) *
                 enclose_measure(polytope_, options.growth_measure(), kMeasureBits)),
      spent_(kMeasureBits) {
  if (*options.max_growth < 0) {
    throw Error(ErrorCode::InvalidArgument, "the growth of a measure cannot be limited below 0");
  }
}

bool GrowthLimit::allows_exactly(const Cost& cost) {
  if (!exact_allowance_) {
    exact_allowance_ = exact_measure(polytope_, options_.growth_measure());
    *exact_allowance_ *= *options_.max_growth;
  }
  std::vector<Cost> costs = costs_;
  costs.push_back(cost);
  const Ordering ordering =
      compare(sum_of(costs), *exact_allowance_, options_.compare, options_.watch);
  undecided_bits_ = ordering.order == Order::Undecided ? ordering.bits : 0;
  return ordering.order == Order::Less || ordering.order == Order::Equal;
}

bool GrowthLimit::allows(const Cost& cost) {
  const Enclosure spent = spent_ + cost.enclose(kMeasureBits);
  const std::optional<Sign> slack = (allowance_ - spent).sign();
  if (slack == Sign::Negative || (!slack && !allows_exactly(cost))) return false;
  costs_.push_back(cost);
  spent_ = spent;
  return true;
}

}  // namespace convexact
