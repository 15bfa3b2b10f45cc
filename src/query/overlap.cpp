// SPDX-License-Identifier: MIT
// Whether two solids have a common point: the facets of both as one linear program without an
// objective.
#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/query.hpp"
#include "solid/solid.hpp"

namespace convexact {
namespace {

std::vector<Halfspace> facets_of_both(const Polytope& a, const Polytope& b) {
  std::vector<Halfspace> facets = a.planes;
  facets.insert(facets.end(), b.planes.begin(), b.planes.end());
  return facets;
}

LinearProgram program_of(const std::vector<Halfspace>& facets) {
  LinearProgram lp;
  lp.normals.resize(static_cast<Eigen::Index>(facets.size()), 3);
  lp.offsets.resize(lp.normals.rows());
  lp.objective = RationalVector::Zero(3);
  for (Eigen::Index i = 0; i < lp.normals.rows(); ++i) {
    lp.normals.row(i) = facets[i].normal().cast<Rational>().transpose();
    lp.offsets[i] = facets[i].offset();
  }
  return lp;
}

struct WeightedSum {
  RationalVector3 normal = RationalVector3::Zero();
  Rational offset = 0;
};

WeightedSum weighted_sum(const std::vector<Halfspace>& facets, const std::vector<Multiplier>& y) {
  WeightedSum sum;
  for (const Multiplier& m : y) {
    const Halfspace& facet = facets[m.row];
    for (int k = 0; k < 3; ++k) sum.normal[k] += m.value * Rational(facet.normal()[k]);
    sum.offset += m.value * Rational(facet.offset());
  }
  return sum;
}

// A satisfies n.x <= -(y'd over A), and B, as its multipliers have the sum -n of normals,
// n.x >= y'd over B, which is greater. n is not zero, or one of the two solids would be empty.
Separation separate(const Polytope& a, const Polytope& b, const std::vector<Multiplier>& farkas) {
  std::vector<Multiplier> of_a, of_b;
  for (const Multiplier& m : farkas) {
    if (m.row < a.planes.size()) {
      of_a.push_back(m);
    } else {
      of_b.push_back({m.row - a.planes.size(), m.value});
    }
  }
  const WeightedSum beside_a = weighted_sum(a.planes, of_a);
  const WeightedSum beside_b = weighted_sum(b.planes, of_b);
  const Rational middle = (beside_b.offset - beside_a.offset) / 2;
  return {std::move(of_a), std::move(of_b), Halfspace(beside_a.normal, -middle)};
}

bool satisfies_all(const std::vector<Halfspace>& facets, const RationalPoint& x) {
  return std::all_of(facets.begin(), facets.end(),
                     [&](const Halfspace& facet) { return facet(x) <= 0; });
}

}  // namespace

std::variant<Polytope, NotSolid> queried_solid(const Shape& shape, std::uint64_t seed) {
  StageLog log;
  SolidOutcome outcome = make_solid(shape, {.seed = seed, .wants_dual = false}, log);
  if (auto* reason = std::get_if<NotSolid>(&outcome)) return std::move(*reason);
  return std::get<Solid>(std::move(outcome)).polytope;
}

Overlap find_overlap(const Polytope& a, const Polytope& b, std::uint64_t seed) {
  const LpOutcome outcome = maximise(program_of(facets_of_both(a, b)), LpOptions{.seed = seed});
  if (const auto* apart = std::get_if<Infeasible>(&outcome)) {
    return separate(a, b, apart->farkas);
  }
  const auto* common = std::get_if<Optimal>(&outcome);
  if (common == nullptr) throw Error(ErrorCode::Internal, "a bounded overlap has no last point");
  return CommonPoint{common->x.head<3>()};
}

bool check(const Polytope& a, const Polytope& b, const CommonPoint& claim) {
  return satisfies_all(a.planes, claim.point) && satisfies_all(b.planes, claim.point);
}

bool check(const Polytope& a, const Polytope& b, const Separation& claim) {
  // (1) The multipliers.
  EmptyProof proof{claim.of_a};
  for (const Multiplier& m : claim.of_b) {
    proof.farkas.push_back({m.row + a.planes.size(), m.value});
  }
  for (const Multiplier& m : claim.of_a) {
    if (m.row >= a.planes.size()) return false;
  }
  if (!check(facets_of_both(a, b), proof)) return false;
  // (2) The plane has the direction of their sum over A.
  const RationalVector3 n = weighted_sum(a.planes, claim.of_a).normal;
  const RationalVector3 m = claim.plane.normal().cast<Rational>();
  if (!n.cross(m).isZero(0) || n.dot(m) <= 0) return false;
  // (3) It separates the vertices, and so their hulls.
  const auto is_inside = [&](const RationalPoint& v) { return claim.plane(v) < 0; };
  const auto is_outside = [&](const RationalPoint& v) { return claim.plane(v) > 0; };
  return std::all_of(a.vertices.begin(), a.vertices.end(), is_inside) &&
         std::all_of(b.vertices.begin(), b.vertices.end(), is_outside);
}

bool check(const Polytope& a, const Polytope& b, const Overlap& claim) {
  return std::visit([&](const auto& answer) { return check(a, b, answer); }, claim);
}

}  // namespace convexact
