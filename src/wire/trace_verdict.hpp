// SPDX-License-Identifier: MIT
// trace_verdict.hpp - the verdict on a removal order, for machines
// (docs/schema/trace_verdict.schema.json) and for people.
#pragma once
#include <string>

#include "convexact/verify_order.hpp"
#include "io/json_document.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kTraceRatingNames =
    name_table<TraceRating>({{TraceRating::Greedy, "greedy"},
                             {TraceRating::UpToRegret, "up-to-regret"},
                             {TraceRating::Undecided, "undecided"},
                             {TraceRating::NotGreedy, "not-greedy"},
                             {TraceRating::Unbounded, "unbounded"},
                             {TraceRating::Meaningless, "meaningless"}});
inline const char* name_of(TraceRating rating) { return name_in(kTraceRatingNames, rating); }

/// "greedy", "greedy up to regret 0.0123 (step 5)", "undecided at step 4", "not greedy from step
/// 7", "unbounded at step 7", "cannot be followed from step 7" or "unreadable"; " by area" if the
/// measure is not the volume; " without facet 12" if it is left out.
/// Steps are counted from 0.
[[nodiscard]] std::string verdict_line(const TraceVerdict& verdict);
/// The same without the measure and the facets.
[[nodiscard]] std::string verdict_line(const OrderRating& rating);

/// "0.0123"; of an interval around 0 its upper end: "at most 1.2e-1233".
[[nodiscard]] std::string regret_text(const Regret& regret);

/// How many steps are undecided, and what may decide them; empty if all are decided.
[[nodiscard]] std::string sentence_on_undecided(const TraceVerdict& verdict);
/// Which facets cause the violation, and the rating of the order without them.
[[nodiscard]] std::string sentence(const LeftOut& left_out, const TraceVerdict& verdict);
/// Which planes of the list are facet planes up to rounding only; empty if all are exactly.
[[nodiscard]] std::string sentence(const ListedPlanes& listed);

/// All steps with exact costs, of any length; without the stages.
[[nodiscard]] Json trace_verdict_json(const TraceVerdict& verdict);

/// The verdict, the violated claims with their witnesses, the worst steps, totals.
[[nodiscard]] std::string trace_verdict_text(const TraceVerdict& verdict);

}  // namespace convexact
