// SPDX-License-Identifier: MIT
// T is found by signs from doubles or DualSigns. The bounds of the cost then come from CapVolume or
// MetricCost, and the exact cost from rationals, roots and angles.
#include "fast/cap.hpp"

#include <algorithm>
#include <array>

#include "geometry/plane_determinants.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"

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

Integer squared_length(const IntegerVector3& v) { return dot(v, v); }

// The same for a cap's area and mean width. With rows (n, d) for dual points, n_x x n_y lambda is
// the roof edge itself, and 2 S_q = |n_q| * sum of lambda slack.

// The area of a facet in plane i from twice it, divided by the length of its normal as it is.
RootTerm area_term(const FastDual& dual, HalfspaceId i, const Rational& twice_per_normal) {
  const IntegerVector3 &normal = dual.exact(i).normal(), direction = primitive_direction(normal);
  int k = 0;
  while (direction[k] == 0) ++k;
  const Integer common = normal[k] / direction[k];
  return {twice_per_normal * Rational(common) / 2, squared_length(direction)};
}

// Twice the area of the base, divided by the length of its normal, as in add_cone().
Rational twice_base(std::uint32_t k, Roof<ExactDeterminants>& roof, ExactDeterminants& of) {
  ExactDeterminants::Sum sum;
  for (std::uint32_t q = 2; q < k; ++q) sum.add(roof.slack(0, q, of) * roof.base_edge(q, of));
  return sum.total();
}

Cost exact_area(const FastDual& dual, HalfspaceId i, std::span<const HalfspaceId> ring,
                std::span<const RingTriangle> triangles) {
  const auto k = static_cast<std::uint32_t>(ring.size());
  ExactDeterminants of(dual, i, ring);
  Roof<ExactDeterminants> roof;
  std::vector<ExactDeterminants::Sum> sides(k);
  roof.for_each_edge(k, triangles, of,
                     [&](std::uint32_t x, std::uint32_t y, const Rational& lambda) {
                       if (lambda == 0) return;
                       sides[x].add(lambda * roof.slack(x, y, of));
                       sides[y].add(lambda * roof.slack(y, x, of));
                     });
  std::vector<RootTerm> terms;
  for (std::uint32_t m = 0; m < k; ++m) {
    terms.push_back(area_term(dual, ring[m], sides[m].total()));
  }
  terms.push_back(area_term(dual, i, -twice_base(k, roof, of)));
  return Cost(RootSum(std::move(terms)));
}

// An edge in the planes x and y.
AngleTerm angle_term(const FastDual& dual, HalfspaceId x, HalfspaceId y, const Rational& lambda,
                     int factor) {
  const IntegerVector3 &m = dual.exact(x).normal(), &n = dual.exact(y).normal();
  const IntegerVector3 p = primitive_direction(m), q = primitive_direction(n);
  return {factor, lambda * lambda * Rational(squared_length(m.cross(n))),
          squared_length(p.cross(q)), dot(p, q)};
}

Cost exact_mean_width(const FastDual& dual, HalfspaceId i, std::span<const HalfspaceId> ring,
                      std::span<const RingTriangle> triangles) {
  const auto k = static_cast<std::uint32_t>(ring.size());
  ExactDeterminants of(dual, i, ring);
  Roof<ExactDeterminants> roof;
  std::vector<AngleTerm> terms;
  roof.for_each_edge(k, triangles, of,
                     [&](std::uint32_t x, std::uint32_t y, const Rational& lambda) {
                       terms.push_back(angle_term(dual, ring[x], ring[y], lambda, 1));
                     });
  for (std::uint32_t q = 0; q < k; ++q) {
    terms.push_back(angle_term(dual, i, ring[q], roof.base_edge(q, of), -1));
  }
  return Cost(AngleSum(std::move(terms)));
}

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

FilteredCap::FilteredCap(const FastDual& dual, const HalfEdgeMesh& mesh, CostMeasure measure,
                         std::uint64_t seed, CostObserver* observer)
    : dual_(dual), mesh_(mesh), measure_(measure), observer_(observer), signs_(dual), seed_(seed) {
  if (measure == CostMeasure::Volume) return;
  metric_.emplace(dual, measure);
  long_metric_.emplace(dual, measure);
}

void FilteredCap::prepare(HalfspaceId i) {
  if (prepared_ == i) return;
  mesh_.one_ring(i, ring_);
  triangulate(i);
}

