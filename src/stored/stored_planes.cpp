// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/stored.hpp"
#include "near/near_plane.hpp"
#include "stored/acceptance.hpp"

namespace convexact {
namespace {

// The normal times 2^-bits, its largest component then in [1/2, 1), each component rounded to
// nearest, or, given a direction, so that dot(normal, towards) does not shrink.
Point round_normal(const IntegerVector3& normal, Precision precision,
                   const std::optional<RationalVector3>& towards = {}) {
  const auto bits = static_cast<long>(bit_length(normal));
  Point rounded;
  for (int k = 0; k < 3; ++k) {
    Rounding rounding = Rounding::Nearest;
    if (towards && (*towards)[k] > 0) rounding = Rounding::Up;
    if (towards && (*towards)[k] < 0) rounding = Rounding::Down;
    const Rational scaled = scale_by_power_of_two(Rational(normal[k]), -bits);
    rounded[k] = round_to(precision, scaled, rounding);
  }
  return rounded;
}

// A ray u != 0 with n.u <= 0 for all the normals, or nothing if the halfspaces are bounded; proven
// in both cases.
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

// Steps (1) and (2): normals whose halfspaces are bounded.
std::vector<Point> round_normals(std::span<const Halfspace> halfspaces, Precision precision) {
  std::vector<Point> normals;
  for (const Halfspace& h : halfspaces) normals.push_back(round_normal(h.normal(), precision));
  // The ladder. The exact solid is bounded, so some exact normal stops every ray. Each rung turns
  // at least one normal for good, so there are at most as many rungs as halfspaces.
  std::vector<bool> turned(halfspaces.size(), false);
  while (const auto ray = escape_ray(normals)) {
    bool is_stopped = false;
    for (std::size_t i = 0; i < halfspaces.size(); ++i) {
      if (turned[i] || halfspaces[i].normal().cast<Rational>().dot(*ray) <= 0) continue;
      normals[i] = round_normal(halfspaces[i].normal(), precision, ray);
      turned[i] = is_stopped = true;
    }
    if (!is_stopped) stored::refuse(precision, "rounded, the halfspaces are unbounded");
  }
  return normals;
}

// The support function of some of the points of a set.
class WitnessSupport {
 public:
  WitnessSupport(const PointSet& points, std::span<const PointId> witnesses)
      : points_(points), witnesses_(witnesses), doubles_(points, witnesses) {}

  // max over the witnesses of n.x; |n_k| <= 1. At least one witness.
  Rational operator()(const Point& n);

 private:
  const PointSet& points_;
  std::span<const PointId> witnesses_;
  CoordinateArrays doubles_;
  std::vector<double> values_;  // of the last call, kept for its memory
};

Rational WitnessSupport::operator()(const Point& n) {
  // One bound for all witnesses: no product is larger than |n_k| * largest. Where a sum might
  // overflow, the bound is infinite, no value is below the limit, and all are compared exactly.
  const double size = n.cwiseAbs().sum() * doubles_.largest;
  const double error = size < 0x1p1022
                           ? kRelativePlaneError * size + absolute_plane_error(std::max(1.0, size))
                           : std::numeric_limits<double>::infinity();
  values_.resize(doubles_.size());
  double top = -std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < values_.size(); ++j) {
    values_[j] = n[0] * doubles_.x[j] + n[1] * doubles_.y[j] + n[2] * doubles_.z[j];
    top = std::max(top, values_[j]);
  }
  const double limit = top - error - error;  // values below it are below the true maximum
  const RationalVector3 exact_normal = to_rational(n);
  std::optional<Rational> maximum;
  for (std::size_t j = 0; j < values_.size(); ++j) {
    if (values_[j] < limit) continue;
    const Rational value = exact_normal.dot(points_[witnesses_[j]]);
    if (!maximum || value > *maximum) maximum = value;
  }
  CONVEXACT_ASSERT(maximum.has_value());
  return *maximum;
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
  WitnessSupport support(input, witnesses);
  for (const Point& n : round_normals(exact.planes, precision)) {
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
