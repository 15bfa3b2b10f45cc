// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "convexact/measure.hpp"
#include "measure/facet_area.hpp"
#include "number/balanced_sum.hpp"

namespace convexact {

// The cone from a point x over facet f has the volume area * height / 3 with the height
// -(n.x + d) / |n|, so (area / |n|) * -(n.x + d) / 3.

Rational volume(const Polytope& polytope) {
  // From the origin, wherever it lies: heights are the plain offsets, and have a sign.
  std::vector<Rational> cones;
  for (std::size_t f = 0; f < polytope.facets.size(); ++f) {
    const Integer& offset = polytope.planes[f].offset();
    if (offset != 0) cones.push_back(area_per_normal(polytope, f) * Rational(Integer(-offset)));
  }
  return balanced_sum(std::move(cones)) / 3;
}

namespace {

// Largest exponent e of a coordinate, |x| < 2^e.
long exponent_of(const Polytope& polytope) {
  long largest = 0;
  bool first = true;
  for (const RationalPoint& p : polytope.vertices) {
    for (const Rational& x : p) {
      if (x == 0) continue;
      const long e = static_cast<long>(bit_length(numerator(x))) -
                     static_cast<long>(bit_length(denominator(x))) + 1;
      largest = first ? e : std::max(largest, e);
      first = false;
    }
  }
  return largest;
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
  const long shift = bits - exponent_of(polytope);
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

// From exact heights and areas: no term is negative, so the digits are there at once.
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
