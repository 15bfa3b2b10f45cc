// SPDX-License-Identifier: MIT
#include "scene/part_runs.hpp"

#include <cmath>
#include <utility>

#include "convexact/measure.hpp"
#include "fast/filtered_loop.hpp"
#include "fast/float_loop.hpp"
#include "number/precision.hpp"
#include "simplify/exact_engine.hpp"

namespace convexact {
namespace {

// Of a cost in units of 2^exponent.
PartRun::Bounds wide_bounds(double low, double high, long exponent) {
  return {WideDouble::of(low, exponent), WideDouble::of(high, exponent)};
}

Enclosure enclosure_of(double low, double high, long exponent) {
  return {scale_by_power_of_two(to_rational(low), exponent),
          scale_by_power_of_two(to_rational(high), exponent), kMeasureBits};
}

class ExactPart : public ScenePartRun, private ExactPartRun {
 public:
  ExactPart(const RunInput& input, const SimplifyRequest& request)
      : input_(input),
        options_(options_of(request, input)),
        run_(input.solid->dual, input.center, options_) {}

  std::size_t left() const override { return run_.left(); }
  bool find_next() override {
    next_ = left() > kLeastFaces ? run_.next() : nullptr;
    return next_ != nullptr;
  }
  Bounds cost_bounds() override {
    return wide_bounds(next_->cost->low_double(), next_->cost->high_double(), 0);
  }
  Enclosure added() override { return exactly_added().enclose(kMeasureBits); }
  void make() override { run_.make(); }
  ExactPartRun* exact() override { return this; }
  RunEnd finish(StopReason stop, StageLog& log) override { return end_of(run_.finish(stop), log); }

 private:
  const Cost& exact_cost() override { return *next_->cost; }
  Cost exactly_added() override { return run_.added(options_.growth_measure()); }
  Cost measure_now() override { return run_.measure(options_.growth_measure()); }
  Cost measure_before() override {
    return exact_measure(input_.solid->polytope, options_.growth_measure());
  }

  const RunInput& input_;
  SimplifyOptions options_;
  ExactRun run_;
  const Step* next_ = nullptr;
};

// With a record of its steps or without.
class FilteredPart : public ScenePartRun, private ExactPartRun {
 public:
  FilteredPart(const RunInput& input, const SimplifyRequest& request)
      : options_(options_of(request, input)) {
    if (input.dual) {
      loop_ = &lean_.emplace(*input.dual, options_);
      dual_ = &*input.dual;
    } else {
      RecordedLoop& recorded = recorded_.emplace(input.solid->dual, input.center, options_);
      loop_ = &recorded.loop();
      dual_ = &recorded.dual();
    }
  }

  std::size_t left() const override { return loop_->left(); }
  bool find_next() override {
    if (left() == kLeastFaces) return false;
    if (!is_evaluated_) loop_->evaluate_all();
    is_evaluated_ = true;
    next_ = loop_->next();
    return next_.has_value();
  }
  Bounds cost_bounds() override {
    return wide_bounds(next_->cost_lower, next_->cost_upper, dual_->cost_exponent(options_.cost));
  }
  Enclosure added() override {
    const Interval<double> added = loop_->added_by(*next_);
    if (!std::isfinite(added.upper)) return exactly_added().enclose(kMeasureBits);
    const CostMeasure measure = options_.growth_measure();
    return enclosure_of(added.lower, added.upper, dual_->cost_exponent(measure));
  }
  void make() override { loop_->make(*next_, recorded_ ? recorded_->steps() : nullptr); }
  ExactPartRun* exact() override { return this; }
  RunEnd finish(StopReason stop, StageLog& log) override {
    FastResult result = loop_->finish(stop);
    if (recorded_) return end_of(recorded_->finish(std::move(result)), log);
    return end_of(result, *dual_, Engine::Filtered, log);
  }

 private:
  const Cost& exact_cost() override { return loop_->cost(next_->removed); }
  Cost exactly_added() override { return loop_->exactly_added_by(*next_); }
  Cost measure_now() override { return loop_->measure(options_.growth_measure()); }
  Cost measure_before() override {
    return exact_measure(*dual_, dual_->triangles(), options_.growth_measure());
  }

  SimplifyOptions options_;
  std::optional<FilteredLoop> lean_;
  std::optional<RecordedLoop> recorded_;
  FilteredLoop* loop_;
  const FastDual* dual_;
  bool is_evaluated_ = false;
  std::optional<FastStep> next_;
};

class FloatPart : public ScenePartRun {
 public:
  FloatPart(const RunInput& input, const SimplifyRequest& request)
      : dual_(*input.dual),
        options_(options_of(request, input)),
        arithmetic_{dual_, {dual_}},
        loop_(dual_, arithmetic_, options_) {}

  std::size_t left() const override { return loop_.left(); }
  bool find_next() override {
    if (left() == kLeastFaces) return false;
    if (!is_evaluated_) loop_.evaluate_all();
    is_evaluated_ = true;
    next_ = loop_.next();
    is_stuck_ = !next_;
    return !is_stuck_;
  }
  Bounds cost_bounds() override {
    return wide_bounds(next_->cost_lower, next_->cost_upper, dual_.cost_exponent(options_.cost));
  }
  Enclosure added() override {
    const double cost = next_->cost_lower;
    return enclosure_of(cost, cost, dual_.cost_exponent(options_.cost));
  }
  void make() override { loop_.make(*next_); }
  ExactPartRun* exact() override { return nullptr; }
  RunEnd finish(StopReason stop, StageLog& log) override {
    FastResult result = loop_.finish(is_stuck_ ? options_.when_stuck() : stop);
    result.stop = stop;
    return end_of(result, dual_, Engine::Float, log);
  }

 private:
  const FastDual& dual_;
  SimplifyOptions options_;
  Doubles arithmetic_;
  FloatLoop<Doubles> loop_;
  bool is_evaluated_ = false, is_stuck_ = false;
  std::optional<FastStep> next_;
};

}  // namespace

std::unique_ptr<ScenePartRun> start_part(const RunInput& input, const SimplifyRequest& request) {
  switch (request.engine) {
    case Engine::Exact:
      return std::make_unique<ExactPart>(input, request);
    case Engine::Filtered:
      return std::make_unique<FilteredPart>(input, request);
    case Engine::Float:
      break;
  }
  return std::make_unique<FloatPart>(input, request);
}

}  // namespace convexact
