// SPDX-License-Identifier: MIT
#include "search/shrunk_surface.hpp"

#include <limits>
#include <utility>

#include "convexact/measure.hpp"
#include "fast/cap.hpp"
#include "fast/mesh.hpp"
#include "simplify/dual_surface.hpp"

namespace convexact {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

class ExactShrunkSurface : public ShrunkSurface {
 public:
  ExactShrunkSurface(const DualHull& dual, const RationalPoint& center)
      : halfspaces_(dual.halfspaces), surface_(dual.halfspaces, dual.triangles, center) {}

  Interval<double> cost(HalfspaceId i) override {
    const Removal removal = surface_.removal_of(i);
    if (!removal.cost) return {kUnbounded, kUnbounded};
    return in_unit(removal.cost->rational());
  }
  Rational exact_cost(HalfspaceId i) override { return surface_.removal_of(i).cost->rational(); }
  std::vector<HalfspaceId> ring(HalfspaceId i) override { return surface_.adjacency().one_ring(i); }
  void remove(HalfspaceId i) override { surface_.apply(surface_.removal_of(i)); }
  void insert(HalfspaceId i) override { surface_.insert(i); }
  Rational volume() const override {
    return exact_measure(to_polytope(halfspaces_, surface_.triangles()), CostMeasure::Volume)
        .rational();
  }
  Interval<double> in_unit(const Rational& volume) const override {
    return {to_double(volume, Rounding::Down), to_double(volume, Rounding::Up)};
  }
  Rational from_unit(double volume) const override { return to_rational(volume); }

 private:
  std::span<const Halfspace> halfspaces_;
  DualSurface surface_;
};

// The unit is a sixth of 2^volume_exponent().
class FilteredShrunkSurface : public ShrunkSurface {
 public:
  explicit FilteredShrunkSurface(const FastDual& dual)
      : dual_(dual),
        signs_(dual),
        mesh_(dual.size(), dual.triangles(), dual.twins()),
        cap_(dual_, mesh_, CostMeasure::Volume, 1) {}
  FilteredShrunkSurface(const FilteredShrunkSurface&) = delete;
  FilteredShrunkSurface& operator=(const FilteredShrunkSurface&) = delete;

  Interval<double> cost(HalfspaceId i) override {
    cap_.prepare(i);
    const CostBounds<double> bounds = cap_.in_doubles();
    if (bounds.kind == Boundedness::Unbounded) return {kUnbounded, kUnbounded};
    if (bounds.kind == Boundedness::Doubtful) return in_unit(cap_.exactly().rational());
    return {bounds.lower, bounds.upper};
  }
  Rational exact_cost(HalfspaceId i) override {
    cap_.prepare(i);
    return cap_.exactly().rational();
  }
  std::vector<HalfspaceId> ring(HalfspaceId i) override {
    OneRing ring;
    mesh_.one_ring(i, ring);
    return std::move(ring.vertices);
  }
  void remove(HalfspaceId i) override {
    cap_.prepare(i);
    mesh_.remove(i, cap_.ring(), cap_.triangles());
    cap_.invalidate();
  }
  // Degenerate: as in DualSurface::insert().
  void insert(HalfspaceId i) override {
    mesh_.insert(i, [&](const DualTriangle& t) {
      return signs_.height(t[0], t[1], t[2], i) != Sign::Negative;
    });
    cap_.invalidate();
  }
  Rational volume() const override {
    return exact_measure(dual_, mesh_.triangles(), CostMeasure::Volume).rational();
  }
  Interval<double> in_unit(const Rational& volume) const override {
    return scaled_enclosure(Cost(6 * volume), dual_.volume_exponent());
  }
  Rational from_unit(double volume) const override {
    return scale_by_power_of_two(to_rational(volume), dual_.volume_exponent()) / 6;
  }

 private:
  const FastDual& dual_;
  DualSigns signs_;
  HalfEdgeMesh mesh_;
  FilteredCap cap_;
};

}  // namespace

std::unique_ptr<ShrunkSurface> make_exact_shrunk_surface(const DualHull& dual,
                                                         const RationalPoint& center) {
  return std::make_unique<ExactShrunkSurface>(dual, center);
}

std::unique_ptr<ShrunkSurface> make_filtered_shrunk_surface(const FastDual& dual) {
  return std::make_unique<FilteredShrunkSurface>(dual);
}

}  // namespace convexact
