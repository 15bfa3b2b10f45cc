// SPDX-License-Identifier: MIT
// trace_claims.hpp - the claims about a removal order: what its file states, against what is true.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "convexact/verify_order.hpp"
#include "oracle/order/facet_match.hpp"

namespace convexact {

class FilteredLoop;

/// One claim per code. Each keeps the first place where it fails.
class TraceClaims {
 public:
  TraceClaims();

  void violate(TraceCode code, TraceWitness witness);
  /// Ignored if the claim is violated already.
  void leave_open(TraceCode code, TraceWitness witness);
  /// A claim that only some files make: it holds unless it is violated.
  void ask(TraceCode code);
  /// The steps cannot be judged.
  void give_up();
  std::vector<TraceClaim> list() && { return std::move(claims_); }

 private:
  TraceClaim& at(TraceCode code) { return claims_[static_cast<std::size_t>(code)]; }

  std::vector<TraceClaim> claims_;
};

/// "removes 7 at cost 0.5", or what else the removal of a facet does.
[[nodiscard]] std::string removal_text(HalfspaceId id, const std::optional<Cost>& cost);

/// Compares what an order states beyond its removals: the facets that it keeps, costs, ties and
/// counts of its steps, the reason of its end, and its moves. What it does not state is not asked.
class StatedClaims {
 public:
  /// All of these are referred to.
  /// @param loop  In the state before the step that is compared.
  StatedClaims(const RemovalOrder& order, const NamedFacets& facets, const JudgeOptions& options,
               FilteredLoop& loop, TraceClaims& claims)
      : order_(order),
        facets_(facets),
        options_(options),
        watch_(options.watch),
        loop_(loop),
        claims_(claims) {}

  /// The list of facets to be kept. That none of them is removed is judged step by step.
  void compare_kept();
  /// The next step. @param left  How many facets the solid has after it.
  void compare_step(const OrderedStep& stated, const JudgedStep& judged, std::size_t left);
  /// After the last step: that no other removal is bounded.
  void compare_stop();
  /// As find_move_fault() says.
  void compare_moves(std::span<const Halfspace> halfspaces, std::vector<bool> is_there,
                     const RationalPoint& center);

 private:
  void compare_cost(const OrderedStep& stated, const JudgedStep& judged);
  void compare_ties(const OrderedStep& stated, const JudgedStep& judged);
  bool may_be_tie(const std::vector<HalfspaceId>& claimed, const std::vector<HalfspaceId>& tie);
  Order order_of(const Cost& a, const Cost& b) const {
    return compare(a, b, options_.compare, watch_).order;
  }
  void violate(TraceCode code, const OrderedStep& stated, std::string found, std::string expected) {
    claims_.violate(code, {step_, stated.row, std::move(found), std::move(expected)});
  }
  void leave_open(TraceCode code, const OrderedStep& stated, std::string found,
                  std::string expected) {
    claims_.leave_open(code, {step_, stated.row, std::move(found), std::move(expected)});
  }

  const RemovalOrder& order_;
  const NamedFacets& facets_;
  const JudgeOptions& options_;
  const Watch watch_;
  FilteredLoop& loop_;
  TraceClaims& claims_;
  std::size_t step_ = 0;  // that is compared
};

/// The first move that is not what the order says, or of which that is not decided.
struct MoveFault {
  std::size_t row;  ///< Of the move; counted from 1.
  std::string found, expected;
  bool is_open = false;  ///< Only comparisons of mean widths leave it open.
};

/// Follows the moves. Each must remove facets that are there and not to be kept, insert as many
/// facets that are not there, leave a bounded solid, and make the measure smaller; a measure that
/// it states must be that of its solid. Every solid is intersected from scratch.
/// @param is_there  Of each facet of the input: whether it is left before the first move.
/// @param center    Strictly inside the input.
/// @throws Error    Stopped.
/// @par Cost        An intersection and an exact measure for each move.
[[nodiscard]] std::optional<MoveFault> find_move_fault(
    const RemovalOrder& order, const NamedFacets& facets, std::span<const Halfspace> halfspaces,
    std::vector<bool> is_there, const RationalPoint& center, const JudgeOptions& options);

}  // namespace convexact
