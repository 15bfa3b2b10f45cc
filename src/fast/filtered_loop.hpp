// SPDX-License-Identifier: MIT
// filtered_loop.hpp - the lazy greedy loop of the filtered engine, open to an auditor.
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "fast/checks.hpp"
#include "fast/filtered_engine.hpp"
#include "fast/growth_watch.hpp"
#include "fast/queue.hpp"
#include "fast/ties.hpp"

namespace convexact {

/// The queue holds, for every halfspace whose removal may be bounded, a lower end of its cost. The
/// cost never decreases, so the end stays true while the ring changes; the entry is *stale* then,
/// and looked at again only when it comes near the top [Minoux1978].
template <class Audit = NoAudit>
class FilteredLoop {
 public:
  FilteredLoop(const FastDual& dual, const SimplifyOptions& options, Audit& audit);

  /// @param steps  If not null, the full record of every step is appended.
  FastResult run(std::vector<Step>* steps = nullptr);

  /// The loop step by step, for callers that may remove another halfspace than the cheapest. Call
  /// first:
  void evaluate_all();
  /// The cheapest, first in canonical order; none if every removal is unbounded.
  std::optional<HalfspaceId> choose();
  /// After choose(): all that cost as little, in canonical order.
  const std::vector<HalfspaceId>& tie() const { return contenders_; }
  /// Of a halfspace that is still there.
  bool is_bounded(HalfspaceId i);
  /// Of one that is_bounded().
  const Rational& exact_cost(HalfspaceId i) { return ties_.exact_cost(i); }
  /// Precondition: is_bounded(i).
  void remove(HalfspaceId i);

 private:
  void evaluate(HalfspaceId i);
  void refine(HalfspaceId i);
  void raise(HalfspaceId i, double lower, double upper);
  void give_up(HalfspaceId i);

  bool are_ends_close(HalfspaceId i) const;
  bool settle_top();
  bool refresh_contenders();
  bool refine_contenders();
  void keep_lowest_ranges();
  void keep_cheapest();

  FastStep describe(HalfspaceId i) const;
  Step record(HalfspaceId i);
  void verify(HalfspaceId i);
  void list_new_triangles();

