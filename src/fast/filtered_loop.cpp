// SPDX-License-Identifier: MIT
#include "fast/filtered_loop.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "convexact/error.hpp"
#include "task/parallel.hpp"

namespace convexact {

GrowthBudget::GrowthBudget(const FastDual& dual, const SimplifyOptions& options)
    : dual_(dual), options_(options) {
  if (!options_.max_growth) return;
  const Rational& share = *options_.max_growth;
  if (share < 0) throw Error(ErrorCode::InvalidArgument, "a growth limit is not negative");
  Interval<double> measure{};
  const CostMeasure limited = options_.growth_measure();
  if (limited == CostMeasure::Volume) {
    const Interval<double> six_times = six_times_volume(dual);
    measure = {next_below(six_times.lower / 6), next_above(six_times.upper / 6)};
  } else {
    measure = scaled_enclosure(exact_measure(dual, dual.triangles(), limited),
                               dual.cost_exponent(limited));
  }
  limit_ = {std::max(0.0, next_below(measure.lower * to_double(share, Rounding::Down))),
            next_above(measure.upper * to_double(share, Rounding::Up))};
}

std::optional<bool> GrowthBudget::allows(const Interval<double>& cost) const {
  if (!options_.max_growth) return true;
  const Interval<double> grown = grown_with(cost);
  if (grown.lower > limit_.upper) return false;
  if (grown.upper <= limit_.lower) return true;
  return {};
}

bool GrowthBudget::allows_exactly(Cost before, const Cost& cost) {
  if (!exact_limit_) {
    exact_limit_ = exact_measure(dual_, dual_.triangles(), options_.growth_measure());
    *exact_limit_ *= Rational(1 + *options_.max_growth);
  }
  const std::array<Cost, 2> parts{std::move(before), cost};
  const Ordering ordering = compare(sum_of(parts), *exact_limit_, options_.compare, options_.watch);
  undecided_bits_ = ordering.order == Order::Undecided ? ordering.bits : 0;
  return ordering.order == Order::Less || ordering.order == Order::Equal;
}

FilteredLoop::FilteredLoop(const FastDual& dual, const SimplifyOptions& options,
                           CostObserver* observer)
    : dual_(dual),
      options_(options),
      mesh_(dual.size(), dual.triangles(), dual.twins()),
      cap_(dual, mesh_, options.cost, options.seed, observer),
      ties_(dual, cap_, counts_),
      queue_(dual.size()),
      upper_(dual.size()),
      stale_(dual.size(), false),
      terms_(options.cost == CostMeasure::Volume ? 0 : dual.size()),
      tie_(dual.size()),
      check_(dual),
      left_(dual.size()),
      is_observed_(observer != nullptr) {
  if (options.faces < 4) throw Error(ErrorCode::InvalidArgument, "a solid has at least 4 faces");
  require_threads(options.jobs);
  if (options.max_growth && options.growth_measure() != options.cost) {
    limited_cap_.emplace(dual, mesh_, options.growth_measure(), options.seed);
  }
}

FastResult FilteredLoop::run(std::vector<Step>* steps) {
  GrowthBudget growth(dual_, options_);
  StopReason stop = StopReason::Reached;
  if (left_ > options_.faces) evaluate_all();
  while (left_ > options_.faces) {
    const std::optional<FastStep> step = next();
    if (!step) {
      stop = options_.when_stuck();
      break;
    }
    if (!is_within(growth, *step)) {
      stop = StopReason::GrowthLimit;
      break;
    }
    make(*step, steps);
    options_.watch.report(dual_.size() - left_, dual_.size() - options_.faces);
  }
  FastResult result = finish(stop);
  if (stop == StopReason::GrowthLimit) result.growth_bits = growth.undecided_bits();
  return result;
}

std::optional<FastStep> FilteredLoop::next() {
  options_.watch.ask();
  const std::optional<HalfspaceId> choice = choose();
  if (!choice) return {};
  cap_.prepare(*choice);
  return describe(*choice);
}

void FilteredLoop::make(const FastStep& step, std::vector<Step>* steps) {
  result_.steps.push_back(step);
  result_.ties.add(evidence_);
  if (steps != nullptr) steps->push_back(record(step.removed));
  if (options_.verify != VerifyLevel::None) verify(step.removed);
  remove(step.removed);
}

FastResult FilteredLoop::finish(StopReason stop) {
  result_.stop = stop;
  result_.triangles = mesh_.triangles();
  result_.survivors = mesh_.vertices();
  counts_.signs = cap_.sign_counts();
  counts_.signs += other_signs_;
  result_.counts = counts_;
  return std::move(result_);
}

Cost FilteredLoop::measure(CostMeasure kind) const {
  return exact_measure(dual_, mesh_.triangles(), kind);
}

// The cap has scratch memory of its own, so each thread needs one.
void FilteredLoop::look_at_some(FilteredCap& cap, std::span<const HalfspaceId> some,
                                std::vector<FirstBounds>& found) const {
  for (const HalfspaceId i : some) {
    options_.watch.ask();
    cap.prepare(i);
    found[i.index()].bounds = cap.in_doubles();
    if (terms_.empty()) continue;
    const std::span<const LastingTerm> terms = cap.lasting_terms();
    found[i.index()].terms.assign(terms.begin(), terms.end());
  }
}

// On several threads, since the mesh does not change yet; an observer is told on one.
std::vector<FilteredLoop::FirstBounds> FilteredLoop::look_at_all(std::span<const HalfspaceId> all) {
  constexpr std::size_t kWorthAThread = 2048;
  const std::size_t most = is_observed_ ? 1 : options_.jobs;
  const std::size_t threads = std::clamp<std::size_t>(all.size() / kWorthAThread, 1, most);
  std::vector<FirstBounds> found(dual_.size());
  std::vector<SignCounts> signs(threads);
  for_each_in_parallel(threads, threads, [&](std::size_t k) {
    const std::size_t first = all.size() * k / threads, end = all.size() * (k + 1) / threads;
    const auto some = all.subspan(first, end - first);
    if (k == 0) return look_at_some(cap_, some, found);
    FilteredCap own(dual_, mesh_, options_.cost, options_.seed);
    look_at_some(own, some, found);
    signs[k] = own.sign_counts();
  });
  for (const SignCounts& each : signs) other_signs_ += each;
  return found;
}

void FilteredLoop::evaluate_all() {
  std::vector<bool> is_kept(dual_.size(), false);
  for (const HalfspaceId i : options_.keep) is_kept.at(i.index()) = true;
  std::vector<HalfspaceId> all;
  for (std::size_t i = 0; i < dual_.size(); ++i) {
    if (!is_kept[i]) all.emplace_back(i);
  }
  std::vector<FirstBounds> found = look_at_all(all);
  for (const HalfspaceId i : all) {
    auto& [bounds, terms] = found[i.index()];
    ++counts_.evaluations;
    counts_.doubtful += bounds.kind == Boundedness::Doubtful;
    if (bounds.kind == Boundedness::Unbounded) continue;  // for good, see evaluate()
    queue_.append(i, std::max(0.0, bounds.lower));
    upper_[i.index()] = bounds.upper;
    if (!terms_.empty()) terms_[i.index()] = std::move(terms);
  }
  queue_.make_heap();
}

bool FilteredLoop::is_bounded(HalfspaceId i) {
  if (queue_.contains(i) && stale_[i.index()]) evaluate(i);
  return queue_.contains(i);
}

// For a fresh entry. The lower bound in the queue is still valid, and the higher of the two is
// better.
void FilteredLoop::set_bounds(HalfspaceId i, const DoubleDouble& lower, const DoubleDouble& upper) {
  upper_[i.index()] = upper;
  if (lower > queue_.key(i)) queue_.update(i, lower);
}

Interval<double> FilteredLoop::bounds_in_doubles(HalfspaceId i) const {
  const DoubleDouble &lower = queue_.key(i), &upper = upper_[i.index()];
  return {lower.lo() < 0 ? next_below(lower.hi()) : lower.hi(),
          upper.lo() > 0 ? next_above(upper.hi()) : upper.hi()};
}

void FilteredLoop::drop(HalfspaceId i) {
  queue_.erase(i);
  tie_.drop(i);
  ties_.forget(i);
}

void FilteredLoop::evaluate(HalfspaceId i) {
  cap_.prepare(i);
  const CostBounds<double> bounds = cap_.in_doubles();
  ++counts_.evaluations;
  counts_.doubtful += bounds.kind == Boundedness::Doubtful;
  stale_[i.index()] = false;
  if (bounds.kind == Boundedness::Unbounded) {
    drop(i);  // for good: a larger cap is not bounded either
    return;
  }
  set_bounds(i, bounds.lower, bounds.upper);
  if (!terms_.empty()) {
    const std::span<const LastingTerm> terms = cap_.lasting_terms();
    terms_[i.index()].assign(terms.begin(), terms.end());
  }
}

void FilteredLoop::refine(HalfspaceId i) {
  const auto [lower, upper] = ties_.refine(i);
  set_bounds(i, lower, upper);
}

std::optional<HalfspaceId> FilteredLoop::choose() {
  if (is_tie_left()) {
    const HalfspaceId first = tie_.first();
    if (!are_bounds_close(first)) refine(first);
    evidence_ = {};
    if (tie_.size() > 1) {
      evidence_.proof = tie_.is_one_class() ? TieProof::Congruent : TieProof::EqualRationals;
    }
    return first;
  }
  const std::optional<HalfspaceId> choice = choose_from_queue();
  remember_tie();
  return choice;
}

// Of volumes: whether some of the last tie are left, and nothing that has changed since costs as
// little; in doubt not.
bool FilteredLoop::is_tie_left() {
  if (options_.cost != CostMeasure::Volume || tie_.size() == 0) return false;
  const HalfspaceId first = tie_.first();
  const auto may_cost_as_little = [&](HalfspaceId i) {
    return queue_.contains(i) && !(queue_.key(i) > upper_[first.index()]);
  };
  for (const HalfspaceId i : changed_) {
    if (tie_.contains(i) || !may_cost_as_little(i)) continue;
    if (stale_[i.index()]) evaluate(i);
    if (may_cost_as_little(i) && !ties_.is_refined(first)) refine(first);
    if (may_cost_as_little(i)) return false;
  }
  changed_.clear();
  return true;
}

// candidates_ are the tie.
void FilteredLoop::remember_tie() {
  classes_.clear();
  if (candidates_.size() > 1) {
    for (const HalfspaceId i : candidates_) classes_.push_back(ties_.class_of(i));
  }
  tie_.assign(candidates_, classes_);
  changed_.clear();
}

// The cheapest of all, first in canonical order where several are; candidates_ is the tie.
std::optional<HalfspaceId> FilteredLoop::choose_from_queue() {
  evidence_ = {};
  candidates_.clear();
  for (;;) {
    if (queue_.empty()) return {};
    if (!tighten_top()) continue;
    if (!collect_candidates()) continue;
    if (candidates_.size() == 1) return candidates_[0];
    if (!refresh_candidates()) continue;
    keep_lowest_bounds();
    if (candidates_.size() == 1) return candidates_[0];
    if (!ties_.are_one_class(candidates_) && !refine_candidates()) continue;
    keep_cheapest();
    return candidates_[0];
  }
}

// An exact cost is close enough, even if its bounds are wide.
bool FilteredLoop::are_bounds_close(HalfspaceId i) const {
  return are_close(queue_.key(i), upper_[i.index()]);
}

// Whether the top is fresh and its bounds are close; otherwise one step is made towards that.
bool FilteredLoop::tighten_top() {
  const HalfspaceId top = queue_.top();
  if (stale_[top.index()]) {
    evaluate(top);
    return false;
  }
  // An upper bound far away would make too many entries candidates.
  const bool is_exact = ties_.is_exact(top);
  if (!is_exact && are_bounds_close(top)) return true;
  refine(top);  // of an exact cost that was computed for a congruent cap, the bounds come only now
  return is_exact && queue_.top() == top;
}

// Those that may cost as little as the top. Of costs that are nearly equal, as those of a
// cylinder's sides, a wide bound would collect thousands at every step; so then the top's bounds
// are made narrower first, which is paid once, and false is returned. (Of mean widths only the
// exact cost, a long sum of angles, is certain to be narrower.)
bool FilteredLoop::collect_candidates() {
  constexpr std::size_t kMany = 32;
  const HalfspaceId top = queue_.top();
  const DoubleDouble most = upper_[top.index()];
  if (options_.cost != CostMeasure::MeanWidth && !ties_.is_exact(top)) {
    queue_.collect(most, candidates_, kMany);
    if (candidates_.size() <= kMany) return true;
    refine(top);
    return false;
  }
  queue_.collect(most, candidates_);
  return true;
}

// Whether all candidates are fresh already.
bool FilteredLoop::refresh_candidates() {
  bool all_fresh = true;
  for (const HalfspaceId i : candidates_) {
    if (!stale_[i.index()]) continue;
    evaluate(i);
    all_fresh = false;
  }
  return all_fresh;
}

void FilteredLoop::keep_lowest_bounds() {
  DoubleDouble best = upper_[candidates_[0].index()];
  for (const HalfspaceId i : candidates_) best = std::min(best, upper_[i.index()]);
  std::erase_if(candidates_, [&](HalfspaceId i) { return queue_.key(i) > best; });
}

// Whether all candidates have bounds in DoubleDouble already.
bool FilteredLoop::refine_candidates() {
  bool all_refined = true;
  for (const HalfspaceId i : candidates_) {
    if (ties_.is_refined(i)) continue;
    refine(i);
    all_refined = false;
  }
  return all_refined;
}

// Reduces candidates, of one class or all refined, to the tie, in canonical order.
void FilteredLoop::keep_cheapest() {
  compared_ = candidates_;
  evidence_ = ties_.keep_cheapest(candidates_, options_.compare, options_.watch);
  // What was computed exactly is told apart from now on.
  for (const HalfspaceId i : compared_) {
    if (ties_.is_exact(i)) refine(i);
  }
  std::sort(candidates_.begin(), candidates_.end(),
            [&](HalfspaceId a, HalfspaceId b) { return dual_.precedes(a, b); });
  if (!are_bounds_close(candidates_[0])) refine(candidates_[0]);
}

FastStep FilteredLoop::describe(HalfspaceId i) const {
  const Interval<double> multiple = cost_multiple(options_.cost);
  const auto [lower, upper] = bounds_in_doubles(i);
  return {i, static_cast<std::uint32_t>(tie_.size()), next_below(lower / multiple.upper),
          next_above(upper / multiple.lower)};
}

// The amount that the step adds to the measure whose growth is limited.
Interval<double> FilteredLoop::added_by(const FastStep& step) {
  if (!limited_cap_) return {step.cost_lower, step.cost_upper};
  limited_cap_->invalidate();  // the mesh has changed
  limited_cap_->prepare(step.removed);
  const CostBounds<double> bounds = limited_cap_->in_doubles();
  if (bounds.kind == Boundedness::Doubtful) {
    return scaled_enclosure(limited_cap_->exactly(),
                            dual_.cost_exponent(options_.growth_measure()));
  }
  const Interval<double> multiple = cost_multiple(options_.growth_measure());
  return {next_below(bounds.lower / multiple.upper), next_above(bounds.upper / multiple.lower)};
}

Cost FilteredLoop::exactly_added_by(const FastStep& step) {
  return limited_cap_ ? limited_cap_->exactly() : ties_.exact_cost(step.removed);
}

// If so, the step counts from now on.
bool FilteredLoop::is_within(GrowthBudget& growth, const FastStep& step) {
  if (!options_.max_growth) return true;
  const Interval<double> cost = added_by(step);
  std::optional<bool> allowed = growth.allows(cost);
  if (!allowed) {
    allowed = growth.allows_exactly(measure(options_.growth_measure()), exactly_added_by(step));
  }
  if (*allowed) growth.add(cost);
  return *allowed;
}

void FilteredLoop::list_new_triangles() {
  new_triangles_.clear();
  const auto& v = cap_.ring().vertices;
  for (const RingTriangle& t : cap_.triangles()) {
    new_triangles_.push_back({v[t.low], v[t.middle], v[t.high]});
  }
}

Step FilteredLoop::record(HalfspaceId i) {
  Step step;
  step.removed = i;
  step.cost = ties_.exact_cost(i);
  step.tie = tie_.list();
  step.tie_evidence = evidence_;
  step.ring = cap_.ring().vertices;
  list_new_triangles();
  step.triangles = new_triangles_;
  step.left = left_ - 1;
  return step;
}

void FilteredLoop::verify(HalfspaceId i) {
  across_.clear();
  for (const std::uint32_t h : cap_.ring().outer) across_.push_back(mesh_.apex(h));
  list_new_triangles();
  check_.check({i, cap_.ring().vertices, across_, new_triangles_});
}

void FilteredLoop::remove(HalfspaceId i) {
  cap_.prepare(i);
  mesh_.remove(i, cap_.ring(), cap_.triangles());
  --left_;
  drop(i);
  for (const HalfspaceId r : cap_.ring().vertices) {
    stale_[r.index()] = true;
    ties_.forget(r);
    tie_.drop(r);
    changed_.push_back(r);
    if (!terms_.empty() && queue_.contains(r)) {
      queue_.update(r, forget_terms_of(i, terms_[r.index()]));
    }
  }
  cap_.invalidate();
}

RecordedLoop::RecordedLoop(const DualHull& dual_hull, const RationalPoint& center,
                           const SimplifyOptions& options)
    : dual_(FastDual::of(dual_hull, center)),
      recorder_(run_),
      loop_(dual_, options, options.keep_evaluations ? &recorder_ : nullptr) {
  run_.halfspaces = dual_hull.halfspaces;
  run_.kept = options.keep;
  run_.measure = options.cost;
}

Run RecordedLoop::finish(FastResult result) {
  run_.stop = result.stop;
  run_.growth_bits = result.growth_bits;
  run_.triangles = std::move(result.triangles);
  return std::move(run_);
}

void RecordedLoop::Recorder::in_doubles(HalfspaceId i, const OneRing& ring,
                                        const std::vector<RingTriangle>& triangles,
                                        const CostBounds<double>&) {
  const auto& v = ring.vertices;
  Evaluation evaluation{run_.steps.size(), i, v, {}};
  for (const RingTriangle& t : triangles) {
    evaluation.triangles.push_back({v[t.low], v[t.middle], v[t.high]});
  }
  run_.evaluations.push_back(std::move(evaluation));
}

}  // namespace convexact
