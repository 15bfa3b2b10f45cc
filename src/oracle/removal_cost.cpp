// SPDX-License-Identifier: MIT
#include "oracle/removal_cost.hpp"

#include <algorithm>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"

namespace convexact {
namespace {

Rational determinant(const RationalVector3& a, const RationalVector3& b, const RationalVector3& c) {
  const RationalVector3 normal = a.cross(b);
  return normal.dot(c);
}

// The pyramid from the center over a facet.
Rational cone(const Polytope& polytope, std::size_t facet, const RationalPoint& center) {
  const std::vector<std::uint32_t>& corners = polytope.facets[facet];
  const RationalVector3 first = polytope.vertices[corners[0]] - center;
  Rational six_times = 0;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const RationalVector3 second = polytope.vertices[corners[k - 1]] - center;
    const RationalVector3 third = polytope.vertices[corners[k]] - center;
    six_times += determinant(first, second, third);
  }
  return six_times / 6;
}

std::size_t facet_on(const Polytope& polytope, const Halfspace& plane) {
  const auto found = std::find(polytope.planes.begin(), polytope.planes.end(), plane);
  if (found == polytope.planes.end()) {
    throw Error(ErrorCode::InvalidArgument, "the halfspace to remove bounds no facet");
  }
  return static_cast<std::size_t>(found - polytope.planes.begin());
}

// The largest |P|.|x| over the planes and the box of a cap: what `removed` cuts off from `after`.
// The box, with the center as origin, holds the corners beyond the plane; what of the cap lies on
// the plane itself is hidden behind these or is a corner of `facet`.
Rational spread(const Polytope& after, const Halfspace& removed, const Polytope& before,
                std::size_t facet, const RationalPoint& center) {
  RationalVector3 box = RationalVector3::Zero();
  const auto include = [&](const RationalPoint& corner) {
    for (int k = 0; k < 3; ++k) {
      const Rational reach = abs(Rational(corner[k] - center[k]));
      if (reach > box[k]) box[k] = reach;
    }
  };
  std::vector<char> beyond;
  for (const RationalPoint& corner : after.vertices) {
    beyond.push_back(removed(corner) > 0);
    if (beyond.back()) include(corner);
  }
  for (const std::uint32_t corner : before.facets[facet]) include(before.vertices[corner]);

  Rational largest = 0;
  const auto consider = [&](const Halfspace& plane) {
    Rational product = 0;
    for (int k = 0; k < 3; ++k) product += abs(Rational(plane.normal()[k])) * box[k];
    product /= -plane(center);
    if (product > largest) largest = product;
  };
  consider(removed);
  for (std::size_t f = 0; f < after.facets.size(); ++f) {
    const auto& corners = after.facets[f];
    if (std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return beyond[v]; })) {
      consider(after.planes[f]);
    }
  }
  return largest;
}

}  // namespace

std::optional<Polytope> intersect(std::span<const Halfspace> halfspaces,
                                  const RationalPoint& center) {
  if (std::holds_alternative<RecessionRay>(find_recession(halfspaces))) return std::nullopt;
  const DualHull dual = dual_of(halfspaces, center).dual;
  return to_polytope(dual.halfspaces, dual.triangles);
}

RemovalOracle::RemovalOracle(std::vector<Halfspace> halfspaces, const RationalPoint& center)
    : halfspaces_(std::move(halfspaces)), center_(center) {
  std::optional<Polytope> polytope = intersect(halfspaces_, center_);
  if (!polytope) throw Error(ErrorCode::InvalidArgument, "the solid is unbounded");
  polytope_ = std::move(*polytope);
  volume_ = volume(polytope_);
}

RemovalCost RemovalOracle::without(const Halfspace& removed) const {
  const std::size_t facet = facet_on(polytope_, removed);
  std::vector<Halfspace> rest;
  std::copy_if(halfspaces_.begin(), halfspaces_.end(), std::back_inserter(rest),
               [&](const Halfspace& h) { return h != removed; });
  const std::optional<Polytope> after = intersect(rest, center_);
  if (!after) return {std::nullopt, 0};
  const Rational cost = volume(*after) - volume_;
  const Rational reach = 2 * cone(polytope_, facet, center_) + cost;
  const Rational share =
      to_rational(kPlaneRounding) * spread(*after, removed, polytope_, facet, center_);
  if (share >= 1) return {cost, std::nullopt};
  return {cost, Rational(3 * share * reach)};
}

}  // namespace convexact
