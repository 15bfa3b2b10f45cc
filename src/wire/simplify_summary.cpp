// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "proof/proof.hpp"
#include "simplify/run_names.hpp"
#include "wire/mass_report.hpp"
#include "wire/simplify_report.hpp"
#include "wire/tie_report.hpp"

namespace convexact {
namespace {

constexpr int kSummaryDigits = 6;

std::string input_line(std::size_t points, std::size_t vertices, std::size_t halfspaces,
                       std::size_t redundant) {
  std::string hull = counted(vertices, "vertex", "vertices") + " and " +
                     counted(halfspaces, "halfspace", "halfspaces");
  if (points > 0) return counted(points, "point", "points") + "; their hull has " + hull;
  if (redundant == 0) return hull;
  return hull + "; " + counted(redundant, "redundant one", "redundant ones") + " left out";
}

std::string growth_limit_text(long undecided_bits) {
  if (undecided_bits == 0) return ": removing one more would exceed the growth allowed";
  return fmt::format(": {} bits do not tell whether one more would exceed the growth allowed",
                     undecided_bits);
}

std::string output_line(const SimplifyResult& result) {
  std::string text = counted(result.solid.exact.planes.size(), "halfspace", "halfspaces");
  if (!result.kept.empty()) text += fmt::format(", {} of them kept on request", result.kept.size());
  switch (result.stop) {
    case StopReason::Reached:
      return text + (result.steps == 0 ? ": as many as the input has" : "");
    case StopReason::GrowthLimit:
      return text + growth_limit_text(result.growth_bits);
    case StopReason::AllUnbounded:
    case StopReason::AllKeptOrUnbounded:
      break;
  }
  if (!result.kept.empty() && !result.float_bound) {
    return text + ": all others are kept, or leave the solid unbounded if removed";
  }
  return text + (result.float_bound && !result.float_bound->is_end_proven
                     ? ": doubles cannot prove that any further removal is bounded; --engine "
                       "filtered decides"
                     : ": removing any one more would leave the solid unbounded");
}

// As many certain digits as the bounds give, up to `digits`.
std::string certain(const Enclosure& bounds, int digits) {
  for (; digits > 0; --digits) {
    if (const auto text = to_decimal(bounds, digits)) return *text;
  }
  return "less than " + to_decimal(bounds.high(), 2);
}

std::string growth_line(const Enclosure& before, const Enclosure& after, std::size_t steps) {
  const std::string text =
      certain(before, kSummaryDigits) + " -> " + certain(after, kSummaryDigits);
  return text + (steps == 0 ? ", unchanged" : ", " + growth_percent(before, after));
}

std::string verified_line(const SimplifyResult& result, bool verbose) {
  if (result.verified == VerifyLevel::None) return "nothing, as requested";
  const std::string points = counted(result.tested_points, "point", "points") +
                             " tested exactly against every halfspace: none outside";
  if (result.engine == Engine::Float) return points + "; the steps are those of doubles";
  const char* const level = !verbose                                ? ""
                            : result.verified == VerifyLevel::Local ? " (local)"
                                                                    : " (full)";
  return fmt::format("{} proven again, exactly{}; {}", counted(result.steps, "step", "steps"),
                     level, points);
}

// What a proof claims, and what it leaves out.
const char* meaning_of(ProofClaim claim) {
  switch (claim) {
    case ProofClaim::Greedy:
      return "each removal adds the least volume";
    case ProofClaim::GreedyArea:
      return "each removal adds the least area";
    case ProofClaim::Costs:
      return "the volume that each removal adds, not that it is least";
    case ProofClaim::CostsNotShown:
      return "the removals; neither what they add nor that it is least";
    case ProofClaim::Optimal:
      return "no other planes, as many, bound a smaller volume";
  }
  throw Error(ErrorCode::Internal, "a claim without a meaning");
}

std::string proof_text(const Run& run) {
  const ProofClaim claim = proof_claim(run);
  return fmt::format("{}: {}", name_in(kProofClaimNames, claim), meaning_of(claim));
}

std::string push_text(const Growth& growth, bool verbose) {
  if (growth.push == 0) return "without any change";
  std::string push = fmt::format("within {:.2g} of the diameter", growth.push);
  if (!verbose) return push;
  return push +
         fmt::format(", volume times at most 1 + {:.2g}", std::max(0.0, growth.volume_ratio - 1));
}

// In how many steps there was a choice, and why the costs are equal.
std::string ties_text(const TieTally& tally, std::size_t steps, const char* what_ties,
                      const char* what_goes) {
  const std::size_t ties = tie_count(tally);
  if (ties == 0) return "";
  return summary_line("ties", fmt::format("in {} of {} {} cost the same ({}); {} goes",
                                          with_separators(ties), counted(steps, "step", "steps"),
                                          what_ties, tie_proofs_text(tally), what_goes));
}

std::string tie_line(const SimplifyResult& result) {
  const std::size_t ties = result.float_bound->ties;
  if (ties == 0) return "";
  return summary_line("ties",
                      fmt::format("in {} of {} several removals cost the same up to rounding; the "
                                  "canonical order chose, and another order may end elsewhere",
                                  with_separators(ties), counted(result.steps, "step", "steps")));
}

std::string float_lines(const SimplifyResult& result) {
  const FloatBound& bound = *result.float_bound;
  if (bound.is_vouched()) {
    const std::string greedy =
        bound.regret == 0
            ? "every step was the cheapest"
            : fmt::format("every step cost at most 1 + {:.1g} times the cheapest", bound.regret);
    return summary_line("doubles",
                        fmt::format("{}, and its cost as computed is right within {:.1g}: proven",
                                    greedy, bound.cost));
  }
  std::string doubts;
  if (bound.doubtful > 0) {
    doubts = fmt::format("{} of {} not proven to be nearly the cheapest",
                         with_separators(bound.doubtful), counted(result.steps, "step", "steps"));
  }
  if (!bound.is_end_proven)
    doubts += std::string(doubts.empty() ? "" : ", ") + "the end is not proven";
  return summary_line("doubtful", doubts + "; --engine filtered decides");
}

std::string optimum_line(const SearchResult& search) {
  const auto& [is_proven, lower_bound, nodes] = *search.optimality;
  const std::string states = counted(nodes, "state", "states");
  if (is_proven) {
    return summary_line("optimum", "proven: no other facets, as many, bound less; by " + states);
  }
  const Enclosure bound(lower_bound, kMeasureBits), hundred(Integer(100), kMeasureBits);
  return summary_line(
      "optimum",
      fmt::format("not proven: {} were looked at; as many facets bound at least {}, up to {}% less "
                  "than these",
                  states, certain(bound, kSummaryDigits),
                  certain(hundred * (search.now - bound) / search.now, 2)));
}

// How much of the amount that the removals added is left, and after how many moves.
std::string search_lines(const SearchResult& search, const Enclosure& input) {
  const bool has_kicks = search.request.kind != SearchKind::Walk;
  const std::string kind =
      has_kicks ? "walk and " + counted(search.request.kicks, "kick", "kicks") : "walk";
  std::string text =
      summary_line("search", fmt::format("{}: {} compared, {} made", kind,
                                         counted(search.tried, "exchange", "exchanges"),
                                         counted(search.moves.size(), "move", "moves")));
  const auto share = [&](const Enclosure& part) {
    return certain(Enclosure(Integer(100), kMeasureBits) * part / (search.greedy - input), 4) + "%";
  };
  if (search.best) {
    text +=
        summary_line("", fmt::format("{} -> {}: {} of what the removals added; the best move "
                                     "took {} off",
                                     certain(search.greedy, kSummaryDigits),
                                     certain(search.now, kSummaryDigits), share(search.now - input),
                                     share(search.best->before - search.best->after)));
  }
  return search.optimality ? text + optimum_line(search) : text;
}

std::string stored_lines(const Stored& solid, bool verbose) {
  std::string text;
  if (const auto& planes = solid.planes) {
    text += summary_line("stored", fmt::format("planes in {}, {}; no point outside",
                                               name_in(kPrecisionNames, planes->precision),
                                               push_text(planes->growth, verbose)));
  }
  if (const auto& mesh = solid.mesh) {
    text += summary_line("stored", fmt::format("mesh in {}, {}; no point outside",
                                               name_in(kPrecisionNames, mesh->precision),
                                               push_text(mesh->growth, verbose)));
  }
  return text;
}

}  // namespace

std::string growth_percent(const Enclosure& before, const Enclosure& after) {
  const Enclosure hundred(Integer(100), kMeasureBits);
  return "+" + certain(hundred * (after - before) / before, 4) + "%";
}

std::string summary(const SimplifyResult& result, bool verbose) {
  std::string text =
      summary_line("input", input_line(result.input_points, result.hull_vertices,
                                       result.input_halfspaces, result.redundant.size()));
  text += summary_line("output", output_line(result));
  if (result.measure) {
    const auto& [before, after] = *result.measure;
    text += summary_line(result.cost == CostMeasure::Area ? "area" : "mean width",
                         growth_line(before, after, result.steps) + "; kept small");
  }
  if (result.limited) {
    const auto& [before, after] = *result.limited;
    text += summary_line(result.growth_of == CostMeasure::Area ? "area" : "mean width",
                         growth_line(before, after, result.steps) + "; its growth is limited");
  }
  text += summary_line(
      "volume", growth_line(result.input_volume.bounds, result.output_volume.bounds, result.steps));
  if (result.search) {
    text += search_lines(*result.search,
                         result.measure ? (*result.measure)[0] : result.input_volume.bounds);
  }
  text += ties_text(result.ties, result.steps, "several removals", "the first in order");
  if (result.float_bound) text += float_lines(result) + tie_line(result);
  text += summary_line("verified", verified_line(result, verbose));
  if (result.start && result.run) text += summary_line("proof", proof_text(*result.run));
  return text + stored_lines(result.solid, verbose);
}

std::string summary(const SceneTotals& totals, const Gaps& gaps) {
  const std::size_t steps = totals.steps;
  std::string output = counted(totals.output_halfspaces, "halfspace", "halfspaces") + " of " +
                       with_separators(totals.input_halfspaces);
  if (totals.stop == StopReason::GrowthLimit) output += growth_limit_text(totals.growth_bits);
  if (totals.stop == StopReason::AllUnbounded) {
    output += ": no removal in any part is found bounded";
  }
  if (totals.stop == StopReason::AllKeptOrUnbounded) {
    output += ": all others are kept, or no removal is found bounded";
  }
  std::string text = "all parts together\n" + summary_line("output", output);
  if (totals.measure) {
    text += summary_line(
        totals.cost == CostMeasure::Area ? "area" : "mean width",
        growth_line((*totals.measure)[0], (*totals.measure)[1], steps) + "; kept small");
  }
  if (totals.limited) {
    text += summary_line(
        totals.growth_of == CostMeasure::Area ? "area" : "mean width",
        growth_line((*totals.limited)[0], (*totals.limited)[1], steps) + "; its growth is limited");
  }
  text += summary_line("volume",
                       growth_line(totals.input_volume.bounds, totals.output_volume.bounds, steps));
  if (totals.engine != Engine::Float) {
    text += ties_text(totals.ties, totals.order.size(), "the next removals of several parts",
                      "the first part");
  }
  if (gaps.faces == 0) return text;
  return text + summary_line("gaps", fmt::format("{} of {} outside the solid of their part: proven",
                                                 with_separators(gaps.out_of_own.size()),
                                                 counted(gaps.faces, "face is", "faces are")));
}

std::string summary(const HullResult& result, int digits, bool verbose) {
  const Polytope& hull = result.solid.exact;
  std::string text = summary_line("input", input_line(result.input_points, hull.vertices.size(),
                                                      hull.planes.size(), result.redundant.size()));
  text += summary_line("edges", with_separators(result.edges));
  const char* const axes[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    text += summary_line(axes[k], to_decimal(result.box.low[k], digits) + " to " +
                                      to_decimal(result.box.high[k], digits));
  }
  text += summary_line("diameter", certain(result.diameter.bounds, digits) + " (of the box)");
  const auto add = [&](const char* name, const std::optional<Measured>& measured) {
    if (measured) text += summary_line(name, certain(measured->bounds, digits));
  };
  add("volume", result.volume);
  add("area", result.area);
  add("mean width", result.mean_width);
  if (result.mass) text += mass_lines(*result.mass, digits);
  return text + stored_lines(result.solid, verbose);
}

}  // namespace convexact
