// SPDX-License-Identifier: MIT
#include "oracle/removal_cost.hpp"

#include <algorithm>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"
#include "simplify/modular_volume.hpp"

namespace convexact {
namespace {

// The pyramid from the center over a facet.
Rational cone(const Polytope& polytope, std::size_t facet, const RationalPoint& center) {
  const std::vector<std::uint32_t>& corners = polytope.facets[facet];
  const RationalVector3 first = polytope.vertices[corners[0]] - center;
  Rational six_times = 0;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const RationalVector3 second = polytope.vertices[corners[k - 1]] - center;
    const RationalVector3 third = polytope.vertices[corners[k]] - center;
    six_times += first.cross(second).dot(third);
  }
  return six_times / 6;
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

void require(bool confirmed) {
  if (!confirmed) {
    throw Error(ErrorCode::Internal, "the cost of a removal is not what its definition says");
  }
}

Rational volume_of(std::span<const Halfspace> halfspaces, const RationalPoint& center) {
  const std::optional<Polytope> polytope = intersect(halfspaces, center);
  require(polytope.has_value());
  return volume(*polytope);
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
  const auto& planes = polytope_.planes;
  const auto found = std::find(planes.begin(), planes.end(), removed);
  if (found == planes.end()) {
    throw Error(ErrorCode::InvalidArgument, "the halfspace to remove bounds no facet");
  }
  const auto facet = static_cast<std::size_t>(found - planes.begin());
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

std::vector<Halfspace> left_before(const TraceVerdict& verdict, std::size_t step) {
  std::vector<HalfspaceId> gone = verdict.left_out;
  for (std::size_t s = 0; s < step; ++s) gone.push_back(verdict.steps[s].removed);
  return left_after(verdict.halfspaces, gone);
}

void confirm_step(const TraceVerdict& verdict, const RationalPoint& center, std::size_t step) {
  const std::vector<Halfspace>& halfspaces = verdict.halfspaces;
  const JudgedStep& judged = verdict.steps[step];
  const RemovalOracle oracle(left_before(verdict, step), center);
  require(oracle.without(halfspaces[judged.removed.index()]).cost == judged.cost);
  if (judged.tie.empty()) return;
  require(oracle.without(halfspaces[judged.tie.front().index()]).cost == judged.minimum);
}

void confirm_sum(const TraceVerdict& verdict, const RationalPoint& center) {
  const std::vector<JudgedStep>& steps = verdict.steps;
  std::size_t bounded = 0;
  while (bounded < steps.size() && steps[bounded].cost) ++bounded;
  if (bounded == 0) return;
  const Rational before = volume_of(left_before(verdict, 0), center);
  const Rational after = volume_of(left_before(verdict, bounded), center);
  Random random(1);
  for (int repeat = 0; repeat < 2; ++repeat) {
    const ModularVolume modulo({}, random);
    std::uint64_t sum = modulo.residue(before);
    for (std::size_t s = 0; s < bounded; ++s) {
      sum = modulo.sum(sum, modulo.residue(steps[s].cost->rational()));
    }
    require(sum == modulo.residue(after));
  }
}

}  // namespace convexact
