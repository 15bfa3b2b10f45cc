// SPDX-License-Identifier: MIT
#include "wire/trace_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/number.hpp"
#include "convexact/scene.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "oracle/order/facet_match.hpp"
#include "simplify/run_names.hpp"
#include "wire/tie_report.hpp"
#include "wire/trace_json.hpp"

namespace convexact {
namespace {

// ---- JSON

Json cost_json(const std::optional<Cost>& cost) {
  if (!cost) return nullptr;
  return cost->measure() == CostMeasure::Volume ? quantity_json(cost->rational())
                                                : convexact::cost_json(*cost);
}

// Null for an interval around 0, too.
Json regret_json(const std::optional<Regret>& regret) {
  if (!regret) return nullptr;
  if (regret->exact() != nullptr) return quantity_json(regret->rational());
  if (!regret->is_positive()) return nullptr;
  return measured_json({regret->bounds(), std::nullopt}, kDigits);
}

Json step_json(const JudgedStep& step, std::size_t number, CostMeasure measure) {
  Json json = {{"step", number},
               {"row", step.row},
               {"removed", step.removed},
               {"cost", cost_json(step.cost)},
               {"minimum", cost_json(step.minimum)},
               {"tie", step.tie},
               {"regret", regret_json(step.regret)}};
  if (measure == CostMeasure::Volume) return json;
  json.update(tie_json(step.tie_evidence));
  if (!step.is_within) json["undecided"] = true;
  return json;
}

Json claim_json(const TraceClaim& claim) {
  Json json = {{"code", name_of(claim.code)}, {"status", name_of(claim.status)}};
  if (!claim.witness) return json;
  const TraceWitness& witness = *claim.witness;
  json["witness"] = {{"step", or_null(witness.step)},
                     {"row", or_null(witness.row)},
                     {"found", witness.found},
                     {"expected", witness.expected}};
  return json;
}

Json worst_json(const OrderRating& rating) {
  if (!rating.worst) return nullptr;
  return {{"step", *rating.worst}, {"regret", regret_json(rating.worst_regret)}};
}

Json notes_json(const TraceVerdict& verdict) {
  Json notes = Json::array();
  if (const auto& left_out = verdict.never_removed) {
    notes.push_back({{"code", "left-out"},
                     {"text", sentence(*left_out, verdict)},
                     {"facets", left_out->facets},
                     {"unlisted", left_out->unlisted},
                     {"steps", left_out->steps},
                     {"verdict", verdict_line(*left_out)},
                     {"rating", name_of(left_out->rating)},
                     {"at", or_null(left_out->at)},
                     {"worst", worst_json(*left_out)}});
  }
  if (verdict.undecided > 0) {
    const auto undecided =
        std::find_if(verdict.steps.begin(), verdict.steps.end(),
                     [](const JudgedStep& step) { return !step.is_within.has_value(); });
    notes.push_back({{"code", "undecided"},
                     {"text", sentence_on_undecided(verdict)},
                     {"steps", verdict.undecided},
                     {"first", undecided - verdict.steps.begin()},
                     {"bits", verdict.tie_bits}});
  }
  if (verdict.listed.rounded + verdict.listed.unknown > 0) {
    notes.push_back({{"code", "facet-list"},
                     {"text", sentence(verdict.listed)},
                     {"rounded", verdict.listed.rounded},
                     {"unknown", verdict.listed.unknown}});
  }
  if (verdict.other_ties == 0) return notes;
  const auto first = std::find_if(verdict.steps.begin(), verdict.steps.end(),
                                  [](const JudgedStep& step) { return step.is_other_tie(); });
  notes.push_back({{"code", "tie-order"},
                   {"steps", verdict.other_ties},
                   {"first", first - verdict.steps.begin()}});
  return notes;
}

// ---- Text

constexpr int kRegretDigits = 3;        // of regrets
constexpr std::size_t kWorstSteps = 5;  // as many as are shown
constexpr std::size_t kLongest = 100;   // characters of a line that a witness may quote

std::string cost_text(const std::optional<Cost>& cost, const char* none) {
  return cost ? cost->decimal(kDigits) : none;
}

// Steps that are dearer than another, the worst first; an unbounded one is worse than any.
std::vector<std::size_t> worst_steps(const std::vector<JudgedStep>& steps) {
  std::vector<std::size_t> worst;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    if (steps[s].is_dearer()) worst.push_back(s);
  }
  std::stable_sort(worst.begin(), worst.end(), [&](std::size_t a, std::size_t b) {
    const std::optional<Regret>&x = steps[a].regret, &y = steps[b].regret;
    return y && (!x || x->is_above(*y));
  });
  return worst;
}

std::string shortened(const std::string& text) {
  return text.size() <= kLongest ? text : text.substr(0, kLongest).append("...");
}

std::string row(const char* label, const std::string& text) {
  return fmt::format("  {:<22} {}\n", label, text);
}

std::string claim_text(const TraceClaim& claim) {
  if (!claim.witness) return row(name_of(claim.code), name_of(claim.status));
  const TraceWitness& witness = *claim.witness;
  std::string where;
  if (witness.step) where += fmt::format("step {}", *witness.step);
  if (witness.row) where += fmt::format("{}row {}", where.empty() ? "" : ", ", *witness.row);
  if (!where.empty()) where = " at " + where;
  const char* how = claim.status == Status::Violated ? "VIOLATED" : "UNDECIDED";
  return row(name_of(claim.code), how + where + ": " + shortened(witness.found)) +
         row("", "expected " + shortened(witness.expected));
}

constexpr const char* kStepRow = "  {:>6}  {:>6}  {:>7}  {:>24}  {:>8}  {:>24}  {:>9}\n";

std::string step_row(std::size_t number, const JudgedStep& step) {
  return fmt::format(fmt::runtime(kStepRow), number, step.row, step.removed.index(),
                     cost_text(step.cost, "unbounded"),
                     step.tie.empty() ? "none" : std::to_string(step.tie.front().index()),
                     cost_text(step.minimum, "-"),
                     step.regret ? regret_text(*step.regret) : "infinite");
}

std::string worst_table(const TraceVerdict& verdict) {
  std::vector<std::size_t> worst = worst_steps(verdict.steps);
  if (worst.empty()) return "";
  std::string text =
      fmt::format("\n  not the cheapest: {} of {} steps; the worst:\n",
                  with_separators(worst.size()), with_separators(verdict.steps.size()));
  text += fmt::format(fmt::runtime(kStepRow), "step", "row", "removed", "cost", "cheapest",
                      "its cost", "regret");
  worst.resize(std::min(worst.size(), kWorstSteps));
  for (const std::size_t s : worst) text += step_row(s, verdict.steps[s]);
  return text;
}

std::string totals_text(const TraceVerdict& verdict) {
  Enclosure added(Rational(0), kMeasureBits);
  for (const JudgedStep& step : verdict.steps) {
    if (step.cost) added += step.cost->enclose(kMeasureBits);
  }
  std::string text = row(
      "removals judged",
      fmt::format("{} of {}, from {} halfspaces", with_separators(verdict.steps.size()),
                  with_separators(verdict.removals), with_separators(verdict.halfspaces.size())));
  const char* what = verdict.measure == CostMeasure::Volume ? "volume added"
                     : verdict.measure == CostMeasure::Area ? "area added"
                                                            : "mean width added";
  text += row(what, to_decimal(added, kDigits).value_or("?"));
  if (verdict.other_ties > 0) {
    text += row("tie-order", with_separators(verdict.other_ties) +
                                 " ties broken otherwise than in canonical order");
  }
  return text;
}

// Meaningless from the start.
bool is_unreadable(const OrderRating& rating) {
  return rating.rating == TraceRating::Meaningless && !rating.at;
}

// "facet 7", "facets 7, 12", "17 facets (7, 12, 30, 31, 40 and 12 more)".
std::string facets_text(const std::vector<HalfspaceId>& facets) {
  constexpr std::size_t kNamed = 5;
  const std::string ids = ids_text(std::span(facets).first(std::min(kNamed, facets.size())), ", ");
  if (facets.size() == 1) return "facet " + ids;
  if (facets.size() <= kNamed) return "facets " + ids;
  return fmt::format("{} facets ({} and {} more)", with_separators(facets.size()), ids,
                     with_separators(facets.size() - kNamed));
}

}  // namespace

