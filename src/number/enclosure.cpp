// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

BigFloat::BigFloat(long precision) {
  if (precision < 1 || precision > MPFR_PREC_MAX) {
    throw Error(ErrorCode::InvalidArgument, "a precision is at least one bit");
  }
  mpfr_init2(value_, precision);
  mpfr_set_zero(value_, 1);
}

BigFloat::BigFloat(const BigFloat& other) {
  mpfr_init2(value_, other.precision());
  mpfr_set(value_, other.value_, MPFR_RNDN);  // same precision: exact
}

// A number that was moved from stays a valid number of the least precision.
BigFloat::BigFloat(BigFloat&& other) noexcept {
  mpfr_init2(value_, MPFR_PREC_MIN);
  mpfr_set_zero(value_, 1);
  mpfr_swap(value_, other.value_);
}

BigFloat& BigFloat::operator=(BigFloat other) noexcept {
  mpfr_swap(value_, other.value_);
  return *this;
}

BigFloat::~BigFloat() { mpfr_clear(value_); }

Rational BigFloat::to_rational() const {
  Rational q;
  mpfr_get_q(q.backend().data(), value_);
  return q;
}

namespace {

using Operation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

struct Range {
  BigFloat low, high;
};

// The ends of an interval b that does not change its sign, by what an end makes of a product or a
// quotient: the larger in size, or the smaller.
struct SignedEnds {
  mpfr_srcptr larger, smaller;
  bool is_negative;
};

// All products, or quotients, of the interval [low, high] and b, rounded outward.
Range range_of(Operation f, mpfr_srcptr low, mpfr_srcptr high, const SignedEnds& b,
               long precision) {
  const mpfr_srcptr& to_low = mpfr_sgn(low) >= 0 ? b.smaller : b.larger;
  const mpfr_srcptr& to_high = mpfr_sgn(high) >= 0 ? b.larger : b.smaller;
  Range range{BigFloat(precision), BigFloat(precision)};
  f(range.low.data(), b.is_negative ? high : low, b.is_negative ? to_high : to_low, MPFR_RNDD);
  f(range.high.data(), b.is_negative ? low : high, b.is_negative ? to_low : to_high, MPFR_RNDU);
  return range;
}

// The ends of an interval as a factor; nothing if it holds numbers of both signs.
std::optional<SignedEnds> factor_ends(mpfr_srcptr low, mpfr_srcptr high) {
  if (mpfr_sgn(low) >= 0) return SignedEnds{high, low, false};
  if (mpfr_sgn(high) <= 0) return SignedEnds{low, high, true};
  return {};
}

// All products of two intervals that both hold 0 inside.
Range range_around_zero(mpfr_srcptr low, mpfr_srcptr high, mpfr_srcptr other_low,
                        mpfr_srcptr other_high, long precision) {
  Range range{BigFloat(precision), BigFloat(precision)};
  BigFloat product(precision);
  mpfr_mul(range.low.data(), low, other_high, MPFR_RNDD);
  mpfr_mul(product.data(), high, other_low, MPFR_RNDD);
  mpfr_min(range.low.data(), range.low.data(), product.data(), MPFR_RNDD);
  mpfr_mul(range.high.data(), low, other_low, MPFR_RNDU);
  mpfr_mul(product.data(), high, other_high, MPFR_RNDU);
  mpfr_max(range.high.data(), range.high.data(), product.data(), MPFR_RNDU);
  return range;
}

}  // namespace

Enclosure::Enclosure(const Rational& x, long precision) : Enclosure(x, x, precision) {}

Enclosure::Enclosure(const Rational& low, const Rational& high, long precision)
    : Enclosure(precision) {
  mpfr_set_q(low_.data(), low.backend().data(), MPFR_RNDD);
  mpfr_set_q(high_.data(), high.backend().data(), MPFR_RNDU);
  require_finite();
}

Enclosure::Enclosure(const Integer& x, long precision) : Enclosure(precision) {
  mpfr_set_z(low_.data(), x.backend().data(), MPFR_RNDD);
  mpfr_set_z(high_.data(), x.backend().data(), MPFR_RNDU);
  require_finite();
}

namespace {

// MPFR caches pi in each thread that needs it, and does not free it when the thread ends.
struct PiOfThread {
  ~PiOfThread() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};

void free_pi_with_its_thread() { [[maybe_unused]] static thread_local const PiOfThread at_end{}; }

}  // namespace

Enclosure Enclosure::pi(long precision) {
  free_pi_with_its_thread();
  Enclosure result(precision);
  mpfr_const_pi(result.low_.data(), MPFR_RNDD);
  mpfr_const_pi(result.high_.data(), MPFR_RNDU);
  return result;
}

// An overflow leaves an infinite end (directed rounding), and no operation starts from one, so
// NaN cannot arise either.
void Enclosure::require_finite() const {
  if (!mpfr_number_p(low_.data()) || !mpfr_number_p(high_.data())) {
    throw Error(ErrorCode::Unrepresentable, "a number is beyond 2^(2^30)");
  }
}

void Enclosure::widen_to(long precision) {
  if (precision <= this->precision()) return;
  mpfr_prec_round(low_.data(), precision, MPFR_RNDD);  // exact: more bits
  mpfr_prec_round(high_.data(), precision, MPFR_RNDU);
}

double Enclosure::low_double() const { return mpfr_get_d(low_.data(), MPFR_RNDD); }
double Enclosure::high_double() const { return mpfr_get_d(high_.data(), MPFR_RNDU); }

std::optional<Sign> Enclosure::sign() const {
  const int low = mpfr_sgn(low_.data()), high = mpfr_sgn(high_.data());
  if (low > 0) return Sign::Positive;
  if (high < 0) return Sign::Negative;
  if (low == 0 && high == 0) return Sign::Zero;
  return std::nullopt;
}

