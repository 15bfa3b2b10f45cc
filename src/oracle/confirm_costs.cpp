// SPDX-License-Identifier: MIT
#include "oracle/confirm_costs.hpp"

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "oracle/removal_cost.hpp"
#include "simplify/modular_volume.hpp"

namespace convexact {
namespace {

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
