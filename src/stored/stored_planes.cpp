// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/stored.hpp"
#include "stored/acceptance.hpp"
#include "stored/interior_point.hpp"
#include "stored/support.hpp"

namespace convexact {
namespace {

// The normal times 2^-bits, its largest component then in [1/2, 1), each component rounded to
// nearest, or, given a direction, so that dot(normal, towards) does not shrink.
Point round_normal(const IntegerVector3& normal, Precision precision,
                   const std::optional<RationalVector3>& towards = {}) {
  std::size_t bits = 0;
  for (int k = 0; k < 3; ++k) bits = std::max(bits, bit_length(normal[k]));
  Point rounded;
  for (int k = 0; k < 3; ++k) {
    Rounding rounding = Rounding::Nearest;
    if (towards && (*towards)[k] > 0) rounding = Rounding::Up;
    if (towards && (*towards)[k] < 0) rounding = Rounding::Down;
    const Rational scaled = scale_by_power_of_two(Rational(normal[k]), -static_cast<long>(bits));
    rounded[k] = round_to(precision, scaled, rounding);
  }
  return rounded;
}

// A ray u != 0 with n.u <= 0 for all the normals, or nothing if they bound. Proven either way.
std::optional<RationalVector3> escape_ray(const std::vector<Point>& normals) {
  std::vector<Halfspace> cone;
  for (const Point& n : normals) cone.emplace_back(to_rational(n), Rational(0));
  const BoundedOutcome outcome = find_recession(cone);
  if (!std::visit([&](const auto& proof) { return check(cone, proof); }, outcome)) {
    throw Error(ErrorCode::Internal, "a proof that halfspaces are bounded, or not, is wrong");
  }
  const auto* ray = std::get_if<RecessionRay>(&outcome);
  return ray == nullptr ? std::nullopt : std::optional(ray->direction);
}

// Steps (1) and (2): normals that bound, and how many of them are not the nearest.
struct RoundedNormals {
  std::vector<Point> normals;
  std::size_t turned = 0;
};

RoundedNormals round_normals(std::span<const Halfspace> halfspaces, Precision precision) {
  RoundedNormals rounded;
  for (const Halfspace& h : halfspaces) {
    rounded.normals.push_back(round_normal(h.normal(), precision));
  }
  // The ladder. The exact solid is bounded, so some exact normal stops every ray. Each rung turns
  // at least one normal for good, so there are at most as many rungs as halfspaces.
  std::vector<bool> turned(halfspaces.size(), false);
  while (const auto ray = escape_ray(rounded.normals)) {
    const std::size_t before = rounded.turned;
    for (std::size_t i = 0; i < halfspaces.size(); ++i) {
      if (turned[i] || halfspaces[i].normal().cast<Rational>().dot(*ray) <= 0) continue;
      rounded.normals[i] = round_normal(halfspaces[i].normal(), precision, ray);
      turned[i] = true;
      ++rounded.turned;
    }
    if (rounded.turned == before)
      stored::refuse(precision, "rounded, the halfspaces are unbounded");
  }
  return rounded;
}

// The solid that the rounded halfspaces bound.
Polytope solid_of(std::span<const Halfspace> halfspaces, const PointSet& input,
                  std::span<const PointId> witnesses) {
  const HalfspaceDual dual =
      dual_of(halfspaces, stored::interior_point(input, witnesses, halfspaces));
  return to_polytope(dual.dual.halfspaces, dual.dual.triangles);
}

}  // namespace

StoredPlanes store_planes(const Polytope& exact, const PointSet& input,
                          std::span<const PointId> witnesses, Precision precision) {
  StoredPlanes stored;
  stored.precision = precision;
  const RoundedNormals rounded = round_normals(exact.planes, precision);
  stored.turned = rounded.turned;
  stored::WitnessSupport support(input, witnesses);
  for (const Point& n : rounded.normals) {
    const double d = round_to(precision, Rational(-support(n)), Rounding::Down);
    if (!std::isfinite(d)) stored::refuse(precision, "an offset is beyond its largest number");
    stored.planes.push_back({n[0], n[1], n[2], d});
    stored.halfspaces.emplace_back(to_rational(n), to_rational(d));
  }
  stored.violations = stored::final_pass(stored.halfspaces, input);
  if (stored.halfspaces != exact.planes) {
    const Polytope polytope = solid_of(stored.halfspaces, input, witnesses);
    stored.growth = stored::checked_growth(exact, polytope, input, witnesses, precision);
  }
  return stored;
}

}  // namespace convexact
