// SPDX-License-Identifier: MIT
// cap.hpp - one cap of a shrinking dual hull: its triangulation, and its volume in three
// arithmetics.
#pragma once
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "fast/cap_volume.hpp"
#include "fast/dual.hpp"
#include "fast/mesh.hpp"
#include "fast/ring.hpp"
#include "fast/signs.hpp"

namespace convexact {

/// For CapVolume. The integer rows (n, d) stand for the dual points: a factor of a row appears as
/// often above as below in every term, so the volume is that of the cap in the caller's units.
class ExactCapSource {
 public:
  using Number = Rational;
  /// Adds in pairs of equal depth: the denominators differ, so partial sums grow.
  class Sum {
   public:
    void add(const Rational& x) { terms_.push_back(x); }
    Rational scaled_down(const Rational& divisor) { return Rational(total() / divisor); }
    Rational total();

   private:
    std::vector<Rational> terms_;
  };

  ExactCapSource(const FastDual& dual, HalfspaceId i, std::span<const HalfspaceId> ring)
      : dual_(dual), center_(i), ring_(ring) {}

  Rational base(std::uint32_t m) const;
  Rational slack(std::uint32_t m) const;
  Rational leg(std::uint32_t m, std::uint32_t q) const;
  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    low_ = ring_[low], middle_ = ring_[middle], high_ = ring_[high];
  }
  Rational vertex() const;
  Rational to_center() const;
  Rational to(std::uint32_t q) const;

 private:
  HalfspaceId after(std::uint32_t m) const { return ring_[m + 1 == ring_.size() ? 0 : m + 1]; }
  Rational height(HalfspaceId a, HalfspaceId b, HalfspaceId c, HalfspaceId p) const;

  const FastDual& dual_;
  HalfspaceId center_;
  std::span<const HalfspaceId> ring_;
  HalfspaceId low_, middle_, high_;
};

/// What a cap depends on: the plane of its facet and those of all facets that share an edge with
/// it, counter-clockwise from outside. Planes that only pass through a vertex of the facet bound
/// nothing beyond it: without dual point i, the dual face they share with i keeps its other points.
struct CapOutline {
  HalfspaceId facet;
  std::vector<HalfspaceId> neighbours;
};

/// Hears of everything that was decided without exact numbers, so that a test can decide it again.
/// The engine runs with this one, which compiles to nothing.
struct NoAudit {
  void height(HalfspaceId, HalfspaceId, HalfspaceId, HalfspaceId, FilterSign) {}
  template <class Scalar>
  void cap(HalfspaceId, const OneRing&, const std::vector<RingTriangle>&, const CapRange<Scalar>&) {
  }
};

/// The ring of one dual point, its triangulation T, and the volume of the cap in three arithmetics.
template <class Audit>
class CapEvaluator {
 public:
  CapEvaluator(const FastDual& dual, const HalfEdgeMesh& mesh, std::uint64_t seed, Audit& audit)
      : dual_(dual), mesh_(mesh), audit_(audit), signs_(dual), seed_(seed) {}

  /// Reads the ring of i and triangulates it, unless it is the one read last.
  void prepare(HalfspaceId i);
  /// Forgets the ring read last: the mesh has changed.
  void invalidate() { prepared_.reset(); }
  const OneRing& ring() const { return ring_; }
  const std::vector<RingTriangle>& triangles() const { return triangles_; }

  /// Of the prepared cap. The first never says Doubtful where it is unbounded, though its upper end
  /// may be infinite; the others are for bounded caps only.
  CapRange<double> in_doubles();
  CapRange<DoubleDouble> in_double_doubles();
  Rational exactly();
  CapOutline outline() const;

  const SignCounts& sign_counts() const { return signs_.counts(); }

 private:
  class Beyond;
  bool is_bounded() const;

  const FastDual& dual_;
  const HalfEdgeMesh& mesh_;
  Audit& audit_;
  DualSigns signs_;
  std::optional<HalfspaceId> prepared_;
  OneRing ring_;
  std::vector<RingTriangle> triangles_;
  RingTriangulator triangulator_;
  std::uint64_t seed_;
  RingGeometry<double> geometry_;
  RingGeometry<DoubleDouble> long_geometry_;
  CapEnclosure<double> enclosure_;
  CapEnclosure<DoubleDouble> long_enclosure_;
  CapVolume<ExactCapSource> exact_volume_;
};