Enclosure Enclosure::operator-() const {
  Enclosure result(precision());
  mpfr_neg(result.low_.data(), high_.data(), MPFR_RNDD);
  mpfr_neg(result.high_.data(), low_.data(), MPFR_RNDU);
  return result;
}

Enclosure& Enclosure::operator+=(const Enclosure& other) {
  widen_to(other.precision());
  mpfr_add(low_.data(), low_.data(), other.low_.data(), MPFR_RNDD);
  mpfr_add(high_.data(), high_.data(), other.high_.data(), MPFR_RNDU);
  require_finite();
  return *this;
}

Enclosure& Enclosure::operator*=(const Enclosure& other) {
  const mpfr_srcptr low = low_.data(), high = high_.data(), other_low = other.low_.data(),
                    other_high = other.high_.data();
  const long bits = std::max(precision(), other.precision());
  const auto make = [&] {
    if (const auto ends = factor_ends(other_low, other_high)) {
      return range_of(mpfr_mul, low, high, *ends, bits);
    }
    if (const auto ends = factor_ends(low, high)) {
      return range_of(mpfr_mul, other_low, other_high, *ends, bits);
    }
    return range_around_zero(low, high, other_low, other_high, bits);
  };
  Range range = make();
  low_ = std::move(range.low);
  high_ = std::move(range.high);
  require_finite();
  return *this;
}

Enclosure& Enclosure::operator/=(const Enclosure& other) {
  const Sign sign = other.sign().value_or(Sign::Zero);
  if (sign == Sign::Zero) reject_argument("a divisor may be zero");
  const mpfr_srcptr low = other.low_.data(), high = other.high_.data();
  const SignedEnds ends =
      sign == Sign::Positive ? SignedEnds{low, high, false} : SignedEnds{high, low, true};
  Range range =
      range_of(mpfr_div, low_.data(), high_.data(), ends, std::max(precision(), other.precision()));
  low_ = std::move(range.low);
  high_ = std::move(range.high);
  require_finite();
  return *this;
}

Enclosure sqrt(const Enclosure& x) {
  if (x.sign() == Sign::Negative) reject_argument("the square root of a negative number");
  Enclosure result(x.precision());  // its lower end is 0
  if (mpfr_sgn(x.low_.data()) > 0) mpfr_sqrt(result.low_.data(), x.low_.data(), MPFR_RNDD);
  mpfr_sqrt(result.high_.data(), x.high_.data(), MPFR_RNDU);
  return result;
}

namespace {

// At least the relative width of an interval that does not hold 0, in few bits.
BigFloat relative_width(const BigFloat& low, const BigFloat& high) {
  BigFloat width(64);
  mpfr_sub(width.data(), high.data(), low.data(), MPFR_RNDU);
  const bool is_positive = mpfr_sgn(low.data()) > 0;
  mpfr_div(width.data(), width.data(), (is_positive ? low : high).data(),
           is_positive ? MPFR_RNDU : MPFR_RNDD);
  mpfr_abs(width.data(), width.data(), MPFR_RNDU);
  return width;
}

}  // namespace

Enclosure atan2(const Enclosure& y, const Enclosure& x) {
  if (mpfr_sgn(y.low_.data()) < 0) reject_argument("an angle below the x axis");
  if (mpfr_zero_p(y.low_.data()) && x.sign().value_or(Sign::Zero) == Sign::Zero) {
    reject_argument("the angle of the origin");
  }
  free_pi_with_its_thread();
  BigFloat low(y.low_), high(y.high_);  // without the sign of -0, whose angles are negative
  mpfr_abs(low.data(), low.data(), MPFR_RNDD);
  mpfr_abs(high.data(), high.data(), MPFR_RNDU);
  // Where y >= 0, the angle falls with x; for a fixed x it rises with y if x > 0 and falls if x <
  // 0.
  const BigFloat& lowest_at = mpfr_sgn(x.high_.data()) > 0 ? low : high;
  const BigFloat& highest_at = mpfr_sgn(x.low_.data()) > 0 ? high : low;
  Enclosure result(std::max(y.precision(), x.precision()));
  mpfr_atan2(result.low_.data(), lowest_at.data(), x.high_.data(), MPFR_RNDD);
  // Most of the time is spent on arctangents. |d angle / d log y| = |d angle / d log x| = |sin cos|
  // is at most the angle, so the other end is less than a factor of exp(w) away, w being the sum of
  // the relative widths, and exp(w) <= 1 + 2 w.
  if (mpfr_sgn(low.data()) > 0 && mpfr_sgn(x.low_.data()) * mpfr_sgn(x.high_.data()) > 0) {
    BigFloat width = relative_width(low, high);
    mpfr_add(width.data(), width.data(), relative_width(x.low_, x.high_).data(), MPFR_RNDU);
    if (mpfr_cmp_ui_2exp(width.data(), 1, -16) < 0) {
      mpfr_set(result.high_.data(), result.low_.data(), MPFR_RNDU);
      mpfr_nextabove(result.high_.data());
      mpfr_mul_2ui(width.data(), width.data(), 1, MPFR_RNDU);
      mpfr_mul(width.data(), width.data(), result.high_.data(), MPFR_RNDU);
      mpfr_add(result.high_.data(), result.high_.data(), width.data(), MPFR_RNDU);
      return result;
    }
  }
  mpfr_atan2(result.high_.data(), highest_at.data(), x.low_.data(), MPFR_RNDU);
  return result;
}

Enclosure enclose_sum(std::span<const Rational> terms, long precision) {
  Enclosure sum(precision);
  for (const Rational& term : terms) sum += Enclosure(term, precision);
  return sum;
}

}  // namespace convexact
