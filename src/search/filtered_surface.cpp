// SPDX-License-Identifier: MIT

#include "fast/cap.hpp"
#include "fast/mesh.hpp"
#include "search/exchange_surface.hpp"
#include "search/known_caps.hpp"

namespace convexact {
namespace {

// Where the solid without i is bounded, i is taken off the mesh for as long as exchanges of i are
// asked for: then the change by an exchange for j is the cap of i, computed once, less that of j.
// It is not taken off before a cap is needed that the known ones do not rule out.
class FilteredSurface : public ExchangeSurface {
 public:
  FilteredSurface(const FastDual& dual, std::span<const DualTriangle> triangles,
                  CostMeasure measure)
      : dual_(dual), signs_(dual_), mesh_(dual_.size(), triangles), cap_(dual_, mesh_, measure, 1) {
    if (measure == CostMeasure::Volume) known_.emplace(dual.size());
  }
  FilteredSurface(const FilteredSurface&) = delete;
  FilteredSurface& operator=(const FilteredSurface&) = delete;

  std::optional<Change> change(HalfspaceId i, HalfspaceId j, double below) override {
    if (out_ != i) turn_to(i);
    if (gained_.kind == Boundedness::Unbounded) return change_with_both(i, j);
    if (is_known_to_lose_too_little(j, below)) return {};
    if (!is_off_) take_off();
    return change_without(j);
  }

  Cost exact_change(HalfspaceId i, HalfspaceId j) override {
    insert_beside(i, j);
    cap_.prepare(i);
    const Cost gained = cap_.exactly();
    cap_.prepare(j);
    const Cost lost = cap_.exactly();
    remove(j);
    return difference(gained, lost);
  }

  double in_unit(const Cost& change) override {
    const CostMeasure measure = cap_.measure();
    return scaled_enclosure(change, dual_.cost_exponent(measure)).lower *
           cost_multiple(measure).lower;
  }

  void exchange(HalfspaceId i, HalfspaceId j) override {
    insert_beside(i, j);
    cap_.prepare(i);
    remove(i);
  }

  Interval<double> measure_bounds() override {
    if (cap_.measure() != CostMeasure::Volume) return ExchangeSurface::measure_bounds();
    put_back();
    return six_times_volume(dual_, mesh_);
  }
  std::vector<DualTriangle> triangles() override {
    put_back();
    return mesh_.triangles();
  }
  Cost measure(std::span<const DualTriangle> triangles) const override {
    return exact_measure(dual_, triangles, cap_.measure());
  }

 private:
  void turn_to(HalfspaceId i);
  bool is_known_to_lose_too_little(HalfspaceId j, double below);
  void take_off();
  void put_back();
  CostBounds<double> measure_cap(HalfspaceId i, const OneRing& ring);
  Change change_without(HalfspaceId j);
  std::optional<Change> change_with_both(HalfspaceId i, HalfspaceId j);
  bool sees(HalfspaceId j, const DualTriangle& t) const;
  auto sight_of(HalfspaceId j) const {
    return [this, j](const DualTriangle& t) { return sees(j, t); };
  }
  void insert_beside(HalfspaceId i, HalfspaceId j);
  void remove(HalfspaceId i);

  const FastDual& dual_;
  // All coordinates of dual points are at most 1 in size.
  const double height_bound_ = PlaneFilter::within({2, 2, 2}, Roundoff<double>::kUnit).height;
  DualSigns signs_;
  HalfEdgeMesh mesh_;
  FilteredCap cap_;
  std::optional<KnownCaps> known_;  // if the measure is the volume
  std::optional<HalfspaceId> out_;  // whose exchanges were asked for last
  OneRing out_ring_;                // of it
  CostBounds<double> gained_;       // by removing it
  bool is_off_ = false;             // whether it is off the mesh
  OneRing ring_;                    // scratch
};

void FilteredSurface::turn_to(HalfspaceId i) {
  put_back();
  mesh_.one_ring(i, out_ring_);
  const CostBounds<double>* known = known_ ? known_->find(i, out_ring_.vertices) : nullptr;
  gained_ = known != nullptr ? *known : measure_cap(i, out_ring_);
  out_ = i;
}

// Bounds of the cap of i, which has that ring.
CostBounds<double> FilteredSurface::measure_cap(HalfspaceId i, const OneRing& ring) {
  cap_.prepare(i, ring);
  const CostBounds<double> bounds = cap_.in_doubles();
  if (known_) known_->add(i, ring.vertices, bounds);
  return bounds;
}

// Whether exchanging out_ for j is known to change the volume by `below` or more.
bool FilteredSurface::is_known_to_lose_too_little(HalfspaceId j, double below) {
  return known_ && known_->is_at_most(j, next_below(gained_.lower - below),
                                      [&](HalfspaceId x) { return x != *out_ && mesh_.has(x); });
}

void FilteredSurface::take_off() {
  cap_.prepare(*out_);
  remove(*out_);
  is_off_ = true;
}

void FilteredSurface::put_back() {
  if (is_off_) {
    mesh_.put_back(*out_, out_ring_);
    cap_.invalidate();
  }
  is_off_ = false;
  out_.reset();
}

Change FilteredSurface::change_without(HalfspaceId j) {
  mesh_.rim(sight_of(j), out_ring_.outer, ring_);
  // Hardly ever is this one known: then it would have been ruled out.
  const CostBounds<double> lost = measure_cap(j, ring_);
  return {next_below(gained_.lower - lost.upper), next_above(gained_.upper - lost.lower)};
}

std::optional<Change> FilteredSurface::change_with_both(HalfspaceId i, HalfspaceId j) {
  insert_beside(i, j);
  cap_.prepare(i);
  const CostBounds<double> gained = cap_.in_doubles();
  cap_.prepare(j);
  const CostBounds<double> lost = cap_.in_doubles();
  remove(j);
  if (gained.kind == Boundedness::Unbounded) return {};
  return Change{next_below(gained.lower - lost.upper), next_above(gained.upper - lost.lower)};
}

// Degenerate: a dual point sees the triangles that it is level with, as in DualSurface::insert().
bool FilteredSurface::sees(HalfspaceId j, const DualTriangle& t) const {
  const auto& [a, b, c] = t;
  const Triple<double>& p = dual_.near(a);
  const Triple<double> normal = cross(dual_.near(b) - p, dual_.near(c) - p);
  const FilterSign sure = filter_sign(dot(normal, dual_.near(j) - p), height_bound_);
  if (sure != FilterSign::Unknown) return sure == FilterSign::Positive;
  return signs_.height(a, b, c, j) != Sign::Negative;
}

// Mostly j sees triangles next to i, to which it is next on the input.
void FilteredSurface::insert_beside(HalfspaceId i, HalfspaceId j) {
  put_back();
  mesh_.one_ring(i, ring_);
  mesh_.insert(j, sight_of(j), ring_.outer);
  cap_.invalidate();
}

// Precondition: the cap of i is prepared.
void FilteredSurface::remove(HalfspaceId i) {
  mesh_.remove(i, cap_.ring(), cap_.triangles());
  cap_.invalidate();
}

}  // namespace

std::unique_ptr<ExchangeSurface> make_filtered_surface(const FastDual& dual,
                                                       std::span<const DualTriangle> triangles,
                                                       CostMeasure measure) {
  return std::make_unique<FilteredSurface>(dual, triangles, measure);
}

}  // namespace convexact
