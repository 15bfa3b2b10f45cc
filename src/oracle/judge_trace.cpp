// SPDX-License-Identifier: MIT
#include "convexact/oracle/judge_trace.hpp"

#include <algorithm>

#include "confirm_costs.hpp"
#include "convexact/error.hpp"
#include "convexact/fast/filtered_loop.hpp"
#include "convexact/number/digits.hpp"
#include "trace_claims.hpp"

namespace convexact {
namespace {

constexpr int kCostDigits = 17;  // of costs in words

std::string id_text(HalfspaceId id) { return std::to_string(id.index()); }

std::string removal_text(HalfspaceId id, const std::optional<Rational>& cost) {
  if (!cost) return "removes " + id_text(id) + ", which leaves the solid unbounded";
  return "removes " + id_text(id) + " at cost " + to_decimal(*cost, kCostDigits);
}

std::string list_text(const std::vector<HalfspaceId>& ids) {
  std::string text = "{";
  for (const HalfspaceId id : ids) text += (text.size() > 1 ? ", " : "") + id_text(id);
  return text + "}";
}

// What an order removes, found in the solid.
class Resolver {
 public:
  Resolver(const std::vector<Halfspace>& halfspaces, const RemovalOrder& order);

  std::size_t size() const { return ids_.size(); }
  /// The facet of the solid; none if it has no such plane. Precondition: facet < size().
  std::optional<HalfspaceId> operator[](ListedFacet facet) const { return ids_[facet]; }

 private:
  std::vector<std::optional<HalfspaceId>> ids_;
};

Resolver::Resolver(const std::vector<Halfspace>& halfspaces, const RemovalOrder& order) {
  for (const std::optional<Halfspace>& plane : order.facets) {
    ids_.emplace_back();
    if (!plane) continue;
    const auto found = std::lower_bound(halfspaces.begin(), halfspaces.end(), *plane);
    if (found == halfspaces.end() || *found != *plane) continue;
    ids_.back() = HalfspaceId(static_cast<std::size_t>(found - halfspaces.begin()));
  }
}

class TraceJudge {
 public:
  TraceJudge(const DualHull& solid, const RationalPoint& center, const RemovalOrder& order,
             const JudgeOptions& options)
      : solid_(solid),
        center_(center),
        order_(order),
        options_(options),
        facets_(solid.halfspaces, order),
        dual_(FastDual::of(solid, center)),
        loop_(dual_, engine_options_, audit_),
        gone_at_(solid.halfspaces.size()) {}

  TraceVerdict run();

 private:
  bool follow(const OrderedRemoval& removal);
  std::optional<HalfspaceId> resolve(const OrderedRemoval& removal);
  JudgedStep judge(const OrderedRemoval& removal, HalfspaceId removed);
  void rate(const JudgedStep& judged);
  void violate_choice(TraceCode code, const JudgedStep& judged);
  void compare_claims(const OrderedRemoval& removal, const JudgedStep& judged);
  void compare_ties(const OrderedRemoval& removal, const JudgedStep& judged);
  void check_stop();
  void confirm() const;

  std::size_t step() const { return verdict_.steps.size(); }
  void violate(TraceCode code, const OrderedRemoval& removal, std::string found,
               std::string expected) {
    claims_.violate(code, {step(), removal.row, std::move(found), std::move(expected)});
  }
  void lower_rating(TraceRating rating) {
    if (verdict_.at) return;
    verdict_.rating = rating;
    verdict_.at = step();
  }

