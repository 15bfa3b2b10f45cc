// SPDX-License-Identifier: MIT

#include "fast/cap.hpp"
#include "fast/mesh.hpp"
#include "search/exchange_surface.hpp"

namespace convexact {
namespace {

// A triangle of dual points, all at most 1 in size, against which many dual points are tested.
struct SightTest {
  DualTriangle corners;
  Triple<double> normal, corner;

  SightTest(const FastDual& dual, const DualTriangle& t)
      : corners(t),
        normal(cross(dual.near(t[1]) - dual.near(t[0]), dual.near(t[2]) - dual.near(t[0]))),
        corner(dual.near(t[0])) {}

  FilterSign height(const Triple<double>& p) const {
    static const double kBound = PlaneFilter::within({2, 2, 2}, Roundoff<double>::kUnit).height;
    return filter_sign(dot(normal, p - corner), kBound);
  }
};

// Where the solid without i is bounded, i is taken off the mesh for as long as exchanges of i are
// asked for: then the change by an exchange for j is the cap of i, computed once, less that of j.
class FilteredSurface : public ExchangeSurface {
 public:
  FilteredSurface(const FastDual& dual, std::span<const DualTriangle> triangles,
                  CostMeasure measure)
      : dual_(dual),
        signs_(dual_),
        mesh_(dual_.size(), triangles),
        cap_(dual_, mesh_, measure, 1) {}
  FilteredSurface(const FilteredSurface&) = delete;
  FilteredSurface& operator=(const FilteredSurface&) = delete;

  std::optional<Change> change(HalfspaceId i, HalfspaceId j) override {
    if (is_off_ != i) take_off(i);
    return is_off_ ? change_without(j) : change_with_both(i, j);
  }

  Cost exact_change(HalfspaceId i, HalfspaceId j) override {
    put_back();
    insert(j);
    cap_.prepare(i);
    const Cost gained = cap_.exactly();
    cap_.prepare(j);
    const Cost lost = cap_.exactly();
    remove(j);
    return difference(gained, lost);
  }

  void exchange(HalfspaceId i, HalfspaceId j) override {
    put_back();
    insert(j);
    cap_.prepare(i);
    remove(i);
  }

  Interval<double> measure_bounds() override {
    if (cap_.measure() != CostMeasure::Volume) return ExchangeSurface::measure_bounds();
    put_back();
    const CostBounds<double> bounds = six_times_volume(dual_, mesh_);
    return {bounds.lower, bounds.upper};
  }
  std::vector<DualTriangle> triangles() override {
    put_back();
    return mesh_.triangles();
  }
  Cost measure(std::span<const DualTriangle> triangles) const override {
    return exact_measure(dual_, triangles, cap_.measure());
  }

 private:
  void take_off(HalfspaceId i);
  void put_back();
  Change change_without(HalfspaceId j);
  std::optional<Change> change_with_both(HalfspaceId i, HalfspaceId j);
  bool sees(const SightTest& test, HalfspaceId j) const;
  // The test for each triangle of the mesh without the halfspace that is off.
  auto sight_of(HalfspaceId j) const {
    return
        [this, j, t = std::size_t{0}](const DualTriangle&) mutable { return sees(tests_[t++], j); };
  }
  void insert(HalfspaceId j);
  void remove(HalfspaceId i);

  const FastDual& dual_;
  DualSigns signs_;
  HalfEdgeMesh mesh_;
  FilteredCap cap_;
  std::optional<HalfspaceId> is_off_;  // kept but off the mesh
  CostBounds<double> gained_;          // without it
  std::vector<SightTest> tests_;       // of the mesh without it
  OneRing ring_;
};

void FilteredSurface::take_off(HalfspaceId i) {
  put_back();
  cap_.prepare(i);
  gained_ = cap_.in_doubles();
  if (gained_.kind == Boundedness::Unbounded) return;
  remove(i);
  is_off_ = i;
  tests_.clear();
  for (const DualTriangle& t : mesh_.triangles()) tests_.emplace_back(dual_, t);
}

void FilteredSurface::put_back() {
  if (!is_off_) return;
  mesh_.insert(*is_off_, sight_of(*is_off_));
  cap_.invalidate();
  is_off_.reset();
}

Change FilteredSurface::change_without(HalfspaceId j) {
  mesh_.rim(sight_of(j), ring_);
  cap_.prepare(j, ring_);
  const CostBounds<double> lost = cap_.in_doubles();
  return {next_below(gained_.lower - lost.upper), next_above(gained_.upper - lost.lower)};
}

std::optional<Change> FilteredSurface::change_with_both(HalfspaceId i, HalfspaceId j) {
  insert(j);
  cap_.prepare(i);
  const CostBounds<double> gained = cap_.in_doubles();
  cap_.prepare(j);
  const CostBounds<double> lost = cap_.in_doubles();
  remove(j);
  if (gained.kind == Boundedness::Unbounded) return {};
  return Change{next_below(gained.lower - lost.upper), next_above(gained.upper - lost.lower)};
}

// Degenerate: a dual point sees the triangles that it is level with, as in DualSurface::insert().
bool FilteredSurface::sees(const SightTest& test, HalfspaceId j) const {
  const FilterSign sure = test.height(dual_.near(j));
  if (sure != FilterSign::Unknown) return sure == FilterSign::Positive;
  const auto& [a, b, c] = test.corners;
  return signs_.height(a, b, c, j) != Sign::Negative;
}

void FilteredSurface::insert(HalfspaceId j) {
  mesh_.insert(j, [&](const DualTriangle& t) {
    return signs_.height(t[0], t[1], t[2], j) != Sign::Negative;
  });
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
