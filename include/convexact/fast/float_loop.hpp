// SPDX-License-Identifier: MIT
// float_loop.hpp - the greedy loop in any floating-point arithmetic, without exact numbers.
#pragma once
#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/fast/cap_estimate.hpp"
#include "convexact/fast/filtered_engine.hpp"
#include "convexact/fast/half_edge_mesh.hpp"
#include "convexact/fast/lazy_queue.hpp"
#include "convexact/fast/ring_geometry.hpp"
#include "convexact/fast/solid_volume.hpp"
#include "convexact/fast/triangulate_ring.hpp"
#include "convexact/number/rounding.hpp"

namespace convexact {

/// Arithmetic provides
///   Scalar                              + - * / < > <= and, by leading(), the nearest double
///   Triple<Scalar> point(HalfspaceId)   the dual point, off by at most 2 unit() per coordinate
///   double unit()                       the relative error of one operation, at most 2^-24
///
/// Signs of H are taken as they come out, and costs as CapEstimator computes them. Three guards,
/// all relative to the size of what is computed (PlaneFilter), keep the result sound:
/// - Existence: a halfspace is removed only if every D of its cap is beyond its error bound.
/// - Laziness: a changed cap is looked at again when its *lower end* comes to the top, not its
///   estimate, unless both are nearly the same; an ill-conditioned cap has a low one. (Without this
///   guard an estimate that is too high would never be looked at again.)
/// - Doubt: a cap some D of which may be zero counts as unbounded until its ring changes.
///
/// It ends: each pass removes a halfspace, evaluates a stale cap or stops, and RingTriangulator
/// ends whatever the signs. The surface stays a sphere around the center: the new triangles of a
/// removal cover, seen from the center, what the old ones covered, because all are proven to be
/// positively oriented and have the same rim. So the center stays strictly inside the hull of the
/// dual points that are left, and the solid stays bounded. Nor does a ring get shorter than three:
/// two triangles on the same three dual points would have opposite orientations.
template <class Arithmetic>
class FloatLoop {
 public:
  using Scalar = typename Arithmetic::Scalar;

  FloatLoop(const FastDual& dual, const Arithmetic& arithmetic, const SimplifyOptions& options);
  FastResult run();

 private:
  // Signs of H as they come out.
  struct Beyond {
    const RingGeometry<Scalar>& ring;
    Triple<Scalar> normal{};
    std::uint32_t low = 0;

    void set_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      low = a;
      normal = cross(ring.point[b] - ring.point[a], ring.point[c] - ring.point[a]);
    }
    bool is_beyond(std::uint32_t m) const {
      return is_positive(dot(normal, ring.point[m] - ring.point[low]));
    }
  };

  void prepare(HalfspaceId i);
  const Scalar& evaluate(HalfspaceId i);
  Scalar six_times_volume();
  std::optional<HalfspaceId> choose();
  void remove(HalfspaceId i);

  const FastDual& dual_;
  const Arithmetic& arithmetic_;
  const SimplifyOptions& options_;
  HalfEdgeMesh mesh_;
  // Keys are estimates where fresh and lower ends where stale. Where these hardly differ, as
  // mostly, the key stays as it is and State says so.
  enum State : unsigned char { kFresh = 0, kStale = 1, kWide = 2 };
  const Scalar infinity_ = Scalar(std::numeric_limits<double>::infinity());
  const Scalar narrow_;  // estimate over lower end, at most
  KeyedQueue<Scalar> queue_;
  std::vector<unsigned char> state_;
  std::vector<Scalar> lower_;     // of six times the cost, as last enclosed
  std::vector<Scalar> estimate_;  // likewise; infinite if there is no such cap, or may be none
  std::optional<HalfspaceId> prepared_;
  OneRing ring_;
  RingGeometry<Scalar> geometry_;
  RingTriangulator triangulator_;
  std::vector<RingTriangle> triangles_;
  CapEstimator<Scalar> estimator_;
  std::uint64_t evaluations_ = 0;
};

template <class Arithmetic>
FloatLoop<Arithmetic>::FloatLoop(const FastDual& dual, const Arithmetic& arithmetic,
                                 const SimplifyOptions& options)
    : dual_(dual),
      arithmetic_(arithmetic),
      options_(options),
      mesh_(dual.size(), dual.triangles(), dual.twins()),
      narrow_(Scalar(1 + std::min(0x1p-24, 0x1p29 * arithmetic.unit()))),
      queue_(dual.size()),
      state_(dual.size(), kFresh),
      lower_(dual.size()),
      estimate_(dual.size()) {
  if (options.faces < 4) throw Error(ErrorCode::InvalidArgument, "a solid has at least 4 faces");
  if (options.max_growth && *options.max_growth < 0) {
    throw Error(ErrorCode::InvalidArgument, "a growth limit is not negative");
  }
}

