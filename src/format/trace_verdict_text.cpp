// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "convexact/format/summary.hpp"
#include "convexact/format/trace_verdict.hpp"
#include "convexact/number/digits.hpp"
#include "convexact/pipeline/measured.hpp"
#include "words.hpp"

namespace convexact {
namespace {

constexpr int kTraceDigits = 17;        // of costs
constexpr int kRegretDigits = 3;        // of regrets
constexpr std::size_t kWorstSteps = 5;  // as many as are shown
constexpr std::size_t kLongest = 100;   // of what a witness may take of a line

std::string number_text(const std::optional<Rational>& x, int digits, const char* none) {
  return x ? to_decimal(*x, digits) : none;
}

// Not greedy, the worst first; an unbounded one is worse than any.
std::vector<std::size_t> worst_steps(const std::vector<JudgedStep>& steps) {
  std::vector<std::size_t> worst;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    if (!steps[s].is_greedy()) worst.push_back(s);
  }
  std::stable_sort(worst.begin(), worst.end(), [&](std::size_t a, std::size_t b) {
    const std::optional<Rational>&x = steps[a].regret, &y = steps[b].regret;
    return y && (!x || *x > *y);
  });
  return worst;
}

std::string shortened(const std::string& text) {
  return text.size() <= kLongest ? text : text.substr(0, kLongest).append("...");
}

std::string claim_text(const TraceClaim& claim) {
  if (!claim.witness) return fmt::format("  {:<22} {}\n", claim.code, name_of(claim.status));
  const TraceWitness& witness = *claim.witness;
  std::string where;
  if (witness.step) where += fmt::format("step {}", *witness.step);
  if (witness.row) where += fmt::format("{}row {}", where.empty() ? "" : ", ", *witness.row);
  return fmt::format("  {:<22} VIOLATED{}{}: {}\n  {:<22} expected {}\n", claim.code,
                     where.empty() ? "" : " at ", where, shortened(witness.found), "",
                     shortened(witness.expected));
}

std::string step_row(std::size_t number, const JudgedStep& step) {
  return fmt::format("  {:>6}  {:>6}  {:>7}  {:>24}  {:>8}  {:>24}  {:>9}\n", number, step.row,
                     step.removed.index(), number_text(step.cost, kTraceDigits, "unbounded"),
                     step.tie.empty() ? "none" : std::to_string(step.tie.front().index()),
                     number_text(step.minimum, kTraceDigits, "-"),
                     number_text(step.regret, kRegretDigits, "infinite"));
}

std::string worst_table(const TraceVerdict& verdict) {
  std::vector<std::size_t> worst = worst_steps(verdict.steps);
  if (worst.empty()) return "";
  std::string text =
      fmt::format("\n  not the cheapest: {} of {} steps; the worst:\n",
                  with_separators(worst.size()), with_separators(verdict.steps.size()));
  text += fmt::format("  {:>6}  {:>6}  {:>7}  {:>24}  {:>8}  {:>24}  {:>9}\n", "step", "row",
                      "removed", "cost", "cheapest", "its cost", "regret");
  worst.resize(std::min(worst.size(), kWorstSteps));
  for (const std::size_t s : worst) text += step_row(s, verdict.steps[s]);
  return text;
}

std::string totals_text(const TraceVerdict& verdict) {
  Enclosure added(Rational(0), kVolumeBits);
  for (const JudgedStep& step : verdict.steps) {
    if (step.cost) added = added + Enclosure(*step.cost, kVolumeBits);
  }
  std::string text =
      fmt::format("  {:<22} {} of {}, from {} halfspaces\n", "removals judged",
                  with_separators(verdict.steps.size()), with_separators(verdict.removals),
                  with_separators(verdict.halfspaces.size()));
  text +=
      fmt::format("  {:<22} {}\n", "volume added", to_decimal(added, kTraceDigits).value_or("?"));
  if (verdict.other_ties > 0) {
    text += fmt::format("  {:<22} {} ties broken otherwise than in canonical order\n", "tie-order",
                        with_separators(verdict.other_ties));
  }
  return text;
}

}  // namespace

std::string verdict_line(const TraceVerdict& verdict) {
  switch (verdict.rating) {
    case TraceRating::Greedy:
      return "greedy";
    case TraceRating::UpToRegret:
      return fmt::format("greedy up to regret {} (step {})",
                         to_decimal(*verdict.steps[*verdict.worst].regret, kRegretDigits),
                         *verdict.worst);
    case TraceRating::NotGreedy:
      return fmt::format("not greedy from step {}", *verdict.at);
    case TraceRating::Unbounded:
      return fmt::format("unbounded at step {}", *verdict.at);
    case TraceRating::Meaningless:
      break;
  }
  return verdict.at ? fmt::format("cannot be followed from step {}", *verdict.at) : "unreadable";
}

std::string trace_verdict_text(const TraceVerdict& verdict) {
  std::string text = "  verdict                " + verdict_line(verdict) + "\n";
  text += totals_text(verdict);
  for (const TraceClaim& claim : verdict.claims) text += claim_text(claim);
  return text + worst_table(verdict);
}

}  // namespace convexact