void FilteredCap::prepare(HalfspaceId i, const OneRing& ring) {
  ring_ = ring;
  triangulate(i);
}

void FilteredCap::triangulate(HalfspaceId i) {
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
  CostBounds<double> bounds = metric_
                                  ? metric_->bounds(geometry_, *prepared_, ring_.vertices,
                                                    triangles_, Roundoff<double>::kUnit)
                                  : cost_.bounds(geometry_, triangles_, Roundoff<double>::kUnit);
  if (bounds.kind == Boundedness::Doubtful && !is_bounded()) {
    bounds = {Boundedness::Unbounded, 0, 0};
  }
  if (observer_ != nullptr) observer_->in_doubles(*prepared_, ring_, triangles_, bounds);
  return bounds;
}

CostBounds<DoubleDouble> FilteredCap::in_double_doubles() {
  long_geometry_.load(*prepared_, ring_.vertices,
                      [&](HalfspaceId v) { return dual_.long_point(v); });
  CostBounds<DoubleDouble> bounds =
      long_metric_ ? long_metric_->bounds(long_geometry_, *prepared_, ring_.vertices, triangles_)
                   : long_cost_.bounds(long_geometry_, triangles_, Roundoff<DoubleDouble>::kUnit);
  if (long_metric_ && bounds.kind == Boundedness::Doubtful) return bounds_of_doubles();
  if (!long_metric_ && !are_close(bounds.lower, bounds.upper)) {
    CloseDeterminants determinants(long_geometry_, *prepared_, ring_.vertices, signs_);
    bounds = determinants.widened(close_volume_.six_times(length(ring_), triangles_, determinants));
  }
  if (observer_ != nullptr) observer_->in_double_doubles(*prepared_, ring_, triangles_, bounds);
  return bounds;
}

CostBounds<DoubleDouble> FilteredCap::bounds_of_doubles() {
  const auto [kind, lower, upper] =
      metric_->bounds(geometry_, *prepared_, ring_.vertices, triangles_, Roundoff<double>::kUnit);
  return {kind, DoubleDouble(lower), DoubleDouble(upper)};
}

Cost FilteredCap::exactly() const {
  if (measure_ == CostMeasure::Area) {
    return exact_area(dual_, *prepared_, ring_.vertices, triangles_);
  }
  if (measure_ == CostMeasure::MeanWidth) {
    return exact_mean_width(dual_, *prepared_, ring_.vertices, triangles_);
  }
  ExactDeterminants determinants(dual_, *prepared_, ring_.vertices);
  CapVolume<ExactDeterminants> volume;
  return Rational(volume.six_times(length(ring_), triangles_, determinants) / 6);
}

// Between the vertices (i, m - 1, m) and (i, m, m + 1) there is an edge unless they are the same.
FacetOutline FilteredCap::outline(HalfspaceId i) {
  if (prepared_ != i) mesh_.one_ring(i, outline_ring_);
  const auto& v = prepared_ == i ? ring_.vertices : outline_ring_.vertices;
  FacetOutline result{i, {}};
  result.neighbours.reserve(v.size());
  for (std::size_t m = 0, k = v.size(); m < k; ++m) {
    const HalfspaceId before = v[m == 0 ? k - 1 : m - 1], after = v[m + 1 == k ? 0 : m + 1];
    if (signs_.height(i, before, v[m], after) == Sign::Zero) continue;
    result.neighbours.push_back(v[m]);
  }
  return result;
}

Interval<double> cost_multiple(CostMeasure measure) {
  switch (measure) {
    case CostMeasure::Volume:
      return {6, 6};
    case CostMeasure::Area:
      return {2, 2};
    case CostMeasure::MeanWidth:
      break;
  }
  constexpr double kBelow4Pi = 0x1.921fb54442d18p+3;  // 4 pi is 12.566370614359172953...
  return {kBelow4Pi, next_above(kBelow4Pi)};
}

Interval<double> scaled_enclosure(const Cost& cost, long exponent) {
  const Enclosure value = cost.enclose(kMeasureBits);
  return {to_double(scale_by_power_of_two(value.low(), -exponent), Rounding::Down),
          to_double(scale_by_power_of_two(value.high(), -exponent), Rounding::Up)};
}

