// SPDX-License-Identifier: MIT
#include "oracle/order/trace_claims.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "fast/filtered_loop.hpp"
#include "io/names.hpp"
#include "number/precision.hpp"
#include "oracle/order/removal_cost.hpp"

namespace convexact {
namespace {

constexpr auto kTraceCodeNames =
    name_table<TraceCode>({{TraceCode::Readable, "trace-readable"},
                           {TraceCode::PlaneUnknown, "trace-plane-unknown"},
                           {TraceCode::IdOutOfRange, "trace-id-out-of-range"},
                           {TraceCode::RemovedTwice, "trace-removed-twice"},
                           {TraceCode::Bounded, "trace-bounded"},
                           {TraceCode::Greedy, "trace-greedy"},
                           {TraceCode::Cost, "trace-cost"},
                           {TraceCode::Ties, "trace-ties"},
                           {TraceCode::Left, "trace-left"},
                           {TraceCode::Kept, "trace-kept"},
                           {TraceCode::Stop, "trace-stop"},
                           {TraceCode::Moves, "trace-moves"}});
// Claims are found by their place.
static_assert(kTraceCodeNames.back().first == TraceCode(kTraceCodeNames.size() - 1));

// Both to so many digits that they differ, if they do. Volumes are fractions instead.
std::array<std::string, 2> distinct_texts(const Cost& a, const Cost& b) {
  if (a.measure() == CostMeasure::Volume) return {to_string(a.rational()), to_string(b.rational())};
  constexpr int kMostDigits = 1000;
  for (int digits = kDigits;; digits *= 4) {
    std::array<std::string, 2> texts{a.decimal(digits), b.decimal(digits)};
    if (texts[0] != texts[1] || digits > kMostDigits) return texts;
  }
}

std::string list_text(const std::vector<HalfspaceId>& ids) {
  return "{" + ids_text(ids, ", ") + "}";
}

}  // namespace

const char* name_of(TraceCode code) { return name_in(kTraceCodeNames, code); }

std::string removal_text(HalfspaceId id, const std::optional<Cost>& cost) {
  const std::string removes = "removes " + std::to_string(id.index());
  if (!cost) return removes + ", which leaves the solid unbounded";
  return removes + " at cost " + cost->decimal(kDigits);
}

// ---- The claims

TraceClaims::TraceClaims() {
  for (const auto& [code, name] : kTraceCodeNames) {
    claims_.push_back({code, is_of_every_order(code) ? Status::Holds : Status::NotAsked});
  }
}

void TraceClaims::violate(TraceCode code, TraceWitness witness) {
  TraceClaim& claim = at(code);
  if (claim.status == Status::Violated) return;
  claim.status = Status::Violated;
  claim.witness = std::move(witness);
}

void TraceClaims::leave_open(TraceCode code, TraceWitness witness) {
  TraceClaim& claim = at(code);
  if (claim.status == Status::Violated || claim.status == Status::Undecided) return;
  claim.status = Status::Undecided;
  claim.witness = std::move(witness);
}

void TraceClaims::ask(TraceCode code) {
  if (at(code).status == Status::NotAsked) at(code).status = Status::Holds;
}

void TraceClaims::give_up() {
  for (TraceClaim& claim : claims_) {
    if (claim.status == Status::Holds) claim.status = Status::NotAsked;
  }
}

// ---- What the order states

void StatedClaims::compare_kept() {
  if (order_.kept || !options_.kept.empty()) claims_.ask(TraceCode::Kept);
  if (!order_.kept) return;
  std::vector<HalfspaceId> stated;
  for (const HalfspaceId facet : *order_.kept) {
    const std::optional<HalfspaceId> id = facets_.find(facet);
    if (!id) {
      claims_.violate(
          TraceCode::Kept,
          {{}, {}, "keeps a plane that is no facet of the input", list_text(options_.kept)});
      return;
    }
    stated.push_back(*id);
  }
  std::sort(stated.begin(), stated.end());
  if (stated == options_.kept) return;
  claims_.violate(
      TraceCode::Kept,
      {{}, {}, "keeps " + list_text(stated), list_text(options_.kept) + ", as --keep selects"});
}

void StatedClaims::compare_step(const OrderedStep& stated, const JudgedStep& judged,
                                std::size_t left) {
  const Step& claim = stated.step;
  if (claim.cost) {
    claims_.ask(TraceCode::Cost);
    compare_cost(stated, judged);
  }
  if (stated.claims_tie) {
    claims_.ask(TraceCode::Ties);
    compare_ties(stated, judged);
  }
  if (stated.claims_left) {
    claims_.ask(TraceCode::Left);
    if (claim.left != left) {
      violate(TraceCode::Left, stated, std::to_string(claim.left), std::to_string(left));
    }
  }
  ++step_;
}

void StatedClaims::compare_cost(const OrderedStep& stated, const JudgedStep& judged) {
  const Cost& claimed = *stated.step.cost;
  if (!judged.cost) {
    const std::string text = claimed.measure() == CostMeasure::Volume
                                 ? to_string(claimed.rational())
                                 : claimed.decimal(kDigits);
    return violate(TraceCode::Cost, stated, text, "unbounded");
  }
  const Order order = order_of(claimed, *judged.cost);
  if (order == Order::Equal) return;
  const auto [found, expected] = distinct_texts(claimed, *judged.cost);
  if (order == Order::Undecided) return leave_open(TraceCode::Cost, stated, found, expected);
  violate(TraceCode::Cost, stated, found, expected);
}

void StatedClaims::compare_ties(const OrderedStep& stated, const JudgedStep& judged) {
  std::vector<HalfspaceId> claimed;
  for (const HalfspaceId facet : stated.step.tie) {
    const std::optional<HalfspaceId> id = facets_.find(facet);
    if (!id) {
      violate(TraceCode::Ties, stated, "an entry that is no facet of the input",
              list_text(judged.tie));
      return;
    }
    claimed.push_back(*id);
  }
  std::sort(claimed.begin(), claimed.end());
  const bool is_open = judged.tie_evidence.proof == TieProof::Undecided;
  if (claimed != judged.tie && !(is_open && may_be_tie(claimed, judged.tie))) {
    violate(TraceCode::Ties, stated, list_text(claimed), list_text(judged.tie));
  } else if (is_open) {
    leave_open(TraceCode::Ties, stated, list_text(claimed),
               list_text(judged.tie) + ", as far as is known");
  }
}

// Whether some of those that may be the cheapest can be all that are: at least one, and with each
// one all that are proven to cost the same.
bool StatedClaims::may_be_tie(const std::vector<HalfspaceId>& claimed,
                              const std::vector<HalfspaceId>& tie) {
  if (claimed.empty() || !std::includes(tie.begin(), tie.end(), claimed.begin(), claimed.end())) {
    return false;
  }
  return std::all_of(tie.begin(), tie.end(), [&](HalfspaceId i) {
    if (std::binary_search(claimed.begin(), claimed.end(), i)) return true;
    const Cost cost = loop_.cost(i);
    return std::none_of(claimed.begin(), claimed.end(), [&](HalfspaceId j) {
      return order_of(loop_.cost(j), cost) == Order::Equal;
    });
  });
}

void StatedClaims::compare_stop() {
  if (order_.stop != StopReason::AllUnbounded && order_.stop != StopReason::AllKeptOrUnbounded) {
    return;
  }
  claims_.ask(TraceCode::Stop);
  if (const std::optional<HalfspaceId> missed = loop_.choose()) {
    claims_.violate(TraceCode::Stop, {step_,
                                      {},
                                      "ends because no other removal is bounded",
                                      removal_text(*missed, loop_.cost(*missed))});
  }
}

void StatedClaims::compare_moves(std::span<const Halfspace> halfspaces, std::vector<bool> is_there,
                                 const RationalPoint& center) {
  if (order_.moves.empty()) return;
  claims_.ask(TraceCode::Moves);
  const auto fault =
      find_move_fault(order_, facets_, halfspaces, std::move(is_there), center, options_);
  if (!fault) return;
  TraceWitness witness{{}, fault->row, fault->found, fault->expected};
  if (fault->is_open) {
    claims_.leave_open(TraceCode::Moves, std::move(witness));
  } else {
    claims_.violate(TraceCode::Moves, std::move(witness));
  }
}

// ---- Moves

namespace {

// Of the facets that are there; none if their solid is unbounded.
std::optional<Cost> measure_of(std::span<const Halfspace> halfspaces,
                               const std::vector<bool>& is_there, const RationalPoint& center,
                               CostMeasure measure, const Watch& watch) {
  std::vector<Halfspace> planes;
  for (std::size_t i = 0; i < halfspaces.size(); ++i) {
    if (is_there[i]) planes.push_back(halfspaces[i]);
  }
  const std::optional<Polytope> solid = intersect(planes, center);
  if (!solid) return std::nullopt;
  return exact_measure(*solid, measure, watch);
}

class MoveJudge {
 public:
  MoveJudge(const NamedFacets& facets, std::vector<bool> is_there, const JudgeOptions& options)
      : facets_(facets), is_there_(std::move(is_there)), options_(options) {}