template <class Arithmetic>
FastResult FloatLoop<Arithmetic>::run() {
  FastResult result;
  Scalar allowance = infinity_;
  if (options_.max_growth) {
    allowance = Scalar(to_double(*options_.max_growth, Rounding::Nearest)) * six_times_volume();
  }
  std::size_t left = dual_.size();
  for (std::size_t i = 0; left > options_.faces && i < dual_.size(); ++i) {
    queue_.append(HalfspaceId(i), evaluate(HalfspaceId(i)));
  }
  queue_.make_heap();
  while (left > options_.faces) {
    if (options_.stop != nullptr && *options_.stop) throw Error(ErrorCode::Stopped, "interrupted");
    const std::optional<HalfspaceId> choice = choose();
    if (!choice) {
      result.stop = StopReason::AllUnbounded;
      break;
    }
    const Scalar& cost = estimate_[choice->index()];
    if (!(cost <= allowance)) {
      result.stop = StopReason::GrowthLimit;
      break;
    }
    allowance = allowance - cost;
    result.steps.push_back({*choice, 1, leading(cost) / 6, leading(cost) / 6});
    remove(*choice);
    --left;
    if (options_.progress) options_.progress(left);
  }
  result.triangles = mesh_.triangles();
  result.survivors = mesh_.vertices();
  result.counts.evaluations = evaluations_;
  return result;
}

template <class Arithmetic>
void FloatLoop<Arithmetic>::prepare(HalfspaceId i) {
  if (prepared_ == i) return;
  mesh_.one_ring(i, ring_);
  geometry_.load(i, ring_.vertices, [&](HalfspaceId v) { return arithmetic_.point(v); });
  Beyond beyond{geometry_};
  triangulator_.run(static_cast<std::uint32_t>(ring_.vertices.size()), beyond, options_.seed,
                    triangles_);
  prepared_ = i;
}

// The key of i, fresh.
template <class Arithmetic>
const typename FloatLoop<Arithmetic>::Scalar& FloatLoop<Arithmetic>::evaluate(HalfspaceId i) {
  prepare(i);
  ++evaluations_;
  const CapEstimate<Scalar> cap = estimator_.run(geometry_, triangles_, arithmetic_.unit());
  using Kind = typename CapRange<Scalar>::Kind;
  Scalar& lower = lower_[i.index()];
  Scalar& estimate = estimate_[i.index()];
  lower = cap.kind == Kind::Unbounded ? infinity_ : cap.lower;
  estimate = cap.kind == Kind::Bounded ? cap.value : infinity_;
  state_[i.index()] = estimate <= narrow_ * lower ? kFresh : kWide;
  return estimate;
}

// The cheapest estimate, once no stale lower end is below it.
template <class Arithmetic>
std::optional<HalfspaceId> FloatLoop<Arithmetic>::choose() {
  for (;;) {
    const HalfspaceId top = queue_.top();
    if (state_[top.index()] & kStale) {
      queue_.update(top, evaluate(top));
    } else if (!(queue_.key(top) < infinity_)) {
      return {};
    } else {
      return top;
    }
  }
}

// Of the initial solid. Where doubts remain, rather too small: the growth limit is kept.
template <class Arithmetic>
typename FloatLoop<Arithmetic>::Scalar FloatLoop<Arithmetic>::six_times_volume() {
  typename RangeSource<Scalar>::Sum sum;
  bool certain = true;
  for (std::size_t i = 0; i < dual_.size(); ++i) {
    prepare(HalfspaceId(i));
    RangeSource<Scalar> source(geometry_, arithmetic_.unit());
    add_cone(static_cast<std::uint32_t>(ring_.vertices.size()), source, sum);
    certain = certain && source.is_certain();
  }
  const auto& [lower, upper] = sum.total;
  return certain ? (lower + upper) / Scalar(2.0) : lower;
}

template <class Arithmetic>
void FloatLoop<Arithmetic>::remove(HalfspaceId i) {
  prepare(i);
  mesh_.remove(i, ring_, triangles_);
  queue_.erase(i);
  for (const HalfspaceId r : ring_.vertices) {
    // What was unbounded stays so; what was in doubt, with a lower end of 0, is looked at next.
    if (state_[r.index()] == kWide) queue_.update(r, lower_[r.index()]);
    state_[r.index()] |= kStale;
  }
  prepared_.reset();
}

}  // namespace convexact