namespace {

// Six times the volume of the cone from the center over facet i, in the caller's units. The row of
// i appears once more below than above, and the apex lies at slack w_i instead of 1.
Rational six_times_cone(const FastDual& dual, HalfspaceId i, const OneRing& ring) {
  ExactDeterminants determinants(dual, i, ring.vertices);
  ExactDeterminants::Sum cone;
  add_cone(length(ring), determinants, cone);
  return cone.total() * -dual.exact(i)(dual.center());
}

// Of the cones over all facets the sum of those that doubles enclose to a share of 2^-21. The
// others are listed.
Interval<double> cones_in_doubles(const FastDual& dual, const HalfEdgeMesh& mesh,
                                  std::vector<HalfspaceId>& others) {
  IntervalDeterminants<double>::Sum sum;
  OneRing ring;
  RingGeometry<double> geometry;
  std::size_t terms = 0;
  for (const HalfspaceId i : mesh.vertices()) {
    mesh.one_ring(i, ring);
    geometry.load(i, ring.vertices, [&](HalfspaceId v) { return dual.near(v); });
    IntervalDeterminants<double> determinants(geometry, Roundoff<double>::kUnit);
    IntervalDeterminants<double>::Sum cone;
    add_cone(length(ring), determinants, cone);
    const auto& [lower, upper] = cone.total;
    if (determinants.is_certain() && upper - lower <= 0x1p-21 * upper) {
      sum.add(cone.total);
      terms += ring.vertices.size();
    } else {
      others.push_back(i);
    }
  }
  // As for a cap, with all cones in one sum.
  const double slop = 2 * (16 + 2 * static_cast<double>(terms)) * Roundoff<double>::kUnit;
  const double tiny = ExponentRange<double>::kVolumeUnderflow;
  return {std::max(sum.total.lower * (1 - slop) - tiny, 0.0), sum.total.upper * (1 + slop) + tiny};
}

Rational exact_cones(const FastDual& dual, const HalfEdgeMesh& mesh,
                     std::span<const HalfspaceId> bases) {
  std::vector<Rational> cones;
  OneRing ring;
  for (const HalfspaceId i : bases) {
    mesh.one_ring(i, ring);
    cones.push_back(six_times_cone(dual, i, ring));
  }
  return balanced_sum(std::move(cones));
}

}  // namespace

Interval<double> six_times_volume(const FastDual& dual, const HalfEdgeMesh& mesh) {
  std::vector<HalfspaceId> others;
  const Interval<double> sure = cones_in_doubles(dual, mesh, others);
  if (others.empty()) return sure;
  const Rational rest =
      scale_by_power_of_two(exact_cones(dual, mesh, others), -dual.volume_exponent());
  return {next_below(sure.lower + to_double(rest, Rounding::Down)),
          next_above(sure.upper + to_double(rest, Rounding::Up))};
}

Interval<double> six_times_volume(const FastDual& dual) {
  return six_times_volume(dual, HalfEdgeMesh(dual.size(), dual.triangles()));
}

namespace {

// Facets as bases of caps: the area of each, or the edges to neighbours of a higher id.
Cost metric_of(const FastDual& dual, const HalfEdgeMesh& mesh, CostMeasure measure) {
  std::vector<RootTerm> areas;
  std::vector<AngleTerm> edges;
  OneRing ring;
  for (const HalfspaceId i : mesh.vertices()) {
    mesh.one_ring(i, ring);
    const std::uint32_t k = length(ring);
    ExactDeterminants of(dual, i, ring.vertices);
    Roof<ExactDeterminants> roof;
    roof.for_each_edge(k, {}, of, [](std::uint32_t, std::uint32_t, const Rational&) {});
    if (measure == CostMeasure::Area) {
      areas.push_back(area_term(dual, i, twice_base(k, roof, of)));
      continue;
    }
    for (std::uint32_t q = 0; q < k; ++q) {
      const HalfspaceId other = ring.vertices[q];
      if (i < other) edges.push_back(angle_term(dual, i, other, roof.base_edge(q, of), 1));
    }
  }
  return measure == CostMeasure::Area ? Cost(RootSum(std::move(areas)))
                                      : Cost(AngleSum(std::move(edges)));
}

}  // namespace

Cost exact_measure(const FastDual& dual, std::span<const DualTriangle> triangles,
                   CostMeasure measure) {
  const HalfEdgeMesh mesh(dual.size(), triangles);
  return measure == CostMeasure::Volume
             ? Cost(Rational(exact_cones(dual, mesh, mesh.vertices()) / 6))
             : metric_of(dual, mesh, measure);
}

}  // namespace convexact
