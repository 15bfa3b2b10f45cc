// SPDX-License-Identifier: MIT
// Where a ray meets a solid: each facet bounds t from below, from above, or not at all.
#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/query.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// The ray in integers: origin x / d and direction u / s, d and s > 0. On the ray the value of a
// facet is (n.x + offset d) / d + t (n.u) / s, so it is 0 at t = (s / d) rise / slope, where
// rise = -(n.x + offset d) and slope = n.u. The factor s / d > 0 does not change an order of t.
struct IntegerRay {
  IntegerFraction origin, direction;

  Integer rise(const Halfspace& facet) const {
    Integer sum = dot(facet.normal(), origin.x);
    add_product(sum, facet.offset(), origin.d);
    return -sum;
  }
  Integer slope(const Halfspace& facet) const { return dot(facet.normal(), direction.x); }
};

// A bound of t, up to the factor: rise / slope as a fraction with a positive denominator, and all
// facets that give it.
struct LineBound {
  Integer rise, slope;
  std::vector<HalfspaceId> facets;

  // rise / slope against this bound.
  Sign compare(const Integer& other_rise, const Integer& other_slope) const {
    Integer difference = other_rise * slope;
    subtract_product(difference, rise, other_slope);
    return sign_of(difference);
  }
  // Keeps the bound that lies further to the side `better`.
  void take(Integer other_rise, Integer other_slope, HalfspaceId facet, Sign better) {
    const Sign side = facets.empty() ? better : compare(other_rise, other_slope);
    if (side == better) {
      rise = std::move(other_rise);
      slope = std::move(other_slope);
      facets.clear();
    }
    if (side != -better) facets.push_back(facet);
  }
  Rational at(const IntegerRay& ray) const {
    return Rational(Integer(rise * ray.direction.d), Integer(slope * ray.origin.d));
  }
};

// The values of a facet on the line: at the origin, and their change with t.
struct OnLine {
  Rational value, slope;
  OnLine(const Halfspace& facet, const Ray& ray) : value(facet(ray.origin)), slope(0) {
    for (int k = 0; k < 3; ++k) slope += Rational(facet.normal()[k]) * ray.direction[k];
  }
};

bool are_facets(const Polytope& solid, const std::vector<HalfspaceId>& ids) {
  return std::all_of(ids.begin(), ids.end(),
                     [&](HalfspaceId id) { return id.index() < solid.planes.size(); });
}

// Whether the point at t is in the solid, and the line crosses exactly these facets there: with
// slopes below 0 at the entry, above 0 at the exit. Then it leaves the solid at t to that side.
bool are_crossed(const Polytope& solid, const Ray& ray, const Rational& t,
                 const std::vector<HalfspaceId>& ids, Sign side) {
  const RationalPoint end = ray.origin + t * ray.direction;
  const IntegerFraction x = clear_denominators(end), u = clear_denominators(ray.direction);
  std::vector<HalfspaceId> crossed;
  for (std::size_t f = 0; f < solid.planes.size(); ++f) {
    const Halfspace& facet = solid.planes[f];
    Integer value = dot(facet.normal(), x.x);
    add_product(value, facet.offset(), x.d);
    if (value > 0) return false;
    if (value == 0 && sign_of(dot(facet.normal(), u.x)) == side) crossed.emplace_back(f);
  }
  return !crossed.empty() && crossed == ids;
}

// Whether no t >= 0 satisfies the facets, one or two.
bool exclude_ray(const Polytope& solid, const Ray& ray, const std::vector<HalfspaceId>& ids) {
  Rational least = 0;
  std::optional<Rational> most;
  for (const HalfspaceId id : ids) {
    const OnLine facet(solid.planes[id.index()], ray);
    if (facet.slope == 0) {
      if (facet.value > 0) return true;
      continue;
    }
    const Rational t = -facet.value / facet.slope;
    if (facet.slope < 0) least = std::max(least, t);
    if (facet.slope > 0) most = most ? std::min(*most, t) : t;
  }
  return most && *most < least;
}

}  // namespace

RayAnswer cast_ray(const Polytope& solid, const Ray& ray) {
  if (ray.direction.isZero(0)) {
    throw Error(ErrorCode::InvalidArgument, "the direction of a ray is zero");
  }
  const IntegerRay line{clear_denominators(ray.origin), clear_denominators(ray.direction)};
  LineBound entry, exit;
  for (std::size_t f = 0; f < solid.planes.size(); ++f) {
    const HalfspaceId id(f);
    Integer rise = line.rise(solid.planes[f]), slope = line.slope(solid.planes[f]);
    if (slope > 0) {
      exit.take(std::move(rise), std::move(slope), id, Sign::Negative);
    } else if (slope < 0) {
      entry.take(-rise, -slope, id, Sign::Positive);
    } else if (rise < 0) {
      return {{}, {id}};  // parallel to the facet's plane and beyond it
    }
  }
  // A bounded solid has facets that the line crosses in either direction.
  CONVEXACT_ASSERT(!entry.facets.empty() && !exit.facets.empty());
  if (entry.compare(exit.rise, exit.slope) == Sign::Negative) {
    return {{}, {entry.facets.front(), exit.facets.front()}};
  }
  RayAnswer answer;
  if (exit.rise < 0) answer.missed = {exit.facets.front()};  // all of it lies behind the origin
  answer.line =
      LineInterval{entry.at(line), exit.at(line), std::move(entry.facets), std::move(exit.facets)};
  return answer;
}

bool check(const Polytope& solid, const Ray& ray, const RayAnswer& claim) {
  if (!are_facets(solid, claim.missed)) return false;
  if (!claim.is_hit()) {
    if (!exclude_ray(solid, ray, claim.missed)) return false;
    if (!claim.line) return true;
  }
  return claim.line && claim.line->entry <= claim.line->exit &&
         (claim.line->exit >= 0) == claim.is_hit() &&
         are_crossed(solid, ray, claim.line->entry, claim.line->entry_facets, Sign::Negative) &&
         are_crossed(solid, ray, claim.line->exit, claim.line->exit_facets, Sign::Positive);
}

}  // namespace convexact
