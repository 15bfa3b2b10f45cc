// SPDX-License-Identifier: MIT
// float_loop.hpp - the greedy loop in any floating-point arithmetic, without exact numbers.
#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/fast/cap_enclosure.hpp"
#include "convexact/fast/filtered_engine.hpp"
#include "convexact/fast/half_edge_mesh.hpp"
#include "convexact/fast/lazy_queue.hpp"
#include "convexact/fast/ring_geometry.hpp"
#include "convexact/fast/solid_volume.hpp"
#include "convexact/fast/triangulate_ring.hpp"
#include "convexact/number/rounding.hpp"

namespace convexact {

/// Arithmetic provides
///   Scalar                              + - * / and, by leading(), a double of the same sign
///   Triple<Scalar> point(HalfspaceId)   the dual point, off by at most 2 unit() per coordinate
///   double unit()                       the relative error of one operation
///
/// Signs of H are taken as they come out. Three guards, all relative to the size of what is
/// computed (PlaneFilter), keep the result sound:
/// - Existence: a halfspace is removed only if every D of its cap is beyond its error bound.
/// - Laziness: a changed cap is looked at again when its *lower end* comes to the top, not its
///   estimate; an ill-conditioned cap has a low one. (Without this guard an estimate that
///   is too high would never be looked at again.)
/// - Doubt: a cap that cannot be enclosed counts as unbounded until its ring changes.
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
      return leading(dot(normal, ring.point[m] - ring.point[low])) > 0;
    }
  };
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  void prepare(HalfspaceId i);
  double evaluate(HalfspaceId i);
  double six_times_volume();
  std::optional<HalfspaceId> choose();
  void remove(HalfspaceId i);

  const FastDual& dual_;
  const Arithmetic& arithmetic_;
  const SimplifyOptions& options_;
  HalfEdgeMesh mesh_;
  // Keys are estimates where fresh and lower ends where stale. Where these hardly differ, as nearly
  // always, the key stays as it is and State says so.
  enum State : unsigned char { kFresh = 0, kStale = 1, kWide = 2 };
  static constexpr double kNarrow = 1 + 0x1p-24;
  LazyQueue queue_;
  std::vector<unsigned char> state_;
  std::vector<double> lower_;     // of six times the cost, as last enclosed
  std::vector<double> estimate_;  // likewise
  std::optional<HalfspaceId> prepared_;
  OneRing ring_;
  RingGeometry<Scalar> geometry_;
  RingTriangulator triangulator_;
  std::vector<RingTriangle> triangles_;
  CapEnclosure<Scalar> enclosure_;
  std::uint64_t evaluations_ = 0;
};

template <class Arithmetic>
FloatLoop<Arithmetic>::FloatLoop(const FastDual& dual, const Arithmetic& arithmetic,
                                 const SimplifyOptions& options)
    : dual_(dual),
      arithmetic_(arithmetic),
      options_(options),
      mesh_(dual.size(), dual.triangles(), dual.twins()),
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
  double allowance = kInfinity;
  if (options_.max_growth) {
    allowance = to_double(*options_.max_growth, Rounding::Nearest) * six_times_volume();
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
    const double cost = estimate_[choice->index()];
    allowance -= cost;
    if (allowance < 0) {
      result.stop = StopReason::GrowthLimit;
      break;
    }
    result.steps.push_back({*choice, 1, cost / 6, cost / 6});
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

// The key of i, fresh: infinite if some vertex of the cap does not exist, or may not.
template <class Arithmetic>
double FloatLoop<Arithmetic>::evaluate(HalfspaceId i) {
  prepare(i);
  ++evaluations_;
  const CapRange<Scalar> range = enclosure_.run(geometry_, triangles_, arithmetic_.unit());
  using Kind = typename CapRange<Scalar>::Kind;
  double& lower = lower_[i.index()];
  double& estimate = estimate_[i.index()];
  lower = range.kind == Kind::Unbounded ? kInfinity : leading(range.lower);
  estimate = range.kind != Kind::Bounded ? kInfinity : (lower + leading(range.upper)) / 2;
  const bool narrow = estimate <= kNarrow * lower;
  state_[i.index()] = narrow ? kFresh : kWide;
  return narrow ? lower : estimate;
}

// The cheapest estimate, once no stale lower end is below it.
template <class Arithmetic>
std::optional<HalfspaceId> FloatLoop<Arithmetic>::choose() {
  for (;;) {
    const HalfspaceId top = queue_.top();
    if (state_[top.index()] & kStale) {
      queue_.update(top, evaluate(top));
    } else if (queue_.key(top) == kInfinity) {
      return {};
    } else {
      return top;
    }
  }
}

template <class Arithmetic>
double FloatLoop<Arithmetic>::six_times_volume() {
  typename RangeSource<Scalar>::Sum sum;
  for (std::size_t i = 0; i < dual_.size(); ++i) {
    prepare(HalfspaceId(i));
    RangeSource<Scalar> source(geometry_, arithmetic_.unit());
    add_cone(static_cast<std::uint32_t>(ring_.vertices.size()), source, sum);
  }
  return (leading(sum.total.lower) + leading(sum.total.upper)) / 2;
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
