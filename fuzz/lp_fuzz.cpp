// SPDX-License-Identifier: MIT
// Property of lp: a small linear program's outcome is the one that Fourier-Motzkin elimination
// finds, with a certificate that check() accepts, for every seed.
// Property of feasibility: for a few halfspaces, the answers about empty, flat, bounded and the
// largest ball have certificates that check() accepts, and agree with the volume of the
// intersection by definition.
#include "convexact/linear_program.hpp"
#include "fourier_motzkin.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "halfspace_arrangement.hpp"
#include "lp/interior_point.hpp"
#include "lp_certificates.hpp"

using namespace convexact;

namespace {

Rational small(FuzzInput& in) { return static_cast<int>(in.below(7)) - 3; }

LinearProgram program(FuzzInput& in) {
  const auto coordinates = static_cast<Eigen::Index>(1 + in.below(4));
  // Elimination squares the number of rows for each coordinate.
  const std::size_t most = coordinates == 4 ? 4 : coordinates == 3 ? 5 : 7;
  const auto rows = static_cast<Eigen::Index>(in.below(most + 1));
  const Rational unit = in.below(4) == 0 ? Rational(1, 3) : Rational(1);
  LinearProgram lp{RationalMatrix(rows, coordinates), RationalVector(rows),
                   RationalVector(coordinates)};
  for (Eigen::Index k = 0; k < coordinates; ++k) lp.objective[k] = small(in) * unit;
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index k = 0; k < coordinates; ++k) lp.normals(i, k) = small(in) * unit;
    lp.offsets[i] = small(in);
  }
  return lp;
}

void hold_lp(FuzzInput& in) {
  const std::uint64_t seed = in.byte();
  const LinearProgram lp = program(in);
  const LpOutcome outcome = maximise(lp, {.seed = seed}), other = maximise(lp, {.seed = seed + 1});
  FUZZ_CHECK(check(lp, outcome));
  FUZZ_CHECK(check(lp, other));
  FUZZ_CHECK(outcome.index() == other.index());
  const oracle::Supremum expected = oracle::supremum(lp);
  if (const auto* optimal = std::get_if<Optimal>(&outcome)) {
    FUZZ_CHECK(expected.kind == oracle::LpKind::Optimal);
    FUZZ_CHECK(lp.objective.dot(optimal->x) == expected.value);
    FUZZ_CHECK(std::get<Optimal>(other).x == optimal->x);
  } else if (const auto* unbounded = std::get_if<Unbounded>(&outcome)) {
    FUZZ_CHECK(expected.kind == oracle::LpKind::Unbounded);
    FUZZ_CHECK(std::get<Unbounded>(other).start == unbounded->start);
    FUZZ_CHECK(std::get<Unbounded>(other).ray == unbounded->ray);
  } else {
    FUZZ_CHECK(expected.kind == oracle::LpKind::Infeasible);
  }
}

std::vector<Halfspace> halfspaces_of(FuzzInput& in) {
  const bool is_close = in.below(4) == 0;  // directions and distances that differ by 2^-60
  const auto integer = [&](int largest) {
    Integer x = static_cast<int>(in.below(static_cast<std::size_t>(2 * largest + 1))) - largest;
    if (is_close) x = (x << 60) + (static_cast<int>(in.below(3)) - 1);
    return x;
  };
  std::vector<Halfspace> list;
  for (std::size_t count = in.below(in.rarely() ? 13 : 8); count > 0; --count) {
    IntegerVector3 normal;
    for (Integer& n : normal) n = integer(2);
    if (normal == IntegerVector3::Zero()) normal[0] = 1;
    list.emplace_back(normal, integer(4));
  }
  return list;
}

// Finds which of the three cases it is, and checks its proof.
bool has_interior(const std::vector<Halfspace>& list, const InteriorOutcome& outcome) {
  FUZZ_CHECK(std::visit([&](const auto& claim) { return check(list, claim); }, outcome));
  const auto* interior = std::get_if<InteriorPoint>(&outcome);
  if (interior == nullptr) return false;
  FUZZ_CHECK(is_strictly_inside(list, interior->point));
  const auto shorter = short_dyadic_interior_point(list, interior->point);
  FUZZ_CHECK(shorter && is_strictly_inside(list, *shorter));
  return true;
}

void check_largest_ball(const std::vector<Halfspace>& list, const InteriorOutcome& interior,
                        std::uint64_t seed) {
  const ChebyshevOutcome ball = chebyshev_center(list, {.seed = seed});
  FUZZ_CHECK(std::visit([&](const auto& claim) { return check(list, claim); }, ball));
  FUZZ_CHECK(std::holds_alternative<EmptyProof>(ball) ==
             std::holds_alternative<EmptyProof>(interior));
  FUZZ_CHECK(std::holds_alternative<FlatProof>(ball) ==
             std::holds_alternative<FlatProof>(interior));
}

void hold_feasibility(FuzzInput& in) {
  const std::uint64_t seed = in.byte();
  const std::vector<Halfspace> list = halfspaces_of(in);
  const InteriorOutcome interior = find_interior(list, {.seed = seed});
  const bool is_solid = has_interior(list, interior);
  check_largest_ball(list, interior, seed);
  const BoundedOutcome recession = find_recession(list, {.seed = seed});
  FUZZ_CHECK(std::visit([&](const auto& claim) { return check(list, claim); }, recession));
  if (std::holds_alternative<EmptyProof>(interior)) return;
  const definition::HalfspaceArrangement arrangement(list);
  const std::optional<Rational> volume = arrangement.volume(arrangement.all());
  FUZZ_CHECK(volume.has_value() == std::holds_alternative<BoundedProof>(recession));
  if (volume) FUZZ_CHECK((*volume > 0) == is_solid);
}

const FuzzTarget kLp("lp", hold_lp);
const FuzzTarget kFeasibility("feasibility", hold_feasibility);

}  // namespace
