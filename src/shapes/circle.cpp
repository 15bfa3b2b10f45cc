// SPDX-License-Identifier: MIT
#include "shapes/circle.hpp"

#include <utility>

#include "convexact/number.hpp"

namespace convexact::shapes {
namespace {

constexpr long kPrecision = 128;

// Cosine and sine of pi a / b for 0 <= a / b <= 1/4.
CirclePoint in_first_octant(std::uint64_t a, std::uint64_t b) {
  if (4 * a == b) {
    // Both are the square root of 1/2; MPFR's two results could differ in the last bit.
    BigFloat half(kPrecision);
    mpfr_set_d(half.data(), 0.5, MPFR_RNDN);
    mpfr_sqrt(half.data(), half.data(), MPFR_RNDN);
    const double root = mpfr_get_d(half.data(), MPFR_RNDN);
    return {root, root};
  }
  BigFloat angle(kPrecision), sine(kPrecision), cosine(kPrecision);
  mpfr_const_pi(angle.data(), MPFR_RNDN);
  mpfr_mul_ui(angle.data(), angle.data(), a, MPFR_RNDN);
  mpfr_div_ui(angle.data(), angle.data(), b, MPFR_RNDN);
  mpfr_sin_cos(sine.data(), cosine.data(), angle.data(), MPFR_RNDN);
  return {mpfr_get_d(cosine.data(), MPFR_RNDN), mpfr_get_d(sine.data(), MPFR_RNDN)};
}

}  // namespace

CirclePoint on_circle(std::uint64_t k, std::uint64_t n) {
  // The angle is pi a / b throughout; each line folds it into half of what was left.
  std::uint64_t a = 2 * (k % n), b = n;
  const bool below = a > b;  // sine < 0
  if (below) a = 2 * b - a;
  const bool left = 2 * a > b;  // cosine < 0
  if (left) a = b - a;
  const bool steep = 4 * a > b;  // sine > cosine: take the complement pi (b - 2a) / (2b)
  CirclePoint p = steep ? in_first_octant(b - 2 * a, 2 * b) : in_first_octant(a, b);
  if (steep) std::swap(p.cosine, p.sine);
  if (left) p.cosine = -p.cosine;
  if (below) p.sine = -p.sine;
  return p;
}

}  // namespace convexact::shapes