  const std::vector<bool>& is_there() const { return is_there_; }
  // Exchanges the facets, one after another. Returns what is wrong with one of them, or nothing.
  std::optional<std::pair<std::string, std::string>> exchange(const Move& move);

 private:
  using Fault = std::pair<std::string, std::string>;
  std::optional<Fault> put(HalfspaceId listed, bool there);

  const NamedFacets& facets_;
  std::vector<bool> is_there_;
  const JudgeOptions& options_;
};

std::optional<MoveJudge::Fault> MoveJudge::put(HalfspaceId listed, bool there) {
  const std::string deed = there ? "inserts " : "removes ";
  const std::optional<HalfspaceId> id = facets_.find(listed);
  if (!id) return Fault(deed + "what is no facet of the input", "a facet");
  const std::string name = std::to_string(id->index());
  const auto& kept = options_.kept;
  if (!there && std::find(kept.begin(), kept.end(), *id) != kept.end()) {
    return Fault(deed + name, "a facet that is not to be kept");
  }
  if (is_there_[id->index()] == there) {
    return there ? Fault(deed + name + ", which is there", "a facet that is not there")
                 : Fault(deed + name + ", which is not there", "a facet that is there");
  }
  is_there_[id->index()] = there;
  return std::nullopt;
}

std::optional<MoveJudge::Fault> MoveJudge::exchange(const Move& move) {
  if (move.removed.size() != move.inserted.size() || move.removed.empty()) {
    return Fault("removes " + std::to_string(move.removed.size()) + " and inserts " +
                     std::to_string(move.inserted.size()),
                 "as many, and at least one");
  }
  for (const HalfspaceId facet : move.removed) {
    if (auto fault = put(facet, false)) return fault;
  }
  for (const HalfspaceId facet : move.inserted) {
    if (auto fault = put(facet, true)) return fault;
  }
  return std::nullopt;
}

}  // namespace

std::optional<MoveFault> find_move_fault(const RemovalOrder& order, const NamedFacets& facets,
                                         std::span<const Halfspace> halfspaces,
                                         std::vector<bool> is_there, const RationalPoint& center,
                                         const JudgeOptions& options) {
  const Watch& watch = options.watch;
  const auto measure_now = [&](const std::vector<bool>& there) {
    return measure_of(halfspaces, there, center, order.measure, watch);
  };
  Cost before = measure_now(is_there).value();
  MoveJudge judge(facets, std::move(is_there), options);
  std::optional<MoveFault> open;
  for (std::size_t k = 0; k < order.moves.size(); ++k) {
    watch.ask();
    const std::size_t row = k + 1;
    const Move& move = order.moves[k];
    if (const auto fault = judge.exchange(move)) return MoveFault{row, fault->first, fault->second};
    const std::optional<Cost> after = measure_now(judge.is_there());
    if (!after) return MoveFault{row, "leaves the solid unbounded", "a bounded solid"};
    const std::string now = after->decimal(kDigits);
    const auto order_of = [&](const Cost& other) {
      return compare(*after, other, options.compare, watch).order;
    };
    const auto leave_open = [&](const std::string& found, const std::string& expected) {
      if (!open) open = MoveFault{row, found, expected, true};
    };
    const Order change = order_of(before);
    const std::string less = "less than " + before.decimal(kDigits);
    if (change == Order::Undecided) {
      leave_open("leaves the measure " + now, less);
    } else if (change != Order::Less) {
      return MoveFault{row, "leaves the measure " + now, less};
    }
    if (move.measure) {
      const Order stated = order_of(*move.measure);
      const std::string found = "states the measure " + move.measure->decimal(kDigits);
      if (stated == Order::Undecided) {
        leave_open(found, now);
      } else if (stated != Order::Equal) {
        return MoveFault{row, found, now};
      }
    }
    before = *after;
  }
  return open;
}

}  // namespace convexact
