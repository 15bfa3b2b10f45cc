// SPDX-License-Identifier: MIT
#include <array>

#include "fast/cap.hpp"
#include "fast/mesh.hpp"
#include "search/exchange_surface.hpp"

namespace convexact {
namespace {

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
    insert(j);
    cap_.prepare(i);
    const CostBounds<double> gained = cap_.in_doubles();
    cap_.prepare(j);
    const CostBounds<double> lost = cap_.in_doubles();
    remove(j);
    if (gained.kind == Boundedness::Unbounded) return {};
    return Change{next_below(gained.lower - lost.upper), next_above(gained.upper - lost.lower)};
  }

  Cost exact_change(HalfspaceId i, HalfspaceId j) override {
    insert(j);
    cap_.prepare(i);
    const Cost gained = cap_.exactly();
    cap_.prepare(j);
    Cost lost = cap_.exactly();
    remove(j);
    lost *= Rational(-1);
    return sum_of(std::array{gained, lost});
  }

  void exchange(HalfspaceId i, HalfspaceId j) override {
    insert(j);
    remove(i);
  }

  Interval<double> measure_bounds() const override {
    if (cap_.measure() != CostMeasure::Volume) return ExchangeSurface::measure_bounds();
    const CostBounds<double> bounds = six_times_volume(dual_, mesh_);
    return {bounds.lower, bounds.upper};
  }
  std::vector<DualTriangle> triangles() const override { return mesh_.triangles(); }
  Cost measure(std::span<const DualTriangle> triangles) const override {
    return exact_measure(dual_, triangles, cap_.measure());
  }

 private:
  // Degenerate: a dual point sees the triangles that it is level with, as in DualSurface::insert().
  void insert(HalfspaceId j) {
    mesh_.insert(j, [&](const DualTriangle& t) {
      return signs_.height(t[0], t[1], t[2], j) != Sign::Negative;
    });
    cap_.invalidate();
  }
  void remove(HalfspaceId i) {
    cap_.prepare(i);
    mesh_.remove(i, cap_.ring(), cap_.triangles());
    cap_.invalidate();
  }

  const FastDual& dual_;
  DualSigns signs_;
  HalfEdgeMesh mesh_;
  FilteredCap cap_;
};

}  // namespace

std::unique_ptr<ExchangeSurface> make_filtered_surface(const FastDual& dual,
                                                       std::span<const DualTriangle> triangles,
                                                       CostMeasure measure) {
  return std::make_unique<FilteredSurface>(dual, triangles, measure);
}

}  // namespace convexact