Json trace_verdict_json(const TraceVerdict& verdict) {
  Json claims = Json::array(), steps = Json::array();
  for (const TraceClaim& claim : verdict.claims) claims.push_back(claim_json(claim));
  for (const JudgedStep& step : verdict.steps) {
    steps.push_back(step_json(step, steps.size(), verdict.measure));
  }
  Json json = {{"verdict", verdict_line(verdict)},
               {"rating", name_of(verdict.rating)},
               {"at", or_null(verdict.at)},
               {"holds", verdict.holds()}};
  if (verdict.measure != CostMeasure::Volume) {
    json["measure"] = name_of(verdict.measure);
    json["undecided"] = verdict.undecided;
  }
  json["max_regret"] = quantity_json(verdict.max_regret);
  json["worst"] = worst_json(verdict);
  json["left_out"] = verdict.left_out;
  if (!verdict.kept.empty()) json["kept"] = verdict.kept;
  json["halfspaces"] = verdict.halfspaces.size();
  json["removals"] = verdict.removals;
  json["judged"] = verdict.steps.size();
  json["claims"] = claims;
  json["notes"] = notes_json(verdict);
  json["steps"] = steps;
  return json;
}

std::string regret_text(const Regret& regret) {
  if (const Rational* exact = regret.exact()) return to_decimal(*exact, kRegretDigits);
  const Enclosure bounds = regret.bounds();
  if (const auto text = to_decimal(bounds, kRegretDigits)) return *text;
  return "at most " + to_decimal(bounds.high(), kRegretDigits);
}

