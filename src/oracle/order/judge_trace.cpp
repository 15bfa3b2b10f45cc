// SPDX-License-Identifier: MIT
// judge_trace(): follows an order of removals and compares every step with the cheapest one.
#include <algorithm>
#include <functional>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/verify_order.hpp"
#include "fast/filtered_loop.hpp"
#include "oracle/order/facet_match.hpp"
#include "oracle/order/removal_cost.hpp"
#include "oracle/order/trace_claims.hpp"

namespace convexact {
namespace {

std::string id_text(HalfspaceId id) { return std::to_string(id.index()); }

class TraceJudge {
 public:
  /// Why an order is followed: for the verdict; to collect the facets that it never removes and
  /// that make it too dear, each of which is removed as soon as it is found; or for a rating only.
  enum class Purpose { Verdict, Collect, Rate };

  TraceJudge(const DualHull& dual, const RationalPoint& center, const RemovalOrder& order,
             const JudgeOptions& options, Purpose purpose = Purpose::Verdict)
      : dual_(dual),
        center_(center),
        order_(order),
        options_(options),
        purpose_(purpose),
        facets_(dual, order, options.unit),
        watch_(options.watch),
        engine_options_{.keep = options.kept,
                        .cost = order.measure,
                        .compare = options.compare,
                        .watch = options.watch},
        fast_(FastDual::of(dual, center)),
        loop_(fast_, engine_options_),
        stated_(order, facets_, options, loop_, claims_),
        gone_at_(dual.halfspaces.size()),
        is_removed_(dual.halfspaces.size(), false) {}

  TraceVerdict run();

 private:
  void leave_out();
  bool is_kept(HalfspaceId i) const {
    return std::find(options_.kept.begin(), options_.kept.end(), i) != options_.kept.end();
  }
  void remove_unlisted(HalfspaceId id);
  bool is_too_dear(HalfspaceId removed, HalfspaceId cheapest);
  std::optional<bool> is_within(const Cost& cost, const Cost& minimum,
                                const std::optional<Regret>& regret) const;
  void judge_open_tie(JudgedStep& judged);
  bool is_blamed(const JudgedStep& judged) const;
  std::optional<LeftOut> find_never_removed() const;
  bool follow(const OrderedStep& removal);
  std::optional<HalfspaceId> resolve(const OrderedStep& removal);
  JudgedStep judge(const OrderedStep& removal, HalfspaceId removed);
  void rate(const JudgedStep& judged);
  TraceWitness witness_of(const JudgedStep& judged) const;
  void violate_choice(TraceCode code, const JudgedStep& judged);
  std::vector<bool> left_at_the_end() const;
  void confirm() const;

