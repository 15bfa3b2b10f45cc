// SPDX-License-Identifier: MIT

#include "convexact/measure.hpp"
#include "fast/cap.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"
#include "search/exchange_surface.hpp"
#include "simplify/dual_surface.hpp"

namespace convexact {
namespace {

class ExactSurface : public ExchangeSurface {
 public:
  ExactSurface(const DualHull& dual, std::span<const DualTriangle> triangles,
               const RationalPoint& center, CostMeasure measure)
      : halfspaces_(dual.halfspaces),
        surface_(dual.halfspaces, triangles, center, 1, measure),
        measure_(measure) {}

  std::optional<Change> change(HalfspaceId i, HalfspaceId j, double /*below*/) override {
    surface_.insert(j);
    const Removal of_i = surface_.removal_of(i), of_j = surface_.removal_of(j);
    surface_.apply(of_j);
    if (!of_i.cost) return {};
    Change result;
    result.exact = difference(*of_i.cost, of_j.cost.value());
    return result;
  }

  Cost exact_change(HalfspaceId i, HalfspaceId j) override {
    return *change(i, j, kNoLimit).value().exact;
  }

  // The power of two next to the first one that is not zero.
  double in_unit(const Cost& change) override {
    const Rational size = change.enclose(kMeasureBits).high();
    if (!exponent_ && size != 0) exponent_ = exponent_of(size);
    return scaled_enclosure(change, exponent_.value_or(0)).lower;
  }

  void exchange(HalfspaceId i, HalfspaceId j) override {
    surface_.insert(j);
    surface_.apply(surface_.removal_of(i));
  }

  std::vector<DualTriangle> triangles() override { return surface_.triangles(); }
  Cost measure(std::span<const DualTriangle> triangles) const override {
    return exact_measure(to_polytope(halfspaces_, triangles), measure_);
  }

 private:
  std::span<const Halfspace> halfspaces_;
  DualSurface surface_;
  CostMeasure measure_;
  std::optional<long> exponent_;  // of the unit
};

}  // namespace

std::unique_ptr<ExchangeSurface> make_exact_surface(const DualHull& dual,
                                                    std::span<const DualTriangle> triangles,
                                                    const RationalPoint& center,
                                                    CostMeasure measure) {
  return std::make_unique<ExactSurface>(dual, triangles, center, measure);
}

}  // namespace convexact
