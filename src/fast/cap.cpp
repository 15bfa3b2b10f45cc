// SPDX-License-Identifier: MIT
// T by signs that doubles decide or DualSigns; then CapVolume in doubles, double-doubles,
// rationals.
#include "fast/cap.hpp"

#include <algorithm>
#include <array>

#include "geometry/plane_determinants.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// Determinants for CapVolume as rationals. The integer rows (n, d) stand for the dual points: a
// factor of a row appears as often above as below in every term, so the volume is that of the cap
// in the caller's units.
class ExactDeterminants {
 public:
  using Number = Rational;
  struct Sum {
    std::vector<Rational> terms;
    void add(const Rational& x) { terms.push_back(x); }
    Rational total() { return balanced_sum(std::move(terms)); }
    Rational scaled_down(const Rational& divisor) { return Rational(total() / divisor); }
  };

  ExactDeterminants(const FastDual& dual, HalfspaceId i, std::span<const HalfspaceId> ring)
      : dual_(dual), center_(i), ring_(ring) {}

  Rational base(std::uint32_t m) const { return determinant(center_, ring_[m], after(m)); }
  Rational slack(std::uint32_t m) const {
    return m < 2 ? Rational(0) : Rational(-height(center_, ring_[0], ring_[1], ring_[m]));
  }
  Rational leg(std::uint32_t m, std::uint32_t q) const {
    return Rational(-height(center_, ring_[m], after(m), ring_[q]));
  }
  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    low_ = ring_[low], middle_ = ring_[middle], high_ = ring_[high];
  }
  Rational vertex() const { return determinant(low_, middle_, high_); }
  Rational to_center() const { return height(low_, middle_, high_, center_); }
  Rational to(std::uint32_t q) const { return Rational(-height(low_, middle_, high_, ring_[q])); }

 private:
  HalfspaceId after(std::uint32_t m) const { return ring_[m + 1 == ring_.size() ? 0 : m + 1]; }
  Rational height(HalfspaceId a, HalfspaceId b, HalfspaceId c, HalfspaceId p) const {
    return Rational(
        plane_determinant(dual_.exact(a), dual_.exact(b), dual_.exact(c), dual_.exact(p)));
  }
  Rational determinant(HalfspaceId a, HalfspaceId b, HalfspaceId c) const {
    return Rational(normal_determinant(dual_.exact(a), dual_.exact(b), dual_.exact(c)));
  }

  const FastDual& dual_;
  HalfspaceId center_;
  std::span<const HalfspaceId> ring_;
  HalfspaceId low_, middle_, high_;
};

std::uint32_t length(const OneRing& ring) {
  return static_cast<std::uint32_t>(ring.vertices.size());
}

}  // namespace

// Signs of H within one ring, by the bound that holds for all of it.
struct FilteredCap::Beyond {
  FilteredCap& cap;
  double bound;
  Triple<double> normal{};
  std::array<std::uint32_t, 3> corners{};

  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    corners = {low, middle, high};
    const auto& point = cap.geometry_.point;
    normal = cross(point[middle] - point[low], point[high] - point[low]);
  }
  FilterSign by_doubles(std::uint32_t m) const {
    const auto& point = cap.geometry_.point;
    return filter_sign(dot(normal, point[m] - point[corners[0]]), bound);
  }
  HalfspaceId id(std::uint32_t position) const { return cap.ring_.vertices[position]; }
  bool is_beyond(std::uint32_t m) {
    const FilterSign sure = by_doubles(m);
    if (sure != FilterSign::Unknown) {
      cap.signs_.count_filtered();
      return sure == FilterSign::Positive;
    }
    return cap.signs_.height_beyond_doubles(id(corners[0]), id(corners[1]), id(corners[2]),
                                            id(m)) == Sign::Positive;
  }
};

// The same, telling the observer.
struct FilteredCap::ObservedBeyond : Beyond {
  bool is_beyond(std::uint32_t m) {
    cap.observer_->height(id(corners[0]), id(corners[1]), id(corners[2]), id(m), by_doubles(m));
    return Beyond::is_beyond(m);
  }
};

void FilteredCap::prepare(HalfspaceId i) {
  if (prepared_ == i) return;
  mesh_.one_ring(i, ring_);
  geometry_.load(i, ring_.vertices, [&](HalfspaceId v) { return dual_.near(v); });
  Beyond beyond{*this, geometry_.filter(Roundoff<double>::kUnit).height};
  if (observer_ == nullptr) {
    triangulator_.run(length(ring_), beyond, seed_, triangles_);
  } else {
    ObservedBeyond observed{beyond};
    triangulator_.run(length(ring_), observed, seed_, triangles_);
  }
  prepared_ = i;
}

