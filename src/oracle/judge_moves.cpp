// SPDX-License-Identifier: MIT
#include "oracle/judge_moves.hpp"

#include <algorithm>
#include <utility>

#include "convexact/measure.hpp"
#include "convexact/watch.hpp"
#include "oracle/removal_cost.hpp"

namespace convexact {
namespace {

constexpr int kMeasureDigits = 17;

// The measure of the facets that are left; none if their solid is unbounded.
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
  const Watch watch(options.stop);
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
    const std::string now = after->decimal(kMeasureDigits);
    const auto order_of = [&](const Cost& other) {
      return compare(*after, other, options.compare, watch).order;
    };
    const auto leave_open = [&](const std::string& found, const std::string& expected) {
      if (!open) open = MoveFault{row, found, expected, true};
    };
    const Order change = order_of(before);
    const std::string less = "less than " + before.decimal(kMeasureDigits);
    if (change == Order::Undecided) {
      leave_open("leaves the measure " + now, less);
    } else if (change != Order::Less) {
      return MoveFault{row, "leaves the measure " + now, less};
    }
    if (move.measure) {
      const Order stated = order_of(*move.measure);
      const std::string found = "states the measure " + move.measure->decimal(kMeasureDigits);
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
