// SPDX-License-Identifier: MIT
#include "stress/judge_float.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "convexact/number.hpp"

namespace convexact {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// An upper end of -1 stands for infinity: no cost is negative.
bool is_infinite(const Rational& x) { return x < 0; }

// Whether the run ends for want of bounded removals where there is one.
bool ends_early(const TraceVerdict& verdict) {
  return std::any_of(verdict.claims.begin(), verdict.claims.end(), [](const TraceClaim& claim) {
    return std::string_view(claim.code) == "trace-stop" && claim.status == Status::Violated;
  });
}

// Whether the step is within what the engine says of its steps.
bool is_as_claimed(const StressClaim& claim, double cost_error, double regret) {
  return cost_error <= claim.cost && regret <= claim.regret;
}

}  // namespace

double error_of_cost(const Range& reported, const Rational& cost) {
  if (is_infinite(reported.low) || is_infinite(reported.high)) return kInfinity;
  const Rational error =
      std::max<Rational>(abs(Rational(reported.low - cost)), abs(Rational(reported.high - cost)));
  if (error == 0) return 0;
  return cost == 0 ? kInfinity : to_double(Rational(error / cost), Rounding::Up);
}

void judge_float(const EngineAnswer& answer, const TraceVerdict& verdict, StressRun& run) {
  std::size_t beyond_claim = 0;
  double cost_error = 0, regret = 0;
  for (std::size_t s = 0; s < verdict.steps.size(); ++s) {
    const JudgedStep& step = verdict.steps[s];
    if (!step.cost) {
      run.faults.push_back(fmt::format("step {} leaves an unbounded solid", s));
      return;
    }
    if (!run.first_difference && !step.is_greedy()) run.first_difference = s;
    const double step_error = error_of_cost(answer.lean_costs[s], *step.cost);
    const double step_regret = step.regret ? to_double(*step.regret, Rounding::Up) : kInfinity;
    cost_error = std::max(cost_error, step_error);
    regret = std::max(regret, step_regret);
    if (answer.claim) beyond_claim += !is_as_claimed(*answer.claim, step_error, step_regret);
  }
  run.other_ties = verdict.other_ties;
  run.cost_error = cost_error;
  run.regret = regret;
  if (!answer.claim) return;
  if (beyond_claim > answer.claim->doubtful) {
    run.faults.push_back(fmt::format("{} steps are worse than it says, and it doubts {}",
                                     beyond_claim, answer.claim->doubtful));
  }
  if (ends_early(verdict) && answer.claim->end_proven) {
    run.faults.push_back("it ends although a bounded removal is left, and vouches for the end");
  }
}

}  // namespace convexact