// Signs of H within one ring, by the bound that holds for all of it.
template <class Audit>
class CapEvaluator<Audit>::Beyond {
 public:
  Beyond(CapEvaluator& cap, double bound) : cap_(cap), bound_(bound) {}

  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    corners_ = {low, middle, high};
    const auto& point = cap_.geometry_.point;
    normal_ = cross(point[middle] - point[low], point[high] - point[low]);
  }
  bool is_beyond(std::uint32_t m) {
    const auto& point = cap_.geometry_.point;
    const FilterSign sure = filter_sign(dot(normal_, point[m] - point[corners_[0]]), bound_);
    const auto id = [&](std::uint32_t position) { return cap_.ring_.vertices[position]; };
    const HalfspaceId a = id(corners_[0]), b = id(corners_[1]), c = id(corners_[2]), p = id(m);
    cap_.audit_.height(a, b, c, p, sure);
    if (sure != FilterSign::Unknown) {
      cap_.signs_.count_filtered();
      return sure == FilterSign::Positive;
    }
    return cap_.signs_.height_beyond_doubles(a, b, c, p) == Sign::Positive;
  }

 private:
  CapEvaluator& cap_;
  double bound_;
  Triple<double> normal_{};
  std::array<std::uint32_t, 3> corners_{};
};

template <class Audit>
void CapEvaluator<Audit>::prepare(HalfspaceId i) {
  if (prepared_ == i) return;
  mesh_.one_ring(i, ring_);
  geometry_.load(i, ring_.vertices, [&](HalfspaceId v) { return dual_.near(v); });
  Beyond beyond(*this, geometry_.filter(Roundoff<double>::kUnit).height);
  triangulator_.run(static_cast<std::uint32_t>(ring_.vertices.size()), beyond, seed_, triangles_);
  prepared_ = i;
}

template <class Audit>
bool CapEvaluator<Audit>::is_bounded() const {
  const auto& v = ring_.vertices;
  for (const RingTriangle& t : triangles_) {
    if (signs_.determinant(v[t.low], v[t.middle], v[t.high]) != Sign::Positive) return false;
  }
  return true;
}

template <class Audit>
CapRange<double> CapEvaluator<Audit>::in_doubles() {
  CapRange<double> range = enclosure_.run(geometry_, triangles_, Roundoff<double>::kUnit);
  using Kind = CapRange<double>::Kind;
  if (range.kind == Kind::Doubtful && !is_bounded()) range = {Kind::Unbounded, 0, 0};
  audit_.cap(*prepared_, ring_, triangles_, range);
  return range;
}

template <class Audit>
CapRange<DoubleDouble> CapEvaluator<Audit>::in_double_doubles() {
  long_geometry_.load(*prepared_, ring_.vertices,
                      [&](HalfspaceId v) { return dual_.long_point(v); });
  const CapRange<DoubleDouble> range =
      long_enclosure_.run(long_geometry_, triangles_, Roundoff<DoubleDouble>::kUnit);
  audit_.cap(*prepared_, ring_, triangles_, range);
  return range;
}

template <class Audit>
Rational CapEvaluator<Audit>::exactly() {
  ExactCapSource source(dual_, *prepared_, ring_.vertices);
  const auto k = static_cast<std::uint32_t>(ring_.vertices.size());
  return exact_volume_.six_times(k, triangles_, source) / 6;
}

// Between the vertices (i, m - 1, m) and (i, m, m + 1) there is an edge unless they are the same.
template <class Audit>
CapOutline CapEvaluator<Audit>::outline() const {
  CapOutline result{*prepared_, {}};
  const auto& v = ring_.vertices;
  for (std::size_t m = 0, k = v.size(); m < k; ++m) {
    const HalfspaceId before = v[m == 0 ? k - 1 : m - 1], after = v[m + 1 == k ? 0 : m + 1];
    if (signs_.height(*prepared_, before, v[m], after) == Sign::Zero) continue;
    result.neighbours.push_back(v[m]);
  }
  return result;
}

}  // namespace convexact
