// SPDX-License-Identifier: MIT
#include "convexact/linear_program.hpp"
#include "lp/inflation.hpp"

namespace convexact {
namespace {

constexpr long kNormBits = 64;

// 2^result <= x, and at most a factor of 4 below it; x > 0.
long log2_below(const Rational& x) {
  return static_cast<long>(bit_length(numerator(x))) -
         static_cast<long>(bit_length(denominator(x))) - 1;
}

// The largest r with n_i.x + d_i + U_i r <= 0 for all i; at least one halfspace.
Rational guaranteed_radius(std::span<const Halfspace> halfspaces,
                           std::span<const Rational> upper_norms, const RationalPoint& x) {
  Rational radius = -halfspaces[0](x) / upper_norms[0];
  for (std::size_t i = 1; i < halfspaces.size(); ++i) {
    const Rational depth = -halfspaces[i](x);
    if (depth < radius * upper_norms[i]) radius = depth / upper_norms[i];
  }
  return radius;
}

}  // namespace

NormEnclosure enclose_norm(const IntegerVector3& n) {
  const Integer square = n.squaredNorm();
  // Let f = floor(sqrt(|n|^2 / 4^shift)), the shift such that f has kNormBits bits: then
  // f <= |n| / 2^shift < f + 1, whether the shift cut off bits or not.
  const long excess = static_cast<long>(bit_length(square)) - (2 * kNormBits - 1);
  const long shift = excess >= 0 ? excess / 2 : -((1 - excess) / 2);
  const Rational scaled = scale_by_power_of_two(Rational(square), -2 * shift);
  const Integer floor = sqrt(Integer(numerator(scaled) / denominator(scaled)));
  const bool is_exact = scaled == Rational(Integer(floor * floor));
  const Integer ceiling = is_exact ? floor : floor + 1;
  return {scale_by_power_of_two(Rational(floor), shift),
          scale_by_power_of_two(Rational(ceiling), shift)};
}

ChebyshevOutcome chebyshev_center(std::span<const Halfspace> halfspaces, const LpOptions& options) {
  // (1) The ball about x lies in a halfspace iff n.x + d + |n| r <= 0. With U >= |n| in its place
  //     the constraint is stricter, so every solution stands.
  std::vector<Rational> upper_norms, lower_norms;
  for (const Halfspace& halfspace : halfspaces) {
    NormEnclosure norm = enclose_norm(halfspace.normal());
    lower_norms.push_back(std::move(norm.lower));
    upper_norms.push_back(std::move(norm.upper));
  }
  auto outcome = detail::inflate(halfspaces, upper_norms, options);
  if (auto* empty = std::get_if<EmptyProof>(&outcome)) return std::move(*empty);
  if (auto* flat = std::get_if<FlatProof>(&outcome)) return std::move(*flat);
  if (const auto* unlimited = std::get_if<detail::Inflatable>(&outcome)) {
    return UnboundedRadius{unlimited->direction};
  }
  auto& ball = std::get<detail::Inflated>(outcome);
  // (2) No ball is much larger: 0 >= sum of y_i (n_i.x + d_i + |n_i| r) >= y'd + r sum of y_i L_i
  //     for every ball, and y'd = -size.
  Rational weight = 0;
  for (const Multiplier& m : ball.touching) weight += m.value * lower_norms[m.row];
  const Rational radius_high = ball.size / weight;
  // (3) Rounding to a grid of spacing g <= size / 16 moves the center by at most sqrt(3)/2 g, so it
  //     keeps 1 - sqrt(3)/32 > 0.9 of its depth.
  const RationalPoint center = round_to_grid(ball.point, log2_below(ball.size) - 4);
  return ChebyshevCenter{center,
                         guaranteed_radius(halfspaces, upper_norms, center),
                         radius_high,
                         std::move(ball.point),
                         std::move(ball.size),
                         std::move(ball.touching)};
}

}  // namespace convexact