  const FastDual& dual_;
  const SimplifyOptions& options_;
  HalfEdgeMesh mesh_;
  FastCounts counts_;
  CapEvaluator<Audit> cap_;
  TieBreaker<Audit> ties_;
  LazyQueue queue_;
  std::vector<double> upper_;
  std::vector<bool> stale_;
  std::vector<HalfspaceId> contenders_;  // after choose(): the tie
  StepCheck check_;
  std::vector<HalfspaceId> across_;
  std::vector<DualTriangle> new_triangles_;
  std::size_t left_;
};

template <class Audit>
FilteredLoop<Audit>::FilteredLoop(const FastDual& dual, const SimplifyOptions& options,
                                  Audit& audit)
    : dual_(dual),
      options_(options),
      mesh_(dual.size(), dual.triangles(), dual.twins()),
      cap_(dual, mesh_, options.seed, audit),
      ties_(dual, cap_, counts_),
      queue_(dual.size()),
      upper_(dual.size()),
      stale_(dual.size(), false),
      check_(dual),
      left_(dual.size()) {
  if (options.faces < 4) throw Error(ErrorCode::InvalidArgument, "a solid has at least 4 faces");
}

template <class Audit>
FastResult FilteredLoop<Audit>::run(std::vector<Step>* steps) {
  FastResult result;
  GrowthWatch growth(dual_, options_.max_growth);
  if (left_ > options_.faces) evaluate_all();
  while (left_ > options_.faces) {
    if (options_.stop != nullptr && *options_.stop) throw Error(ErrorCode::Stopped, "interrupted");
    const std::optional<HalfspaceId> choice = choose();
    if (!choice) {
      result.stop = StopReason::AllUnbounded;
      break;
    }
    cap_.prepare(*choice);
    const FastStep step = describe(*choice);
    const auto volume_after = [&] {
      return Rational(exact_volume(dual_, mesh_.triangles()) + ties_.exact_cost(*choice));
    };
    if (!growth.allows(step.cost_lower, step.cost_upper, volume_after)) {
      result.stop = StopReason::GrowthLimit;
      break;
    }
    result.steps.push_back(step);
    if (steps != nullptr) steps->push_back(record(*choice));
    if (options_.verify != VerifyLevel::None) verify(*choice);
    remove(*choice);
    if (options_.progress) options_.progress(left_);
  }
  result.triangles = mesh_.triangles();
  result.survivors = mesh_.vertices();
  counts_.signs = cap_.sign_counts();
  result.counts = counts_;
  return result;
}

template <class Audit>
void FilteredLoop<Audit>::evaluate_all() {
  for (std::size_t i = 0; i < dual_.size(); ++i) queue_.append(HalfspaceId(i), 0);
  for (std::size_t i = 0; i < dual_.size(); ++i) evaluate(HalfspaceId(i));
}

template <class Audit>
bool FilteredLoop<Audit>::is_bounded(HalfspaceId i) {
  if (queue_.contains(i) && stale_[i.index()]) evaluate(i);
  return queue_.contains(i);
}

// Ends of a fresh entry. An old lower end is one still, and the higher of the two is better.
template <class Audit>
void FilteredLoop<Audit>::raise(HalfspaceId i, double lower, double upper) {
  upper_[i.index()] = upper;
  if (lower > queue_.key(i)) queue_.update(i, lower);
}

template <class Audit>
void FilteredLoop<Audit>::give_up(HalfspaceId i) {
  queue_.erase(i);
  ties_.forget(i);
}

template <class Audit>
void FilteredLoop<Audit>::evaluate(HalfspaceId i) {
  cap_.prepare(i);
  const CapRange<double> range = cap_.in_doubles();
  using Kind = CapRange<double>::Kind;
  ++counts_.evaluations;
  counts_.doubtful += range.kind == Kind::Doubtful;
  stale_[i.index()] = false;
  if (range.kind == Kind::Unbounded) {
    give_up(i);  // for ever: a larger cap is not bounded either
  } else {
    raise(i, range.lower, range.upper);
  }
}

template <class Audit>
void FilteredLoop<Audit>::refine(HalfspaceId i) {
  const auto [lower, upper] = ties_.refine(i);
  raise(i, lower, upper);
}

// The cheapest of all, first in canonical order where several are; contenders_ is the tie.
template <class Audit>
std::optional<HalfspaceId> FilteredLoop<Audit>::choose() {
  for (;;) {
    if (queue_.empty()) return {};
    if (!settle_top()) continue;
    queue_.collect(upper_[queue_.top().index()], contenders_);
    if (contenders_.size() == 1) return contenders_[0];
    if (!refresh_contenders()) continue;
    keep_lowest_ranges();
    if (contenders_.size() == 1) return contenders_[0];
    if (!refine_contenders()) continue;
    keep_cheapest();
    return contenders_[0];
  }
}

// The exact cost is close enough, whatever its ends are.
template <class Audit>
bool FilteredLoop<Audit>::are_ends_close(HalfspaceId i) const {
  constexpr double kClose = 1 + 0x1p-10;
  return upper_[i.index()] <= kClose * queue_.key(i);
}

// Whether the top is fresh and its ends are close; otherwise one step is made towards that.
template <class Audit>
bool FilteredLoop<Audit>::settle_top() {
  const HalfspaceId top = queue_.top();
  if (stale_[top.index()]) {
    evaluate(top);
    return false;
  }
  // An end far away would make contenders of too many.
  if (are_ends_close(top)) return true;
  const bool is_exact = ties_.is_exact(top);
  refine(top);
  return is_exact && queue_.top() == top;  // its end may have been raised only now
}

// Whether all contenders are fresh already.
template <class Audit>
bool FilteredLoop<Audit>::refresh_contenders() {
  bool all_fresh = true;
  for (const HalfspaceId i : contenders_) {
    if (!stale_[i.index()]) continue;
    evaluate(i);
    all_fresh = false;
  }
  return all_fresh;
}

template <class Audit>
void FilteredLoop<Audit>::keep_lowest_ranges() {
  double best = std::numeric_limits<double>::infinity();
  for (const HalfspaceId i : contenders_) best = std::min(best, upper_[i.index()]);
  std::erase_if(contenders_, [&](HalfspaceId i) { return queue_.key(i) > best; });
}

// Whether all contenders have a DoubleDouble range already.
template <class Audit>
bool FilteredLoop<Audit>::refine_contenders() {
  bool all_refined = true;
  for (const HalfspaceId i : contenders_) {
    if (ties_.is_refined(i)) continue;
    refine(i);
    all_refined = false;
  }
  return all_refined;
}

// Reduces refined contenders to the tie, in canonical order.
template <class Audit>
void FilteredLoop<Audit>::keep_cheapest() {
  ties_.keep_cheapest(contenders_);
  std::sort(contenders_.begin(), contenders_.end(),
            [&](HalfspaceId a, HalfspaceId b) { return dual_.precedes(a, b); });
  if (!are_ends_close(contenders_[0])) refine(contenders_[0]);
}

template <class Audit>
FastStep FilteredLoop<Audit>::describe(HalfspaceId i) const {
  return {i, static_cast<std::uint32_t>(contenders_.size()), next_below(queue_.key(i) / 6),
          next_above(upper_[i.index()] / 6)};
}

template <class Audit>
void FilteredLoop<Audit>::list_new_triangles() {
  new_triangles_.clear();
  const auto& v = cap_.ring().vertices;
  for (const RingTriangle& t : cap_.triangles()) {
    new_triangles_.push_back({v[t.low], v[t.middle], v[t.high]});
  }
}

template <class Audit>
Step FilteredLoop<Audit>::record(HalfspaceId i) {
  Step step;
  step.removed = i;
  step.cost = ties_.exact_cost(i);
  step.tie = contenders_;
  step.ring = cap_.ring().vertices;
  list_new_triangles();
  step.triangles = new_triangles_;
  step.left = left_ - 1;
  return step;
}

template <class Audit>
void FilteredLoop<Audit>::verify(HalfspaceId i) {
  across_.clear();
  for (const std::uint32_t h : cap_.ring().outer) across_.push_back(mesh_.apex(h));
  list_new_triangles();
  check_.check({i, cap_.ring().vertices, across_, new_triangles_});
}

template <class Audit>
void FilteredLoop<Audit>::remove(HalfspaceId i) {
  cap_.prepare(i);
  mesh_.remove(i, cap_.ring(), cap_.triangles());
  --left_;
  give_up(i);
  for (const HalfspaceId r : cap_.ring().vertices) {
    stale_[r.index()] = true;
    ties_.forget(r);
  }
  cap_.invalidate();
}

}  // namespace convexact