  std::size_t step() const { return verdict_.steps.size(); }
  Order order_of(const Cost& a, const Cost& b) const {
    return compare(a, b, options_.compare, watch_).order;
  }
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
  const Watch watch_;
  const SimplifyOptions engine_options_;
  const FastDual fast_;
  FilteredLoop loop_;
  TraceClaims claims_;
  StatedClaims stated_;
  std::vector<std::optional<std::size_t>> gone_at_;
  std::vector<bool> is_removed_;                // anywhere in the order
  std::optional<std::size_t> first_undecided_;  // step
  TraceVerdict verdict_;
};

TraceVerdict TraceJudge::run() {
  verdict_.halfspaces = dual_.halfspaces;
  verdict_.removals = order_.steps.size();
  verdict_.max_regret = options_.max_regret;
  verdict_.measure = order_.measure;
  verdict_.tie_bits = options_.compare.bits;
  verdict_.listed = facets_.listed();
  verdict_.kept = options_.kept;
  stated_.compare_kept();
  loop_.evaluate_all();
  leave_out();
  const bool is_complete = std::all_of(order_.steps.begin(), order_.steps.end(),
                                       [&](const OrderedStep& r) { return follow(r); });
  if (is_complete) stated_.compare_stop();
  if (is_complete && purpose_ == Purpose::Verdict) {
    stated_.compare_moves(dual_.halfspaces, left_at_the_end(), center_);
  }
  if (verdict_.worst && !verdict_.at) verdict_.rating = TraceRating::UpToRegret;
  if (first_undecided_ && !verdict_.at) {
    verdict_.rating = TraceRating::Undecided;
    verdict_.at = first_undecided_;
  }
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
    if (is_kept(id)) refuse(id, ", and to be kept");
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

// Whether a step is too dear, and a facet that the order never removes is one of the cheapest.
bool TraceJudge::is_blamed(const JudgedStep& judged) const {
  if (judged.is_within.value_or(true)) return false;
  return std::any_of(judged.tie.begin(), judged.tie.end(),
                     [&](HalfspaceId i) { return !is_removed_[i.index()]; });
}

// Follows the order twice more: to collect the facets, and on the solid without them.
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
  if (found.facets.empty()) return std::nullopt;  // only tied with one that is removed later
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
  watch_.ask();
  const std::optional<HalfspaceId> removed = resolve(removal);
  if (!removed) {
    lower_rating(TraceRating::Meaningless);
    return false;
  }
  const JudgedStep judged = judge(removal, *removed);
  rate(judged);
  stated_.compare_step(removal, judged,
                       dual_.halfspaces.size() - verdict_.left_out.size() - step() - 1);
  gone_at_[removed->index()] = step();
  verdict_.steps.push_back(judged);
  watch_.report(step(), dual_.halfspaces.size() - verdict_.left_out.size() - 4);
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
  if (is_kept(*id)) {
    violate(TraceCode::Kept, removal, "removes " + id_text(*id), "a facet that is not to be kept");
    return std::nullopt;
  }
  return id;
}

JudgedStep TraceJudge::judge(const OrderedStep& removal, HalfspaceId removed) {
  JudgedStep judged{.row = removal.row, .removed = removed};
  std::optional<HalfspaceId> cheapest = loop_.choose();
  for (; purpose_ == Purpose::Collect && cheapest && !is_removed_[cheapest->index()] &&
         is_too_dear(removed, *cheapest);
       cheapest = loop_.choose()) {
    remove_unlisted(*cheapest);
  }
  if (cheapest) {
    judged.minimum = loop_.cost(*cheapest);
    judged.tie = loop_.tie();
    judged.tie_evidence = loop_.tie_evidence();
  }
  if (!loop_.is_bounded(removed)) return judged;
  const bool is_tied = std::find(judged.tie.begin(), judged.tie.end(), removed) != judged.tie.end();
  if (judged.tie_evidence.proof == TieProof::Undecided) {
    judged.cost = loop_.cost(removed);
    judge_open_tie(judged);
    return judged;
  }
  judged.cost = is_tied ? *judged.minimum : loop_.cost(removed);
  judged.regret = is_tied
                      ? Rational(0)
                      : relative_regret(*judged.cost, *judged.minimum, options_.compare, watch_);
  judged.is_within = is_within(*judged.cost, *judged.minimum, judged.regret);
  return judged;
}

// Compares the removal with each one that may be the cheapest: a proof against any of them counts.
void TraceJudge::judge_open_tie(JudgedStep& judged) {
  judged.regret = Rational(0);
  judged.is_within = true;
  for (const HalfspaceId i : judged.tie) {
    if (i == judged.removed) continue;
    const Cost minimum = loop_.cost(i);
    const Order order = order_of(*judged.cost, minimum);
    if (order == Order::Less || order == Order::Equal) continue;
    const auto regret = relative_regret(*judged.cost, minimum, options_.compare, watch_);
    const std::optional<bool> is_near = is_within(*judged.cost, minimum, regret);
    if (!is_near.value_or(true) || judged.is_within.value_or(false)) judged.is_within = is_near;
    if (order == Order::Greater || *judged.regret == 0) judged.regret = regret;
    if (order == Order::Greater) judged.minimum = minimum;
  }
}

std::optional<bool> TraceJudge::is_within(const Cost& cost, const Cost& minimum,
                                          const std::optional<Regret>& regret) const {
  if (!regret) return false;
  if (const Rational* exact = regret->exact()) return *exact <= options_.max_regret;
  Cost limit = minimum;
  limit *= Rational(1 + options_.max_regret);
  switch (order_of(cost, limit)) {
    case Order::Less:
    case Order::Equal:
      return true;
    case Order::Greater:
      return false;
    case Order::Undecided:
      break;
  }
  return std::nullopt;
}

bool TraceJudge::is_too_dear(HalfspaceId removed, HalfspaceId cheapest) {
  if (!loop_.is_bounded(removed)) return true;
  const Cost cost = loop_.cost(removed), minimum = loop_.cost(cheapest);
  const auto regret = relative_regret(cost, minimum, options_.compare, watch_);
  return !is_within(cost, minimum, regret).value_or(true);
}

void TraceJudge::rate(const JudgedStep& judged) {
  if (judged.is_other_tie()) ++verdict_.other_ties;
  if (judged.is_greedy()) return;
  if (!judged.cost) {
    violate_choice(TraceCode::Bounded, judged);
    lower_rating(TraceRating::Unbounded);
    return;
  }
  const bool is_known = judged.is_within.has_value() || judged.regret->is_positive();
  if (is_known && (!verdict_.worst || judged.regret->is_above(*verdict_.worst_regret))) {
    verdict_.worst = step();
    verdict_.worst_regret = judged.regret;
  }
  if (!judged.is_within) {
    ++verdict_.undecided;
    if (!first_undecided_) first_undecided_ = step();
    claims_.leave_open(TraceCode::Greedy, witness_of(judged));
    return;
  }
  if (*judged.is_within) return;
  violate_choice(TraceCode::Greedy, judged);
  lower_rating(TraceRating::NotGreedy);
}

TraceWitness TraceJudge::witness_of(const JudgedStep& judged) const {
  return {step(), judged.row, removal_text(judged.removed, judged.cost),
          judged.tie.empty() ? "the end: every removal is unbounded"
                             : removal_text(judged.tie.front(), judged.minimum)};
}

void TraceJudge::violate_choice(TraceCode code, const JudgedStep& judged) {
  claims_.violate(code, witness_of(judged));
}

// Of each facet: whether it is left after the last step.
std::vector<bool> TraceJudge::left_at_the_end() const {
  std::vector<bool> is_there(dual_.halfspaces.size(), true);
  for (const HalfspaceId id : verdict_.left_out) is_there[id.index()] = false;
  for (const JudgedStep& step : verdict_.steps) is_there[step.removed.index()] = false;
  return is_there;
}

void TraceJudge::confirm() const {
  if (verdict_.steps.empty()) return;
  const bool is_bounded = verdict_.steps.back().cost.has_value();
  const std::size_t last = verdict_.steps.size() - 1;
  confirm_step(verdict_, center_, is_bounded ? verdict_.worst.value_or(last) : last, watch_);
  confirm_sum(verdict_, center_, watch_);
}

}  // namespace

bool TraceVerdict::holds() const {
  return std::none_of(claims.begin(), claims.end(),
                      [](const TraceClaim& claim) { return claim.status == Status::Violated; });
}

TraceVerdict judge_trace(const DualHull& dual, const RationalPoint& center,
                         const RemovalOrder& order, const JudgeOptions& options) {
  if (options.max_regret < 0) {
    throw Error(ErrorCode::InvalidArgument, "the regret that is allowed is negative");
  }
  const std::vector<HalfspaceId>& kept = options.kept;
  const std::size_t facets = dual.halfspaces.size();
  if (std::adjacent_find(kept.begin(), kept.end(), std::greater_equal<>()) != kept.end() ||
      (!kept.empty() && kept.back().index() >= facets)) {
    throw Error(ErrorCode::InvalidArgument, "the facets to be kept: expected different ids below " +
                                                std::to_string(facets) + ", ascending");
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
