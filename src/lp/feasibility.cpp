// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "convexact/linear_program.hpp"
#include "lp/inflation.hpp"

namespace convexact {

using detail::Inflatable;
using detail::Inflated;

namespace {

// A power of two within a factor of 2 sqrt(3) of |n|. Any positive weights would decide; these
// keep the point away from planes whose integers happen to be long.
Rational rough_norm(const IntegerVector3& n) {
  std::size_t bits = 0;
  for (const Integer& entry : n) bits = std::max(bits, bit_length(entry));
  return scale_by_power_of_two(Rational(1), static_cast<long>(bits));
}

}  // namespace

InteriorOutcome find_interior(std::span<const Halfspace> halfspaces, const LpOptions& options) {
  std::vector<Rational> weights;
  for (const Halfspace& halfspace : halfspaces) weights.push_back(rough_norm(halfspace.normal()));
  auto outcome = detail::inflate(halfspaces, weights, options);
  if (auto* empty = std::get_if<EmptyProof>(&outcome)) return std::move(*empty);
  if (auto* flat = std::get_if<FlatProof>(&outcome)) return std::move(*flat);
  const auto* inflated = std::get_if<Inflated>(&outcome);
  const RationalPoint& inside = inflated ? inflated->point : std::get<Inflatable>(outcome).interior;
  return InteriorPoint{short_dyadic_interior_point(halfspaces, inside).value()};
}

namespace {

bool is_parallel(const IntegerVector3& a, const IntegerVector3& b) { return a.cross(b).isZero(0); }

// Three halfspaces whose normals are independent, or a direction orthogonal to all normals.
std::variant<std::array<std::size_t, 3>, RecessionRay> span_normals(
    std::span<const Halfspace> halfspaces) {
  const std::size_t count = halfspaces.size();
  if (count == 0) return RecessionRay{RationalVector3::UnitX()};
  const IntegerVector3& first = halfspaces[0].normal();
  std::size_t j = 1;
  while (j < count && is_parallel(first, halfspaces[j].normal())) ++j;
  IntegerVector3 across;
  if (j < count) {
    across = first.cross(halfspaces[j].normal());
  } else {
    across = first[0] == 0 ? IntegerVector3::UnitX() : IntegerVector3(-first[1], first[0], 0);
  }
  for (std::size_t k = j; k < count; ++k) {
    if (halfspaces[k].normal().dot(across) != 0) return std::array<std::size_t, 3>{0, j, k};
  }
  return RecessionRay{across.cast<Rational>()};
}

}  // namespace

// Maximises -(sum of all n_i).u subject to N u <= 0. An unbounded ray is a direction of recession.
// Otherwise the optimum is 0 with multipliers z: sum of (1 + z_i) n_i = 0, all factors positive.
BoundedOutcome find_recession(std::span<const Halfspace> halfspaces, const LpOptions& options) {
  const auto spanning = span_normals(halfspaces);
  if (const auto* ray = std::get_if<RecessionRay>(&spanning)) return *ray;
  LinearProgram lp;
  lp.normals.resize(static_cast<Eigen::Index>(halfspaces.size()), 3);
  lp.offsets = RationalVector::Zero(lp.normals.rows());
  IntegerVector3 sum = IntegerVector3::Zero();
  for (Eigen::Index i = 0; i < lp.normals.rows(); ++i) {
    const IntegerVector3& normal = halfspaces[i].normal();
    lp.normals.row(i) = normal.cast<Rational>().transpose();
    sum += normal;
  }
  lp.objective = -sum.cast<Rational>();
  const LpOutcome outcome = maximise(lp, options);
  if (const auto* unbounded = std::get_if<Unbounded>(&outcome)) {
    return RecessionRay{unbounded->ray};
  }
  BoundedProof proof{std::vector<Rational>(halfspaces.size(), Rational(1)),
                     std::get<std::array<std::size_t, 3>>(spanning)};
  for (const Multiplier& m : std::get<Optimal>(outcome).tight) proof.multipliers[m.row] += m.value;
  return proof;
}

}  // namespace convexact
