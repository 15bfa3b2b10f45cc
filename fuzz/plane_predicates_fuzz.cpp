// SPDX-License-Identifier: MIT
// Property of plane_signs: the determinants of plane coefficients are those of Laplace's expansion,
// in each of the three places that compute them independently: in the fast engines, in the dual and
// in the verifier. Property of dual_signs: the signs of a solid's dual points are exact at every
// stage; the rounded dual points are as near to the true ones as stated.
#include "convexact/dual.hpp"
#include "fast/signs.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "geometry/plane_determinants.hpp"
#include "hard_numbers.hpp"
#include "simplify/plain_vertex.hpp"

using namespace convexact;

namespace {

// Laplace's expansions, along the first row and along the column of the offsets.
Integer true_normal_determinant(const Halfspace& a, const Halfspace& b, const Halfspace& c) {
  const IntegerVector3 &x = a.normal(), &y = b.normal(), &z = c.normal();
  return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) +
         x[2] * (y[0] * z[1] - y[1] * z[0]);
}

Integer true_determinant(const Halfspace& a, const Halfspace& b, const Halfspace& c,
                         const Halfspace& p) {
  return p.offset() * true_normal_determinant(a, b, c) -
         c.offset() * true_normal_determinant(a, b, p) +
         b.offset() * true_normal_determinant(a, c, p) -
         a.offset() * true_normal_determinant(b, c, p);
}

// Small numbers, or two that differ in the last of many bits, or numbers of very different sizes.
Halfspace halfspace(FuzzInput& in, std::size_t kind) {
  Integer row[4];
  for (Integer& x : row) {
    x = static_cast<int>(in.below(7)) - 3;
    if (kind == 1) x = (x << 60) + (static_cast<int>(in.below(3)) - 1);
    if (kind == 2) x <<= static_cast<unsigned>(in.below(1200));
  }
  if (row[0] == 0 && row[1] == 0 && row[2] == 0) row[0] = 1;
  return {IntegerVector3(row[0], row[1], row[2]), row[3]};
}

// Whether the rows (n, d) of the three planes are linearly dependent: every 3x3 minor vanishes.
// Then the dual points are collinear, and no plane passes through them alone.
bool are_dependent(const Halfspace& a, const Halfspace& b, const Halfspace& c) {
  const auto entry = [](const Halfspace& h, int k) -> const Integer& {
    return k < 3 ? h.normal()[k] : h.offset();
  };
  for (int left_out = 0; left_out < 4; ++left_out) {
    int k[3], count = 0;
    for (int column = 0; column < 4; ++column) {
      if (column != left_out) k[count++] = column;
    }
    const auto minor = [&](int i, int j) -> Integer {
      return entry(b, i) * entry(c, j) - entry(b, j) * entry(c, i);
    };
    if (entry(a, k[0]) * minor(k[1], k[2]) - entry(a, k[1]) * minor(k[0], k[2]) +
            entry(a, k[2]) * minor(k[0], k[1]) !=
        0) {
      return false;
    }
  }
  return true;
}

// The exponent of the power of two that a positive number nearly is.
long nearest_power_of_two(const Rational& x) {
  const long exponent =
      static_cast<long>(bit_length(numerator(x))) - static_cast<long>(bit_length(denominator(x)));
  const Rational rest = scale_by_power_of_two(x, -exponent);  // in (1/2, 2)
  return exponent + (rest > Rational(3, 2) ? 1 : rest < Rational(3, 4) ? -1 : 0);
}

// The dual point about the origin, wherever that lies.
DualPoint dual_point(const Halfspace& h) { return {h.normal(), Integer(-h.offset())}; }

void hold_plane_signs(FuzzInput& in) {
  const std::size_t kind = in.below(3);
  const Halfspace a = halfspace(in, kind), b = halfspace(in, kind), c = halfspace(in, kind),
                  p = halfspace(in, kind);
  const Integer normals = true_normal_determinant(a, b, c), whole = true_determinant(a, b, c, p);
  FUZZ_CHECK(normal_determinant(a, b, c) == normals);
  FUZZ_CHECK(plane_determinant(a, b, c, p) == whole);
  const DualPoint points[] = {dual_point(a), dual_point(b), dual_point(c), dual_point(p)};
  if (!are_dependent(a, b, c)) {
    const DualPlane plane = plane_through(points[0], points[1], points[2]);
    FUZZ_CHECK(sign_of(plane.d) == sign_of(normals));
    FUZZ_CHECK(sign_of(height(plane, points[3])) == sign_of(whole));
  }
  const PlainVertex vertex = plain_vertex(a, b, c);
  FUZZ_CHECK(vertex.d == normals);
  FUZZ_CHECK(value_at(vertex, p) == whole);
}

// Each axis is scaled by one power of two for all dual points.
void check_coordinates(const FastDual& dual) {
  for (int axis = 0; axis < 3; ++axis) {
    std::optional<long> exponent;
    for (std::size_t i = 0; i < dual.size(); ++i) {
      const HalfspaceId id(i);
      const double near = dual.near(id)[axis], rest = dual.rest(id)[axis];
      const Halfspace& h = dual.exact(id);
      const Rational q = Rational(h.normal()[axis]) / -h(dual.center());
      if (std::abs(near) < 0x1p-900) continue;  // may have underflowed
      FUZZ_CHECK(q != 0);
      if (!exponent) exponent = nearest_power_of_two(to_rational(near) / q);
      const Rational truth = scale_by_power_of_two(q, *exponent);
      const Rational size = abs(to_rational(near));
      FUZZ_CHECK(abs(Rational(to_rational(near) - truth)) <=
                 size * to_rational(FastDual::kNearError));
      FUZZ_CHECK(abs(Rational(to_rational(near) + to_rational(rest) - truth)) <=
                 size * to_rational(FastDual::kLongError));
    }
  }
}

void check_signs(const FastDual& dual, FuzzInput& in) {
  const DualSigns signs(dual);
  for (int round = 0; round < 2; ++round) {
    HalfspaceId ids[4];
    for (HalfspaceId& id : ids) id = HalfspaceId(in.below(dual.size()));
    const auto& [a, b, c, p] = ids;
    const Sign height =
        sign_of(true_determinant(dual.exact(a), dual.exact(b), dual.exact(c), dual.exact(p)));
    const Sign normals =
        sign_of(true_normal_determinant(dual.exact(a), dual.exact(b), dual.exact(c)));
    FUZZ_CHECK(signs.height(a, b, c, p) == height);
    FUZZ_CHECK(signs.height_beyond_doubles(a, b, c, p) == height);
    FUZZ_CHECK(signs.determinant(a, b, c) == normals);
    FUZZ_CHECK(signs.determinant_beyond_doubles(a, b, c) == normals);
  }
}

void hold_dual_signs(FuzzInput& in) {
  std::vector<Point> points;
  HardNumbers numbers(in);
  for (std::size_t count = 4 + in.below(3); points.size() < count;) {
    points.push_back(numbers.point());
  }
  const PointSet set(points);
  const HullOutcome outcome = convex_hull(set);
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return;
  const FastDual dual = FastDual::of(*hull, set);
  check_coordinates(dual);
  check_signs(dual, in);
}

const FuzzTarget kPlaneSigns("plane_signs", hold_plane_signs);
const FuzzTarget kDualSigns("dual_signs", hold_dual_signs);

}  // namespace
