// SPDX-License-Identifier: MIT
// float_loop.hpp - the greedy loop in any floating-point arithmetic, without exact numbers.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/run.hpp"
#include "fast/cap.hpp"
#include "fast/cap_volume.hpp"
#include "fast/engines.hpp"
#include "fast/float_cap.hpp"
#include "fast/float_errors.hpp"
#include "fast/keyed_queue.hpp"
#include "fast/mesh.hpp"
#include "fast/metric_cost.hpp"
#include "fast/signs.hpp"

namespace convexact {

// FloatCap<Arithmetic::Longer>, or nothing.
template <class Arithmetic>
struct LongerCapOf {
  using Type = std::monostate;
};
template <HasLonger Arithmetic>
struct LongerCapOf<Arithmetic> {
  using Type = FloatCap<typename Arithmetic::Longer>;
};

/// Whether the bounds of a cap are too far apart to be useful.
template <class Scalar>
bool is_loose(const CostEstimate<Scalar>& cap) {
  constexpr double kLoose = 1 + FloatBound::kMost / 4;
  return !(cap.upper <= Scalar(kLoose) * cap.lower);
}

/// Signs of H are taken as computed, and costs as CapCost estimates them. Three guards, all
/// relative to the size of the computed numbers (PlaneFilter), keep the result sound:
/// - Existence: a halfspace is removed only if every D of its cap is beyond its error bound.
/// - Laziness: a changed cap is evaluated again when its *lower bound* comes to the top, not
///   its estimate, unless both are nearly the same; an ill-conditioned cap has a low one. (Without
///   this guard a cap with too high an estimate would never be evaluated again.) Costs by area and
///   mean width may fall, so their lower bound is the sum of the terms that last.
/// - Doubt: a cap is evaluated in the longer arithmetic if it is not found bounded, because some D
///   is too close to zero or T is wrong, or if its bounds are far apart. If that does not find
///   it bounded either, it is postponed until its ring changes. (Facets that would be one, had
///   their vertices not been rounded, have dual points a few roundings apart.)
///
/// The loop ends: each pass removes a halfspace, evaluates a stale cap or stops, and
/// RingTriangulator ends whatever the signs. The surface stays a sphere around the center: the new
/// triangles of a removal cover, seen from the center, what the old ones covered, because all are
/// proven to be positively oriented and both have the same rim. So the center stays strictly inside
/// the hull of the dual points that are left, and the solid stays bounded. Nor does a ring get
/// shorter than three: two triangles on the same three dual points would have opposite
/// orientations.
template <class Arithmetic>
class FloatLoop {
 public:
  using Scalar = typename Arithmetic::Scalar;

  FloatLoop(const FastDual& dual, const Arithmetic& arithmetic, const SimplifyOptions& options);
  FastResult run();

  /// The loop step by step, like that of the filtered engine. First:
  /// @param removes_any  Whether there will be a step.
  void evaluate_all(bool removes_any = true);
  std::size_t left() const { return left_; }
  /// The next removal with its cost as estimated; none if no removal is found bounded.
  std::optional<FastStep> next();
  /// Makes next().
  void make(const FastStep& step);
  /// After the last step. @param stop  options.when_stuck() if next() was none.
  FastResult finish(StopReason stop);

  /// cost_multiple() times the cost of a removal that run() made, as it was found.
  const Scalar& scaled_cost(HalfspaceId removed) const { return estimate_[removed.index()]; }

 private:
  void prepare(HalfspaceId i);
  void load(HalfspaceId i);
  const Scalar& evaluate(HalfspaceId i);
  template <class Estimate>
  bool evaluate_by(HalfspaceId i, const Estimate& estimate);
  template <class Number>
  void keep(HalfspaceId i, const CostEstimate<Number>& cap);
  template <class Number>
  void enclose(HalfspaceId i, const CostEstimate<Number>& cap, bool is_right);
  bool is_unbounded_by_signs() const;
  Scalar scaled_measure() const;
  std::optional<HalfspaceId> choose();
  bool collect_tie(HalfspaceId top);
  void remove(HalfspaceId i);

  const FastDual& dual_;
  const Arithmetic& arithmetic_;
  const SimplifyOptions& options_;
  HalfEdgeMesh mesh_;
  // Keys are estimates where fresh and lower bounds where stale. Where these hardly differ, which
  // is the usual case, the key stays as it is. State says which of the two it is, and whether the
  // longer arithmetic was used.
  enum State : unsigned char { kFresh = 0, kStale = 1, kWide = 2, kLonger = 4 };
  const Scalar infinity_ = Scalar(std::numeric_limits<double>::infinity());
  const Scalar narrow_;  // estimate over lower bound, at most
  const Scalar same_;    // the same of a tie that no symmetry explains: a guess, not a bound
  KeyedQueue<Scalar> queue_;
  std::vector<unsigned char> state_;
  std::vector<Scalar> lower_;     // of cost_multiple() times the cost, as last enclosed
  std::vector<Scalar> upper_;     // likewise
  std::vector<Scalar> estimate_;  // likewise; infinite if there is no such cap, or may be none
  // Changes of its ring to wait for before another look at a cap that was not found bounded: with a
  // quarter of the ring's length, the total cost of all looks is linear in it.
  std::vector<std::uint32_t> patience_;
  std::optional<HalfspaceId> prepared_;
  OneRing ring_;
  FloatCap<Arithmetic> cap_;
  std::optional<typename LongerCapOf<Arithmetic>::Type> longer_cap_;
  std::optional<MetricCost> metric_;             // unless the measure is the volume
  std::vector<std::vector<LastingTerm>> terms_;  // empty if it is
  std::optional<FloatErrors> errors_;
  std::vector<RingTriangle> triangles_;
  std::vector<HalfspaceId> tied_;  // after choose(): the choice first, then its equals
  std::uint64_t evaluations_ = 0;
  std::size_t left_;
  FastResult result_;
};

extern template class FloatLoop<Doubles>;  // in float_loop.cpp

}  // namespace convexact
