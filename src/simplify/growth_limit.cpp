// SPDX-License-Identifier: MIT
#include "simplify/growth_limit.hpp"

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"

namespace convexact {

// kMeasureBits decide all but equality up to 30 digits; the exact numbers are there for the rest.

GrowthLimit::GrowthLimit(Polytope polytope, Rational max_growth)
    : polytope_(std::move(polytope)),
      max_growth_(std::move(max_growth)),
      allowance_(Enclosure(max_growth_, kMeasureBits) * enclose_volume(polytope_, kMeasureBits)),
      spent_(kMeasureBits) {
  if (max_growth_ < 0) {
    throw Error(ErrorCode::InvalidArgument, "the growth of the volume cannot be limited below 0");
  }
}

bool GrowthLimit::allows(const Rational& cost) {
  costs_.push_back(cost);
  const Enclosure spent = spent_ + Enclosure(cost, kMeasureBits);
  std::optional<Sign> slack = (allowance_ - spent).sign();
  if (!slack) {
    if (!exact_allowance_) exact_allowance_ = max_growth_ * volume(polytope_);
    slack = sign_of(Rational(*exact_allowance_ - balanced_sum(costs_)));
  }
  if (*slack == Sign::Negative) {
    costs_.pop_back();
    return false;
  }
  spent_ = spent;
  return true;
}

}  // namespace convexact