std::string sentence_on_undecided(const TraceVerdict& verdict) {
  if (verdict.undecided == 0) return "";
  return fmt::format(
      "{} of {} steps are not decided: {} bits do not tell their costs apart from the limit, and "
      "no "
      "proof shows that they are equal. They are neither accepted nor refuted; --tie-bits allows "
      "for more.",
      with_separators(verdict.undecided), with_separators(verdict.steps.size()),
      with_separators(static_cast<std::uint64_t>(verdict.tie_bits)));
}

std::string verdict_line(const OrderRating& rating) {
  switch (rating.rating) {
    case TraceRating::Greedy:
      return "greedy";
    case TraceRating::UpToRegret:
      return fmt::format("greedy up to regret {} (step {})", regret_text(*rating.worst_regret),
                         *rating.worst);
    case TraceRating::Undecided:
      return fmt::format("undecided at step {}", *rating.at);
    case TraceRating::NotGreedy:
      return fmt::format("not greedy from step {}", *rating.at);
    case TraceRating::Unbounded:
      return fmt::format("unbounded at step {}", *rating.at);
    case TraceRating::Meaningless:
      break;
  }
  return is_unreadable(rating) ? "unreadable"
                               : fmt::format("cannot be followed from step {}", *rating.at);
}

std::string verdict_line(const TraceVerdict& verdict) {
  std::string line = verdict_line(static_cast<const OrderRating&>(verdict));
  if (verdict.measure != CostMeasure::Volume && !is_unreadable(verdict)) {
    line += fmt::format(" by {}", verdict.measure == CostMeasure::Area ? "area" : "mean width");
  }
  if (!verdict.kept.empty()) line += ", with " + facets_text(verdict.kept) + " kept";
  return verdict.left_out.empty() ? line : line + " without " + facets_text(verdict.left_out);
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
  std::string ids = ids_text(left_out.facets, ",");
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
        with_separators(listed.rounded), decimal_of_root(listed.squared_distance, kRegretDigits));
  }
  if (listed.unknown > 0) {
    text += fmt::format("{}{} planes of the list are no facet planes, even up to rounding.",
                        text.empty() ? "" : " ", with_separators(listed.unknown));
  }
  return text;
}

std::string trace_verdict_text(const TraceVerdict& verdict) {
  std::string text = row("verdict", verdict_line(verdict));
  if (verdict.never_removed) text += row("note", sentence(*verdict.never_removed, verdict));
  for (const std::string& note : {sentence_on_undecided(verdict), sentence(verdict.listed)}) {
    if (!note.empty()) text += row("note", note);
  }
  text += totals_text(verdict);
  for (const TraceClaim& claim : verdict.claims) text += claim_text(claim);
  return text + worst_table(verdict);
}

}  // namespace convexact
