// SPDX-License-Identifier: MIT
#include "lab/report/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// The vertices as seen from the center, each axis scaled to at most one by a power of two.
class ScaledVertices {
 public:
  ScaledVertices(const std::vector<RationalPoint>& vertices, const RationalPoint& center) {
    for (const RationalPoint& v : vertices) exact_.push_back(v - center);
    for (int k = 0; k < 3; ++k) {
      Rational largest = 0;
      for (const RationalVector3& v : exact_) largest = std::max<Rational>(largest, abs(v[k]));
      down_[k] = -exponent_of(largest);
      for (RationalVector3& v : exact_) v[k] = scale_by_power_of_two(v[k], down_[k]);
    }
    for (const RationalVector3& v : exact_) near_.push_back(nearest(v));
  }

  // max P.v over the vertices.
  //
  // In doubles P.v is off by less than 2^-50 (|P1| + |P2| + |P3|): each product by 2^-53 from each
  // factor and 2^-53 from rounding, the two sums by another 2 * 2^-53, as |v_k| <= 1. Underflow
  // loses less than 2^-1000 as long as no |P_k| is beyond 2^60; then every vertex is looked at.
  Rational support(const RationalVector3& point) const {
    RationalVector3 scaled;
    for (int k = 0; k < 3; ++k) scaled[k] = scale_by_power_of_two(point[k], -down_[k]);
    const Vector3<double> p = nearest(scaled);
    const double size = std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
    const double error =
        size < 0x1p60 ? 0x1p-50 * size + 0x1p-1000 : std::numeric_limits<double>::infinity();
    double best = -std::numeric_limits<double>::infinity();
    for (const Vector3<double>& v : near_) best = std::max(best, p.dot(v));
    Rational largest = scaled.dot(exact_.front());
    for (std::size_t i = 0; i < near_.size(); ++i) {
      if (p.dot(near_[i]) < best - 2 * error) continue;
      largest = std::max<Rational>(largest, scaled.dot(exact_[i]));
    }
    return largest;
  }

 private:
  std::vector<RationalVector3> exact_;
  std::vector<Vector3<double>> near_;
  std::array<long, 3> down_{};
};

// log2 of x > 0, to about 12 digits.
double log2_of(const Rational& x) {
  const long s =
      static_cast<long>(bit_length(numerator(x))) - static_cast<long>(bit_length(denominator(x)));
  return std::log2(to_double(scale_by_power_of_two(x, -s), Rounding::Nearest)) +
         static_cast<double>(s);
}

}  // namespace

ErrorSize error_size(const Rational& error) {
  if (error == 0) return {};
  const Rational size = abs(error);
  return {to_double(size, Rounding::Nearest), -log2_of(size)};
}

ErrorSize root_size(const Rational& x) {
  if (x == 0) return {};
  const double bits = -log2_of(x) / 2;
  return {std::exp2(-bits), bits};
}

ErrorSize relative_error(const Rational& computed, const Rational& exact) {
  if (computed == exact) return {};
  return error_size((computed - exact) / exact);
}

ErrorSize worst_coordinate(const RoundedDual& rounded, std::size_t halfspaces) {
  ErrorSize worst;
  for (std::size_t i = 0; i < halfspaces; ++i) {
    const RationalVector3 p = rounded.point(HalfspaceId(i)),
                          exact = rounded.exact_point(HalfspaceId(i));
    for (int k = 0; k < 3; ++k) worst = std::max(worst, relative_error(p[k], exact[k]));
  }
  return worst;
}

ErrorSize worst_outside(const RoundedDual& rounded, const DualHull& dual,
                        const RationalPoint& center) {
  const ScaledVertices vertices(dual.vertices, center);
  const Rational squared_diameter = bounding_box(dual.vertices).squared_diameter();
  ErrorSize worst;
  for (std::size_t i = 0; i < dual.halfspaces.size(); ++i) {
    const RationalVector3 p = rounded.point(HalfspaceId(i));
    const Rational beyond = vertices.support(p) - 1;
    if (beyond <= 0) continue;
    const Rational squared = beyond * beyond / (p.squaredNorm() * squared_diameter);
    worst = std::max(worst, root_size(squared));
  }
  return worst;
}

}  // namespace convexact
