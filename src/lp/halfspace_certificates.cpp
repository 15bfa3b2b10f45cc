// SPDX-License-Identifier: MIT
// Checks of emptiness, flatness, boundedness and the Chebyshev center, by definition and without a
// solver.
#include "convexact/linear_program.hpp"

namespace convexact {
namespace {

struct Combination {
  RationalVector3 normal;  // y'N
  Rational offset;         // y'd
};

Combination combine(std::span<const Halfspace> halfspaces, std::span<const Multiplier> y) {
  Combination sum{RationalVector3::Zero(), 0};
  for (const Multiplier& m : y) {
    const Halfspace& halfspace = halfspaces[m.row];
    for (int k = 0; k < 3; ++k) sum.normal[k] += m.value * Rational(halfspace.normal()[k]);
    sum.offset += m.value * Rational(halfspace.offset());
  }
  return sum;
}

bool are_positive(std::span<const Halfspace> halfspaces, std::span<const Multiplier> y) {
  for (const Multiplier& m : y) {
    if (m.value <= 0 || m.row >= halfspaces.size()) return false;
  }
  return !y.empty();
}

// The ball of radius r about x lies in n.x + d <= 0 iff n.x + d <= 0 and (n.x + d)^2 >= |n|^2 r^2.
bool holds_ball(std::span<const Halfspace> halfspaces, const RationalPoint& x, const Rational& r) {
  if (r <= 0) return false;
  for (const Halfspace& halfspace : halfspaces) {
    const Rational value = halfspace(x);
    const Integer square = halfspace.normal().squaredNorm();
    if (value > 0 || value * value < Rational(square) * r * r) return false;
  }
  return true;
}

// A rational <= sqrt(square), by less than 2^-128.
Rational root_below(const Integer& square) {
  const Integer root = sqrt(Integer(square << 256));
  return scale_by_power_of_two(Rational(root), -128);
}

}  // namespace

bool check(std::span<const Halfspace> halfspaces, const EmptyProof& claim) {
  if (!are_positive(halfspaces, claim.farkas)) return false;
  const Combination sum = combine(halfspaces, claim.farkas);
  return sum.normal.isZero(0) && sum.offset > 0;
}

bool check(std::span<const Halfspace> halfspaces, const FlatProof& claim) {
  for (const Halfspace& halfspace : halfspaces) {
    if (halfspace(claim.point) > 0) return false;
  }
  if (!are_positive(halfspaces, claim.multipliers)) return false;
  const Combination sum = combine(halfspaces, claim.multipliers);
  return sum.normal.isZero(0) && sum.offset == 0;
}

bool check(std::span<const Halfspace> halfspaces, const InteriorPoint& claim) {
  for (const Halfspace& halfspace : halfspaces) {
    if (halfspace(claim.point) >= 0) return false;
  }
  return true;
}

bool check(std::span<const Halfspace> halfspaces, const BoundedProof& claim) {
  if (claim.multipliers.size() != halfspaces.size()) return false;
  std::vector<Multiplier> y;
  for (std::size_t i = 0; i < halfspaces.size(); ++i) y.push_back({i, claim.multipliers[i]});
  if (!are_positive(halfspaces, y) || !combine(halfspaces, y).normal.isZero(0)) return false;
  const auto [a, b, c] = claim.spanning;
  if (a >= halfspaces.size() || b >= halfspaces.size() || c >= halfspaces.size()) return false;
  const IntegerVector3 across = halfspaces[a].normal().cross(halfspaces[b].normal());
  return across.dot(halfspaces[c].normal()) != 0;
}

bool check(std::span<const Halfspace> halfspaces, const RecessionRay& claim) {
  for (const Halfspace& halfspace : halfspaces) {
    const RationalVector3 normal = halfspace.normal().cast<Rational>();
    if (normal.dot(claim.direction) > 0) return false;
  }
  return !claim.direction.isZero(0);
}

bool check(std::span<const Halfspace> halfspaces, const UnboundedRadius& claim) {
  for (const Halfspace& halfspace : halfspaces) {
    const RationalVector3 normal = halfspace.normal().cast<Rational>();
    if (normal.dot(claim.direction) >= 0) return false;
  }
  return true;
}

bool check(std::span<const Halfspace> halfspaces, const ChebyshevCenter& claim) {
  if (!holds_ball(halfspaces, claim.center, claim.radius_low) ||
      !holds_ball(halfspaces, claim.optimum, claim.optimum_radius) ||
      !are_positive(halfspaces, claim.touching)) {
    return false;
  }
  const Combination sum = combine(halfspaces, claim.touching);
  Rational weight = 0;  // <= sum of y_i |n_i|
  for (const Multiplier& m : claim.touching) {
    weight += m.value * root_below(halfspaces[m.row].normal().squaredNorm());
  }
  return sum.normal.isZero(0) && claim.radius_high * weight >= -sum.offset;
}

}  // namespace convexact
