// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "convexact/number.hpp"
#include "convexact/scene.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "oracle/trace_verdict.hpp"
#include "scene/summary.hpp"

namespace convexact {
namespace {

constexpr int kTraceDigits = 17;        // of costs
constexpr int kRegretDigits = 3;        // of regrets
constexpr std::size_t kWorstSteps = 5;  // as many as are shown
constexpr std::size_t kLongest = 100;   // of what a witness may take of a line

std::string cost_text(const std::optional<Cost>& cost, const char* none) {
  return cost ? to_decimal(cost->rational(), kTraceDigits) : none;
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
                     step.removed.index(), cost_text(step.cost, "unbounded"),
                     step.tie.empty() ? "none" : std::to_string(step.tie.front().index()),
                     cost_text(step.minimum, "-"),
                     step.regret ? to_decimal(*step.regret, kRegretDigits) : "infinite");
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
  Enclosure added(Rational(0), kMeasureBits);
  for (const JudgedStep& step : verdict.steps) {
    if (step.cost) added += step.cost->enclose(kMeasureBits);
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

// "facet 7", "facets 7, 12", "17 facets (7, 12, 30, 31, 40 and 12 more)".
std::string facets_text(const std::vector<HalfspaceId>& facets) {
  constexpr std::size_t kNamed = 5;
  std::string ids;
  for (std::size_t k = 0; k < std::min(kNamed, facets.size()); ++k) {
    ids += (k > 0 ? ", " : "") + std::to_string(facets[k].index());
  }
  if (facets.size() == 1) return "facet " + ids;
  if (facets.size() <= kNamed) return "facets " + ids;
  return fmt::format("{} facets ({} and {} more)", with_separators(facets.size()), ids,
                     with_separators(facets.size() - kNamed));
}

std::string rating_line(TraceRating rating, std::optional<std::size_t> at,
                        std::optional<std::size_t> worst, const std::optional<Rational>& regret) {
  switch (rating) {
    case TraceRating::Greedy:
      return "greedy";
    case TraceRating::UpToRegret:
      return fmt::format("greedy up to regret {} (step {})", to_decimal(*regret, kRegretDigits),
                         *worst);
    case TraceRating::NotGreedy:
      return fmt::format("not greedy from step {}", *at);
    case TraceRating::Unbounded:
      return fmt::format("unbounded at step {}", *at);
    case TraceRating::Meaningless:
      break;
  }
  return at ? fmt::format("cannot be followed from step {}", *at) : "unreadable";
}

std::string note(const std::string& sentence) {
  return sentence.empty() ? "" : fmt::format("  {:<22} {}\n", "note", sentence);
}

}  // namespace

std::string verdict_line(const TraceVerdict& verdict) {
  const auto regret = verdict.worst ? verdict.steps[*verdict.worst].regret : std::nullopt;
  const std::string line = rating_line(verdict.rating, verdict.at, verdict.worst, regret);
  return verdict.left_out.empty() ? line : line + " without " + facets_text(verdict.left_out);
}

std::string verdict_line(const LeftOut& left_out) {
  return rating_line(left_out.rating, left_out.at, left_out.worst, left_out.worst_regret);
}

std::string sentence(const LeftOut& left_out, const TraceVerdict& verdict) {
  const bool is_one = left_out.facets.size() == 1;
  const std::size_t steps = verdict.steps.size();
  const std::string unlisted =
      left_out.unlisted == 0 ? ""
      : left_out.unlisted == left_out.facets.size()
          ? " (not in the facet list)"
          : fmt::format(" ({} of them not in the facet list)", left_out.unlisted);
  const std::string where = left_out.steps == steps
                                ? "in every step"
                                : fmt::format("in {} of {} steps", with_separators(left_out.steps),
                                              with_separators(steps));
  const std::string cause =
      is_one ? fmt::format("{}{} is the cheapest {} and never removed: was it left out on purpose?",
                           facets_text(left_out.facets), unlisted, where)
             : fmt::format(
                   "{}{} are never removed, and the cheapest {} is one of them: were they "
                   "left out on purpose?",
                   facets_text(left_out.facets), unlisted, where);
  std::string ids;
  for (const HalfspaceId id : left_out.facets) {
    ids += (ids.empty() ? "" : ",") + std::to_string(id.index());
  }
  if (ids.size() > kLongest) ids = "ID,...";
  return fmt::format("{} Without {} the order is {}; --left-out {} makes that the verdict.", cause,
                     is_one ? "it" : "them", verdict_line(left_out), ids);
}

std::string sentence(const ListedPlanes& listed) {
  std::string text;
  if (listed.rounded > 0) {
    text = fmt::format(
        "{} planes of the list are facet planes up to rounding: each is taken for the nearest, of "
        "which it misses a corner by {} at most.",
        with_separators(listed.rounded),
        to_decimal(sqrt(Enclosure(listed.squared_distance, kMeasureBits)), kRegretDigits)
            .value_or("?"));
  }
  if (listed.unknown > 0) {
    text += fmt::format("{}{} planes of the list are no facet planes, even up to rounding.",
                        text.empty() ? "" : " ", with_separators(listed.unknown));
  }
  return text;
}

std::string trace_verdict_text(const TraceVerdict& verdict) {
  std::string text = "  verdict                " + verdict_line(verdict) + "\n";
  if (verdict.never_removed) text += note(sentence(*verdict.never_removed, verdict));
  text += note(sentence(verdict.listed)) + totals_text(verdict);
  for (const TraceClaim& claim : verdict.claims) text += claim_text(claim);
  return text + worst_table(verdict);
}

}  // namespace convexact
