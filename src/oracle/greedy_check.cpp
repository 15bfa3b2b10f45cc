// SPDX-License-Identifier: MIT
#include "oracle/greedy_check.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "fast/filtered_loop.hpp"

namespace convexact {
namespace {

Divergence tied(std::size_t step, std::size_t left, HalfspaceId first, HalfspaceId chosen,
                const Rational& cost) {
  return {step, left, DivergenceKind::Tie, {first, cost}, {chosen, cost}, false, Rational(0), {}};
}

// Judges one step after another; `tell` gets each divergence and says whether to go on.
template <class Tell>
void follow(const DualHull& dual, const RationalPoint& center, const Run& run,
            const std::atomic<bool>* stop, Tell&& tell) {
  const FastDual fast = FastDual::of(dual, center);
  const SimplifyOptions options;
  FilteredLoop loop(fast, options);
  loop.evaluate_all();
  for (std::size_t step = 0; step < run.steps.size(); ++step) {
    if (stop != nullptr && *stop) throw Error(ErrorCode::Stopped, "interrupted");
    const HalfspaceId chosen = run.steps[step].removed;
    const std::optional<HalfspaceId> cheapest = loop.choose();
    if (cheapest != chosen) {
      const std::vector<HalfspaceId>& tie = loop.tie();
      const bool is_tied = cheapest && std::find(tie.begin(), tie.end(), chosen) != tie.end();
      const bool go_on = tell(is_tied ? tied(step, dual.halfspaces.size() - step, *cheapest, chosen,
                                             loop.exact_cost(chosen))
                                      : judge_choices(run, center, step, cheapest, chosen));
      if (!go_on || !loop.is_bounded(chosen)) return;
    }
    loop.remove(chosen);
  }
  if (run.stop != StopReason::AllUnbounded) return;
  if (const std::optional<HalfspaceId> missed = loop.choose()) {
    tell(judge_choices(run, center, run.steps.size(), missed, {}));
  }
}

}  // namespace

std::vector<Divergence> check_greedy(const DualHull& dual, const RationalPoint& center,
                                     const Run& run, const std::atomic<bool>* stop) {
  std::vector<Divergence> found;
  follow(dual, center, run, stop, [&](Divergence divergence) {
    found.push_back(std::move(divergence));
    return true;
  });
  return found;
}

std::optional<Divergence> first_wrong_step(const DualHull& dual, const RationalPoint& center,
                                           const Run& run, const std::atomic<bool>* stop) {
  std::optional<Divergence> wrong;
  follow(dual, center, run, stop, [&](Divergence divergence) {
    if (divergence.kind != DivergenceKind::Tie) wrong = std::move(divergence);
    return !wrong;
  });
  return wrong;
}

}  // namespace convexact
