// SPDX-License-Identifier: MIT
// float_loop_steps.hpp - how the float loop works, for sources that run it in an arithmetic of
// their own; all others need float_loop.hpp only.
#pragma once
#include "fast/float_loop.hpp"

namespace convexact {

template <class Arithmetic>
FloatLoop<Arithmetic>::FloatLoop(const FastDual& dual, const Arithmetic& arithmetic,
                                 const SimplifyOptions& options)
    : dual_(dual),
      arithmetic_(arithmetic),
      options_(options),
      mesh_(dual.size(), dual.triangles(), dual.twins()),
      narrow_(Scalar(1 + std::min(0x1p-24, 0x1p29 * arithmetic.unit()))),
      same_(Scalar(1 + std::min(0x1p-24, 0x1p13 * arithmetic.unit()))),
      queue_(dual.size()),
      state_(dual.size(), kFresh),
      lower_(dual.size()),
      upper_(dual.size()),
      estimate_(dual.size()),
      patience_(dual.size()),
      cap_(arithmetic),
      terms_(options.cost == CostMeasure::Volume ? 0 : dual.size()),
      left_(dual.size()) {
  if constexpr (HasLonger<Arithmetic>) longer_cap_.emplace(arithmetic.longer());
  if constexpr (HasSigns<Arithmetic>) errors_.emplace(dual.size(), options.cost);
  if (options.cost != CostMeasure::Volume) {
    if (!HasSigns<Arithmetic>) {
      throw Error(ErrorCode::InvalidArgument, "rounded dual points have costs by volume only");
    }
    metric_.emplace(dual, options.cost);
  }
  if (options.faces < 4) throw Error(ErrorCode::InvalidArgument, "a solid has at least 4 faces");
  if (options.max_growth && *options.max_growth < 0) {
    throw Error(ErrorCode::InvalidArgument, "a growth limit is not negative");
  }
  if (options.max_growth && options.growth_measure() != options.cost) {
    throw Error(ErrorCode::InvalidArgument,
                "the float engine limits the growth of the measure of its costs only");
  }
}

template <class Arithmetic>
FastResult FloatLoop<Arithmetic>::run() {
  Scalar allowance = infinity_;
  if (options_.max_growth) {
    allowance = Scalar(to_double(*options_.max_growth, Rounding::Nearest)) * scaled_measure();
  }
  StopReason stop = StopReason::Reached;
  evaluate_all(left_ > options_.faces);
  while (left_ > options_.faces) {
    const std::optional<FastStep> step = next();
    if (!step) {
      stop = options_.when_stuck();
      break;
    }
    const Scalar cost = scaled_cost(step->removed);
    if (!(cost <= allowance)) {
      stop = StopReason::GrowthLimit;
      break;
    }
    allowance = allowance - cost;
    make(*step);
    options_.watch.report(dual_.size() - left_, dual_.size() - options_.faces);
  }
  return finish(stop);
}

// Kept halfspaces have no entry.
template <class Arithmetic>
void FloatLoop<Arithmetic>::evaluate_all(bool removes_any) {
  std::vector<bool> is_kept(dual_.size(), false);
  for (const HalfspaceId i : options_.keep) {
    is_kept.at(i.index()) = true;
    // No removal is judged against it.
    if (errors_) errors_->enclose(i, leading(infinity_), leading(infinity_));
  }
  for (std::size_t i = 0; removes_any && i < dual_.size(); ++i) {
    if (!is_kept[i]) queue_.append(HalfspaceId(i), evaluate(HalfspaceId(i)));
  }
  queue_.make_heap();
}

template <class Arithmetic>
std::optional<FastStep> FloatLoop<Arithmetic>::next() {
  options_.watch.ask();
  const std::optional<HalfspaceId> choice = choose();
  if (!choice) return {};
  const double in_units = leading(scaled_cost(*choice)) / cost_multiple(options_.cost).lower;
  return FastStep{*choice, static_cast<std::uint32_t>(tied_.size()), in_units, in_units};
}

template <class Arithmetic>
void FloatLoop<Arithmetic>::make(const FastStep& step) {
  result_.steps.push_back(step);
  if (errors_) errors_->remove(step.removed, leading(scaled_cost(step.removed)));
  if (errors_ && step.tied > 1) errors_->count_tie();
  remove(step.removed);
  --left_;
}

template <class Arithmetic>
FastResult FloatLoop<Arithmetic>::finish(StopReason stop) {
  result_.stop = stop;
  result_.triangles = mesh_.triangles();
  result_.survivors = mesh_.vertices();
  result_.counts.evaluations = evaluations_;
  if (errors_) result_.bound = errors_->bound(stop == options_.when_stuck());
  return std::move(result_);
}

// The ring of i, triangulated in the arithmetic that holds its cap.
template <class Arithmetic>
void FloatLoop<Arithmetic>::prepare(HalfspaceId i) {
  if (prepared_ == i) return;
  load(i);
  if constexpr (HasLonger<Arithmetic>) {
    if (state_[i.index()] & kLonger) longer_cap_->load(i, ring_, options_.seed, triangles_);
  }
}

template <class Arithmetic>
void FloatLoop<Arithmetic>::load(HalfspaceId i) {
  mesh_.one_ring(i, ring_);
  cap_.load(i, ring_, options_.seed, triangles_);
  prepared_ = i;
}

// The key of i, fresh.
template <class Arithmetic>
const typename FloatLoop<Arithmetic>::Scalar& FloatLoop<Arithmetic>::evaluate(HalfspaceId i) {
  load(i);
  ++evaluations_;
  if (!metric_) {
    evaluate_by(i, [&](auto& cap) { return cap.estimate(triangles_); });
  } else if constexpr (HasSigns<Arithmetic>) {
    const bool is_right = evaluate_by(i, [&](auto& cap) {
      return metric_->estimate(cap.geometry(), i, ring_.vertices, triangles_, cap.unit());
    });
    terms_[i.index()].clear();
    if (is_right) terms_[i.index()] = metric_->terms();
  }
  return estimate_[i.index()];
}

// Sets the key by bounds and estimates of a cap in this arithmetic or in the longer one. Returns
// whether its T is right, and therefore the bounds.
template <class Arithmetic>
template <class Estimate>
bool FloatLoop<Arithmetic>::evaluate_by(HalfspaceId i, const Estimate& estimate) {
  const auto cap = estimate(cap_);
  keep(i, cap);
  if constexpr (HasLonger<Arithmetic>) {
    if (cap.kind != Boundedness::Bounded || !cap_.is_right() || is_loose(cap)) {
      longer_cap_->load(i, ring_, options_.seed, triangles_);
      const auto long_cap = estimate(*longer_cap_);
      keep(i, long_cap);
      state_[i.index()] |= kLonger;
      enclose(i, long_cap, longer_cap_->is_right());
      return longer_cap_->is_right();
    }
  }
  enclose(i, cap, cap_.is_right());
  return cap_.is_right();
}

// Records the bounds proven for i, whose ring and triangles are known.
template <class Arithmetic>
template <class Number>
void FloatLoop<Arithmetic>::enclose(HalfspaceId i, const CostEstimate<Number>& cap, bool is_right) {
  if constexpr (HasSigns<Arithmetic>) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    if (!is_right) {
      errors_->enclose(i, 0, kInfinite);
    } else if (cap.kind == Boundedness::Unbounded ||
               (cap.kind == Boundedness::Doubtful && is_unbounded_by_signs())) {
      errors_->enclose(i, kInfinite, kInfinite);
    } else {
      errors_->enclose(i, next_below(leading(cap.lower)), next_above(leading(cap.upper)));
    }
  }
}

