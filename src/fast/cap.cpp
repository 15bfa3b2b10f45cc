// SPDX-License-Identifier: MIT
#include "fast/cap.hpp"

namespace convexact {

Rational ExactCapSource::Sum::total() {
  if (terms_.empty()) return 0;
  for (std::size_t count = terms_.size(); count > 1; count = (count + 1) / 2) {
    for (std::size_t j = 0; 2 * j < count; ++j) {
      terms_[j] = 2 * j + 1 < count ? Rational(terms_[2 * j] + terms_[2 * j + 1]) : terms_[2 * j];
    }
  }
  return terms_[0];
}

Rational ExactCapSource::height(HalfspaceId a, HalfspaceId b, HalfspaceId c, HalfspaceId p) const {
  return Rational(exact_height(dual_.exact(a), dual_.exact(b), dual_.exact(c), dual_.exact(p)));
}
Rational ExactCapSource::base(std::uint32_t m) const {
  return Rational(
      exact_determinant(dual_.exact(center_), dual_.exact(ring_[m]), dual_.exact(after(m))));
}
Rational ExactCapSource::slack(std::uint32_t m) const {
  return m < 2 ? Rational(0) : Rational(-height(center_, ring_[0], ring_[1], ring_[m]));
}
Rational ExactCapSource::leg(std::uint32_t m, std::uint32_t q) const {
  return Rational(-height(center_, ring_[m], after(m), ring_[q]));
}
Rational ExactCapSource::vertex() const {
  return Rational(exact_determinant(dual_.exact(low_), dual_.exact(middle_), dual_.exact(high_)));
}
Rational ExactCapSource::to_center() const { return height(low_, middle_, high_, center_); }
Rational ExactCapSource::to(std::uint32_t q) const {
  return Rational(-height(low_, middle_, high_, ring_[q]));
}

}  // namespace convexact
