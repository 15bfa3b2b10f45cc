// SPDX-License-Identifier: MIT
// number.hpp - exact numbers, directed rounding, and enclosures of real numbers.
//
// Everything that the library proves is a statement about integers and rationals of any length.
// Doubles come in by to_rational(), exactly, and go out by to_double() in a named direction. Roots
// and angles are not rational: an Enclosure holds them between two of MPFR's numbers.
#pragma once
#include <mpfr.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace convexact {

// ---- Signs and exact numbers

enum class Sign : signed char { Negative = -1, Zero = 0, Positive = 1 };

/// Sign of any number that compares with 0 (NaN has none and must not be passed).
template <class Number>
[[nodiscard]] constexpr Sign sign_of(const Number& x) {
  return x < 0 ? Sign::Negative : x > 0 ? Sign::Positive : Sign::Zero;
}

[[nodiscard]] constexpr Sign operator-(Sign s) { return Sign(-static_cast<signed char>(s)); }
[[nodiscard]] constexpr Sign operator*(Sign a, Sign b) {
  return Sign(static_cast<signed char>(a) * static_cast<signed char>(b));
}

/// An integer, and a fraction in lowest terms, of any length. Without expression templates: `auto`
/// is safe, and Eigen accepts the numbers.
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

/// How many bits |x| takes; 0 for 0.
[[nodiscard]] std::size_t bit_length(const Integer& x);

/// x * 2^k, exactly; k of either sign.
[[nodiscard]] Rational scale_by_power_of_two(const Rational& x, long k);

// ---- Rounding

enum class Rounding {
  Down,     ///< The largest format number <= x; below the lowest one: -infinity.
  Up,       ///< The smallest format number >= x; above the largest one: +infinity.
  Nearest,  ///< IEEE 754 round half to even, with its overflow to infinity.
};

/// x in binary64, correctly rounded through subnormals. Down of a value above the largest double is
/// the largest double (and so on by symmetry), as IEEE 754 says. Zero becomes +0, an x that
/// rounds to zero keeps its sign.
[[nodiscard]] double to_double(const Rational& x, Rounding rounding);

/// x in binary32, likewise; rounded once.
[[nodiscard]] float to_float(const Rational& x, Rounding rounding);

enum class Precision {
  Binary64,  ///< IEEE 754 double: 53 bits, up to about 1.8e308.
  Binary32,  ///< IEEE 754 float: 24 bits, up to about 3.4e38.
};

/// Bits of the significand, the leading one included.
[[nodiscard]] constexpr int significand_bits(Precision precision) {
  return precision == Precision::Binary64 ? 53 : 24;
}

/// x in the format `precision`, as to_double() and to_float() round; a double holds either.
[[nodiscard]] inline double round_to(Precision precision, const Rational& x, Rounding rounding) {
  return precision == Precision::Binary64 ? to_double(x, rounding) : to_float(x, rounding);
}

// ---- Enclosures

/// A binary floating-point number of any precision. It only owns memory: arithmetic is done by
/// the caller with MPFR's functions on data(), each with its direction of rounding.
/// Exponents reach +-2^30 (MPFR's default range, which the library never changes).
class BigFloat {
 public:
  /// The number 0 with `precision` >= 1 bits. @throws Error InvalidArgument if precision < 1.
  explicit BigFloat(long precision);
  BigFloat(const BigFloat& other);
  BigFloat(BigFloat&& other) noexcept;
  BigFloat& operator=(BigFloat other) noexcept;
  ~BigFloat();

  mpfr_ptr data() { return value_; }
  mpfr_srcptr data() const { return value_; }
  long precision() const { return mpfr_get_prec(value_); }

  /// Exactly. Precondition: finite.
  Rational to_rational() const;

 private:
  mpfr_t value_;
};

/// A closed interval [low, high] with binary floating-point ends of `precision` bits. Every
/// operation rounds its lower end down and its upper end up, so the interval holds the exact result
/// for all exact arguments in the intervals it was given.
///
/// The result has the larger of the precisions of the arguments. Ends are always finite: a result
/// beyond 2^(2^30) throws Error Unrepresentable. One below 2^-(2^30) widens to zero and stays true.
class Enclosure {
 public:
  /// [0, 0].
  explicit Enclosure(long precision) : low_(precision), high_(precision) {}
  /// The narrowest interval around x; a point if `precision` bits hold x.
  Enclosure(const Rational& x, long precision);
  Enclosure(const Integer& x, long precision);
  /// The narrowest interval around [low, high], low <= high.
  Enclosure(const Rational& low, const Rational& high, long precision);
  static Enclosure pi(long precision);

