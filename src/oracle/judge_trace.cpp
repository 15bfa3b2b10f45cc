// SPDX-License-Identifier: MIT
// judge_trace(): follows an order of removals and compares every step with the cheapest one.
#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/verify_run.hpp"
#include "convexact/watch.hpp"
#include "fast/filtered_loop.hpp"
#include "oracle/facet_match.hpp"
#include "oracle/removal_cost.hpp"
#include "oracle/trace_verdict.hpp"

namespace convexact {
namespace {

constexpr int kCostDigits = 17;  // of costs in words

std::string id_text(HalfspaceId id) { return std::to_string(id.index()); }

std::string removal_text(HalfspaceId id, const std::optional<Cost>& cost) {
  if (!cost) return "removes " + id_text(id) + ", which leaves the solid unbounded";
  return "removes " + id_text(id) + " at cost " + to_decimal(cost->rational(), kCostDigits);
}

std::string list_text(const std::vector<HalfspaceId>& ids) {
  return "{" + ids_text(ids, ", ") + "}";
}

enum class TraceCode : unsigned char {
  Readable,
  PlaneUnknown,
  IdOutOfRange,
  RemovedTwice,
  Bounded,
  Greedy,
  Cost,
  Ties,
  Left,
  Stop,
};

// One claim per code; of each the first violation is kept.
class TraceClaims {
 public:
  void violate(TraceCode code, TraceWitness witness) {
    TraceClaim& claim = at(code);
    if (claim.status == Status::Violated) return;
    claim.status = Status::Violated;
    claim.witness = std::move(witness);
  }
  // A claim that only some files make: it holds unless it is violated.
  void ask(TraceCode code) {
    if (at(code).status == Status::NotAsked) at(code).status = Status::Holds;
  }
  // The steps cannot be judged.
  void give_up() {
    for (TraceClaim& claim : claims_) {
      if (claim.status == Status::Holds) claim.status = Status::NotAsked;
    }
  }
  std::vector<TraceClaim> list() && { return std::move(claims_); }

 private:
  TraceClaim& at(TraceCode code) { return claims_[static_cast<std::size_t>(code)]; }

  std::vector<TraceClaim> claims_ = {{"trace-readable"},
                                     {"trace-plane-unknown"},
                                     {"trace-id-out-of-range"},
                                     {"trace-removed-twice"},
                                     {"trace-bounded"},
                                     {"trace-greedy"},
                                     {"trace-cost", Status::NotAsked},
                                     {"trace-ties", Status::NotAsked},
                                     {"trace-left", Status::NotAsked},
                                     {"trace-stop", Status::NotAsked}};
};

class TraceJudge {
 public:
  /// Why an order is followed: for the verdict; to collect the facets that it never removes and
  /// that make it too dear, each of which goes as soon as it is found; or for a rating only.
  enum class Purpose { Verdict, Collect, Rate };

  TraceJudge(const DualHull& dual, const RationalPoint& center, const RemovalOrder& order,
             const JudgeOptions& options, Purpose purpose = Purpose::Verdict)
      : dual_(dual),
        center_(center),
        order_(order),
        options_(options),
        purpose_(purpose),
        facets_(dual, order, options.unit),
        fast_(FastDual::of(dual, center)),
        loop_(fast_, engine_options_),
        gone_at_(dual.halfspaces.size()),
        is_removed_(dual.halfspaces.size(), false) {}

  TraceVerdict run();

 private:
  void leave_out();
  void remove_unlisted(HalfspaceId id);
  bool is_too_dear(HalfspaceId removed, HalfspaceId cheapest);
  bool is_blamed(const JudgedStep& judged) const;
  std::optional<LeftOut> find_never_removed() const;
  bool follow(const OrderedStep& removal);
  std::optional<HalfspaceId> resolve(const OrderedStep& removal);
  JudgedStep judge(const OrderedStep& removal, HalfspaceId removed);
  void rate(const JudgedStep& judged);
  void violate_choice(TraceCode code, const JudgedStep& judged);
  void compare_claims(const OrderedStep& removal, const JudgedStep& judged);
  void compare_ties(const OrderedStep& removal, const JudgedStep& judged);
  void check_stop();
  void confirm() const;

  std::size_t step() const { return verdict_.steps.size(); }
  void violate(TraceCode code, const OrderedStep& removal, std::string found,
               std::string expected) {
    claims_.violate(code, {step(), removal.row, std::move(found), std::move(expected)});
  }
  void lower_rating(TraceRating rating) {
    if (verdict_.at) return;
    verdict_.rating = rating;
    verdict_.at = step();
  }

