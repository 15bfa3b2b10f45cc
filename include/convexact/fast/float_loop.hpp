// SPDX-License-Identifier: MIT
// float_loop.hpp - the greedy loop in any floating-point arithmetic, without exact numbers.
#pragma once
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/fast/cap_volume.hpp"
#include "convexact/fast/filtered_engine.hpp"
#include "convexact/fast/half_edge_mesh.hpp"
#include "convexact/fast/lazy_queue.hpp"
#include "convexact/fast/ring_geometry.hpp"
#include "convexact/fast/solid_volume.hpp"
#include "convexact/fast/triangulate_ring.hpp"
#include "convexact/number/rounding.hpp"

namespace convexact {

/// Determinants as they come out, for CapVolume and add_cone.
template <class Scalar>
class FloatSource {
 public:
  using Number = Scalar;
  struct Sum {
    Number total{0.0};
    void add(const Number& x) { total += x; }
    Number scaled_down(const Number& x) const { return total / x; }
  };

  FloatSource(const RingGeometry<Scalar>& ring, double existence_guard)
      : ring_(ring), existence_guard_(existence_guard) {}

  Number base(std::uint32_t m) { return existing(dot(ring_.side[m], ring_.center)); }
  Number slack(std::uint32_t m) const { return clamped(-dot(ring_.side[0], ring_.arm[m])); }
  Number leg(std::uint32_t m, std::uint32_t q) const {
    return clamped(-dot(ring_.side[m], ring_.arm[q]));
  }
  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    low_ = low;
    normal_ = cross(ring_.point[middle] - ring_.point[low], ring_.point[high] - ring_.point[low]);
  }
  Number vertex() { return existing(dot(normal_, ring_.point[low_])); }
  Number to_center() const { return clamped(-dot(normal_, ring_.arm[low_])); }
  Number to(std::uint32_t q) const {
    return clamped(-dot(normal_, ring_.point[q] - ring_.point[low_]));
  }

  /// Whether every vertex asked for exists beyond doubt.
  bool all_exist() const { return all_exist_; }

 private:
  // True heights are not negative; one that comes out so is zero up to rounding.
  static Number clamped(const Number& x) { return leading(x) > 0 ? x : Number(0.0); }
  Number existing(const Number& determinant) {
    all_exist_ &= leading(determinant) > existence_guard_;  // false for NaN as well
    return determinant;
  }

  const RingGeometry<Scalar>& ring_;
  double existence_guard_;
  Triple<Scalar> normal_{};
  std::uint32_t low_ = 0;
  bool all_exist_ = true;
};

/// Arithmetic provides
///   Scalar                              + - * / and, by leading(), a double of the same sign
///   Triple<Scalar> point(HalfspaceId)   the dual point, off by at most 2 unit() per coordinate
///   double unit()                       the relative error of one operation
///
/// Every changed cap is evaluated at once. To put that off as FilteredLoop does takes proven lower
/// ends: an estimate that is too high would never be looked at again.
///
/// It ends: each pass removes a halfspace or stops, and RingTriangulator ends whatever the signs.
/// The surface stays a sphere around the center: the new triangles of a removal cover, seen
/// from the center, what the old ones covered, because all are proven to be positively oriented
/// (D > existence guard) and have the same rim. So the center stays inside the hull of the dual
/// points that are left, and the solid stays bounded. No ring gets shorter than three.
template <class Arithmetic>
class FloatLoop {
 public:
  using Scalar = typename Arithmetic::Scalar;

  FloatLoop(const FastDual& dual, const Arithmetic& arithmetic, const SimplifyOptions& options)
      : dual_(dual),
        arithmetic_(arithmetic),
        options_(options),
        mesh_(dual.size(), dual.triangles()),
        queue_(dual.size()) {
    if (options.faces < 4) throw Error(ErrorCode::InvalidArgument, "a solid has at least 4 faces");
    if (options.max_growth && *options.max_growth < 0)
      throw Error(ErrorCode::InvalidArgument, "a growth limit is not negative");
  }

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

  void prepare(HalfspaceId i);
  double six_times_cost(HalfspaceId i);
  double six_times_volume();
  void remove(HalfspaceId i);

  const FastDual& dual_;
  const Arithmetic& arithmetic_;
  const SimplifyOptions& options_;
  HalfEdgeMesh mesh_;
  LazyQueue queue_;  // of costs; infinite where the removal may be unbounded
  OneRing ring_;
  RingGeometry<Scalar> geometry_;
  RingTriangulator triangulator_;
  std::vector<RingTriangle> triangles_;
  CapVolume<FloatSource<Scalar>> volume_;
  std::vector<HalfspaceId> changed_;
  std::uint64_t evaluations_ = 0;
};

template <class Arithmetic>
FastResult FloatLoop<Arithmetic>::run() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  FastResult result;
  double allowance = infinity;
  if (options_.max_growth) {
    allowance = to_double(*options_.max_growth, Rounding::Nearest) * six_times_volume();
  }
  std::size_t left = dual_.size();
  for (std::size_t i = 0; left > options_.faces && i < dual_.size(); ++i) {
    queue_.append(HalfspaceId(i), six_times_cost(HalfspaceId(i)));
  }
  queue_.make_heap();
  while (left > options_.faces) {
    if (options_.stop != nullptr && *options_.stop) throw Error(ErrorCode::Stopped, "interrupted");
    const HalfspaceId choice = queue_.top();
    const double cost = queue_.key(choice);
    if (cost == infinity) {
      result.stop = StopReason::AllUnbounded;
      break;
    }
    allowance -= cost;
    if (allowance < 0) {
      result.stop = StopReason::GrowthLimit;
      break;
    }
    result.steps.push_back({choice, 1, cost / 6, cost / 6});
    remove(choice);
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
  mesh_.one_ring(i, ring_);
  geometry_.load(i, ring_.vertices, [&](HalfspaceId v) { return arithmetic_.point(v); });
  Beyond beyond{geometry_};
  triangulator_.run(static_cast<std::uint32_t>(ring_.vertices.size()), beyond, options_.seed,
                    triangles_);
}

// Infinite if some vertex of the cap may not exist.
template <class Arithmetic>
double FloatLoop<Arithmetic>::six_times_cost(HalfspaceId i) {
  prepare(i);
  ++evaluations_;
  FloatSource<Scalar> source(geometry_, geometry_.filter(arithmetic_.unit()).determinant);
  const auto k = static_cast<std::uint32_t>(ring_.vertices.size());
  const double cost = leading(volume_.six_times(k, triangles_, source));
  return source.all_exist() && cost >= 0 ? cost : std::numeric_limits<double>::infinity();
}

template <class Arithmetic>
double FloatLoop<Arithmetic>::six_times_volume() {
  typename FloatSource<Scalar>::Sum sum;
  for (std::size_t i = 0; i < dual_.size(); ++i) {
    prepare(HalfspaceId(i));
    FloatSource<Scalar> source(geometry_, 0);
    add_cone(static_cast<std::uint32_t>(ring_.vertices.size()), source, sum);
  }
  return leading(sum.total);
}

template <class Arithmetic>
void FloatLoop<Arithmetic>::remove(HalfspaceId i) {
  prepare(i);
  mesh_.remove(i, ring_, triangles_);
  queue_.erase(i);
  changed_ = ring_.vertices;
  for (const HalfspaceId r : changed_) queue_.update(r, six_times_cost(r));
}

}  // namespace convexact