// Whether some vertex of the cap does not exist: D <= 0 in exact numbers.
template <class Arithmetic>
bool FloatLoop<Arithmetic>::is_unbounded_by_signs() const {
  const auto& v = ring_.vertices;
  return std::any_of(triangles_.begin(), triangles_.end(), [&](const RingTriangle& t) {
    return arithmetic_.signs().determinant(v[t.low], v[t.middle], v[t.high]) != Sign::Positive;
  });
}

template <class Arithmetic>
template <class Number>
void FloatLoop<Arithmetic>::keep(HalfspaceId i, const CostEstimate<Number>& cap) {
  const auto shortened = [](const Number& x) {
    if constexpr (std::is_same_v<Number, Scalar>) {
      return x;
    } else {
      return Scalar(leading(x));
    }
  };
  Scalar& lower = lower_[i.index()];
  Scalar& estimate = estimate_[i.index()];
  const bool is_bounded = cap.kind == Boundedness::Bounded && std::isfinite(leading(cap.value));
  lower = is_bounded ? shortened(cap.lower) : Scalar(0.0);
  estimate = is_bounded ? shortened(cap.value) : infinity_;
  upper_[i.index()] = is_bounded ? shortened(cap.upper) : infinity_;
  state_[i.index()] = estimate <= narrow_ * lower ? kFresh : kWide;
  const auto k = static_cast<std::uint32_t>(ring_.vertices.size());
  patience_[i.index()] = is_bounded || k <= RingTriangulator::kShortRing ? 0 : k / 4;
}