  const DualHull& dual_;
  const RationalPoint& center_;
  const RemovalOrder& order_;
  const JudgeOptions& options_;
  const Purpose purpose_;
  const NamedFacets facets_;
  const FastDual fast_;
  const SimplifyOptions engine_options_;
  FilteredLoop loop_;
  std::vector<std::optional<std::size_t>> gone_at_;
  std::vector<bool> is_removed_;  // anywhere in the order
  TraceClaims claims_;
  TraceVerdict verdict_;
};

TraceVerdict TraceJudge::run() {
  verdict_.halfspaces = dual_.halfspaces;
  verdict_.removals = order_.steps.size();
  verdict_.max_regret = options_.max_regret;
  verdict_.listed = facets_.listed();
  loop_.evaluate_all();
  leave_out();
  const bool is_complete = std::all_of(order_.steps.begin(), order_.steps.end(),
                                       [&](const OrderedStep& r) { return follow(r); });
  if (is_complete) check_stop();
  if (verdict_.worst && !verdict_.at) verdict_.rating = TraceRating::UpToRegret;
  if (purpose_ == Purpose::Verdict) {
    verdict_.never_removed = find_never_removed();
    if (options_.confirm) confirm();
  }
  verdict_.claims = std::move(claims_).list();
  return std::move(verdict_);
}

void TraceJudge::leave_out() {
  const auto refuse = [](HalfspaceId id, const std::string& why) {
    throw Error(ErrorCode::InvalidArgument, "facet " + id_text(id) + " is to be left out" + why);
  };
  for (const OrderedStep& removal : order_.steps) {
    if (const auto id = facets_.find(removal.step.removed)) is_removed_[id->index()] = true;
  }
  for (const HalfspaceId id : options_.left_out) {
    if (id.index() >= is_removed_.size()) {
      refuse(id, ": expected an id below " + std::to_string(is_removed_.size()));
    }
    if (is_removed_[id.index()]) refuse(id, ", and the order removes it");
    const auto& gone = verdict_.left_out;
    if (std::find(gone.begin(), gone.end(), id) != gone.end()) continue;
    if (!loop_.is_bounded(id)) refuse(id, ", and without it the input is unbounded");
    remove_unlisted(id);
  }
}

void TraceJudge::remove_unlisted(HalfspaceId id) {
  loop_.remove(id);
  verdict_.left_out.push_back(id);
}

// Whether a step is too dear, and a facet that the order never removes is as cheap as can be.
bool TraceJudge::is_blamed(const JudgedStep& judged) const {
  if (judged.regret && *judged.regret <= options_.max_regret) return false;
  return std::any_of(judged.tie.begin(), judged.tie.end(),
                     [&](HalfspaceId i) { return !is_removed_[i.index()]; });
}

// The order twice more: to collect the facets, and on the solid without them.
std::optional<LeftOut> TraceJudge::find_never_removed() const {
  const auto& steps = verdict_.steps;
  if (std::none_of(steps.begin(), steps.end(), [&](auto& step) { return is_blamed(step); })) {
    return std::nullopt;
  }
  JudgeOptions without = options_;
  without.left_out = TraceJudge(dual_, center_, order_, options_, Purpose::Collect).run().left_out;
  LeftOut found;
  const auto first = without.left_out.begin() + std::ptrdiff_t(verdict_.left_out.size());
  found.facets.assign(first, without.left_out.end());
  if (found.facets.empty()) return std::nullopt;  // only level with one that is removed later
  std::sort(found.facets.begin(), found.facets.end());
  const TraceVerdict others = TraceJudge(dual_, center_, order_, without, Purpose::Rate).run();
  const auto is_found = [&](HalfspaceId i) {
    return std::binary_search(found.facets.begin(), found.facets.end(), i);
  };
  for (const JudgedStep& step : steps) {
    found.steps += is_blamed(step) && std::any_of(step.tie.begin(), step.tie.end(), is_found);
  }
  found.unlisted = facets_.count_unlisted(found.facets);
  static_cast<OrderRating&>(found) = others;
  return found;
}

// Whether the order can be followed beyond this removal.
bool TraceJudge::follow(const OrderedStep& removal) {
  Watch(options_.stop).ask();
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

std::optional<HalfspaceId> TraceJudge::resolve(const OrderedStep& removal) {
  if (removal.step.removed.index() >= facets_.size()) {
    violate(TraceCode::IdOutOfRange, removal, removal.text,
            "an id below " + std::to_string(facets_.size()));
    return std::nullopt;
  }
  const std::optional<HalfspaceId> id = facets_.find(removal.step.removed);
  if (!id) {
    violate(TraceCode::PlaneUnknown, removal, facets_.found(removal), facets_.expected(removal));
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

JudgedStep TraceJudge::judge(const OrderedStep& removal, HalfspaceId removed) {
  JudgedStep judged{removal.row, removed, {}, {}, {}, {}};
  std::optional<HalfspaceId> cheapest = loop_.choose();
  for (; purpose_ == Purpose::Collect && cheapest && !is_removed_[cheapest->index()] &&
         is_too_dear(removed, *cheapest);
       cheapest = loop_.choose()) {
    remove_unlisted(*cheapest);
  }
  if (cheapest) {
    judged.minimum = loop_.exact_cost(*cheapest);
    judged.tie = loop_.tie();
  }
  if (!loop_.is_bounded(removed)) return judged;
  const bool is_tied = std::find(judged.tie.begin(), judged.tie.end(), removed) != judged.tie.end();
  judged.cost = is_tied ? *judged.minimum : loop_.exact_cost(removed);
  judged.regret = relative_regret(*judged.cost, *judged.minimum);
  return judged;
}

bool TraceJudge::is_too_dear(HalfspaceId removed, HalfspaceId cheapest) {
  if (!loop_.is_bounded(removed)) return true;
  const auto regret = relative_regret(loop_.exact_cost(removed), loop_.exact_cost(cheapest));
  return !regret || *regret > options_.max_regret;
}

void TraceJudge::rate(const JudgedStep& judged) {
  if (judged.is_other_tie()) ++verdict_.other_ties;
  if (judged.is_greedy()) return;
  if (!judged.cost) {
    violate_choice(TraceCode::Bounded, judged);
    lower_rating(TraceRating::Unbounded);
    return;
  }
  if (!verdict_.worst || *judged.regret > *verdict_.worst_regret) {
    verdict_.worst = step();
    verdict_.worst_regret = judged.regret;
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

void TraceJudge::compare_claims(const OrderedStep& removal, const JudgedStep& judged) {
  const Step& claim = removal.step;
  if (claim.cost) {
    claims_.ask(TraceCode::Cost);
    if (claim.cost != judged.cost) {
      violate(TraceCode::Cost, removal, to_string(claim.cost->rational()),
              judged.cost ? to_string(judged.cost->rational()) : "unbounded");
    }
  }
  if (removal.claims_tie) {
    claims_.ask(TraceCode::Ties);
    compare_ties(removal, judged);
  }
  if (removal.claims_left) {
    claims_.ask(TraceCode::Left);
    const std::size_t left = dual_.halfspaces.size() - verdict_.left_out.size() - step() - 1;
    if (claim.left != left) {
      violate(TraceCode::Left, removal, std::to_string(claim.left), std::to_string(left));
    }
  }
}

void TraceJudge::compare_ties(const OrderedStep& removal, const JudgedStep& judged) {
  std::vector<HalfspaceId> claimed;
  for (const HalfspaceId facet : removal.step.tie) {
    const std::optional<HalfspaceId> id = facets_.find(facet);
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
  if (verdict_.steps.empty()) return;
  const bool is_bounded = verdict_.steps.back().cost.has_value();
  const std::size_t last = verdict_.steps.size() - 1;
  confirm_step(verdict_, center_, is_bounded ? verdict_.worst.value_or(last) : last);
  confirm_sum(verdict_, center_);
}

}  // namespace

std::optional<Rational> relative_regret(const Cost& cost, const Cost& minimum) {
  if (cost == minimum) return Rational(0);
  const Rational &paid = cost.rational(), &least = minimum.rational();
  if (least == 0) return std::nullopt;
  return Rational((paid - least) / least);
}

bool TraceVerdict::holds() const {
  return std::none_of(claims.begin(), claims.end(),
                      [](const TraceClaim& claim) { return claim.status == Status::Violated; });
}

TraceVerdict judge_trace(const DualHull& dual, const RationalPoint& center,
                         const RemovalOrder& order, const JudgeOptions& options) {
  if (options.max_regret < 0) {
    throw Error(ErrorCode::InvalidArgument, "the regret that is allowed is negative");
  }
  return TraceJudge(dual, center, order, options).run();
}

TraceVerdict unreadable_trace(const DualHull& dual, const std::string& what,
                              std::optional<std::size_t> line) {
  TraceVerdict verdict;
  verdict.rating = TraceRating::Meaningless;
  verdict.halfspaces = dual.halfspaces;
  TraceClaims claims;
  claims.violate(TraceCode::Readable, {{}, line, what, "a trace, planes or facet ids"});
  claims.give_up();
  verdict.claims = std::move(claims).list();
  return verdict;
}

}  // namespace convexact
