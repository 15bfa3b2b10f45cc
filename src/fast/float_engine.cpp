// SPDX-License-Identifier: MIT
#include "fast/float_engine.hpp"

#include "fast/float_loop.hpp"

namespace convexact {

FloatErrors::FloatErrors(std::size_t halfspaces, CostMeasure measure)
    : lower_(halfspaces),
      upper_(halfspaces, std::numeric_limits<double>::infinity()),
      multiple_(cost_multiple(measure)) {
  for (std::size_t i = 0; i < halfspaces; ++i) lower_.append(HalfspaceId(i), 0);
}

void FloatErrors::remove(HalfspaceId i, double cost) {
  const double upper = upper_[i.index()], lower = lower_.key(i);
  lower_.erase(i);
  // The error is that of the enclosure's bounds, and of the division by the multiple, which may be
  // rounded.
  const double of_quotient = 0x1p-52 + (multiple_.upper - multiple_.lower) / multiple_.lower;
  const double error =
      next_above(next_above(std::max(upper - cost, cost - lower)) / lower) + of_quotient;
  const double regret =
      lower_.empty() ? 0 : next_above(next_above(upper / lower_.key(lower_.top())) - 1);
  if (!(error <= FloatBound::kMost && regret <= FloatBound::kMost)) {
    ++bound_.doubtful;
    return;
  }
  bound_.cost = std::max(bound_.cost, error);
  bound_.regret = std::max(bound_.regret, regret);
}

FloatBound FloatErrors::bound(bool is_stuck) const {
  FloatBound bound = bound_;
  const double least = lower_.key(lower_.top());
  bound.least_next = std::isinf(least) ? least : next_below(least / multiple_.upper);
  bound.is_end_proven = !is_stuck || std::isinf(least);
  return bound;
}

template class FloatLoop<Doubles>;

FastResult simplify_float(const FastDual& dual, const SimplifyOptions& options) {
  const Doubles arithmetic{dual, {dual}};
  return FloatLoop<Doubles>(dual, arithmetic, options).run();
}

}  // namespace convexact