// The cheapest estimate, once no stale lower bound is below it; among estimates that are equal up
// to rounding, the first in canonical order.
template <class Arithmetic>
std::optional<HalfspaceId> FloatLoop<Arithmetic>::choose() {
  for (;;) {
    if (queue_.empty()) return {};  // all that are left are to be kept
    const HalfspaceId top = queue_.top();
    if (state_[top.index()] & kStale) {
      queue_.update(top, evaluate(top));
    } else if (!(queue_.key(top) < infinity_)) {
      return {};
    } else if (collect_tie(top)) {
      return tied_.front();
    }
  }
}

// For a fresh top: collects those whose estimates are next to its estimate and whose bounds
// overlap, the first in canonical order in front. Without a symmetry "next to" is much less: the
// caps of a sphere differ by little, and the lower estimate is the better guess. False if some were
// stale; they are then refreshed.
template <class Arithmetic>
bool FloatLoop<Arithmetic>::collect_tie(HalfspaceId top) {
  // Symmetries of modelled shapes make ties of pairs, and the symmetries of the cube ties of at
  // most 48. Long prisms have ties of thousands; the order among these is arbitrary.
  constexpr std::size_t kMost = 48;
  queue_.collect(narrow_ * queue_.key(top), tied_, kMost);
  if (tied_.size() > kMost) tied_.assign(1, top);
  const Scalar same = same_ * queue_.key(top);
  std::erase_if(
      tied_, [&](HalfspaceId i) { return same < queue_.key(i) && !dual_.seem_congruent(i, top); });
  if (tied_.size() == 1) return true;
  bool all_fresh = true;
  for (const HalfspaceId i : tied_) {
    if (!(state_[i.index()] & kStale)) continue;
    queue_.update(i, evaluate(i));
    all_fresh = false;
  }
  if (!all_fresh) return false;
  Scalar least = upper_[top.index()];
  for (const HalfspaceId i : tied_) least = std::min(least, upper_[i.index()]);
  std::erase_if(tied_, [&](HalfspaceId i) { return least < lower_[i.index()]; });
  const auto first =
      std::min_element(tied_.begin(), tied_.end(),
                       [&](HalfspaceId a, HalfspaceId b) { return dual_.seems_to_precede(a, b); });
  std::iter_swap(tied_.begin(), first);
  return true;
}

// Of the initial solid. Not more than it is, so that the growth limit is kept.
template <class Arithmetic>
typename FloatLoop<Arithmetic>::Scalar FloatLoop<Arithmetic>::scaled_measure() const {
  if (!metric_) return Scalar(six_times_volume(dual_).lower);
  const Cost exact = exact_measure(dual_, dual_.triangles(), options_.cost);
  const double measure = scaled_enclosure(exact, dual_.cost_exponent(options_.cost)).lower;
  return Scalar(measure * cost_multiple(options_.cost).lower);
}

template <class Arithmetic>
void FloatLoop<Arithmetic>::remove(HalfspaceId i) {
  prepare(i);
  mesh_.remove(i, ring_, triangles_);
  queue_.erase(i);
  for (const HalfspaceId r : ring_.vertices) {
    if (!queue_.contains(r)) continue;  // it is kept
    state_[r.index()] |= kStale;
    const double lasting = metric_ ? forget_terms_of(i, terms_[r.index()]) : 0;
    if (metric_ && errors_) errors_->lower(r, lasting);
    if (patience_[r.index()] > 0) {
      --patience_[r.index()];
    } else if (metric_) {
      queue_.update(r, Scalar(lasting));
    } else if (state_[r.index()] & kWide) {
      queue_.update(r, lower_[r.index()]);
    }
  }
  prepared_.reset();
}

}  // namespace convexact