  const DualHull& solid_;
  const RationalPoint& center_;
  const RemovalOrder& order_;
  const JudgeOptions& options_;
  const Resolver facets_;
  const FastDual dual_;
  NoAudit audit_;
  const SimplifyOptions engine_options_;
  FilteredLoop<NoAudit> loop_;
  std::vector<std::optional<std::size_t>> gone_at_;
  TraceClaims claims_;
  TraceVerdict verdict_;
};

TraceVerdict TraceJudge::run() {
  verdict_.halfspaces = solid_.halfspaces;
  verdict_.removals = order_.removals.size();
  verdict_.max_regret = options_.max_regret;
  loop_.evaluate_all();
  const bool is_complete = std::all_of(order_.removals.begin(), order_.removals.end(),
                                       [&](const OrderedRemoval& r) { return follow(r); });
  if (is_complete) check_stop();
  if (verdict_.worst && !verdict_.at) verdict_.rating = TraceRating::UpToRegret;
  if (options_.confirm) confirm();
  verdict_.claims = std::move(claims_).list();
  return std::move(verdict_);
}

// Whether the order can be followed beyond this removal.
bool TraceJudge::follow(const OrderedRemoval& removal) {
  if (options_.stop != nullptr && *options_.stop) throw Error(ErrorCode::Stopped, "interrupted");
  const std::optional<HalfspaceId> removed = resolve(removal);
  if (!removed) {
    lower_rating(TraceRating::Meaningless);
    return false;
  }
  const JudgedStep judged = judge(removal, *removed);
  rate(judged);
  compare_claims(removal, judged);
  gone_at_[removed->index()] = step();
  verdict_.steps.push_back(judged);
  if (options_.progress) options_.progress(step());
  if (!judged.cost) return false;
  loop_.remove(*removed);
  return true;
}

std::optional<HalfspaceId> TraceJudge::resolve(const OrderedRemoval& removal) {
  if (removal.facet >= facets_.size()) {
    violate(TraceCode::IdOutOfRange, removal, removal.text,
            "an id below " + std::to_string(facets_.size()));
    return std::nullopt;
  }
  const std::optional<HalfspaceId> id = facets_[removal.facet];
  if (!id) {
    violate(TraceCode::PlaneUnknown, removal, removal.text, "a facet plane of the input, exactly");
    return std::nullopt;
  }
  if (const std::optional<std::size_t> gone = gone_at_[id->index()]) {
    violate(TraceCode::RemovedTwice, removal,
            "removes " + id_text(*id) + ", gone since step " + std::to_string(*gone),
            "a halfspace that is still there");
    return std::nullopt;
  }
  return id;
}

JudgedStep TraceJudge::judge(const OrderedRemoval& removal, HalfspaceId removed) {
  JudgedStep judged{removal.row, removed, {}, {}, {}, {}};
  if (const std::optional<HalfspaceId> cheapest = loop_.choose()) {
    judged.minimum = loop_.exact_cost(*cheapest);
    judged.tie = loop_.tie();
  }
  if (!loop_.is_bounded(removed)) return judged;
  const bool is_tied = std::find(judged.tie.begin(), judged.tie.end(), removed) != judged.tie.end();
  judged.cost = is_tied ? *judged.minimum : loop_.exact_cost(removed);
  judged.regret = relative_regret(*judged.cost, *judged.minimum);
  return judged;
}

void TraceJudge::rate(const JudgedStep& judged) {
  if (judged.is_other_tie()) ++verdict_.other_ties;
  if (judged.is_greedy()) return;
  if (!judged.cost) {
    violate_choice(TraceCode::Bounded, judged);
    lower_rating(TraceRating::Unbounded);
    return;
  }
  if (!verdict_.worst || *judged.regret > *verdict_.steps[*verdict_.worst].regret) {
    verdict_.worst = step();
  }
  if (*judged.regret <= options_.max_regret) return;
  violate_choice(TraceCode::Greedy, judged);
  lower_rating(TraceRating::NotGreedy);
}

void TraceJudge::violate_choice(TraceCode code, const JudgedStep& judged) {
  claims_.violate(code, {step(), judged.row, removal_text(judged.removed, judged.cost),
                         judged.tie.empty() ? "the end: every removal is unbounded"
                                            : removal_text(judged.tie.front(), judged.minimum)});
}

void TraceJudge::compare_claims(const OrderedRemoval& removal, const JudgedStep& judged) {
  const StepClaim& claim = removal.claim;
  if (claim.cost) {
    claims_.ask(TraceCode::Cost);
    if (claim.cost != judged.cost) {
      violate(TraceCode::Cost, removal, to_string(*claim.cost),
              judged.cost ? to_string(*judged.cost) : "unbounded");
    }
  }
  if (claim.tie) {
    claims_.ask(TraceCode::Ties);
    compare_ties(removal, judged);
  }
  if (claim.left) {
    claims_.ask(TraceCode::Left);
    const std::size_t left = solid_.halfspaces.size() - step() - 1;
    if (*claim.left != left) {
      violate(TraceCode::Left, removal, std::to_string(*claim.left), std::to_string(left));
    }
  }
}

void TraceJudge::compare_ties(const OrderedRemoval& removal, const JudgedStep& judged) {
  std::vector<HalfspaceId> claimed;
  for (const ListedFacet facet : *removal.claim.tie) {
    const auto id = facet < facets_.size() ? facets_[facet] : std::nullopt;
    if (!id) {
      violate(TraceCode::Ties, removal, "an entry that is no facet of the input",
              list_text(judged.tie));
      return;
    }
    claimed.push_back(*id);
  }
  std::sort(claimed.begin(), claimed.end());
  if (claimed != judged.tie) {
    violate(TraceCode::Ties, removal, list_text(claimed), list_text(judged.tie));
  }
}

void TraceJudge::check_stop() {
  if (order_.stop != StopReason::AllUnbounded) return;
  claims_.ask(TraceCode::Stop);
  if (const std::optional<HalfspaceId> missed = loop_.choose()) {
    claims_.violate(TraceCode::Stop, {step(),
                                      {},
                                      "ends because every removal is unbounded",
                                      removal_text(*missed, loop_.exact_cost(*missed))});
  }
}

void TraceJudge::confirm() const {
  const std::vector<JudgedStep>& steps = verdict_.steps;
  if (steps.empty()) return;
  const bool is_bounded = steps.back().cost.has_value();
  const std::size_t last = steps.size() - 1;
  confirm_step(solid_.halfspaces, center_, steps,
               is_bounded ? verdict_.worst.value_or(last) : last);
  confirm_sum(solid_.halfspaces, center_, steps);
}

}  // namespace

std::optional<Rational> relative_regret(const Rational& cost, const Rational& minimum) {
  if (cost == minimum) return Rational(0);
  if (minimum == 0) return std::nullopt;
  return Rational((cost - minimum) / minimum);
}

bool TraceVerdict::holds() const {
  return std::none_of(claims.begin(), claims.end(),
                      [](const TraceClaim& claim) { return claim.status == Status::Violated; });
}

TraceVerdict judge_trace(const DualHull& solid, const RationalPoint& center,
                         const RemovalOrder& order, const JudgeOptions& options) {
  if (options.max_regret < 0) {
    throw Error(ErrorCode::InvalidArgument, "the regret that is allowed is negative");
  }
  return TraceJudge(solid, center, order, options).run();
}

TraceVerdict unreadable_trace(const DualHull& solid, const std::string& what,
                              std::optional<std::size_t> line) {
  TraceVerdict verdict;
  verdict.rating = TraceRating::Meaningless;
  verdict.halfspaces = solid.halfspaces;
  TraceClaims claims;
  claims.violate(TraceCode::Readable, {{}, line, what, "a trace, planes or facet ids"});
  claims.give_up();
  verdict.claims = std::move(claims).list();
  return verdict;
}

}  // namespace convexact
