// SPDX-License-Identifier: MIT
// stored_cases.hpp - results to store (hulls and bounded subsets of their planes), in the form for
// the independent checker.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/hull.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/number.hpp"
#include "number/random.hpp"
#include "stored_checker.hpp"

namespace stored_cases {

using namespace convexact;

inline constexpr Precision kPrecisions[] = {Precision::Binary64, Precision::Binary32};

struct Case {
  PointSet input;
  std::vector<PointId> witnesses;
  Polytope exact;
};

/// The hull itself as the result; nothing if the points are flat.
inline std::optional<Case> hull_case(PointSet input) {
  const HullOutcome outcome = convex_hull(input);
  const auto* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return {};
  Polytope exact = to_polytope(*hull, input);
  return Case{std::move(input), hull->vertices, std::move(exact)};
}

inline mpz_class to_mpz(const Integer& x) { return mpz_class(x.backend().data()); }
inline mpq_class to_mpq(const Rational& x) { return mpq_class(x.backend().data()); }

inline stored_checker::Plane to_plane(const Halfspace& h) {
  return {to_mpz(h.normal()[0]), to_mpz(h.normal()[1]), to_mpz(h.normal()[2]), to_mpz(h.offset())};
}

inline std::vector<stored_checker::Homogeneous> to_homogeneous(const PointSet& points) {
  std::vector<stored_checker::Homogeneous> converted;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RationalPoint p = points[PointId(i)];
    converted.push_back(stored_checker::point(to_mpq(p[0]), to_mpq(p[1]), to_mpq(p[2])));
  }
  return converted;
}

/// The solid that halfspaces around the points bound.
inline Polytope solid_of(std::span<const Halfspace> halfspaces, const PointSet& points,
                         std::span<const PointId> witnesses) {
  RationalPoint center = RationalPoint::Zero();
  for (const PointId id : witnesses) center += points[id];
  center /= Rational(witnesses.size());
  const HalfspaceDual dual = dual_of(halfspaces, center);
  return to_polytope(dual.dual.halfspaces, dual.dual.triangles);
}

/// The same input with a random subset of the hull's planes as the result; halfspaces are removed
/// one after another as long as the rest is bounded, until `left` are left.
inline Case drop_planes(const Case& hull, std::size_t left, std::uint64_t seed) {
  std::vector<Halfspace> kept = hull.exact.planes;
  Random random(seed);
  for (int attempt = 0; attempt < 100 && kept.size() > left; ++attempt) {
    const auto i = static_cast<std::ptrdiff_t>(uniform_below(random, kept.size()));
    std::vector<Halfspace> fewer = kept;
    fewer.erase(fewer.begin() + i);
    if (std::holds_alternative<BoundedProof>(find_recession(fewer))) kept = std::move(fewer);
  }
  return {hull.input, hull.witnesses, solid_of(kept, hull.input, hull.witnesses)};
}

}  // namespace stored_cases
