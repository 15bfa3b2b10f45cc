// SPDX-License-Identifier: MIT
// fractions.hpp - points that no doubles are, at the places of given ones.
#pragma once
#include <random>
#include <vector>

#include "convexact/io.hpp"

namespace support {

/// The kinds of fractions that rounding treats differently.
enum class Fractions {
  Scaled,     ///< By other factors along each axis.
  Far,        ///< Thirds, 2^20 from the origin: rounding moves them by 2^-34 of their distances.
  Needle,     ///< Thirds, so thin along z that rounding moves points by its thickness.
  Hair,       ///< So thin that not even the remainders of rounding tell its points apart well.
  Tiny,       ///< Below the smallest normal double.
  NearTies,   ///< As far in x and y, and moved there by less than rounding moves them.
  WithATiny,  ///< One coordinate of 10^-19 among decimals, as programs write a zero.
};
inline constexpr Fractions kFractions[] = {
    Fractions::Scaled, Fractions::Far,      Fractions::Needle,   Fractions::Hair,
    Fractions::Tiny,   Fractions::NearTies, Fractions::WithATiny};

inline convexact::PointSet as_fractions(const convexact::PointSet& points, Fractions kind) {
  using convexact::Rational;
  std::vector<convexact::RationalPoint> made;
  for (std::size_t i = 0; i < points.size(); ++i) {
    convexact::RationalPoint p = points[convexact::PointId(i)];
    switch (kind) {
      case Fractions::Scaled:
        p = {p[0] / 3, p[1] * Rational(5, 7), p[2] * Rational(10, 9)};
        break;
      case Fractions::Far:
        for (int k = 0; k < 3; ++k) p[k] = p[k] / 3 + Rational(convexact::Integer(1) << 20);
        break;
      case Fractions::Needle:
      case Fractions::Hair:
        p = {p[0] / 3, p[1] / 3,
             p[2] / Rational(3 * (convexact::Integer(1) << (kind == Fractions::Hair ? 70 : 52))) +
                 Rational(1, 7)};
        break;
      case Fractions::Tiny:
        for (int k = 0; k < 3; ++k) p[k] /= Rational(3 * (convexact::Integer(1) << 1040));
        break;
      case Fractions::NearTies:
        for (int k = 0; k < 2; ++k) {
          const std::size_t some = (7 * i + 5 * static_cast<std::size_t>(k)) % 13;
          p[k] += Rational(some, 3 * (convexact::Integer(1) << 35)) + Rational(1 << 20);
        }
        break;
      case Fractions::WithATiny:
        p /= Rational(10);
        if (i == 0) p[0] += Rational(1, convexact::Integer("10000000000000000000"));
        break;
    }
    made.push_back(p);
  }
  return convexact::PointSet(std::move(made));
}

}  // namespace support