bool FilteredCap::is_bounded() const {
  const auto& v = ring_.vertices;
  return std::all_of(triangles_.begin(), triangles_.end(), [&](const RingTriangle& t) {
    return signs_.determinant(v[t.low], v[t.middle], v[t.high]) == Sign::Positive;
  });
}

CostBounds<double> FilteredCap::in_doubles() {
  CostBounds<double> bounds = cost_.bounds(geometry_, triangles_, Roundoff<double>::kUnit);
  if (bounds.kind == Boundedness::Doubtful && !is_bounded()) {
    bounds = {Boundedness::Unbounded, 0, 0};
  }
  if (observer_ != nullptr) observer_->in_doubles(*prepared_, ring_, triangles_, bounds);
  return bounds;
}

CostBounds<DoubleDouble> FilteredCap::in_double_doubles() {
  long_geometry_.load(*prepared_, ring_.vertices,
                      [&](HalfspaceId v) { return dual_.long_point(v); });
  const CostBounds<DoubleDouble> bounds =
      long_cost_.bounds(long_geometry_, triangles_, Roundoff<DoubleDouble>::kUnit);
  if (observer_ != nullptr) observer_->in_double_doubles(*prepared_, ring_, triangles_, bounds);
  return bounds;
}

Rational FilteredCap::exactly() const {
  ExactDeterminants determinants(dual_, *prepared_, ring_.vertices);
  CapVolume<ExactDeterminants> volume;
  return volume.six_times(length(ring_), triangles_, determinants) / 6;
}

// Between the vertices (i, m - 1, m) and (i, m, m + 1) there is an edge unless they are the same.
FacetOutline FilteredCap::outline() const {
  FacetOutline result{*prepared_, {}};
  const auto& v = ring_.vertices;
  for (std::size_t m = 0, k = v.size(); m < k; ++m) {
    const HalfspaceId before = v[m == 0 ? k - 1 : m - 1], after = v[m + 1 == k ? 0 : m + 1];
    if (signs_.height(*prepared_, before, v[m], after) == Sign::Zero) continue;
    result.neighbours.push_back(v[m]);
  }
  return result;
}

CostBounds<double> six_times_volume(const FastDual& dual) {
  const HalfEdgeMesh mesh(dual.size(), dual.triangles());
  IntervalDeterminants<double>::Sum sum;
  OneRing ring;
  RingGeometry<double> geometry;
  std::size_t terms = 0;
  bool certain = true;
  for (std::size_t i = 0; i < dual.size(); ++i) {
    mesh.one_ring(HalfspaceId(i), ring);
    geometry.load(HalfspaceId(i), ring.vertices, [&](HalfspaceId v) { return dual.near(v); });
    IntervalDeterminants<double> determinants(geometry, Roundoff<double>::kUnit);
    add_cone(length(ring), determinants, sum);
    terms += ring.vertices.size();
    certain = certain && determinants.is_certain();
  }
  if (!certain) return CostBounds<double>::doubtful();
  // As for a cap, with all cones in one sum.
  const double slop = 2 * (16 + 2 * static_cast<double>(terms)) * Roundoff<double>::kUnit;
  const double tiny = ExponentRange<double>::kVolumeUnderflow;
  return {Boundedness::Bounded, std::max(sum.total.lower * (1 - slop) - tiny, 0.0),
          sum.total.upper * (1 + slop) + tiny};
}

Rational exact_volume(const FastDual& dual, std::span<const DualTriangle> triangles) {
  const HalfEdgeMesh mesh(dual.size(), triangles);
  std::vector<Rational> cones;
  OneRing ring;
  for (const HalfspaceId i : mesh.vertices()) {
    mesh.one_ring(i, ring);
    ExactDeterminants determinants(dual, i, ring.vertices);
    ExactDeterminants::Sum cone;
    add_cone(length(ring), determinants, cone);
    // The row of i is once more below than above, and the apex lies at slack w_i instead of 1.
    cones.push_back(cone.total() * -dual.exact(i)(dual.center()));
  }
  return Rational(balanced_sum(std::move(cones)) / 6);
}

}  // namespace convexact