  long precision() const { return low_.precision(); }
  Rational low() const { return low_.to_rational(); }
  Rational high() const { return high_.to_rational(); }
  Rational width() const { return high() - low(); }
  double low_double() const;   ///< The largest double <= low, -infinity if there is none.
  double high_double() const;  ///< The smallest double >= high, infinity if there is none.

  /// The sign of every number in the interval; nothing if they differ.
  std::optional<Sign> sign() const;
  bool contains(const Rational& x) const { return low() <= x && x <= high(); }

  Enclosure operator-() const;
  Enclosure& operator+=(const Enclosure& other);
  Enclosure& operator-=(const Enclosure& other) { return *this += -other; }
  Enclosure& operator*=(const Enclosure& other);
  /// @throws Error InvalidArgument unless the sign of the divisor is certain and not zero.
  Enclosure& operator/=(const Enclosure& other);
  friend Enclosure operator+(Enclosure a, const Enclosure& b) { return a += b; }
  friend Enclosure operator-(Enclosure a, const Enclosure& b) { return a -= b; }
  friend Enclosure operator*(Enclosure a, const Enclosure& b) { return a *= b; }
  friend Enclosure operator/(Enclosure a, const Enclosure& b) { return a /= b; }

  /// Square root of a number that the caller knows to be >= 0; the part below 0 is cut off.
  /// @throws Error InvalidArgument if the interval is below 0.
  friend Enclosure sqrt(const Enclosure& x);
  /// The angle in [0, pi] between the x axis and the point (x, y), y >= 0 and not both zero.
  /// @throws Error InvalidArgument if y may be negative, or if the box holds the origin.
  friend Enclosure atan2(const Enclosure& y, const Enclosure& x);

 private:
  void widen_to(long precision);
  void require_finite() const;
  BigFloat low_, high_;
};

// Visible also where no argument is an Enclosure yet.
Enclosure sqrt(const Enclosure& x);
Enclosure atan2(const Enclosure& y, const Enclosure& x);

/// The sum of exact terms, each rounded outward once and once more when added: n terms cost about
/// log2(n) + 1 bits. Zero for no terms.
[[nodiscard]] Enclosure enclose_sum(std::span<const Rational> terms, long precision);

/// A measured real number: always bounds, and the fraction if it was requested.
struct Measured {
  Enclosure bounds;
  std::optional<Rational> exact;
};

// ---- Numbers from text

/// The rational that a decimal spells: "-12", "+1.5", "5.", ".5e-3", or a fraction "p/q".
/// @throws Error Malformed if `text` is anything else (q = 0, blanks, nan), or if the exponent is
///         beyond +-100000 (its digits would need too much memory).
[[nodiscard]] Rational parse_rational(std::string_view text);

/// The meaning of a decimal in a file.
enum class Decimal {
  Nearest,    ///< The double nearest to it, half to even; underflow rounds correctly too.
  Nearest32,  ///< The binary32 number nearest to it, rounded once; binary64 is rounded likewise.
  Exact,      ///< The rational that it spells.
};

/// The double nearest to a decimal: "-12", "+1.5", "5.", ".5e-3", of any length and exponent.
/// @throws Error Malformed if `text` is no decimal; NotFinite if it spells infinity or NaN, or
///         rounds beyond the largest double.
[[nodiscard]] double nearest_double(std::string_view text);

/// The binary32 number nearest to a decimal, rounded from its digits at once: rounded through the
/// double, 1.00000017881393432617187499 would come out one unit too high.
/// @throws Error as nearest_double, for the largest binary32 number.
[[nodiscard]] float nearest_float(std::string_view text);

/// An integer or a fraction "p/q" as spelled; a decimal with a point or an exponent by `decimal`.
/// @throws Error as nearest_double and parse_rational.
[[nodiscard]] Rational parse_number(std::string_view text, Decimal decimal);

// ---- Numbers as text

/// "p" or "p/q" in lowest terms, q > 1.
[[nodiscard]] std::string to_string(const Rational& x);
[[nodiscard]] std::string to_string(const Integer& x);

// "Certain" means: the number differs from what is printed by less than one unit of the last digit
// printed. (It need not begin with these digits: enclosures can never distinguish 2.999... from 3.)
// Text is plain ("-0.00125", "1234.5") or scientific ("1.25e-9", "3.0e+25") where plain text would
// need more than five zeros after the point, or zeros before it that are not certain.

/// x rounded to `digits` >= 1 significant digits, half to even, so within half a unit. If x itself
/// has no more digits, then exactly x without trailing zeros: "0.5" is 1/2, "0.500" is not.
[[nodiscard]] std::string to_decimal(const Rational& x, int digits);

/// The middle of x rounded likewise, if that is within one unit of all of x; otherwise nothing.
[[nodiscard]] std::optional<std::string> to_decimal(const Enclosure& x, int digits);

}  // namespace convexact
