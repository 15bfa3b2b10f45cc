// SPDX-License-Identifier: MIT
#include "io/placement.hpp"

#include "convexact/error.hpp"

namespace convexact {

Sign Placement::orientation() const {
  const RationalVector3 a = linear.col(0), b = linear.col(1), c = linear.col(2);
  return sign_of(Rational(a.dot(b.cross(c))));
}

Placement translation(const RationalVector3& by) {
  Placement placement;
  placement.shift = by;
  return placement;
}

Placement scaling(const RationalVector3& by) {
  Placement placement;
  for (int k = 0; k < 3; ++k) placement.linear(k, k) = by[k];
  return placement;
}

Placement rotation(const std::array<Rational, 4>& q) {
  const auto& [x, y, z, w] = q;
  const Rational square = x * x + y * y + z * z + w * w;
  CONVEXACT_ASSERT(square != 0);
  Placement placement;
  placement.linear << w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w),
      2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w), 2 * (x * z - y * w),
      2 * (y * z + x * w), w * w - x * x - y * y + z * z;
  placement.linear /= square;
  return placement;
}

Placement rotation_about(const RationalVector3& axis, const Rational& degrees) {
  const Rational turns = degrees / 360;
  const Integer whole = numerator(turns) / denominator(turns);  // towards zero
  const Rational angle = degrees - Rational(whole * 360);       // in (-360, 360)
  if (abs(angle) == 180) return rotation({axis[0], axis[1], axis[2], 0});
  // q = (axis tan(angle / 2) / |axis|, 1), up to its length.
  constexpr long kBits = 200;
  BigFloat tangent(kBits), length(kBits), half(kBits);
  mpfr_const_pi(half.data(), MPFR_RNDN);
  mpfr_mul_q(half.data(), half.data(), Rational(angle / 360).backend().data(), MPFR_RNDN);
  mpfr_tan(tangent.data(), half.data(), MPFR_RNDN);
  mpfr_set_q(length.data(), Rational(axis.dot(axis)).backend().data(), MPFR_RNDN);
  mpfr_sqrt(length.data(), length.data(), MPFR_RNDN);
  mpfr_div(tangent.data(), tangent.data(), length.data(), MPFR_RNDN);
  const Rational ratio = to_rational(mpfr_get_d(tangent.data(), MPFR_RNDN));
  return rotation({axis[0] * ratio, axis[1] * ratio, axis[2] * ratio, 1});
}

Placement affine(std::span<const Rational, 16> rows) {
  if (rows[12] != 0 || rows[13] != 0 || rows[14] != 0 || rows[15] != 1) {
    throw Error(ErrorCode::Malformed, "expected a matrix whose last row is 0 0 0 1");
  }
  Placement placement;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) placement.linear(i, k) = rows[4 * i + k];
    placement.shift[i] = rows[4 * i + 3];
  }
  return placement;
}

}  // namespace convexact
