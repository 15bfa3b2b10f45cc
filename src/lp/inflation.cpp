// SPDX-License-Identifier: MIT
#include "lp/inflation.hpp"

#include "convexact/error.hpp"

namespace convexact::detail {
namespace {

LinearProgram inflation_lp(std::span<const Halfspace> halfspaces,
                           std::span<const Rational> weights) {
  const auto count = static_cast<Eigen::Index>(halfspaces.size());
  LinearProgram lp;
  lp.normals = RationalMatrix::Zero(count + 1, 4);
  lp.offsets = RationalVector::Zero(count + 1);
  lp.objective = RationalVector::Unit(4, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) lp.normals(i, k) = halfspaces[i].normal()[k];
    lp.normals(i, 3) = weights[i];
    lp.offsets[i] = halfspaces[i].offset();
  }
  lp.normals(count, 3) = -1;  // t >= 0
  return lp;
}

// Without the row t >= 0, which stands last and only balances the weights.
std::vector<Multiplier> of_halfspaces(std::vector<Multiplier> multipliers, std::size_t count) {
  std::erase_if(multipliers, [&](const Multiplier& m) { return m.row == count; });
  return multipliers;
}

}  // namespace

std::variant<Inflated, Inflatable, FlatProof, EmptyProof> inflate(
    std::span<const Halfspace> halfspaces, std::span<const Rational> weights,
    const LpOptions& options) {
  CONVEXACT_ASSERT(weights.size() == halfspaces.size());
  const std::size_t count = halfspaces.size();
  LpOutcome outcome = maximise(inflation_lp(halfspaces, weights), options);
  if (auto* infeasible = std::get_if<Infeasible>(&outcome)) {
    return EmptyProof{of_halfspaces(std::move(infeasible->farkas), count)};
  }
  if (const auto* unbounded = std::get_if<Unbounded>(&outcome)) {
    const Rational rate = unbounded->ray[3];  // > 0, as it is the objective
    const RationalVector3 direction = unbounded->ray.head<3>() / rate;
    return Inflatable{unbounded->start.head<3>() + direction, direction};
  }
  auto& best = std::get<Optimal>(outcome);
  std::vector<Multiplier> multipliers = of_halfspaces(std::move(best.tight), count);
  const RationalPoint point = best.x.head<3>();
  if (best.x[3] == 0) return FlatProof{point, std::move(multipliers)};
  return Inflated{point, best.x[3], std::move(multipliers)};
}

}  // namespace convexact::detail
