// SPDX-License-Identifier: MIT
#include "simplify/plain_vertex.hpp"

namespace convexact {

PlainVertex plain_vertex(const Halfspace& a, const Halfspace& b, const Halfspace& c) {
  const IntegerVector3 bc = b.normal().cross(c.normal());
  const IntegerVector3 ca = c.normal().cross(a.normal());
  const IntegerVector3 ab = a.normal().cross(b.normal());
  return {-(bc * a.offset() + ca * b.offset() + ab * c.offset()), a.normal().dot(bc)};
}

PlainVertex plain_vertex(const RationalPoint& point) {
  Integer common = 1;
  for (int k = 0; k < 3; ++k) common = lcm(common, denominator(point[k]));
  PlainVertex vertex{{}, common};
  for (int k = 0; k < 3; ++k) {
    vertex.x[k] = numerator(point[k]) * (common / denominator(point[k]));
  }
  return vertex;
}

Integer value_at(const PlainVertex& vertex, const Halfspace& halfspace) {
  Integer sum;
  mpz_t& z = sum.backend().data();
  mpz_mul(z, vertex.d.backend().data(), halfspace.offset().backend().data());
  for (int k = 0; k < 3; ++k) {
    mpz_addmul(z, vertex.x[k].backend().data(), halfspace.normal()[k].backend().data());
  }
  return sum;
}

}  // namespace convexact
