// SPDX-License-Identifier: MIT
// rational.hpp - the exact integers and rationals of every verdict, alone and in Eigen vectors.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <string>
#include <string_view>

#include "convexact/number/sign.hpp"

namespace convexact {

/// Without expression templates: `auto` is safe, and Eigen accepts the numbers.
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
using IntegerVector3 = Vector3<Integer>;
using RationalVector3 = Vector3<Rational>;
using RationalVector = Eigen::Matrix<Rational, Eigen::Dynamic, 1>;

[[nodiscard]] inline Sign sign_of(const Integer& x) { return Sign(x.sign()); }
[[nodiscard]] inline Sign sign_of(const Rational& x) { return Sign(x.sign()); }

/// The rational that a double is. The only way from double to Rational.
/// @throws Error NotFinite for NaN and infinity.
[[nodiscard]] Rational to_rational(double x);
[[nodiscard]] RationalVector3 to_rational(const Vector3<double>& v);

/// The rational that a decimal spells: "-12", "+1.5", "5.", ".5e-3", or a fraction "p/q".
/// @throws Error Malformed if `text` is anything else (q = 0, blanks, nan), or if the exponent is
///         beyond +-100000 (its digits would not fit a sensible memory).
[[nodiscard]] Rational parse_rational(std::string_view text);

/// "p" or "p/q" in lowest terms, q > 1.
[[nodiscard]] std::string to_string(const Rational& x);
[[nodiscard]] std::string to_string(const Integer& x);

/// How many bits |x| takes; 0 for 0.
[[nodiscard]] std::size_t bit_length(const Integer& x);

/// Greatest common divisor, >= 0; gcd(0, 0) = 0.
[[nodiscard]] Integer gcd(const Integer& a, const Integer& b);

/// Divides (x, d), not all zero, by the greatest common divisor of all four.
void make_primitive(IntegerVector3& x, Integer& d);

/// x * 2^k, exactly; k of either sign.
[[nodiscard]] Rational scale_by_power_of_two(const Rational& x, long k);

}  // namespace convexact
