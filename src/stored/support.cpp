// SPDX-License-Identifier: MIT
#include "stored/support.hpp"

#include <limits>
#include <optional>

#include "convexact/error.hpp"

namespace convexact::stored {

Rational WitnessSupport::operator()(const Point& n) {
  // One bound for all witnesses: no product is larger than |n_k| * largest. Where a sum might
  // overflow the bound is infinite, nothing is below the limit and all are compared exactly.
  const double size = n.cwiseAbs().sum() * doubles_.largest;
  const double error = size < 0x1p1022 ? kRelative * size + absolute_error(std::max(1.0, size))
                                       : std::numeric_limits<double>::infinity();
  values_.resize(doubles_.size());
  double top = -std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < values_.size(); ++j) {
    values_[j] = n[0] * doubles_.x[j] + n[1] * doubles_.y[j] + n[2] * doubles_.z[j];
    top = std::max(top, values_[j]);
  }
  const double limit = top - error - error;  // values below it are below the true maximum
  const RationalVector3 exact_normal = to_rational(n);
  std::optional<Rational> maximum;
  for (std::size_t j = 0; j < values_.size(); ++j) {
    if (values_[j] < limit) continue;
    const Rational value = exact_normal.dot(points_[witnesses_[j]]);
    if (!maximum || value > *maximum) maximum = value;
  }
  CONVEXACT_ASSERT(maximum.has_value());
  return *maximum;
}

}  // namespace convexact::stored
