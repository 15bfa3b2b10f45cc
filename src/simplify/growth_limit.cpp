// SPDX-License-Identifier: MIT
#include "convexact/simplify/growth_limit.hpp"

#include "convexact/error.hpp"
#include "convexact/number/sum.hpp"

namespace convexact {
namespace {

// Pyramids from the first vertex over the facets that do not hold it, cut into tetrahedra.
Rational volume_of(const Polytope& solid) {
  std::vector<Rational> six_volumes;
  for (std::size_t f = 0; f < solid.facets.size(); ++f) {
    const std::vector<std::uint32_t>& facet = solid.facets[f];
    const auto arm = [&](std::size_t c) {
      return RationalVector3(solid.vertices[facet[c]] - solid.vertices[0]);
    };
    if (solid.planes[f](solid.vertices[0]) == 0) continue;
    const RationalVector3 first = arm(0);
    for (std::size_t c = 2; c < facet.size(); ++c) {
      six_volumes.push_back(first.dot(arm(c - 1).cross(arm(c))));
    }
  }
  return balanced_sum(std::move(six_volumes)) / 6;
}

}  // namespace

GrowthLimit::GrowthLimit(const DualHull& solid, std::optional<Rational> max_growth)
    : solid_(solid), max_growth_(std::move(max_growth)) {
  if (max_growth_ && *max_growth_ < 0) {
    throw Error(ErrorCode::InvalidArgument, "the growth of the volume cannot be limited below 0");
  }
}

bool GrowthLimit::allows(const Rational& cost) {
  if (!max_growth_) return true;
  if (!allowance_) {
    allowance_ = *max_growth_ * volume_of(to_polytope(solid_.halfspaces, solid_.triangles));
  }
  costs_.push_back(cost);
  if (balanced_sum(costs_) <= *allowance_) return true;
  costs_.pop_back();
  return false;
}

}  // namespace convexact
