// SPDX-License-Identifier: MIT
// Areas of facets and the volume of a polytope: the volume of a cone over a facet is its area times
// its height over 3, where the roots in both cancel.
#include <algorithm>
#include <optional>
#include <vector>

#include "convexact/measure.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

int largest_component(const IntegerVector3& n) {
  int k = 0;
  if (abs(n[1]) > abs(n[k])) k = 1;
  if (abs(n[2]) > abs(n[k])) k = 2;
  return k;
}

// Area of a facet divided by the length of its plane's normal, the rational part of it; positive.
Rational area_per_normal(const Polytope& polytope, std::size_t facet) {
  // Projected along axis k, the facet shrinks by |n_k| / |n|, and keeps its orientation if n_k > 0.
  // So area / |n| = S / (2 n_k) with the shoelace sum S = sum of u_i (v_{i+1} - v_{i-1}).
  const IntegerVector3& n = polytope.planes[facet].normal();
  const int k = largest_component(n), u = (k + 1) % 3, v = (k + 2) % 3;
  const std::vector<std::uint32_t>& corners = polytope.facets[facet];
  const std::size_t m = corners.size();
  const auto corner = [&](std::size_t i) -> const RationalPoint& {
    return polytope.vertices[corners[i % m]];
  };
  std::vector<Rational> terms;
  for (std::size_t i = 0; i < m; ++i) {
    terms.push_back(corner(i)[u] * (corner(i + 1)[v] - corner(i + m - 1)[v]));
  }
  return balanced_sum(std::move(terms)) / Rational(Integer(2 * n[k]));
}

}  // namespace

std::vector<RootTerm> facet_areas(const Polytope& polytope, const Watch& watch) {
  std::vector<RootTerm> areas;
  for (std::size_t f = 0; f < polytope.facets.size(); ++f) {
    watch.at(f, polytope.facets.size());
    const IntegerVector3& n = polytope.planes[f].normal();
    const Integer common = gcd(gcd(n[0], n[1]), n[2]);
    const Integer x = n[0] / common, y = n[1] / common, z = n[2] / common;
    areas.push_back({area_per_normal(polytope, f) * Rational(common), x * x + y * y + z * z});
  }
  return areas;
}

Enclosure enclose_sum(const std::vector<RootTerm>& terms, long precision) {
  Enclosure sum(precision);
  for (const RootTerm& term : terms) {
    sum += Enclosure(term.factor, precision) * sqrt(Enclosure(term.radicand, precision));
  }
  return sum;
}

Enclosure surface_area(const Polytope& polytope, long precision, const Watch& watch) {
  return enclose_sum(facet_areas(polytope, watch), precision);
}

// The cone from a point x over facet f has the volume area * height / 3 with the height
// -(n.x + d) / |n|, so (area / |n|) * -(n.x + d) / 3.

Rational volume(const Polytope& polytope) {
  // Cones from the origin, wherever it lies: heights are the plain offsets, and have a sign.
  std::vector<Rational> cones;
  for (std::size_t f = 0; f < polytope.facets.size(); ++f) {
    const Integer& offset = polytope.planes[f].offset();
    if (offset != 0) cones.push_back(area_per_normal(polytope, f) * Rational(Integer(-offset)));
  }
  return balanced_sum(std::move(cones)) / 3;
}

namespace {

// An e with |x| < 2^e for every coordinate x.
long largest_exponent(const Polytope& polytope) {
  std::optional<long> largest;
  for (const RationalPoint& p : polytope.vertices) {
    for (const Rational& x : p) {
      if (x != 0) largest = std::max(largest.value_or(exponent_of(x)), exponent_of(x));
    }
  }
  return largest.value_or(0);
}

// The vertices less vertex 0 as multiples of 2^-shift, both rounded down: each off by less than 1,
// and exact where all vertices are such multiples.
struct RoundedArms {
  std::vector<IntegerVector3> arms;
  bool are_exact = true;
};
RoundedArms rounded_arms(const Polytope& polytope, long shift) {
  RoundedArms result;
  std::vector<IntegerVector3>& arms = result.arms;
  arms.reserve(polytope.vertices.size());
  Integer rest;
  const auto up = static_cast<unsigned>(std::max(shift, 0L)),
             down = static_cast<unsigned>(std::max(-shift, 0L));
  for (const RationalPoint& p : polytope.vertices) {
    IntegerVector3& arm = arms.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const Integer above = numerator(p[k]) << up, below = denominator(p[k]) << down;
      mpz_fdiv_qr(arm[k].backend().data(), rest.backend().data(), above.backend().data(),
                  below.backend().data());
      result.are_exact = result.are_exact && rest.is_zero();
    }
  }
  const IntegerVector3 apex = arms[0];
  for (IntegerVector3& arm : arms) arm -= apex;
  return result;
}

// By tetrahedra from vertex 0 in integers of about `bits` bits. This is cheap, but the number of
// digits lost to rounding depends on how far from the origin the polytope lies.
//
// Where no entry of a 3 x 3 determinant is larger than L, and each is off by less than 1, each of
// its six products is off by less than (L + 1)^3 - L^3 <= 3 (L + 1)^2.
Enclosure enclose_by_rounding(const Polytope& polytope, long bits) {
  const long shift = bits - largest_exponent(polytope);
  const auto [arms, are_exact] = rounded_arms(polytope, shift);
  Integer sum = 0, largest = 0, tetrahedra = 0;
  for (const IntegerVector3& arm : arms) {
    for (const Integer& x : arm) largest = std::max(largest, Integer(abs(x)));
  }
  for (const auto& facet : polytope.facets) {
    if (std::find(facet.begin(), facet.end(), 0u) != facet.end()) continue;  // apex in its plane
    for (std::size_t m = 2; m < facet.size(); ++m) {
      const IntegerVector3 normal = arms[facet[m - 1]].cross(arms[facet[m]]);
      sum += arms[facet[0]].dot(normal);
      ++tetrahedra;
    }
  }
  const Integer error = are_exact ? 0 : Integer(18 * tetrahedra * (largest + 1) * (largest + 1));
  const auto end = [&](const Integer& six_volumes) {
    return scale_by_power_of_two(Rational(six_volumes), -3 * shift) / 6;
  };
  return {end(sum - error), end(sum + error), bits};
}

// From exact heights and areas: no term is negative, so no digits cancel.
Enclosure enclose_by_heights(const Polytope& polytope, long precision) {
  Enclosure sum(precision);
  for (std::size_t f = 0; f < polytope.facets.size(); ++f) {
    const Rational depth = -polytope.planes[f](polytope.vertices.front());
    if (depth == 0) continue;
    sum += Enclosure(area_per_normal(polytope, f), precision) * Enclosure(depth, precision);
  }
  return sum / Enclosure(Integer(3), precision);
}

}  // namespace

Enclosure enclose_volume(const Polytope& polytope, long precision) {
  constexpr long kSpareBits = 96;  // lost to cancellation in an ordinary scene
  const Enclosure rounded = enclose_by_rounding(polytope, precision + kSpareBits);
  const bool is_narrow = scale_by_power_of_two(rounded.width(), precision) <= rounded.low();
  return is_narrow ? rounded : enclose_by_heights(polytope, precision);
}

}  // namespace convexact
