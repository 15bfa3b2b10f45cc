// SPDX-License-Identifier: MIT
// Questions about halfspaces by linear programs: whether they are empty, flat or have an interior,
// whether they are bounded, and where an almost largest ball is (docs/design/lp.md).
#include <algorithm>
#include <limits>
#include <optional>

#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "lp/interior_point.hpp"
#include "number/arithmetic.hpp"

namespace convexact {

RationalPoint round_to_grid(const RationalPoint& x, long exponent) {
  RationalPoint rounded;
  for (int k = 0; k < 3; ++k) {
    const Rational steps = scale_by_power_of_two(x[k], -exponent) + Rational(1, 2);
    Integer whole;
    mpz_fdiv_q(whole.backend().data(), mpq_numref(steps.backend().data()),
               mpq_denref(steps.backend().data()));
    rounded[k] = scale_by_power_of_two(Rational(whole), exponent);
  }
  return rounded;
}

bool is_strictly_inside(std::span<const Halfspace> halfspaces, const RationalPoint& x) {
  return std::all_of(halfspaces.begin(), halfspaces.end(),
                     [&](const Halfspace& halfspace) { return halfspace(x) < 0; });
}

std::optional<RationalPoint> short_dyadic_interior_point(std::span<const Halfspace> halfspaces,
                                                         const RationalPoint& inside) {
  if (!is_strictly_inside(halfspaces, inside)) return std::nullopt;
  if (inside.isZero(0)) return inside;
  // |x| < 2^e rounds to 0 in steps of twice that.
  long exponent = std::numeric_limits<long>::min();
  for (const Rational& x : inside) {
    if (x != 0) exponent = std::max(exponent, exponent_of(x) + 1);
  }
  // The loop ends: the interior is open, and the roundings converge to a point of it.
  RationalPoint rounded = round_to_grid(inside, exponent);
  while (!is_strictly_inside(halfspaces, rounded)) rounded = round_to_grid(inside, --exponent);
  return rounded;
}

// How far all halfspaces can be pushed inwards together.

namespace {

// The largest t, > 0, such that n_i.point + d_i + w_i t <= 0 for all i.
struct Inflated {
  RationalPoint point;
  Rational size;                     // t
  std::vector<Multiplier> touching;  // y >= 0, y'N = 0, y'w = 1, y'd = -t
};

// Any t is possible; n_i.direction <= -w_i for all i.
struct Inflatable {
  RationalPoint interior;
  RationalVector3 direction;
};

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

// max t subject to n_i.x + d_i + w_i t <= 0 and t >= 0, for one positive weight per halfspace.
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

// A power of two within a factor of 2 sqrt(3) of |n|. Any positive weights would decide; these
// keep the point away from planes whose integers happen to be long.
Rational rough_norm(const IntegerVector3& n) {
  return scale_by_power_of_two(Rational(1), static_cast<long>(bit_length(n)));
}

}  // namespace

InteriorOutcome find_interior(std::span<const Halfspace> halfspaces, const LpOptions& options) {
  std::vector<Rational> weights;
  for (const Halfspace& halfspace : halfspaces) weights.push_back(rough_norm(halfspace.normal()));
  auto outcome = inflate(halfspaces, weights, options);
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

namespace {

constexpr long kNormBits = 64;

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
  //     the constraint is stricter, so every solution stays valid.
  std::vector<Rational> upper_norms, lower_norms;
  for (const Halfspace& halfspace : halfspaces) {
    NormEnclosure norm = enclose_norm(halfspace.normal());
    lower_norms.push_back(std::move(norm.lower));
    upper_norms.push_back(std::move(norm.upper));
  }
  auto outcome = inflate(halfspaces, upper_norms, options);
  if (auto* empty = std::get_if<EmptyProof>(&outcome)) return std::move(*empty);
  if (auto* flat = std::get_if<FlatProof>(&outcome)) return std::move(*flat);
  if (const auto* unlimited = std::get_if<Inflatable>(&outcome)) {
    return UnboundedRadius{unlimited->direction};
  }
  auto& ball = std::get<Inflated>(outcome);
  // (2) No ball is much larger: 0 >= sum of y_i (n_i.x + d_i + |n_i| r) >= y'd + r sum of y_i L_i
  //     for every ball, and y'd = -size.
  Rational weight = 0;
  for (const Multiplier& m : ball.touching) weight += m.value * lower_norms[m.row];
  const Rational radius_high = ball.size / weight;
  // (3) Rounding to a grid of spacing g <= size / 16 moves the center by at most sqrt(3)/2 g, so it
  //     keeps 1 - sqrt(3)/32 > 0.9 of its depth.
  const RationalPoint center = round_to_grid(ball.point, exponent_of(ball.size) - 6);
  return ChebyshevCenter{center,
                         guaranteed_radius(halfspaces, upper_norms, center),
                         radius_high,
                         std::move(ball.point),
                         std::move(ball.size),
                         std::move(ball.touching)};
}

}  // namespace convexact
